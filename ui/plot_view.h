// A chart of curves over one axis, with limits, marks and a cursor that goes where the user points. The wheel
// zooms along the horizontal axis (Ctrl: along the upright one). No knowledge of what is charted: the panel
// fills it.
#pragma once

#include "ui/chart_view.h"
#include "ui/plot_painting.h"

#include <QImage>
#include <QPixmap>
#include <QPointF>
#include <QRectF>
#include <QString>

#include <optional>
#include <vector>

namespace facetmill::ui {

class PlotView : public ChartView {
    Q_OBJECT
public:
    explicit PlotView(QWidget* parent = nullptr);

    /// It is seen whole.
    void set_content(PlotContent content);
    const PlotContent& content() const { return content_; }
    /// Without content the text says why.
    void clear(const QString& why);
    bool empty() const { return content_.x.empty(); }
    const QString& empty_text() const { return empty_text_; }
    /// Place along the axis, or none.
    void set_cursor(std::optional<double> x);
    std::optional<double> cursor() const { return cursor_; }

    void reset_view() override;
    /// What is seen of either axis.
    QRectF view() const { return view_; }
    void zoom_x(double about, double factor);
    /// Pixel of the widget for a place in the chart.
    QPointF place_of(double x, double y) const;
    /// White ground, with the title; no cursor.
    QImage picture(const QSize& size) const;
    QSize sizeHint() const override { return {600, 220}; }
    QSize minimumSizeHint() const override { return {180, 110}; }

signals:
    /// By the user.
    void cursor_moved(double x);

protected:
    void paintEvent(QPaintEvent* event) override;
    void changeEvent(QEvent* event) override;
    bool filled() const override { return !empty(); }
    void point_at(const QPointF& at) override;
    void move_by(const QPointF& by) override;
    void zoom_at(const QPointF& about, double factor, bool upright) override;
    void zoom_by_key(double factor) override;

private:
    QRectF whole() const;
    QRectF frame() const;
    double x_at(double pixel) const;
    void hold_view();
    void redraw(); ///< everything, not the cursor alone
    PlotLook look() const;
    void paint(QPainter& p, const QSize& size, const PlotLook& look, bool exported) const;

    PlotContent content_;
    QString empty_text_;
    QRectF whole_{0, 0, 1, 1},
        view_{0, 0, 1, 1}; ///< x from left to right, y from top (the low end) to bottom
    std::optional<double> cursor_;
    QPixmap cache_; ///< all but the cursor
    bool drawn_ = false;
};

} // namespace facetmill::ui
