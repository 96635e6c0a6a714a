// What other lead limits and tools would take, as a chart in the dialog of rework regions; a click in it sets
// the lead limit.
#pragma once

#include "core/base/units.h"
#include "core/strategy/global_local/tool_advice.h"

#include <QWidget>

#include <optional>

class QComboBox;
class QLabel;
class QPushButton;

namespace facetmill::ui {

class PlotView;

class AdvicePage : public QWidget {
    Q_OBJECT
public:
    explicit AdvicePage(QWidget* parent);

    void set_unit(LengthUnit unit) { unit_ = unit; }
    /// `diameter`: of the operation's tool; `lead_limit` where the cursor stands.
    void show_advice(const ToolAdvice& advice, double diameter, double lead_limit);
    void clear_advice(const QString& why);
    /// Lead limit of the least time with the operation's own tool.
    std::optional<double> suggested() const;

    PlotView* plot() { return plot_; }
    QComboBox* quantity_box() { return quantity_; }
    QComboBox* axis_box() { return axis_; }
    QPushButton* use_suggested() { return use_; }
    QString advice_text() const;

signals:
    /// The chart's cursor was put on a lead limit, radians.
    void lead_wanted(double lead_limit);
    void lead_chosen(double lead_limit);

private:
    void fill_chart();
    void show_cursor();
    bool over_lead() const;
    QString estimate_text(const StrategyEstimate& e) const;

    PlotView* plot_ = nullptr;
    QComboBox *quantity_ = nullptr, *axis_ = nullptr;
    QLabel *readout_ = nullptr, *suggestion_ = nullptr;
    QPushButton* use_ = nullptr;
    LengthUnit unit_ = LengthUnit::mm;
    std::optional<ToolAdvice> advice_;
    double diameter_ = 0, lead_limit_ = 0;
};

} // namespace facetmill::ui
