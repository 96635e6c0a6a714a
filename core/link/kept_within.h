// Passes within a boundary: what of a path keeps the place where the cutter touches, the tip, or all of the
// cutter in the region of a boundary. Millimetres, part coordinates.
#pragma once

#include "core/link/pass_pieces.h"
#include "core/strategy/surface/boundary_region.h"

namespace facetmill {

/// Leaves out what of the passes is not within. Places along a pass are looked at a twentieth of
/// the cutter's radius apart; an upright tool's end at borders, found to a thousandth, a tilted one's at
/// locations. Between pieces the tool does not go along the surface outside. Contact points for clean-up that
/// lie outside are left out as well. Throws Error(empty_result) when nothing is left.
void keep_within(StrategyResult& path, const PlanContext& context, const OperationCommon& common,
                 const KeptWithin& within, const Progress& progress);

} // namespace facetmill
