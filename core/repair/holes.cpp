#include "core/repair/holes.h"

#include "core/mesh/index_pair.h"
#include "core/mesh/topology.h"

#include <algorithm>
#include <unordered_set>

namespace facetmill {

namespace {

constexpr std::size_t max_measured_corners = 4000;

void measure(const Mesh& mesh, Hole& hole) {
    const std::size_t n = hole.loop.size();
    Box3 box;
    for (std::size_t i = 0; i < n; ++i) {
        const Vec3& p = mesh.vertices[hole.loop[i]];
        hole.perimeter += (mesh.vertices[hole.loop[(i + 1) % n]] - p).norm();
        hole.center += p / double(n);
        box.add(p);
    }
    hole.diameter = box.diagonal();
    if (n >= max_measured_corners) return;
    double farthest = 0;
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = i + 1; j < n; ++j)
            farthest =
                std::max(farthest, (mesh.vertices[hole.loop[i]] - mesh.vertices[hole.loop[j]]).squaredNorm());
    hole.diameter = std::sqrt(farthest);
}

/// A curve that comes to a vertex twice is two curves.
std::vector<Hole> parted(const std::vector<Index>& loop) {
    std::vector<Hole> holes;
    std::vector<Index> open;
    std::unordered_set<Index> seen;
    for (const Index v : loop) {
        if (!seen.insert(v).second) {
            const auto from = std::find(open.begin(), open.end(), v);
            Hole& hole = holes.emplace_back();
            hole.loop.assign(from, open.end());
            for (auto it = from + 1; it != open.end(); ++it)
                seen.erase(*it);
            open.erase(from + 1, open.end());
        } else {
            open.push_back(v);
        }
    }
    holes.emplace_back().loop = std::move(open);
    std::erase_if(holes, [](const Hole& hole) { return hole.loop.size() < 3; });
    return holes;
}

} // namespace

std::size_t hole_near(const std::vector<Hole>& holes, const Vec3& at) {
    std::size_t nearest = holes.size();
    double distance = infinity;
    for (std::size_t h = 0; h < holes.size(); ++h) {
        const double d = (holes[h].center - at).norm();
        if (d > 0.5 * holes[h].diameter || d >= distance) continue;
        distance = d;
        nearest = h;
    }
    return nearest;
}

HoleList holes_of(const Mesh& mesh, const Progress& progress) {
    const auto topology = build_topology(mesh, progress.part(0, 0.9));
    const HalfedgeMesh& half = topology->mesh;
    HoleList list;
    list.left_out = topology->left_out;
    // Edges of facets that are in no sheet: a border there is no end of the surface.
    std::unordered_set<std::uint64_t> shared;
    for (std::size_t f = 0, i = 0; f < mesh.facet_count() && topology->left_out > 0; ++f) {
        if (i < topology->facet_of.size() && topology->facet_of[i] == f) {
            ++i;
            continue;
        }
        const Facet& facet = mesh.facets[f];
        for (std::size_t k = 0; k < 3; ++k)
            shared.insert(pair_of(facet[k], facet[(k + 1) % 3]));
    }
    std::vector<char> seen(half.n_halfedges(), 0);
    for (const auto first : half.halfedges()) {
        if (!half.is_boundary(first) || seen[std::size_t(first.idx())]) continue;
        progress.check();
        Hole hole;
        bool ends = false;
        HalfedgeMesh::HalfedgeHandle h = first;
        do {
            seen[std::size_t(h.idx())] = 1;
            const Index from = topology->vertex_of[std::size_t(half.from_vertex_handle(h).idx())];
            const Index to = topology->vertex_of[std::size_t(half.to_vertex_handle(h).idx())];
            hole.loop.push_back(from);
            ends = ends || (!shared.empty() && shared.count(pair_of(from, to)) > 0);
            h = half.next_halfedge_handle(h);
        } while (h != first);
        if (ends) {
            ++list.sheet_ends;
            continue;
        }
        for (Hole& part : parted(hole.loop)) {
            measure(mesh, part);
            list.holes.push_back(std::move(part));
        }
    }
    std::stable_sort(list.holes.begin(), list.holes.end(),
                     [](const Hole& a, const Hole& b) { return a.diameter > b.diameter; });
    return list;
}

} // namespace facetmill
