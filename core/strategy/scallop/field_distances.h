// Distances over a field, counted in steps: the fast sweeping method over its triangles (Tsai et al. 2003,
// Qian et al. 2007).
#pragma once

#include "core/base/progress.h"
#include "core/strategy/scallop/metric_grid.h"

#include <vector>

namespace facetmill {

/// In steps from the nearest seed, once no round of sweeps changes them by more than `settled`; infinite
/// where none is reached.
std::vector<double> field_distances(const MetricGrid& field, const std::vector<MetricGrid::Seed>& seeds,
                                    const Progress& progress, double settled = 1e-4);

} // namespace facetmill
