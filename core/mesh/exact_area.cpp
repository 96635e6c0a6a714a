#include "core/mesh/exact_area.h"

#include "core/mesh/exact_sum.h"

#include <cmath>
#include <limits>

namespace facetmill::detail {

namespace {

bool zero_determinant(double ax, double ay, double bx, double by, double cx, double cy) {
    const ExactDifference ux(bx, ax), uy(by, ay), vx(cx, ax), vy(cy, ay);
    ExactSum<24> sum;
    for (const double x : {ux.high, ux.low})
        for (const double y : {vy.high, vy.low})
            sum.add_product(x, y);
    for (const double y : {uy.high, uy.low})
        for (const double x : {vx.high, vx.low})
            sum.add_product(-y, x);
    return sum.zero();
}

} // namespace

bool exactly_collinear(const Vec3& a, const Vec3& b, const Vec3& c) {
    constexpr double bound = 8.0 * std::numeric_limits<double>::epsilon();
    const Vec3 u = b - a, v = c - a;
    for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3;
        const double left = u[i] * v[j], right = u[j] * v[i];
        if (std::abs(left - right) > bound * (std::abs(left) + std::abs(right))) return false;
    }
    return zero_determinant(a.x(), a.y(), b.x(), b.y(), c.x(), c.y())
           && zero_determinant(a.y(), a.z(), b.y(), b.z(), c.y(), c.z())
           && zero_determinant(a.z(), a.x(), b.z(), b.x(), c.z(), c.x());
}

} // namespace facetmill::detail
