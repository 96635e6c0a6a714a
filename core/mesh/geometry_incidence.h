// Facets around each vertex, for loops that gather per vertex: no scatter, hence the same bits for every
// thread count.
#pragma once

#include "core/base/progress.h"
#include "core/mesh/mesh.h"

#include <span>
#include <vector>

namespace facetmill {

struct VertexFacets {
    std::vector<Index> start; ///< one more than vertices
    std::vector<Index>
        facets; ///< ascending for each vertex; a facet that names a vertex twice stands there once

    std::span<const Index> around(std::size_t vertex) const {
        return {facets.data() + start[vertex], facets.data() + start[vertex + 1]};
    }
};

VertexFacets facets_around_vertices(const Mesh& mesh, const Progress& progress);

} // namespace facetmill
