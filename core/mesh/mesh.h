// The triangle mesh that everything plans on: flat arrays, for the kernels. Any mesh that could be read has
// one, also an open, non-manifold, inverted or partly degenerate one; connectivity as half-edges is built
// beside it where the mesh allows (topology.h). Millimetres, part coordinates. Immutable once published
// (shared_ptr<const Mesh>).
#pragma once

#include "core/base/vec.h"

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

namespace facetmill {

using Index = std::uint32_t;
inline constexpr Index no_index = 0xFFFFFFFFu;

using Facet = std::array<Index, 3>;

struct Mesh {
    std::vector<Vec3> vertices;
    std::vector<Facet> facets; ///< corners counter-clockwise seen from outside

    std::size_t facet_count() const { return facets.size(); }
    const Vec3& corner(std::size_t facet, int k) const { return vertices[facets[facet][std::size_t(k)]]; }
    Vec3 facet_cross(std::size_t f) const {
        return (corner(f, 1) - corner(f, 0)).cross(corner(f, 2) - corner(f, 0));
    }
    /// Unit normal by the winding; zero for a degenerate facet.
    Vec3 facet_normal(std::size_t f) const {
        const Vec3 n = facet_cross(f);
        const double length = n.norm();
        return length > 0.0 ? Vec3(n / length) : Vec3(Vec3::Zero());
    }
    Box3 box() const {
        Box3 b;
        for (const Facet& f : facets)
            for (Index v : f)
                b.add(vertices[v]);
        return b;
    }
};

/// Adds the vertices and facets of another mesh behind its own.
inline void append_mesh(Mesh& mesh, const Mesh& more) {
    const auto first = Index(mesh.vertices.size());
    mesh.vertices.insert(mesh.vertices.end(), more.vertices.begin(), more.vertices.end());
    for (const Facet& f : more.facets)
        mesh.facets.push_back({first + f[0], first + f[1], first + f[2]});
}

using MeshPtr = std::shared_ptr<const Mesh>;

} // namespace facetmill
