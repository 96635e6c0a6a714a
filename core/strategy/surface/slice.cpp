#include "core/strategy/surface/slice.h"

#include "core/base/tolerances.h"

#include <cmath>
#include <unordered_map>

namespace facetmill {

namespace {

/// A vertex whose normal leans so much away from the facets of an edge belongs to a sharp edge. Its normal
/// says nothing of these facets: what lies between it and the edge's other end is as they are.
const double sharp_cosine = std::cos(radians(30));
/// Facets that are wound unlike, or meet at a ridge, have no normal in common.
constexpr double min_in_common = 0.5;

/// One cut edge: the point on it, and the cut facets that meet there.
struct Crossing {
    SlicePoint at;
    Index from = no_index, to = no_index; ///< the edge's ends, the lower index first
    double share = 0;                     ///< of the way between them
    Vec3 normals = Vec3::Zero();          ///< sum of those of the facets that meet there
    std::vector<std::uint32_t> segments;
};

struct Segment {
    std::uint32_t end[2];
    bool used = false;
};

std::uint64_t edge_key(Index a, Index b) {
    return a < b ? (std::uint64_t(a) << 32 | b) : (std::uint64_t(b) << 32 | a);
}

/// Where an edge is cut, `da` and `db` being how far its ends are above the plane.
Crossing point_on_edge(const Mesh& mesh, Index a, double da, Index b, double db) {
    // From the lower index to the higher, whichever facet asks: the same bits for both.
    if (b < a) {
        std::swap(a, b);
        std::swap(da, db);
    }
    const Vec3 &p = mesh.vertices[a], &q = mesh.vertices[b];
    const double t = std::clamp(da / (da - db), 0.0, 1.0);
    Crossing c;
    c.from = a;
    c.to = b;
    c.share = t;
    c.at.point = t <= 0.5 ? Vec3(p + t * (q - p)) : Vec3(q + (1 - t) * (p - q));
    return c;
}

Vec3 normal_on_edge(const MeshGeometry& geometry, const Crossing& c, std::size_t facets) {
    const Vec3 common = c.normals.normalized();
    const bool asked = c.normals.norm() > min_in_common * double(facets);
    const auto at = [&](Index vertex) {
        const Vec3& n = geometry.vertex_normals[vertex];
        // One that looks the other way is a matter of winding.
        const bool sharp = asked && n.dot(common) < sharp_cosine && n.dot(common) > -min_in_common;
        return sharp ? common : n;
    };
    return edge_normal(at(c.from), at(c.to), c.share);
}

} // namespace

MeshSlicer::MeshSlicer(const Mesh& mesh, const MeshGeometry& geometry, const DriveFrame& frame,
                       const Progress& progress, const PassMap* map)
    : mesh_(mesh), geometry_(geometry), frame_(frame), map_(map),
      index_(
          mesh.facet_count(), [this](std::size_t f) { return range_of(f); }, progress) {}

std::pair<double, double> MeshSlicer::range_of(std::size_t facet) const {
    const Facet& corners = mesh_.facets[facet];
    const double a = v(corners[0]), b = v(corners[1]), c = v(corners[2]);
    return {std::min({a, b, c}), std::max({a, b, c})};
}

double MeshSlicer::mapped_u(Index from, Index to, double share) const {
    const double a = map_->u[from], b = map_->u[to];
    return map_->period > 0 ? a + share * std::remainder(b - a, map_->period) : a + share * (b - a);
}

std::vector<SliceChain> MeshSlicer::slice(double offset) const {
    std::vector<Crossing> crossings;
    std::vector<Segment> segments;
    std::unordered_map<std::uint64_t, std::uint32_t> crossing_of;
    std::vector<std::size_t> cut;
    index_.visit(offset, offset, [&](std::size_t f) { cut.push_back(f); });
    std::sort(cut.begin(), cut.end());
    for (const std::size_t f : cut) {
        const Facet& corners = mesh_.facets[f];
        bool above[3];
        for (int k = 0; k < 3; ++k)
            above[k] = v(corners[k]) >= offset;
        if (above[0] == above[1] && above[1] == above[2]) continue;
        Segment s;
        int ends = 0;
        for (int k = 0; k < 3; ++k) {
            const int next = (k + 1) % 3;
            if (above[k] == above[next]) continue;
            const Index a = corners[k], b = corners[next];
            const auto [it, fresh] = crossing_of.try_emplace(edge_key(a, b), std::uint32_t(crossings.size()));
            if (fresh) {
                crossings.push_back(point_on_edge(mesh_, a, v(a) - offset, b, v(b) - offset));
                Crossing& c = crossings.back();
                c.at.facet = Index(f);
                c.at.u = map_ ? mapped_u(c.from, c.to, c.share) : frame_.u(c.at.point);
            }
            crossings[it->second].normals += geometry_.facet_normals[f];
            crossings[it->second].segments.push_back(std::uint32_t(segments.size()));
            s.end[ends++] = it->second;
        }
        segments.push_back(s);
    }
    for (Crossing& c : crossings)
        c.at.normal = normal_on_edge(geometry_, c, c.segments.size());

    const auto next_segment = [&](std::uint32_t crossing) -> Segment* {
        for (const std::uint32_t s : crossings[crossing].segments)
            if (!segments[s].used) return &segments[s];
        return nullptr;
    };
    // Follows unused segments from a crossing until none is left there or the start is met again.
    const auto follow = [&](std::uint32_t start, SliceChain& chain) {
        std::uint32_t at = start;
        chain.points.push_back(crossings[at].at);
        while (Segment* s = next_segment(at)) {
            s->used = true;
            at = s->end[0] == at ? s->end[1] : s->end[0];
            if (at == start) {
                chain.closed = true;
                return;
            }
            if (crossings[at].at.point != chain.points.back().point) chain.points.push_back(crossings[at].at);
        }
    };

    std::vector<SliceChain> chains;
    const auto start_at = [&](std::uint32_t c) {
        SliceChain chain;
        follow(c, chain);
        if (chain.closed && chain.points.size() > 1
            && chain.points.front().point == chain.points.back().point)
            chain.points.pop_back();
        if (chain.points.size() >= 2) chains.push_back(std::move(chain));
    };
    // Ends first: edges with an odd number of segments; what remains afterwards is closed.
    for (std::uint32_t c = 0; c < crossings.size(); ++c)
        if (crossings[c].segments.size() % 2 == 1 && next_segment(c)) start_at(c);
    for (std::uint32_t c = 0; c < crossings.size(); ++c)
        while (next_segment(c))
            start_at(c);

    const auto by_u = [](const SlicePoint& a, const SlicePoint& b) { return a.u < b.u; };
    for (SliceChain& chain : chains) {
        auto& p = chain.points;
        if (chain.closed)
            std::rotate(p.begin(), std::min_element(p.begin(), p.end(), by_u), p.end());
        else if (p.back().u < p.front().u)
            std::reverse(p.begin(), p.end());
    }
    const auto min_u = [&](const SliceChain& c) {
        return std::min_element(c.points.begin(), c.points.end(), by_u)->u;
    };
    std::stable_sort(chains.begin(), chains.end(),
                     [&](const SliceChain& a, const SliceChain& b) { return min_u(a) < min_u(b); });
    return chains;
}

void add_normal_change(const SliceChain& chain, double shortest, double& sum, std::size_t& count) {
    const SlicePoint* last = nullptr;
    for (const SlicePoint& p : chain.points) {
        if (std::abs(p.normal.z()) < tolerance::vertical_normal_z) {
            last = nullptr;
            continue;
        }
        if (last) {
            const double d = (p.point - last->point).norm();
            if (d < shortest) continue;
            sum += (p.normal - last->normal).squaredNorm() / (d * d);
            ++count;
        }
        last = &p;
    }
}

} // namespace facetmill
