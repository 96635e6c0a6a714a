// On which side of a plane a point lies, and whether triangles run through each other: exactly.
#pragma once

#include "core/base/vec.h"

#include <array>

namespace facetmill {

/// 1 where d lies on the side of the plane through a, b, c from which these are seen clockwise, -1 on the
/// other, 0 on it: the sign of (a - d) . ((b - d) x (c - d)) for the doubles as they are. In plain arithmetic
/// where its error bound allows (Shewchuk 1997), else with exact sums. Coordinates are 0 or between 1e-90 and
/// 1e90.
int exact_side(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);

/// Whether the insides of two triangles have a place in common and they do not lie in one plane: what only
/// touches, or has a side or a corner in common, does not cross. By the signs of volumes alone, exactly
/// (Devillers, Guigue, "Faster triangle-triangle intersection tests", 2002).
bool triangles_cross(const std::array<Vec3, 3>& t, const std::array<Vec3, 3>& u);

} // namespace facetmill
