#include "core/base/turn.h"

namespace facetmill {

namespace {

/// For directions whose cosine is below this, and so far from each other the cross product says too little
/// about the axis.
constexpr double nearly_opposite = -0.9999, no_axis = 1e-12;

Eigen::Quaterniond turn_to_nearly_opposite(const Vec3& a, const Vec3& b) {
    const Vec3 cross = a.cross(b);
    const double sine = cross.norm();
    Vec3 axis = sine > no_axis ? cross : a.z() * a.z() > 0.5 ? Vec3::UnitX() : Vec3::UnitZ();
    axis = (axis - axis.dot(a) * a).normalized();
    const double half = sine > no_axis ? 0.5 * std::atan2(sine, a.dot(b)) : 0.5 * pi;
    axis *= std::sin(half);
    return Eigen::Quaterniond(std::cos(half), axis.x(), axis.y(), axis.z());
}

} // namespace

Eigen::Quaterniond turn_between(const Vec3& from, const Vec3& to) {
    // What Eigen's FromTwoVectors computes but for nearly opposite directions: there it loses half of the
    // digits, and for opposite ones alone it instantiates a singular value decomposition, which takes longer
    // to compile than most files here.
    const Vec3 a = from.normalized(), b = to.normalized();
    const double cosine = b.dot(a);
    if (cosine < nearly_opposite) return turn_to_nearly_opposite(a, b);
    const double twice_w = std::sqrt((1 + cosine) * 2);
    const Vec3 axis = a.cross(b) * (1 / twice_w);
    return Eigen::Quaterniond(0.5 * twice_w, axis.x(), axis.y(), axis.z());
}

} // namespace facetmill
