#include "core/mesh/geometry.h"
#include "core/base/plane_geometry.h"

#include "core/base/parallel.h"
#include "core/base/tolerances.h"
#include "core/mesh/geometry_incidence.h"

#include <cmath>

namespace facetmill {

namespace {

/// Weighted normal of one facet at the corner where it meets `vertex`, and the weight.
struct Share {
    Vec3 sum = Vec3::Zero();
    double weight = 0.0;
};

Share facet_share(const Mesh& mesh, Index facet, Index vertex, NormalWeight weight) {
    const Vec3 cross = mesh.facet_cross(facet);
    const double twice_area = cross.norm();
    if (!(twice_area > 0.0)) return {};
    if (weight == NormalWeight::area) return {0.5 * cross, 0.5 * twice_area};
    const Facet& f = mesh.facets[facet];
    const std::size_t k = f[0] == vertex ? 0 : f[1] == vertex ? 1 : 2;
    const Vec3& p = mesh.vertices[vertex];
    const double angle = angle_between(mesh.vertices[f[(k + 1) % 3]] - p, mesh.vertices[f[(k + 2) % 3]] - p);
    return {cross * (angle / twice_area), angle};
}

/// True where the facet's least height is more than its corners' rounding.
bool has_sure_normal(const Mesh& mesh, Index facet) {
    const Vec3 &a = mesh.corner(facet, 0), &b = mesh.corner(facet, 1), &c = mesh.corner(facet, 2);
    const double longest =
        std::sqrt(std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()}));
    const double size = std::max({a.cwiseAbs().maxCoeff(), b.cwiseAbs().maxCoeff(), c.cwiseAbs().maxCoeff()});
    return (b - a).cross(c - a).norm() > tolerance::coordinate_rounding * size * longest;
}

} // namespace

std::vector<Vec3> vertex_normals(const Mesh& mesh, NormalWeight weight, const Progress& progress) {
    const VertexFacets around = facets_around_vertices(mesh, progress);
    std::vector<Vec3> normals(mesh.vertices.size());
    parallel_for(normals.size(), 20'000, progress, [&](std::size_t v) {
        Share sure, unsure;
        for (const Index f : around.around(v)) {
            const Share s = facet_share(mesh, f, Index(v), weight);
            Share& total = has_sure_normal(mesh, f) ? sure : unsure;
            total.sum += s.sum;
            total.weight += s.weight;
        }
        const Share& s = sure.weight > 0.0 ? sure : unsure;
        const double length = s.sum.norm();
        normals[v] = length > tolerance::vanishing_sum * s.weight ? Vec3(s.sum / length) : Vec3(Vec3::Zero());
    });
    return normals;
}

Vec3 edge_normal(const Vec3& n1, const Vec3& n2, double t) {
    const Vec3 n = n1 + (n2 - n1) * t;
    const double length = n.norm();
    return length > tolerance::vanishing_sum ? Vec3(n / length) : Vec3(Vec3::Zero());
}

std::shared_ptr<const MeshGeometry> compute_geometry(const Mesh& mesh, const Progress& progress) {
    auto geometry = std::make_shared<MeshGeometry>();
    geometry->facet_normals.resize(mesh.facet_count());
    parallel_for(mesh.facet_count(), 20'000, progress.part(0.0, 0.2),
                 [&](std::size_t f) { geometry->facet_normals[f] = mesh.facet_normal(f); });
    geometry->vertex_normals = vertex_normals(mesh, NormalWeight::angle, progress.part(0.2, 1.0));
    return geometry;
}

} // namespace facetmill
