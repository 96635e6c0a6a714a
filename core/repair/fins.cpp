// Fins: sheets that hang on the surface by edges of more than two facets and end in the open. They are left
// where two views of a scanner do not fit; no hole beside them can be filled.
#include "core/mesh/edge_table.h"
#include "core/mesh/facet_groups.h"
#include "core/repair/repair_step.h"

#include <algorithm>
#include <unordered_map>

namespace facetmill::detail {

namespace {

/// As long as taking fins away makes others of what they hung on.
constexpr int max_fin_rounds = 10;

/// Facets joined by edges that only two of them have.
struct HangingSheet {
    Box3 box;
    bool ends_open = false, hangs = false;
};

std::vector<char> fins_of(const Mesh& mesh, double size, const Progress& progress) {
    const EdgeTable edges(mesh, progress.part(0, 0.5));
    FacetGroups groups(mesh.facet_count());
    const auto each_edge = [&](const auto& visit) {
        for (std::size_t low = 0; low < edges.vertex_count(); ++low) {
            if (low % 65536 == 0) progress.check();
            edges.for_edges(low, [&](Index, std::span<const EdgeSide> sides) { visit(sides); });
        }
    };
    each_edge([&](std::span<const EdgeSide> sides) {
        if (sides.size() == 2) groups.join(sides[0].facet(), sides[1].facet());
    });
    std::unordered_map<Index, HangingSheet> sheets;
    for (std::size_t f = 0; f < mesh.facet_count(); ++f)
        for (int k = 0; k < 3; ++k)
            sheets[groups.of(Index(f))].box.add(mesh.corner(f, k));
    each_edge([&](std::span<const EdgeSide> sides) {
        for (const EdgeSide& side : sides) {
            HangingSheet& sheet = sheets[groups.of(side.facet())];
            sheet.ends_open = sheet.ends_open || sides.size() == 1;
            sheet.hangs = sheet.hangs || sides.size() > 2;
        }
    });
    std::vector<char> goes(mesh.facet_count(), 0);
    for (std::size_t f = 0; f < mesh.facet_count(); ++f) {
        const HangingSheet& sheet = sheets[groups.of(Index(f))];
        goes[f] = sheet.hangs && sheet.ends_open && sheet.box.diagonal() <= size;
    }
    return goes;
}

} // namespace

StepResult remove_fins(const Mesh& mesh, const RepairStep& step, const Progress& progress) {
    StepResult result;
    MeshPtr now;
    std::size_t removed = 0;
    for (int round = 0; round < max_fin_rounds; ++round) {
        const Mesh& before = now ? *now : mesh;
        std::vector<char> stays = fins_of(before, step.size, progress);
        const auto count = std::size_t(std::count(stays.begin(), stays.end(), 1));
        if (count == 0) break;
        removed += count;
        for (char& stay : stays)
            stay = !stay;
        now = with_facets(before, stays, progress);
        progress.set(double(round + 1) / max_fin_rounds);
    }
    result.tell("facets_removed", removed);
    result.mesh = std::move(now);
    return result;
}

} // namespace facetmill::detail
