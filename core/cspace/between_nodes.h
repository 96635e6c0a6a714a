// Free postures between the nodes of a grid. Where the tool has little room a coarse grid may have no free
// node though some axis between nodes would do. Radians, mm, part coordinates.
#pragma once

#include "core/cspace/cspace.h"

#include <span>
#include <vector>

namespace facetmill {

/// Axes nearer to each other than this are not looked at: a grid of the usual step has them all.
inline const double finest_between_nodes = radians(2);

/// Free postures found from nodes that hold the strip and hit the part: the axis is turned away from what is
/// hit, and back by half as much where the tool hits the other side then, by no less than
/// `finest_between_nodes`. At most four; none says that none was found, not that there is none. `space`: of
/// `curves`, without a free node. The builder needs its grid.
std::vector<PostureValue> free_between_nodes(const CSpaceBuilder& builder, const CSpace& space,
                                             std::span<const RaisedCurve> curves);

} // namespace facetmill
