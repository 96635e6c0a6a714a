// Holes of a mesh, filled one by one. Internal to the room.
#pragma once

#include "core/mesh/geometry_incidence.h"
#include "core/repair/holes.h"
#include "core/repair/patch.h"
#include "core/repair/recipe.h"

#include <unordered_set>

namespace facetmill::detail {

class HoleFiller {
public:
    /// The mesh with the holes; it must outlive this.
    HoleFiller(const Mesh& source, const Progress& progress);

    /// Adds vertices and facets to `mesh`, which began as a copy of the source. False, and nothing added,
    /// where no facets fit, or where they would lie on the surface's own back: the rim of a flat sheet is no
    /// hole in it.
    bool fill(const Hole& hole, RepairStep::Fill kind, Mesh& mesh, const Progress& progress);

private:
    bool has_edge(Index a, Index b) const;
    PatchRim rim_of(const Hole& hole) const;

    const Mesh& source_;
    const VertexFacets around_;
    std::unordered_set<std::uint64_t> added_; ///< edges between vertices of the source
};

} // namespace facetmill::detail
