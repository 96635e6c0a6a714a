#include "core/strategy/cleanup/border_touch.h"

#include "core/strategy/surface/surface_lines.h"

#include <algorithm>
#include <array>
#include <vector>

namespace facetmill {

namespace {

/// A touched point that is no farther from an edge lies on it, mm.
constexpr double on_edge = 1e-4;
/// Normals nearer to each other than this cosine differ by noise only.
constexpr double same_normal = 0.9945;

} // namespace

bool rolls_over_border(const Mesh& mesh, const FacetGrid& grid, const UpSide& side, const Vec3& touch,
                       const Vec3& normal) {
    std::vector<std::array<Index, 3>> found; // edge, facet
    grid.near(touch.head<2>(), on_edge, [&](Index f) {
        for (std::size_t k = 0; k < 3; ++k) {
            const Index a = mesh.facets[f][k], b = mesh.facets[f][(k + 1) % 3];
            if (distance_to_segment(touch, mesh.vertices[a], mesh.vertices[b]) <= on_edge)
                found.push_back({std::min(a, b), std::max(a, b), f});
        }
    });
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
    bool border = false;
    for (std::size_t i = 0; i < found.size();) {
        std::size_t end = i + 1;
        while (end < found.size() && found[end][0] == found[i][0] && found[end][1] == found[i][1])
            ++end;
        border = border || end == i + 1;
        i = end;
    }
    return border && std::none_of(found.begin(), found.end(), [&](const auto& edge) {
               return side.towards_tool(mesh.facet_normal(edge[2])).dot(normal) > same_normal;
           });
}

} // namespace facetmill
