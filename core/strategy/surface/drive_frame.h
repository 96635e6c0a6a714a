// The frame of parallel drive planes. Drive planes are vertical and parallel to the direction of travel:
//
//   u  along the direction of travel
//   v  across it, the step-over direction: 90 degrees counter-clockwise from u seen from +Z
//   z  up
//
// A drive plane is v = const. Right-handed; the origin is that of the part.
#pragma once

#include "core/base/tolerances.h"
#include "core/base/vec.h"

#include <cmath>

namespace facetmill {

struct DriveFrame {
    double angle = 0; ///< from X to u, radians
    Vec2 along = Vec2(1, 0), across = Vec2(0, 1);

    DriveFrame() = default;
    /// Multiples of 90 degrees give exact unit axes, so that planes parallel to x and y hit vertices exactly.
    explicit DriveFrame(double radians_from_x) : angle(radians_from_x) {
        double c = std::cos(radians_from_x), s = std::sin(radians_from_x);
        if (std::abs(c) < tolerance::axis_rounding) c = 0;
        if (std::abs(s) < tolerance::axis_rounding) s = 0;
        if (s == 0) c = c < 0 ? -1 : 1;
        if (c == 0) s = s < 0 ? -1 : 1;
        along = Vec2(c, s);
        across = Vec2(-s, c);
    }

    double u(const Vec3& p) const { return along.x() * p.x() + along.y() * p.y(); }
    double v(const Vec3& p) const { return across.x() * p.x() + across.y() * p.y(); }
    Vec2 xy(double u, double v) const { return u * along + v * across; }
    Vec3 point(double u, double v, double z) const {
        const Vec2 p = xy(u, v);
        return Vec3(p.x(), p.y(), z);
    }
};

} // namespace facetmill
