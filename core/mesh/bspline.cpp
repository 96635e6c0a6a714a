#include "core/mesh/bspline.h"

#include "core/base/error.h"

#include <algorithm>

namespace facetmill {

CubicBSpline::CubicBSpline(std::vector<Vec2> poles) : poles_(std::move(poles)) {
    if (poles_.size() < 4)
        throw Error(ErrorCode::internal, "cubic B-spline", "fewer than four poles",
                    "give at least four poles");
}

template <bool derivatives>
CurvePoint2 CubicBSpline::de_boor(double t) const {
    // In units of a span, where the knots are whole numbers: 0 0 0 0 1 .. n n n n.
    const int n = spans();
    const double s = std::clamp(t, 0.0, 1.0) * n;
    const int span = std::min(int(s), n - 1);
    const auto knot = [n, span](int i) { return double(std::clamp(span + i - 3, 0, n)); };
    std::array<Vec2, 4> d;
    for (std::size_t j = 0; j < 4; ++j)
        d[j] = poles_[std::size_t(span) + j];
    // De Boor's triangle; differences of its second last rows give the derivatives.
    CurvePoint2 result;
    for (int level = 1; level <= 3; ++level) {
        if (derivatives && level == 2) {
            const Vec2 a = (d[2] - d[1]) / (knot(4) - knot(2)), b = (d[3] - d[2]) / (knot(5) - knot(3));
            result.d2 = 6.0 * n * n * (b - a);
        } else if (derivatives && level == 3) {
            result.d1 = 3.0 * n * (d[3] - d[2]);
        }
        for (int j = 3; j >= level; --j) {
            const double lo = knot(j), hi = knot(j + 4 - level);
            const double w = (s - lo) / (hi - lo);
            d[std::size_t(j)] = (1.0 - w) * d[std::size_t(j - 1)] + w * d[std::size_t(j)];
        }
    }
    result.point = d[3];
    return result;
}

Vec2 CubicBSpline::point(double t) const {
    return de_boor<false>(t).point;
}
CurvePoint2 CubicBSpline::evaluate(double t) const {
    return de_boor<true>(t);
}

} // namespace facetmill
