// Distances over a field, counted in steps, across its triangles (Qian et al. 2007 have their formula):
// fronts go on from the nearest places first, and again from those that come nearer.
#pragma once

#include "core/base/progress.h"
#include "core/strategy/scallop/metric_grid.h"

#include <vector>

namespace facetmill {

/// In steps from the nearest seed, once none changes by anything that counts against `settled`; infinite
/// where none is reached.
std::vector<double> field_distances(const MetricGrid& field, const std::vector<MetricGrid::Seed>& seeds,
                                    const Progress& progress, double settled = 1e-4);

} // namespace facetmill
