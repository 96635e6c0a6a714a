// Lift of a convex body of revolution along any unit vector w over a vertex, an edge and a facet (Lu
// 3.126-3.188, rebuilt). Everything in the body's frame: its axis is z, and w = (wx, 0, wz) with wx >= 0.
//
// The lift over a point q is the largest s with q - s w in the (closed) body; over an edge or a facet the
// largest over its points. -inf where the body passes the element by. README.md has the formulas.
#pragma once

#include "core/base/vec.h"
#include "core/gouge/revolved_body.h"

namespace facetmill {

/// A lift, and where on the mesh and on the body (its chain's piece) it comes from. The touched point of the
/// body is point - lift * w.
struct VectorElement {
    double lift = -infinity;
    Vec3 point = Vec3::Zero();
    unsigned piece = 0;
};

/// Unit vector along which the body is lifted, in the body's frame.
struct LiftVector {
    double wx = 0, wz = 1;
    Vec3 vec() const { return Vec3(wx, 0, wz); }
};

/// The lift over a vertex.
VectorElement vector_vertex_lift(const RevolvedBody& body, const LiftVector& w, const Vec3& q);

/// Where the inside of the edge is touched; -inf where the highest lift of its line lies at or beyond an end
/// (then the end's own lift is the edge's). `along` gets that place as a share of the edge, 0 at a;
/// not-a-number where the body passes the line by or the edge has no direction seen along w.
VectorElement vector_edge_lift(const RevolvedBody& body, const LiftVector& w, const Vec3& a, const Vec3& b,
                               double& along);

/// The lift over the whole closed facet: its inside, edges and corners. `none_above`: the caller needs no
/// lift that is not above this; such a lift may come back as anything that is not above it, and any other is
/// the same bits whatever `none_above` was. `feature`: how many corners span the touched element (1 vertex, 2
/// edge, 3 facet).
VectorElement vector_facet_lift(const RevolvedBody& body, const LiftVector& w, const Vec3& a, const Vec3& b,
                                const Vec3& c, double none_above, int& feature);

} // namespace facetmill
