// Passes without the places at which shank or holder would touch the part, or with the axis inclined there.
// Millimetres, part coordinates.
#pragma once

#include "core/strategy/cleanup/cleanup_job.h"
#include "core/strategy/tilt/axis_tilt.h"

namespace facetmill {

struct ClearedPasses {
    std::vector<Pass> passes;
    double held = 0;                   ///< length of what is left out
    ToolBody held_by = ToolBody::none; ///< what would touch there
    double largest_tilt = 0;
};

/// Says of every pass of an upright tool whether shank and holder are free along it.
std::vector<char> is_body_clear(const CleanupJob& job, const std::vector<Pass>& passes,
                                const Progress& progress);
ClearedPasses with_clear_body(const CleanupJob& job, const std::vector<Pass>& passes,
                              const Progress& progress);

} // namespace facetmill
