// Lines of one value over a field on a grid, as polylines seen from above. Millimetres.
#pragma once

#include "core/base/progress.h"
#include "core/strategy/scallop/metric_grid.h"

#include <span>
#include <vector>

namespace facetmill {

struct FieldContour {
    std::vector<Vec2> places;
    bool closed = false; ///< goes on from the last to the first
    double value = 0;
    std::vector<std::size_t> corners; ///< of the grid's cells that it crosses
};

/// For every level, in ascending order: where it is passed, between places that are cut; each line once, in
/// an order that the field gives.
std::vector<std::vector<FieldContour>> field_contours(const MetricGrid& field,
                                                      const std::vector<double>& values,
                                                      std::span<const double> levels,
                                                      const Progress& progress);

} // namespace facetmill
