// Facets turned to agree: first with their neighbours, then outward.
#include "core/mesh/edge_table.h"
#include "core/mesh/outward.h"
#include "core/repair/doubles.h"
#include "core/repair/repair_step.h"

#include <algorithm>
#include <array>
#include <map>

namespace facetmill::detail {

namespace {

constexpr std::size_t turns_per_check = 20'000;

/// Across each side of each facet, where an edge has two facets, the other facet; and whether the two are
/// wound against each other.
struct Neighbors {
    std::vector<Index> across; ///< per side; no_index: none, or more than one
    std::vector<char> against;

    Neighbors(const Mesh& mesh, const Progress& progress)
        : across(3 * mesh.facet_count(), no_index), against(3 * mesh.facet_count(), 0) {
        const EdgeTable table(mesh, progress);
        for (std::size_t low = 0; low < table.vertex_count(); ++low) {
            if (low % turns_per_check == 0) progress.check();
            table.for_edges(low, [&](Index, std::span<const EdgeSide> sides) {
                if (sides.size() != 2 || sides[0].facet() == sides[1].facet()) return;
                const Index a = sides[0].side, b = sides[1].side;
                across[a] = sides[1].facet();
                across[b] = sides[0].facet();
                against[a] = against[b] = side_start(mesh, a) == side_start(mesh, b);
            });
        }
    }
};

/// Whether each facet is to be turned so that neighbours agree and in each patch the larger area stays as it
/// is; and the edges on which that is not possible (a strip with one side).
struct Agreement {
    std::vector<char> turned;
    std::size_t left = 0; ///< edges
};

Agreement agree(const Mesh& mesh, const Neighbors& neighbors, const Progress& progress) {
    const std::size_t n = mesh.facet_count();
    Agreement result;
    result.turned.assign(n, 0);
    std::vector<char> seen(n, 0);
    std::vector<Index> patch;
    for (std::size_t first = 0; first < n; ++first) {
        if (seen[first]) continue;
        patch.assign(1, Index(first));
        seen[first] = 1;
        double kept = 0, turned = 0;
        for (std::size_t i = 0; i < patch.size(); ++i) {
            if (i % turns_per_check == 0) progress.check();
            const Index f = patch[i];
            (result.turned[f] ? turned : kept) += mesh.facet_cross(f).norm();
            for (std::size_t s = 3 * std::size_t(f); s < 3 * std::size_t(f) + 3; ++s) {
                const Index g = neighbors.across[s];
                if (g == no_index) continue;
                const char wanted = char(result.turned[f] != neighbors.against[s]);
                if (!seen[g]) {
                    seen[g] = 1;
                    result.turned[g] = wanted;
                    patch.push_back(g);
                } else if (result.turned[g] != wanted && g > f) {
                    ++result.left;
                }
            }
        }
        if (turned > kept)
            for (const Index f : patch)
                result.turned[f] = !result.turned[f];
    }
    return result;
}

} // namespace

std::vector<char> doubled_facets(const Mesh& mesh, const Progress& progress) {
    // By the lowest vertex, there by the others: linear where vertices have few facets.
    const std::size_t vertices = mesh.vertices.size();
    std::vector<Index> start(vertices + 1, 0), order(mesh.facet_count());
    const auto lowest = [&](const Facet& f) { return std::min({f[0], f[1], f[2]}); };
    for (const Facet& f : mesh.facets)
        ++start[lowest(f) + 1];
    for (std::size_t v = 0; v < vertices; ++v)
        start[v + 1] += start[v];
    progress.check();
    std::vector<Index> next(start.begin(), start.end() - 1);
    for (std::size_t f = 0; f < mesh.facet_count(); ++f)
        order[next[lowest(mesh.facets[f])]++] = Index(f);
    std::vector<char> doubled(mesh.facet_count(), 0);
    const auto sorted = [&](Index f) {
        Facet key = mesh.facets[f];
        std::sort(key.begin(), key.end());
        return key;
    };
    for (std::size_t v = 0; v < vertices; ++v) {
        if (v % turns_per_check == 0) progress.check();
        const auto begin = order.begin() + start[v], end = order.begin() + start[v + 1];
        std::stable_sort(begin, end, [&](Index a, Index b) { return sorted(a) < sorted(b); });
        for (auto it = begin; it != end && it + 1 != end; ++it)
            if (sorted(*it) == sorted(*(it + 1))) doubled[*(it + 1)] = 1;
    }
    return doubled;
}

StepResult turn_facets(const Mesh& source, const RepairStep&, const Progress& progress) {
    StepResult result;
    // A sheet that is there twice has edges of more than two facets: there none could agree.
    const std::vector<char> doubled = doubled_facets(source, progress.part(0, 0.1));
    const auto doubles = std::size_t(std::count(doubled.begin(), doubled.end(), 1));
    auto mesh = std::make_shared<Mesh>(source);
    if (doubles > 0) {
        std::size_t to = 0;
        for (std::size_t f = 0; f < source.facet_count(); ++f)
            if (!doubled[f]) mesh->facets[to++] = source.facets[f];
        mesh->facets.resize(to);
    }
    const Neighbors neighbors(*mesh, progress.part(0.1, 0.3));
    const Agreement agreement = agree(*mesh, neighbors, progress.part(0.3, 0.4));
    const std::vector<Facet> before = mesh->facets;
    for (std::size_t f = 0; f < mesh->facet_count(); ++f)
        if (agreement.turned[f]) std::swap(mesh->facets[f][1], mesh->facets[f][2]);
    const OutwardSides sides = outward_sides(*mesh, progress.part(0.4, 1));
    std::size_t turned = 0;
    for (std::size_t f = 0; f < mesh->facet_count(); ++f) {
        const bool reversed = sides.sides[f] == OutwardSides::reversed;
        const bool changes = reversed != bool(agreement.turned[f]);
        turned += changes;
        // Turned twice it has the corner order that it came with.
        mesh->facets[f] = before[f];
        if (changes) std::swap(mesh->facets[f][1], mesh->facets[f][2]);
    }
    result.tell("turned", turned);
    result.tell_any("doubles_removed", doubles);
    result.tell_any("edges_left_against", agreement.left);
    if (turned > 0 || doubles > 0) result.mesh = std::move(mesh);
    return result;
}

} // namespace facetmill::detail
