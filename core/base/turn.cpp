#include "core/base/turn.h"

namespace facetmill {

Eigen::Quaterniond turn_between(const Vec3& from, const Vec3& to) {
    return Eigen::Quaterniond::FromTwoVectors(from, to);
}

} // namespace facetmill
