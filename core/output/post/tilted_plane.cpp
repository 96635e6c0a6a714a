#include "core/output/post/tilted_plane.h"

#include <cmath>

namespace facetmill {

Mat3 TiltedPlane::frame() const {
    const double cz = std::cos(about_z), sz = std::sin(about_z), cx = std::cos(about_x),
                 sx = std::sin(about_x);
    Mat3 m;
    m << cz, -sz * cx, sz * sx, //
        sz, cz * cx, -cz * sx,  //
        0, sx, cx;
    return m;
}

TiltedPlane plane_across(const Vec3& axis) {
    const double across = std::hypot(axis.x(), axis.y());
    return {across > 0 ? std::atan2(axis.x(), -axis.y()) : 0, std::atan2(across, axis.z())};
}

} // namespace facetmill
