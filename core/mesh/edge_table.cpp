#include "core/mesh/edge_table.h"

#include "core/base/error.h"
#include "core/base/parallel.h"

#include <algorithm>
#include <array>
#include <numeric>

namespace facetmill {

namespace {

/// Facets, or vertices, between two looks at whether the job was cancelled.
constexpr std::size_t edges_per_check = 20'000;

/// By the higher vertex; sides that share it keep their order, which is that of their numbers.
void sort_by_high(std::span<EdgeSide> sides, const Progress& progress) {
    const auto by_high = [](const EdgeSide& a, const EdgeSide& b) { return a.high < b.high; };
    if (sides.size() <= 24) { // nearly always; sorting by insertion is the fastest here
        for (std::size_t i = 1; i < sides.size(); ++i) {
            const EdgeSide s = sides[i];
            std::size_t j = i;
            for (; j > 0 && sides[j - 1].high > s.high; --j)
                sides[j] = sides[j - 1];
            sides[j] = s;
        }
        return;
    }
    if (sides.size() <= 50'000) {
        std::stable_sort(sides.begin(), sides.end(), by_high);
        return;
    }
    // One vertex of a million facets: by bytes, so that a cancel is seen between the rounds.
    std::vector<EdgeSide> sorted(sides.size());
    for (int shift = 0; shift < 32; shift += 8) {
        progress.check();
        std::array<std::size_t, 257> place{};
        for (const EdgeSide& s : sides)
            ++place[((s.high >> shift) & 0xFF) + 1];
        std::partial_sum(place.begin(), place.end(), place.begin());
        for (const EdgeSide& s : sides)
            sorted[place[(s.high >> shift) & 0xFF]++] = s;
        std::copy(sorted.begin(), sorted.end(), sides.begin());
    }
}

} // namespace

EdgeTable::EdgeTable(const Mesh& mesh, const Progress& progress) {
    const std::size_t facets = mesh.facet_count(), vertices = mesh.vertices.size();
    start_.assign(vertices + 1, 0);
    for (std::size_t f = 0; f < facets; ++f) {
        if (f % edges_per_check == 0) progress.check();
        const Facet& v = mesh.facets[f];
        if (std::max({v[0], v[1], v[2]}) >= vertices)
            throw Error(ErrorCode::internal, "facet " + std::to_string(f),
                        "names a vertex that the mesh has not", "report the part");
        for (std::size_t k = 0; k < 3; ++k)
            ++start_[std::min(v[k], v[(k + 1) % 3]) + 1];
    }
    for (std::size_t v = 0; v < vertices; ++v)
        start_[v + 1] += start_[v];
    sides_.resize(3 * facets);
    {
        std::vector<Index> next(start_.begin(), start_.end() - 1);
        for (std::size_t f = 0; f < facets; ++f) {
            if (f % edges_per_check == 0) progress.check();
            const Facet& v = mesh.facets[f];
            for (std::size_t k = 0; k < 3; ++k) {
                const Index a = v[k], b = v[(k + 1) % 3];
                sides_[next[std::min(a, b)]++] = {std::max(a, b), Index(3 * f + k)};
            }
        }
    }
    parallel_blocks(
        vertices, edges_per_check, progress.part(0.5, 1), [&](std::size_t begin, std::size_t end) {
            for (std::size_t v = begin; v < end; ++v)
                sort_by_high({sides_.data() + start_[v], sides_.data() + start_[v + 1]}, progress);
        });
}

} // namespace facetmill
