// Turns of directions.
#pragma once

#include "core/base/vec.h"

namespace facetmill {

/// The shortest turn that takes the direction of `from` to that of `to`, neither of which is zero. Opposite
/// directions are turned half way round about Z, or about X where they are closer to Z than 45 degrees, as
/// far as those are square to them.
Eigen::Quaterniond turn_between(const Vec3& from, const Vec3& to);

} // namespace facetmill
