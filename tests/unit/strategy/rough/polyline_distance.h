// How far points are from a polyline.
#pragma once

#include "core/base/vec.h"

#include <algorithm>
#include <vector>

namespace facetmill::test {

/// Distance of p from the polyline through `points`; infinite where it has fewer than two.
inline double distance_to(const std::vector<Vec2>& points, const Vec2& p) {
    double nearest = infinity;
    for (std::size_t i = 1; i < points.size(); ++i) {
        const Vec2 d = points[i] - points[i - 1];
        const double square = d.squaredNorm();
        const double t = square > 0 ? std::clamp((p - points[i - 1]).dot(d) / square, 0.0, 1.0) : 0;
        nearest = std::min(nearest, (p - points[i - 1] - t * d).norm());
    }
    return nearest;
}

} // namespace facetmill::test
