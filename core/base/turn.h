// Turns of directions.
#pragma once

#include "core/base/vec.h"

namespace facetmill {

/// The shortest turn that takes the direction of `from` to that of `to`, neither of which is zero. Stands in
/// a file of its own: Eigen decides opposite directions by a singular value decomposition, which takes longer
/// to compile than most files here.
Eigen::Quaterniond turn_between(const Vec3& from, const Vec3& to);

} // namespace facetmill
