// What holds the stock begins at its bottom: no path goes lower unless its operation allows it. Millimetres,
// part coordinates.
#pragma once

#include "core/cutter/cutter.h"
#include "core/strategy/plan/operation.h"

namespace facetmill {

/// The lowest height that a cutter of the operation may reach: the bottom of the stock, less what
/// `below_bottom` allows. Without a stock the part's bottom counts.
double lowest_allowed(const PlanContext& context, const OperationCommon& common);

/// How far below the tip's level the cutter reaches with this axis; 0 for +Z.
double reach_below_tip(const CutterProfile& profile, const Vec3& axis);

/// Keeps the cutter of a path at or above `lowest_allowed`. Tips of an upright tool are raised to it: that
/// takes nothing more from the part, neither where they are nor on the way between them, as the higher of a
/// straight line and a level is never above the line between the higher ends; where the way crosses the level
/// a location is added, or more than that would stay. Passes of a tilted tool end where it would be lower. A
/// warning tells what stays for it, and where the operation allows less than the stock's bottom, how far
/// below it the cutter goes. Throws Error(empty_result) when no pass is left.
void keep_above_bottom(StrategyResult& path, const PlanContext& context, const OperationCommon& common);

} // namespace facetmill
