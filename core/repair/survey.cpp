#include "core/repair/survey.h"

#include "core/mesh/edge_table.h"
#include "core/repair/crossings.h"
#include "core/repair/doubles.h"
#include "core/repair/needles.h"

#include <algorithm>

namespace facetmill {

Survey survey_mesh(const Mesh& mesh, const Progress& progress) {
    Survey survey;
    survey.shells = shells_of(mesh, progress.part(0, 0.2, "Looking for pieces"));
    survey.holes = holes_of(mesh, progress.part(0.2, 0.5, "Looking for holes"));
    const std::vector<char> doubled = detail::doubled_facets(mesh, progress.part(0.5, 0.6));
    survey.doubles = std::size_t(std::count(doubled.begin(), doubled.end(), 1));
    survey.needles = count_needles(mesh);
    const EdgeTable table(mesh, progress.part(0.6, 0.7));
    for (std::size_t low = 0; low < table.vertex_count(); ++low)
        table.for_edges(low, [&](Index, std::span<const EdgeSide> sides) {
            survey.non_manifold += sides.size() > 2;
            survey.against +=
                sides.size() == 2 && side_start(mesh, sides[0].side) == side_start(mesh, sides[1].side);
        });
    const auto pairs = crossing_facets(mesh, progress.part(0.7, 1, "Looking for crossings"));
    survey.crossings = pairs.size();
    std::vector<Index> facets;
    for (const auto& [f, g] : pairs) {
        facets.push_back(f);
        facets.push_back(g);
    }
    std::sort(facets.begin(), facets.end());
    survey.crossing_facets = std::size_t(std::unique(facets.begin(), facets.end()) - facets.begin());
    return survey;
}

} // namespace facetmill
