// How a chart is painted (ui/plot_view.h): axes, curves, limits, marks and key, without its cursor.
#pragma once

#include "ui/plot_content.h"

#include <QColor>
#include <QFont>
#include <QPointF>
#include <QRectF>
#include <QSize>

#include <array>

class QPainter;

namespace facetmill::ui {

struct PlotLook {
    QColor ground, ink, quiet, grid, cursor;
    std::array<QColor, 3> series;
    QFont font;
};

/// Where the curves are in a picture of this size. `view` is what is seen of either axis, here and below.
QRectF plot_frame(const QRectF& view, const QFont& font, const QSize& size, bool titled);
/// Where a place of the chart is in such a frame.
QPointF plot_place(const QRectF& view, const QRectF& frame, double x, double y);
void paint_plot(QPainter& p, const PlotContent& content, const QRectF& view, const QSize& size,
                const PlotLook& look, bool titled);

} // namespace facetmill::ui
