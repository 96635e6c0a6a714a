// What a chart shows (ui/plot_view.h): curves over one axis, with limits and marks.
#pragma once

#include <QString>

#include <vector>

namespace facetmill::ui {

struct PlotSeries {
    QString name;
    std::vector<double> y; ///< one per value of PlotContent::x; NaN parts the curve
    /// Places where something happens on the curve: indices into x, ascending.
    std::vector<std::size_t> marks;
    double low_limit, high_limit; ///< drawn as lines; not finite: none
};

/// Values as they are shown: in the units of the labels.
struct PlotContent {
    QString title; ///< on exported pictures
    QString x_label, y_label;
    std::vector<double> x; ///< ascending
    std::vector<PlotSeries> series;
    QString marks_label; ///< what the marks mean; empty where there are none
    bool dots = false;   ///< a dot at every value too
};

} // namespace facetmill::ui
