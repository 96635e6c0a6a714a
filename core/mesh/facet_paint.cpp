#include "core/mesh/facet_paint.h"

#include "core/mesh/edge_table.h"
#include "core/mesh/geometry_incidence.h"
#include "core/mesh/triangle_distance.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <queue>
#include <utility>

namespace facetmill {

namespace {

/// Facets on one edge that are all beside each other; of more, each is beside the next one.
constexpr std::size_t max_beside_all = 8;
constexpr std::size_t painted_per_check = 1u << 16;

/// link(a, b) for the facets on an edge.
template <class Link>
void link_sides(std::span<const EdgeSide> sides, Link&& link) {
    const std::size_t n = sides.size(), reach = n <= max_beside_all ? n : 2;
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t k = i + 1; k < std::min(n, i + reach); ++k)
            if (sides[i].facet() != sides[k].facet()) link(sides[i].facet(), sides[k].facet());
}

/// They run along an edge in the same direction: one of them is wound the other way.
bool wound_differently(const Facet& a, const Facet& b) {
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t k = 0; k < 3; ++k)
            if (a[i] == b[k] && a[(i + 1) % 3] == b[(k + 1) % 3]) return true;
    return false;
}

} // namespace

FacetNeighbours::FacetNeighbours(const Mesh& mesh, const Progress& progress) {
    const EdgeTable edges(mesh, progress.part(0, 0.5));
    const auto each = [&](auto&& link) {
        for (std::size_t low = 0; low < edges.vertex_count(); ++low) {
            if (low % painted_per_check == 0) progress.check();
            edges.for_edges(low, [&](Index, std::span<const EdgeSide> sides) { link_sides(sides, link); });
        }
    };
    start_.assign(mesh.facet_count() + 2, 0);
    each([&](Index a, Index b) {
        ++start_[a + 2];
        ++start_[b + 2];
    });
    for (std::size_t f = 2; f < start_.size(); ++f)
        start_[f] += start_[f - 1];
    neighbours_.resize(start_.back());
    // Each facet's place goes from where its own begin to where the next one's do.
    each([&](Index a, Index b) {
        neighbours_[start_[a + 1]++] = b;
        neighbours_[start_[b + 1]++] = a;
    });
    start_.pop_back();
    progress.set(1);
}

FacetPainter::FacetPainter(MeshPtr mesh, const Progress& progress)
    : mesh_(std::move(mesh)), neighbours_(*mesh_, progress), seen_(mesh_->facet_count(), 0) {}

template <class Take>
std::vector<Index> FacetPainter::spread(Index facet, Take&& take) {
    if (++search_ == 0) { // counted once round
        std::fill(seen_.begin(), seen_.end(), 0);
        search_ = 1;
    }
    std::vector<Index> taken{facet};
    seen_[facet] = search_;
    for (std::size_t i = 0; i < taken.size(); ++i)
        for (const Index next : neighbours_.of(taken[i]))
            if (seen_[next] != search_ && take(i, taken[i], next)) {
                seen_[next] = search_;
                taken.push_back(next);
            }
    return taken;
}

std::vector<Index> FacetPainter::brush(Index facet, const Vec3& at, double radius) {
    return spread(facet, [&, r2 = radius * radius](std::size_t, Index, Index f) {
        return squared_distance(at, mesh_->corner(f, 0), mesh_->corner(f, 1), mesh_->corner(f, 2)) <= r2;
    });
}

std::vector<Index> FacetPainter::flood(Index facet, double angle) {
    const double least = std::cos(angle);
    // Of those taken, in their order; of one without area the normal of where it was reached from.
    std::vector<Vec3> normals{mesh_->facet_normal(facet)};
    return spread(facet, [&](std::size_t place, Index from, Index to) {
        const Vec3 here = normals[place];
        Vec3 there = mesh_->facet_normal(to);
        if (there == Vec3::Zero()) {
            there = here;
        } else if (here != Vec3::Zero()) {
            const double along = here.dot(there);
            if ((wound_differently(mesh_->facets[from], mesh_->facets[to]) ? -along : along) < least)
                return false;
        }
        normals.push_back(there);
        return true;
    });
}

std::vector<Index> ring_round(const Mesh& mesh, const std::vector<char>& marks, bool of, double distance,
                              const Progress& progress) {
    std::vector<double> away(mesh.vertices.size(), infinity);
    for (std::size_t f = 0; f < mesh.facet_count(); ++f)
        if (bool(marks[f]) == of)
            for (const Index v : mesh.facets[f])
                away[v] = 0;
    if (distance > 0) {
        const VertexFacets incident = facets_around_vertices(mesh, progress);
        using Reached = std::pair<double, Index>; // a vertex and how far it is
        std::priority_queue<Reached, std::vector<Reached>, std::greater<>> open;
        // From those on the border alone: beyond the others nothing is to be found.
        for (std::size_t v = 0; v < away.size(); ++v) {
            const auto around = incident.around(v);
            if (away[v] == 0
                && std::any_of(around.begin(), around.end(), [&](Index f) { return bool(marks[f]) != of; }))
                open.emplace(0, Index(v));
        }
        for (std::size_t n = 0; !open.empty(); ++n) {
            if (n % painted_per_check == 0) progress.check();
            const auto [far, v] = open.top();
            open.pop();
            if (far > away[v]) continue;
            for (const Index f : incident.around(v))
                for (const Index w : mesh.facets[f]) {
                    const double there = far + (mesh.vertices[w] - mesh.vertices[v]).norm();
                    if (there > distance || there >= away[w]) continue;
                    away[w] = there;
                    open.emplace(there, w);
                }
        }
    }
    std::vector<Index> found;
    for (std::size_t f = 0; f < mesh.facet_count(); ++f) {
        const auto near = [&](Index v) { return away[v] <= distance; };
        const Facet& corners = mesh.facets[f];
        if (bool(marks[f]) != of && std::any_of(corners.begin(), corners.end(), near))
            found.push_back(Index(f));
    }
    return found;
}

} // namespace facetmill
