// The edges of a mesh with the facets on them: the one adjacency of meshes that need not be manifold, closed
// or wound alike. Where a half-edge structure is wanted instead, topology.h makes OpenMesh's from it.
#pragma once

#include "core/base/progress.h"
#include "core/mesh/mesh.h"

#include <span>
#include <vector>

namespace facetmill {

/// A side of a facet: side 3 f + k runs from corner k of facet f to its next corner. It is filed under the
/// lower of its two vertices, `high` is the other one; they are the same where the facet names a vertex
/// twice.
struct EdgeSide {
    Index high, side;

    Index facet() const { return side / 3; }
    Index corner() const { return side % 3; }
};

/// The vertex a side starts at, the one it ends at, and the corner of its facet that is not on it.
inline Index side_start(const Mesh& mesh, std::size_t side) {
    return mesh.facets[side / 3][side % 3];
}
inline Index side_end(const Mesh& mesh, std::size_t side) {
    return mesh.facets[side / 3][(side % 3 + 1) % 3];
}
inline Index side_across(const Mesh& mesh, std::size_t side) {
    return mesh.facets[side / 3][(side % 3 + 2) % 3];
}

/// All sides of a mesh, by their lower vertex, there by their higher one, and on an edge by number. Sides
/// that join the same two vertices, in whichever direction, are one edge.
class EdgeTable {
public:
    /// Linear in facets and vertices, whatever the valence. Throws Error(internal) for a facet that names a
    /// vertex which the mesh has not.
    EdgeTable(const Mesh& mesh, const Progress& progress);

    std::size_t vertex_count() const { return start_.size() - 1; }
    /// The sides whose lower vertex is `low`.
    std::span<const EdgeSide> sides(std::size_t low) const {
        return {sides_.data() + start_[low], sides_.data() + start_[low + 1]};
    }

    /// visit(high, sides) for each edge whose lower vertex is `low`, by ascending `high`.
    template <class Visit>
    void for_edges(std::size_t low, Visit&& visit) const {
        const auto all = sides(low);
        for (std::size_t i = 0, end = 0; i < all.size(); i = end) {
            while (end < all.size() && all[end].high == all[i].high)
                ++end;
            visit(all[i].high, all.subspan(i, end - i));
        }
    }

private:
    std::vector<Index> start_; ///< one more than vertices
    std::vector<EdgeSide> sides_;
};

} // namespace facetmill
