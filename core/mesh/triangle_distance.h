// Distances of a point from a segment and from a triangle.
#pragma once

#include "core/base/vec.h"

#include <algorithm>

namespace facetmill {

/// Squared distance of p from the segment from s to e, which may be a point.
inline double squared_distance(const Vec3& p, const Vec3& s, const Vec3& e) {
    const Vec3 d = e - s;
    const double length2 = d.squaredNorm();
    const double t = length2 > 0.0 ? std::clamp((p - s).dot(d) / length2, 0.0, 1.0) : 0.0;
    return (p - s - t * d).squaredNorm();
}

/// Squared distance of p from the triangle a b c, which may be without area (regions by barycentric signs:
/// Ericson, Real-Time Collision Detection, 5.1.5).
inline double squared_distance(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
    const Vec3 n = (b - a).cross(c - a);
    const double n2 = n.squaredNorm();
    if (n2 > 0.0 && (b - a).cross(p - a).dot(n) >= 0.0 && (c - b).cross(p - b).dot(n) >= 0.0
        && (a - c).cross(p - c).dot(n) >= 0.0) {
        const double h = (p - a).dot(n);
        return h * h / n2;
    }
    return std::min({squared_distance(p, a, b), squared_distance(p, b, c), squared_distance(p, c, a)});
}

} // namespace facetmill
