// Vectors and boxes. Core is millimetres, radians and double, in part coordinates, everywhere; other units
// exist only at the edges (files, forms, command line), see units.h.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <limits>
#include <numbers>

namespace facetmill {

using Vec2 = Eigen::Vector2d;
using Vec3 = Eigen::Vector3d;
using Mat3 = Eigen::Matrix3d;

inline constexpr double pi = std::numbers::pi;
inline constexpr double infinity = std::numeric_limits<double>::infinity();

/// Axis-aligned box. A default box is empty: lo = +inf, hi = -inf.
struct Box3 {
    Vec3 lo = Vec3::Constant(infinity);
    Vec3 hi = Vec3::Constant(-infinity);

    bool empty() const { return !(lo.x() <= hi.x() && lo.y() <= hi.y() && lo.z() <= hi.z()); }
    void add(const Vec3& p) {
        lo = lo.cwiseMin(p);
        hi = hi.cwiseMax(p);
    }
    void add(const Box3& b) {
        lo = lo.cwiseMin(b.lo);
        hi = hi.cwiseMax(b.hi);
    }
    Vec3 size() const { return empty() ? Vec3(Vec3::Zero()) : Vec3(hi - lo); }
    Vec3 center() const { return 0.5 * (lo + hi); }
    double diagonal() const { return size().norm(); }
};

/// Every number rounded to a float. Not cast<float>().cast<double>(): where g++ 12 converts two numbers at
/// once (-O3, and -O2 in places) it takes one conversion for the inverse of the other and drops both.
inline Vec3 rounded_to_float(const Vec3& v) {
    Vec3 rounded;
    for (int k = 0; k < 3; ++k) {
        const volatile float single = float(v[k]);
        rounded[k] = single;
    }
    return rounded;
}

inline double radians(double degrees) {
    return degrees * (pi / 180.0);
}
inline double degrees(double radians) {
    return radians * (180.0 / pi);
}

} // namespace facetmill
