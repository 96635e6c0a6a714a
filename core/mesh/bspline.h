// Cubic B-spline curves with clamped, uniform knots: the section curves of Lu's benchmark surfaces.
#pragma once

#include "core/base/vec.h"

#include <array>
#include <vector>

namespace facetmill {

/// Point and first two derivatives by the parameter.
struct CurvePoint2 {
    Vec2 point = Vec2::Zero(), d1 = Vec2::Zero(), d2 = Vec2::Zero();
};

/// Plane cubic B-spline over [0, 1]; knots 0 0 0 0, 1/n .. (n-1)/n, 1 1 1 1 with n = poles - 3 spans. C2
/// everywhere, starts at the first pole and ends at the last. Unit weights.
class CubicBSpline {
public:
    /// Throws Error(internal) for fewer than four poles.
    explicit CubicBSpline(std::vector<Vec2> poles);

    /// `t` outside [0, 1] is clamped.
    Vec2 point(double t) const;
    CurvePoint2 evaluate(double t) const;
    int spans() const { return int(poles_.size()) - 3; }
    const std::vector<Vec2>& poles() const { return poles_; }

private:
    template <bool derivatives>
    CurvePoint2 de_boor(double t) const;
    std::vector<Vec2> poles_;
};

} // namespace facetmill
