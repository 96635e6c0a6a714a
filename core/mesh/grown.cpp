#include "core/mesh/grown.h"

#include "core/mesh/edge_table.h"

#include <cmath>

namespace facetmill {

namespace {

constexpr int prism_sides = 8;
/// Facets whose normals have this cosine are one plane: the prism of their edge adds nothing.
constexpr double same_plane = 1 - 1e-14;

void add_facet(Mesh& mesh, const Vec3& a, const Vec3& b, const Vec3& c) {
    const auto first = Index(mesh.vertices.size());
    mesh.vertices.insert(mesh.vertices.end(), {a, b, c});
    mesh.facets.push_back({first, first + 1, first + 2});
}

/// A prism that holds the cylinder of this radius round an edge, beyond its ends by the radius: so it holds
/// half of the ball round each end, and the edges there hold the other half between them.
void add_prism(Mesh& mesh, const Vec3& from, const Vec3& to, double radius) {
    const Vec3 along = (to - from).normalized(), x = along.unitOrthogonal(), y = along.cross(x);
    const Vec3 a = from - radius * along, b = to + radius * along;
    const double r = radius / std::cos(pi / prism_sides);
    const auto corner = [&](int k) -> Vec3 {
        const double angle = 2 * pi * k / prism_sides;
        return r * (std::cos(angle) * x + std::sin(angle) * y);
    };
    for (int k = 0; k < prism_sides; ++k) {
        const Vec3 p = corner(k), q = corner(k + 1);
        add_facet(mesh, a + p, a + q, b + q);
        add_facet(mesh, a + p, b + q, b + p);
        if (k == 0 || k + 1 == prism_sides) continue;
        const Vec3 first = corner(0);
        add_facet(mesh, a + first, a + q, a + p);
        add_facet(mesh, b + first, b + p, b + q);
    }
}

} // namespace

Mesh grown_mesh(const Mesh& mesh, double by, const Progress& progress) {
    Mesh grown;
    for (std::size_t f = 0; f < mesh.facet_count(); ++f) {
        if (f % 4096 == 0) progress.check();
        const Vec3 n = by * mesh.facet_normal(f);
        const Vec3 &a = mesh.corner(f, 0), &b = mesh.corner(f, 1), &c = mesh.corner(f, 2);
        add_facet(grown, a + n, b + n, c + n);
        add_facet(grown, a - n, c - n, b - n);
    }
    const EdgeTable edges(mesh, progress);
    for (std::size_t low = 0; low < edges.vertex_count(); ++low) {
        if (low % 4096 == 0) progress.check();
        edges.for_edges(low, [&](Index high, std::span<const EdgeSide> sides) {
            if (high == low || mesh.vertices[low] == mesh.vertices[high]) return;
            const bool flat =
                sides.size() == 2
                && std::abs(mesh.facet_normal(sides[0].facet()).dot(mesh.facet_normal(sides[1].facet())))
                       > same_plane;
            if (!flat) add_prism(grown, mesh.vertices[low], mesh.vertices[high], by);
        });
    }
    return grown;
}

} // namespace facetmill
