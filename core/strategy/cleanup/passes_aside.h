// Passes of clean-up beside one that shank or holder keep the tool from. Millimetres, part coordinates,
// upright tools.
#pragma once

#include "core/strategy/cleanup/cleanup_job.h"

#include <vector>

namespace facetmill {

/// The pass moved level to either side by `far`, where that does not lift the tool: at the foot of a wall
/// away from it. What finishing left on the wall is not in the way of a shank as thick as its cutter there.
/// Clear of the part, and shank and holder too.
std::vector<Pass> passes_aside(const CleanupJob& job, const Pass& pass, double far, const Progress& progress);

} // namespace facetmill
