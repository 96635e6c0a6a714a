// Is a triangle exactly without area? Internal to the room.
#pragma once

#include "core/base/vec.h"

namespace facetmill::detail {

/// The three points, as the doubles they are, lie exactly on one line (or coincide). Decided in plain
/// arithmetic where its error bound allows, else with exact sums (Shewchuk 1997, expansions). Coordinates
/// must be finite and below 1e100; areas below about 1e-290 count as zero.
bool exactly_collinear(const Vec3& a, const Vec3& b, const Vec3& c);

} // namespace facetmill::detail
