#include "core/mesh/geometry_incidence.h"

namespace facetmill {

VertexFacets facets_around_vertices(const Mesh& mesh, const Progress& progress) {
    constexpr std::size_t block = 65'536;
    VertexFacets around;
    around.start.assign(mesh.vertices.size() + 1, 0);
    const auto corners = [&mesh](std::size_t f, auto&& visit) {
        const auto [a, b, c] = mesh.facets[f];
        visit(a);
        if (b != a) visit(b);
        if (c != a && c != b) visit(c);
    };
    for (std::size_t f = 0; f < mesh.facet_count(); ++f) {
        if (f % block == 0) progress.check();
        corners(f, [&](Index v) { ++around.start[v + 1]; });
    }
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v)
        around.start[v + 1] += around.start[v];
    around.facets.resize(around.start.back());
    std::vector<Index> next(around.start.begin(), around.start.end() - 1);
    for (std::size_t f = 0; f < mesh.facet_count(); ++f) {
        if (f % block == 0) progress.check();
        corners(f, [&](Index v) { around.facets[next[v]++] = Index(f); });
    }
    return around;
}

} // namespace facetmill
