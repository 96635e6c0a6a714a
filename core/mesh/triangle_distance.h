// Distances of a point from a segment and from a triangle, and the point of a triangle that is nearest to it.
#pragma once

#include "core/base/vec.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace facetmill {

namespace detail {

/// Squared distance of a place from the segment along d, which may be none, that begins `from` away from it.
inline double squared_distance_along(const Vec3& from, const Vec3& d) {
    const double length2 = d.squaredNorm();
    const double t = length2 > 0.0 ? std::clamp(from.dot(d) / length2, 0.0, 1.0) : 0.0;
    return (from - t * d).squaredNorm();
}

} // namespace detail

/// Squared distance of p from the segment from s to e, which may be a point.
inline double squared_distance(const Vec3& p, const Vec3& s, const Vec3& e) {
    return detail::squared_distance_along(p - s, e - s);
}

/// Whether p lies over the inside of the triangle a b c, whose normal is n, or over its edge.
inline bool lies_over(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& n) {
    return (b - a).cross(p - a).dot(n) >= 0.0 && (c - b).cross(p - b).dot(n) >= 0.0
           && (a - c).cross(p - c).dot(n) >= 0.0;
}

/// Squared distance of p from the triangle a b c, which may be without area (regions by barycentric signs:
/// Ericson, Real-Time Collision Detection, 5.1.5).
inline double squared_distance(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
    // Differences by name: in products of expressions each of their coordinates would be taken twice.
    const Vec3 ab = b - a, ac = c - a, bc = c - b, ca = a - c, ap = p - a, bp = p - b, cp = p - c;
    const Vec3 n = ab.cross(ac);
    const double n2 = n.squaredNorm();
    if (n2 > 0.0 && ab.cross(ap).dot(n) >= 0.0 && bc.cross(bp).dot(n) >= 0.0 && ca.cross(cp).dot(n) >= 0.0) {
        const double h = ap.dot(n);
        return h * h / n2;
    }
    return std::min({detail::squared_distance_along(ap, ab), detail::squared_distance_along(bp, bc),
                     detail::squared_distance_along(cp, ca)});
}

/// The point of the triangle a b c that is nearest to p, by the same regions.
inline Vec3 nearest_in_triangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
    const Vec3 n = (b - a).cross(c - a);
    const double n2 = n.squaredNorm();
    if (n2 > 0.0 && lies_over(p, a, b, c, n)) return p - (p - a).dot(n) / n2 * n;
    Vec3 best = a;
    double least = std::numeric_limits<double>::infinity();
    for (const auto& [s, e] : {std::pair(a, b), std::pair(b, c), std::pair(c, a)}) {
        const Vec3 d = e - s;
        const double length2 = d.squaredNorm();
        const double t = length2 > 0.0 ? std::clamp((p - s).dot(d) / length2, 0.0, 1.0) : 0.0;
        const Vec3 at = s + t * d;
        if (const double d2 = (p - at).squaredNorm(); d2 < least) {
            least = d2;
            best = at;
        }
    }
    return best;
}

} // namespace facetmill
