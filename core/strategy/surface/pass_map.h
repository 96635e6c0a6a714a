// Where passes run that follow the surface, not planes: two numbers for every vertex of a mesh, linear over
// its facets, but for a jump where u begins anew. They stand for u and v of the drive planes (drive_frame.h):
// a pass is a line of equal v, and u grows along it.
#pragma once

#include "core/mesh/mesh.h"

#include <vector>

namespace facetmill {

/// Both are lengths: over nearly all of the surface neither changes by more than 1 mm per mm. So a distance
/// in u or v is no longer than the one on the surface, as with planes across a slope.
struct PassMap {
    std::vector<double> u, v;    ///< per vertex, mm
    std::vector<Vec3> gradients; ///< of v per facet, in the frame of the mesh, mm per mm
    double u_hi = 0;             ///< the largest u; the smallest is 0
    /// What u has grown by once round a piece that its lines go round; it begins anew at 0 there. 0: they do
    /// not. Then lines go on beyond a round, by a round at most, and u_hi is twice this.
    double period = 0;
    double steepest_u = 1; ///< the most that u changes by anywhere, mm per mm; at least 1
    /// The least that v changes by over nearly all of the surface, mm per mm; from `min_flattest` to 1.
    double flattest_v = 1;
    static constexpr double min_flattest = 1.0 / 8;
};

} // namespace facetmill
