#include "core/mesh/unused_vertices.h"

namespace facetmill {

void drop_unused_vertices(Mesh& mesh, const Progress& progress) {
    std::vector<Index> number(mesh.vertices.size(), no_index);
    for (const Facet& f : mesh.facets)
        for (const Index v : f)
            number[v] = 0;
    progress.check();
    Index next = 0;
    for (std::size_t v = 0; v < number.size(); ++v)
        if (number[v] == 0) {
            mesh.vertices[next] = mesh.vertices[v];
            number[v] = next++;
        }
    mesh.vertices.resize(next);
    progress.check();
    for (Facet& f : mesh.facets)
        for (Index& v : f)
            v = number[v];
}

} // namespace facetmill
