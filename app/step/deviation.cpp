#include "app/step/deviation.h"

#include "core/mesh/triangle_distance.h"

#include <BRepAdaptor_Curve.hxx>
#include <BRepAdaptor_Surface.hxx>
#include <BRep_Tool.hxx>
#include <Poly_PolygonOnTriangulation.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <gp_Pnt.hxx>
#include <gp_Pnt2d.hxx>

#include <array>
#include <cmath>
#include <vector>

namespace facetmill::step {

namespace {

/// Share by which what lies between the places that are measured may exceed them.
constexpr double between_places = 0.1;
/// Divisions of a facet's sides where the surface lies far from it.
constexpr int fine_divisions = 6;
/// Share of the largest distance so far from which a facet is looked at more closely.
constexpr double far_share = 0.8;
/// Divisions of a chord of an edge.
constexpr int chord_divisions = 8;

Vec3 vec(const gp_Pnt& p) {
    return {p.X(), p.Y(), p.Z()};
}

struct FacetOnSurface {
    std::array<Vec3, 3> corners;
    std::array<gp_Pnt2d, 3> parameters;
    Vec3 normal = Vec3::Zero(); ///< unit
};

/// The place of the surface with the parameters of a place on the facet, barycentric.
void look(const FacetOnSurface& facet, const BRepAdaptor_Surface& surface, double a, double b, double c,
          Deviation& deviation) {
    const gp_XY uv =
        facet.parameters[0].XY() * a + facet.parameters[1].XY() * b + facet.parameters[2].XY() * c;
    const Vec3 p = vec(surface.Value(uv.X(), uv.Y()));
    const double d = std::sqrt(squared_distance(p, facet.corners[0], facet.corners[1], facet.corners[2]));
    double& side = (p - facet.corners[0]).dot(facet.normal) >= 0 ? deviation.out : deviation.in;
    side = std::max(side, d);
}

void look_coarsely(const FacetOnSurface& facet, const BRepAdaptor_Surface& surface, Deviation& deviation) {
    look(facet, surface, 1.0 / 3, 1.0 / 3, 1.0 / 3, deviation);
    look(facet, surface, 0.5, 0.5, 0, deviation);
    look(facet, surface, 0, 0.5, 0.5, deviation);
    look(facet, surface, 0.5, 0, 0.5, deviation);
}

void look_closely(const FacetOnSurface& facet, const BRepAdaptor_Surface& surface, Deviation& deviation) {
    for (int i = 0; i <= fine_divisions; ++i)
        for (int j = 0; i + j <= fine_divisions; ++j)
            look(facet, surface, double(i) / fine_divisions, double(j) / fine_divisions,
                 double(fine_divisions - i - j) / fine_divisions, deviation);
}

/// Parameters of nodes that the surface says nothing of: all along an edge that is a single point, a pole.
struct FreeParameters {
    std::vector<char> u, v; ///< for each node, from 1

    FreeParameters(const TopoDS_Face& face, const Poly_Triangulation& facets, const TopLoc_Location& at)
        : u(std::size_t(facets.NbNodes()) + 1, 0), v(u) {
        for (TopExp_Explorer e(face, TopAbs_EDGE); e.More(); e.Next()) {
            const TopoDS_Edge& edge = TopoDS::Edge(e.Current());
            if (!BRep_Tool::Degenerated(edge)) continue;
            const auto polygon = BRep_Tool::PolygonOnTriangulation(edge, &facets, at);
            gp_Pnt2d first, last;
            BRep_Tool::UVPoints(edge, face, first, last);
            const bool along_u = std::abs(first.X() - last.X()) > std::abs(first.Y() - last.Y());
            for (int i = 1; !polygon.IsNull() && i <= polygon->NbNodes(); ++i)
                (along_u ? u : v)[std::size_t(polygon->Node(i))] = 1;
        }
    }
};

/// A free parameter takes the mean of those that are not.
void settle(std::array<gp_Pnt2d, 3>& parameters, const std::array<int, 3>& nodes,
            const FreeParameters& free) {
    for (const bool of_u : {true, false}) {
        const auto& flags = of_u ? free.u : free.v;
        double sum = 0;
        int known = 0;
        for (std::size_t k = 0; k < 3; ++k)
            if (!flags[std::size_t(nodes[k])]) {
                sum += parameters[k].Coord(of_u ? 1 : 2);
                ++known;
            }
        for (std::size_t k = 0; k < 3 && known > 0; ++k)
            if (flags[std::size_t(nodes[k])]) parameters[k].SetCoord(of_u ? 1 : 2, sum / known);
    }
}

} // namespace

Deviation face_deviation(const TopoDS_Face& face, const Poly_Triangulation& facets, const TopLoc_Location& at,
                         double chord) {
    const BRepAdaptor_Surface surface(face, Standard_False);
    Deviation deviation;
    if (surface.GetType() == GeomAbs_Plane || !facets.HasUVNodes()) return deviation;
    const FreeParameters free(face, facets, at);
    const gp_Trsf place = at.Transformation();
    for (int t = 1; t <= facets.NbTriangles(); ++t) {
        std::array<int, 3> n{};
        facets.Triangle(t).Get(n[0], n[1], n[2]);
        FacetOnSurface facet;
        for (std::size_t k = 0; k < 3; ++k) {
            facet.corners[k] = vec(facets.Node(n[k]).Transformed(place));
            facet.parameters[k] = facets.UVNode(n[k]);
        }
        settle(facet.parameters, n, free);
        const Vec3 cross = (facet.corners[1] - facet.corners[0]).cross(facet.corners[2] - facet.corners[0]);
        if (!(cross.norm() > 0)) continue;
        facet.normal = cross.normalized();
        Deviation here;
        look_coarsely(facet, surface, here);
        if (here.larger() > far_share * std::max(deviation.larger(), chord))
            look_closely(facet, surface, here);
        deviation.add(here);
    }
    deviation.out *= 1 + between_places;
    deviation.in *= 1 + between_places;
    return face.Orientation() == TopAbs_REVERSED ? deviation.turned() : deviation;
}

double edge_deviation(const TopoDS_Edge& edge, const opencascade::handle<Poly_Triangulation>& facets,
                      const TopLoc_Location& at) {
    const auto polygon = BRep_Tool::PolygonOnTriangulation(edge, facets, at);
    if (polygon.IsNull() || !polygon->HasParameters() || BRep_Tool::Degenerated(edge)) return 0;
    const BRepAdaptor_Curve curve(edge);
    if (curve.GetType() == GeomAbs_Line) return 0;
    const gp_Trsf place = at.Transformation();
    double squared = 0;
    for (int i = 1; i < polygon->NbNodes(); ++i) {
        const Vec3 s = vec(facets->Node(polygon->Node(i)).Transformed(place)),
                   e = vec(facets->Node(polygon->Node(i + 1)).Transformed(place));
        const double from = polygon->Parameter(i), to = polygon->Parameter(i + 1);
        for (int k = 0; k < chord_divisions; ++k)
            squared = std::max(
                squared, squared_distance(vec(curve.Value(from + (to - from) * k / chord_divisions)), s, e));
    }
    return std::sqrt(squared) * (1 + between_places);
}

} // namespace facetmill::step
