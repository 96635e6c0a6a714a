// The reference for axial lifts: slow and obviously right. The cutter's lower surface g(rho) is convex, so
// over an edge or a facet, cut to the cutter's disc, the lift z - g(rho) is a concave function: a
// golden-section search finds its maximum, in one variable along an edge, in two (one inside the other) over
// a facet. Extended precision; every facet; no closed form, no index, no code of the kernel.
#pragma once

#include "core/cutter/cutter.h"
#include "core/mesh/mesh.h"

#include <functional>

namespace facetmill::test {

/// The lower surface of a cutter straight from the APT letters (or from any convex function).
struct BruteCutter {
    explicit BruteCutter(const AptCutter& cutter);
    BruteCutter(std::function<long double(long double)> g, long double max_radius);

    std::function<long double(long double)> height; ///< g(rho) for 0 <= rho <= radius
    long double radius = 0;
};

/// -inf where the mesh is not under the cutter.
double brute_lift(const BruteCutter& cutter, const Vec3& a, const Vec3& b, const Vec3& c, double x, double y);
double brute_lift(const BruteCutter& cutter, const Mesh& mesh, double x, double y);

} // namespace facetmill::test
