// Closed forms of plane geometry that several rooms need.
#pragma once

#include "core/base/vec.h"

#include <algorithm>
#include <cmath>

namespace facetmill {

/// Angle that spreads any number of directions evenly when each is turned by it from the one before, radians.
inline constexpr double golden_angle = 2.399963229728653;

/// Angle between two vectors, [0, pi]; exact for small angles too, and 0 where one of them is zero.
inline double angle_between(const Vec3& a, const Vec3& b) {
    return std::atan2(a.cross(b).norm(), a.dot(b));
}

/// sqrt(a^2 - b^2), the other leg of the right triangle, without cancellation; 0 where b is larger.
inline double leg_length(double a, double b) {
    return std::sqrt(std::max(0.0, (a - b) * (a + b)));
}

/// Eigenvalues of a symmetric matrix of two rows, `high` not below `low`, and the angle from the first axis
/// to the eigenvector of `high`, radians in (-pi / 2, pi / 2].
struct PrincipalForm {
    double high, low, angle;
};
inline PrincipalForm principal_form(double xx, double xy, double yy) {
    const double middle = 0.5 * (xx + yy), half = 0.5 * (xx - yy), radius = std::hypot(half, xy);
    return {middle + radius, middle - radius, 0.5 * std::atan2(xy, half)};
}

} // namespace facetmill
