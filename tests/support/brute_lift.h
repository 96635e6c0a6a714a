// The reference for axial lifts: slow and obviously right. The cutter's lower surface g(rho) is convex, so
// over an edge or a facet, cut to the cutter's disc, the lift z - g(rho) is a concave function: a
// golden-section search finds its maximum, in one variable along an edge, in two (one inside the other) over
// a facet. Extended precision; every facet; no closed form, no index, no code of the kernel.
#pragma once

#include "core/cutter/cutter.h"
#include "core/mesh/mesh.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace facetmill::test {

/// The lower surface of a cutter straight from the APT letters, or from any convex function.
class BruteCutter {
public:
    using Real = long double;
    explicit BruteCutter(const AptCutter& cutter);
    BruteCutter(std::function<Real(Real)> g, Real max_radius);

    /// g(rho) for 0 <= rho <= radius().
    Real height(Real rho) const {
        if (function_) return function_(rho);
        if (rho <= rho_a_) return rho * bottom_;
        if (rho <= rho_b_) return f_ - std::sqrt(std::max(Real(0), (r_ - (rho - e_)) * (r_ + (rho - e_))));
        return corner_z_ + (rho - corner_) / side_;
    }
    Real radius() const { return radius_; }

private:
    std::function<Real(Real)> function_;
    Real r_ = 0, e_ = 0, f_ = 0, bottom_ = 0, side_ = 0, corner_ = 0, corner_z_ = 0;
    Real rho_a_ = 0, rho_b_ = 0; ///< where the bottom gives over to the circle, and the circle to the side
    Real radius_ = 0;
};

/// -inf where the mesh is not under the cutter. Of a facet that gives nothing above `floor` any value up to
/// there will do.
double brute_lift(const BruteCutter& cutter, const Vec3& a, const Vec3& b, const Vec3& c, double x, double y,
                  double floor = -infinity);
double brute_lift(const BruteCutter& cutter, const Mesh& mesh, double x, double y);

} // namespace facetmill::test
