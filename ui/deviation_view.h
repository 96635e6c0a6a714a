// The deviations of the part as a histogram in the colours of the view, with fields for the ends of its
// range.
#pragma once

#include "core/base/units.h"
#include "viz/deviation_display.h"

#include <QWidget>

#include <optional>

class QDoubleSpinBox;
class QToolButton;

namespace facetmill::ui {

class DeviationHistogramView : public QWidget {
    Q_OBJECT
public:
    explicit DeviationHistogramView(QWidget* parent = nullptr);
    void show_deviation(DeviationDisplayPtr display, const DeviationScale& scale, LengthUnit unit);
    const std::optional<DeviationHistogram>& histogram() const { return histogram_; }
    QSize sizeHint() const override { return {220, 150}; }
    QSize minimumSizeHint() const override { return {120, 110}; }

protected:
    void paintEvent(QPaintEvent* event) override;
    bool event(QEvent* event) override;

private:
    struct Frame;
    Frame frame() const;
    DeviationDisplayPtr display_;
    std::optional<DeviationHistogram> histogram_;
    LengthUnit unit_ = LengthUnit::mm;
};

/// "from ... to ..." in the project's unit, with a button back to the default.
class DeviationRangeEditor : public QWidget {
    Q_OBJECT
public:
    explicit DeviationRangeEditor(QWidget* parent = nullptr);
    void set_scale(const DeviationScale& scale, LengthUnit unit);
    QDoubleSpinBox* low() { return low_; }
    QDoubleSpinBox* high() { return high_; }

signals:
    /// Both in mm; low < 0 < high.
    void edited(double low, double high);
    void reset();

private:
    void take();
    QDoubleSpinBox *low_ = nullptr, *high_ = nullptr;
    LengthUnit unit_ = LengthUnit::mm;
};

} // namespace facetmill::ui
