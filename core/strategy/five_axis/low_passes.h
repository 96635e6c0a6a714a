// Passes of a leaning tool at the foot of the stock. Millimetres, part coordinates.
#pragma once

#include "core/strategy/plan/operation.h"

namespace facetmill {

/// Raises locations of leaning passes at which the cutter would be below `lowest_allowed` to that height,
/// then along the axis as far as it takes to cut nothing: at the foot of a wall a cutter as low as it may be
/// leaves less than one that stops above. That is done where the cutter's place stays within half its radius
/// of what it was to cut, where the machine reaches it, where motions to and from its neighbours keep clear
/// of the part, and where no other pass was raised to the same place. What is not raised stays as it is:
/// `keep_above_bottom` ends passes there. A warning tells. `holder_clearance`: of shank and holder, mm.
void raise_low_passes(StrategyResult& path, const PlanContext& context, const OperationCommon& common,
                      double holder_clearance);

/// Keeps the passes of an operation above the bottom of the stock: raises what is of use, then
/// `keep_above_bottom`.
void keep_passes_up(StrategyResult& path, const PlanContext& context, const Operation& operation);

} // namespace facetmill
