// A frame about a tool axis, as the kernels want it.
#pragma once

#include "core/base/vec.h"

namespace facetmill {

/// Rows: two unit vectors that make a right-handed frame with the axis, and the axis. They turn steadily with
/// an axis that keeps away from -Z.
inline void set_frame(const Vec3& axis, double (&frame)[3][3]) {
    const double sign = axis.z() >= 0 ? 1 : -1, a = -1 / (sign + axis.z()), b = axis.x() * axis.y() * a;
    const Vec3 u(1 + sign * axis.x() * axis.x() * a, sign * b, -sign * axis.x());
    const Vec3 v(b, sign + axis.y() * axis.y() * a, -axis.y());
    for (int k = 0; k < 3; ++k) {
        frame[0][k] = u[k];
        frame[1][k] = v[k];
        frame[2][k] = axis[k];
    }
}

} // namespace facetmill
