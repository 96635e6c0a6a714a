// What a clean-up's passes leave of its strips, measured against what the cutter could reach. Millimetres,
// part coordinates.
#pragma once

#include "core/strategy/cleanup/cleanup_job.h"
#include "core/strategy/cleanup/strip_search.h"

namespace facetmill {

struct UncutStrips {
    double area = 0;    ///< area of the strips, as they are measured
    double reached = 0; ///< the most that stays where the cutter can go
    /// The most that stays where the cutter is too large to go deeper, and where.
    double hollow = 0;
    Vec3 hollow_at = Vec3::Zero();
    /// Area on which more stays than the cutter must leave, the most that does, and where.
    double missed_area = 0, missed = 0;
    Vec3 missed_at = Vec3::Zero();
};

/// Strips that are switched off in `described` are left out.
UncutStrips measure_uncut(const CleanupJob& job, const std::vector<FoundStrip>& found,
                          const std::vector<Strip>& described, const std::vector<Pass>& passes,
                          const Progress& progress);

} // namespace facetmill
