// A chart: curves over one axis, limits, marks and a cursor. Left click or drag moves the cursor, the wheel
// zooms along the horizontal axis about the pointer (Ctrl: along the upright one), right, middle or Shift
// drag moves, a double click or Home shows all again. No knowledge of what is charted: the panel fills it.
#pragma once

#include "ui/plot_content.h"

#include <QImage>
#include <QPixmap>
#include <QPointF>
#include <QRectF>
#include <QString>
#include <QWidget>

#include <optional>
#include <vector>

namespace facetmill::ui {

class PlotView : public QWidget {
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

    void reset_view();
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
    void stepped(int by);

protected:
    void paintEvent(QPaintEvent* event) override;
    void changeEvent(QEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    enum class Drag { none, cursor, move };
    struct Look;
    QRectF whole() const;
    QRectF frame(const QSize& size, bool titled) const;
    QPointF place_of(double x, double y, const QRectF& in) const;
    double x_at(double pixel) const;
    void hold_view();
    void redraw(); ///< everything, not the cursor alone
    Look look() const;
    void paint(QPainter& p, const QSize& size, const Look& look, bool exported) const;
    void paint_axes(QPainter& p, const QRectF& in, const Look& look) const;
    void paint_series(QPainter& p, const QRectF& in, const Look& look, std::size_t k) const;
    void paint_key(QPainter& p, const QRectF& in, const Look& look) const;

    PlotContent content_;
    QString empty_text_;
    QRectF whole_{0, 0, 1, 1},
        view_{0, 0, 1, 1}; ///< x from left to right, y from top (the low end) to bottom
    std::optional<double> cursor_;
    Drag drag_ = Drag::none;
    QPointF last_;
    QPixmap cache_; ///< all but the cursor
    bool drawn_ = false;
};

} // namespace facetmill::ui
