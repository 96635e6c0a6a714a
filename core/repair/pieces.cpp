// Small pieces: shells, facets joined by edges, that are too small to be meant.
#include "core/mesh/edge_table.h"
#include "core/mesh/facet_groups.h"
#include "core/repair/repair_step.h"
#include "core/repair/shells.h"

#include <algorithm>

namespace facetmill {

namespace {

constexpr std::size_t facets_per_check = 20'000;

} // namespace

Shells shells_of(const Mesh& mesh, const Progress& progress) {
    FacetGroups groups(mesh.facet_count());
    const EdgeTable table(mesh, progress.part(0, 0.6));
    for (std::size_t low = 0; low < table.vertex_count(); ++low) {
        if (low % facets_per_check == 0) progress.check();
        table.for_edges(low, [&](Index, std::span<const EdgeSide> sides) {
            for (std::size_t i = 1; i < sides.size(); ++i)
                groups.join(sides[0].facet(), sides[i].facet());
        });
    }
    Shells result;
    result.of_facet.resize(mesh.facet_count());
    for (std::size_t f = 0; f < mesh.facet_count(); ++f) {
        if (f % facets_per_check == 0) progress.check();
        const Index root = groups.of(Index(f)); // the first facet of its shell
        if (root == f) {
            result.of_facet[f] = Index(result.all.size());
            result.all.emplace_back();
        } else {
            result.of_facet[f] = result.of_facet[root];
        }
        Shell& shell = result.all[result.of_facet[f]];
        ++shell.facets;
        shell.area += 0.5 * mesh.facet_cross(f).norm();
        for (int k = 0; k < 3; ++k)
            shell.box.add(mesh.corner(f, k));
    }
    return result;
}

std::vector<char> pieces_that_go(const Shells& shells, const RepairStep& step) {
    const std::size_t n = shells.all.size();
    std::vector<char> goes(n, 0);
    for (std::size_t s = 0; s < n; ++s) {
        const Shell& shell = shells.all[s];
        goes[s] = shell.facets < std::size_t(step.facets) || shell.area < step.area
                  || shell.box.diagonal() < step.size;
    }
    if (step.keep > 0) {
        std::vector<std::size_t> order(n);
        for (std::size_t s = 0; s < n; ++s)
            order[s] = s;
        std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
            return shells.all[a].area > shells.all[b].area;
        });
        for (std::size_t i = std::size_t(step.keep); i < n; ++i)
            goes[order[i]] = 1;
    }
    return goes;
}

namespace detail {

StepResult remove_pieces(const Mesh& mesh, const RepairStep& step, const Progress& progress) {
    const Shells shells = shells_of(mesh, progress.part(0, 0.8));
    const std::size_t n = shells.all.size();
    const std::vector<char> goes = pieces_that_go(shells, step);
    StepResult result;
    std::size_t pieces = 0, facets = 0;
    for (std::size_t s = 0; s < n; ++s)
        if (goes[s]) {
            ++pieces;
            facets += shells.all[s].facets;
        }
    result.tell("pieces_removed", pieces);
    result.tell("facets_removed", facets);
    result.tell("pieces_left", n - pieces);
    if (pieces == 0) return result;
    std::vector<char> stays(mesh.facet_count());
    for (std::size_t f = 0; f < mesh.facet_count(); ++f)
        stays[f] = !goes[shells.of_facet[f]];
    result.mesh = with_facets(mesh, stays, progress);
    return result;
}

} // namespace detail

} // namespace facetmill
