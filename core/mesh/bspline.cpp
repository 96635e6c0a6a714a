#include "core/mesh/bspline.h"

#include "core/base/error.h"

#include <algorithm>

namespace facetmill {

CubicBSpline::CubicBSpline(std::vector<Vec2> poles) : poles_(std::move(poles)) {
    if (poles_.size() < 4)
        throw Error(ErrorCode::internal, "cubic B-spline", "fewer than four poles",
                    "give at least four poles");
}

double CubicBSpline::knot(int i) const {
    return std::clamp(double(i - 3) / spans(), 0.0, 1.0);
}

CurvePoint2 CubicBSpline::evaluate(double t) const {
    t = std::clamp(t, 0.0, 1.0);
    const int span = std::min(int(t * spans()), spans() - 1);
    // De Boor's triangle: the differences of its two lower rows give the derivatives.
    std::array<Vec2, 4> d;
    for (int j = 0; j < 4; ++j)
        d[std::size_t(j)] = poles_[std::size_t(span + j)];
    CurvePoint2 result;
    for (int level = 1; level <= 3; ++level) {
        if (level == 2) {
            // Rows after one step: points of the polar form f(t, ., .); d2 = 6 (second difference over its
            // knots).
            const Vec2 a = (d[2] - d[1]) / (knot(span + 4) - knot(span + 2));
            const Vec2 b = (d[3] - d[2]) / (knot(span + 5) - knot(span + 3));
            result.d2 = 6.0 * (b - a) / (knot(span + 4) - knot(span + 3));
        } else if (level == 3) {
            result.d1 = 3.0 * (d[3] - d[2]) / (knot(span + 4) - knot(span + 3));
        }
        for (int j = 3; j >= level; --j) {
            const double lo = knot(span + j), hi = knot(span + j + 4 - level);
            const double w = (t - lo) / (hi - lo);
            d[std::size_t(j)] = (1.0 - w) * d[std::size_t(j - 1)] + w * d[std::size_t(j)];
        }
    }
    result.point = d[3];
    return result;
}

} // namespace facetmill
