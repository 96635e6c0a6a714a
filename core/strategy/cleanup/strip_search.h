// The strips of a clean-up: valleys and hollows that the previous cutter left, creases sharper than a limit,
// and places that operations before left. Millimetres, part coordinates.
#pragma once

#include "core/strategy/cleanup/cleanup_job.h"
#include "core/strategy/cleanup/left_strip.h"

#include <optional>

namespace facetmill {

struct FoundStrip {
    StripKind kind;
    std::optional<ValleyCurve> curve; ///< none: a hollow, or places that were left
    RestBand band;
    LeftStrip left; ///< only around places that were left: `band` has its facets
};

/// Throws Error(limit_exceeded).
std::vector<FoundStrip> find_strips(const CleanupJob& job, const Progress& progress);

/// The strips as a result gives them: with names, reasons, and which of them are switched off; yet without
/// their bands, which are needed where they are until all is planned.
std::vector<Strip> described(const CleanupJob& job, const std::vector<FoundStrip>& found);

} // namespace facetmill
