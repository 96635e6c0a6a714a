// How far surfaces lie from the facets that stand for them.
#pragma once

#include <Poly_Triangulation.hxx>
#include <TopLoc_Location.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>

namespace facetmill::step {

/// mm; `out` is on the side that the normals of the face point to.
struct Deviation {
    double out = 0, in = 0;
    void add(const Deviation& more) {
        out = std::max(out, more.out);
        in = std::max(in, more.in);
    }
    double larger() const { return std::max(out, in); }
    Deviation turned() const { return {in, out}; }
};

/// Measured where the surface's parameters are those of places on the facets: at corners, along sides and
/// inside, more closely where it lies far from them; a tenth is added for what lies between those places.
/// Plane faces have none.
Deviation face_deviation(const TopoDS_Face& face, const Poly_Triangulation& facets, const TopLoc_Location& at,
                         double chord);
/// Largest distance of an edge's curve from the chords that stand for it on a face, mm.
double edge_deviation(const TopoDS_Edge& edge, const opencascade::handle<Poly_Triangulation>& facets,
                      const TopLoc_Location& at);

} // namespace facetmill::step
