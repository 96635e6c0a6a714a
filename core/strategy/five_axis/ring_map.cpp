#include "core/strategy/five_axis/ring_map.h"

#include "core/base/error.h"
#include "core/mesh/edge_table.h"
#include "core/strategy/five_axis/surface_values.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <optional>
#include <queue>

namespace facetmill {

namespace {

/// Two borders lie across from each other where the shorter one is no less than this share of the other; less
/// where they face apart by more than the angle of this cosine.
constexpr double like_share = 0.25, apart_share = 1.0 / 40, apart_cos = 0.5;
/// The hole at an end, as a share of the shortest edge there.
constexpr double end_hole = 0.01;
/// Places that a round may begin at, and how much flatter one has to be than those before it.
constexpr std::size_t seam_places = 24;
constexpr double seam_gain = 0.01;

struct RingBorder {
    std::vector<Index> loop;
    double length = 0;
    Vec3 area = Vec3::Zero(); ///< mm^2, along the normal of what it encloses
    double height = 0;        ///< mean z
};

std::vector<RingBorder> ring_borders(const Mesh& mesh, const PieceEdges& edges) {
    std::vector<RingBorder> borders;
    for (std::vector<Index>& loop : border_of(edges)) {
        if (loop.size() < 3) continue;
        RingBorder b;
        const Vec3& first = mesh.vertices[loop.front()];
        for (std::size_t i = 0; i < loop.size(); ++i) {
            const Vec3 &p = mesh.vertices[loop[i]], &q = mesh.vertices[loop[(i + 1) % loop.size()]];
            b.length += (q - p).norm();
            b.area += 0.5 * (p - first).cross(q - first);
            b.height += p.z() / double(loop.size());
        }
        b.loop = std::move(loop);
        borders.push_back(std::move(b));
    }
    return borders;
}

/// What rings lie between; `second` has no loop where the piece has an end instead.
struct RingEnds {
    RingBorder first, second;
};

std::optional<RingEnds> ring_ends(std::vector<RingBorder> borders) {
    if (borders.empty()) return std::nullopt;
    double most = -1;
    std::size_t first = 0, second = 0;
    for (std::size_t i = 0; i < borders.size(); ++i)
        for (std::size_t k = i + 1; k < borders.size(); ++k) {
            const RingBorder &a = borders[i], &b = borders[k];
            const double both = a.area.norm() * b.area.norm(), apart = -a.area.dot(b.area);
            const double alike = std::min(a.length, b.length) / std::max(a.length, b.length);
            if (alike < like_share && !(alike >= apart_share && apart >= apart_cos * both)) continue;
            if (!(both + apart > most)) continue;
            most = both + apart;
            first = i;
            second = k;
        }
    if (most > 0) return RingEnds{borders[first], borders[second]};
    const auto widest =
        std::max_element(borders.begin(), borders.end(), [](const RingBorder& a, const RingBorder& b) {
            return a.area.squaredNorm() < b.area.squaredNorm();
        });
    return RingEnds{*widest, {}};
}

/// How much of a piece's directions its inside takes in, steradians: 2 pi for half a ball.
double bulge(const Mesh& mesh, const PieceEdges& edges) {
    std::vector<double> angles(mesh.vertices.size(), 0);
    for (std::size_t f = 0; f < mesh.facet_count(); ++f)
        for (int k = 0; k < 3; ++k) {
            const Vec3 a = mesh.corner(f, (k + 1) % 3) - mesh.corner(f, k),
                       b = mesh.corner(f, (k + 2) % 3) - mesh.corner(f, k);
            angles[mesh.facets[f][std::size_t(k)]] += std::atan2(a.cross(b).norm(), a.dot(b));
        }
    std::vector<char> at_border(angles.size(), 0);
    for (std::size_t i = 0; i < angles.size(); ++i)
        for (const Index to : edges.next[i])
            at_border[i] = at_border[to] = 1;
    double sum = 0;
    for (std::size_t i = 0; i < angles.size(); ++i)
        if (!at_border[i] && angles[i] > 0) sum += 2 * pi - angles[i];
    return sum;
}

/// The vertex inside a piece that is farthest from a border, along edges.
Index farthest_from(const Mesh& mesh, const PieceEdges& edges, const std::vector<Index>& border,
                    const Progress& progress) {
    const std::size_t n = mesh.vertices.size();
    std::vector<std::vector<Index>> beside(n);
    for (const Pull& p : edges.pulls) {
        beside[p.a].push_back(p.b);
        beside[p.b].push_back(p.a);
    }
    std::vector<double> away(n, infinity);
    using Entry = std::pair<double, Index>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
    for (const Index i : border) {
        away[i] = 0;
        open.emplace(0, i);
    }
    while (!open.empty()) {
        progress.check();
        const auto [distance, i] = open.top();
        open.pop();
        if (distance > away[i]) continue;
        for (const Index to : beside[i]) {
            const double further = distance + (mesh.vertices[to] - mesh.vertices[i]).norm();
            if (!(further < away[to])) continue;
            away[to] = further;
            open.emplace(further, to);
        }
    }
    Index farthest = no_index;
    for (std::size_t i = 0; i < n; ++i)
        if (std::isfinite(away[i]) && edges.next[i].empty()
            && (farthest == no_index || away[i] > away[farthest]))
            farthest = Index(i);
    return farthest;
}

/// Takes the facets about a vertex back from it by so little that no tool notices.
void open_hole(DerivedMesh& piece, Index at) {
    Mesh& mesh = piece.mesh;
    const Vec3 middle = mesh.vertices[at];
    std::vector<std::size_t> about;
    double shortest = infinity;
    for (std::size_t f = 0; f < mesh.facet_count(); ++f)
        for (const Index i : mesh.facets[f])
            if (i == at) {
                about.push_back(f);
                for (const Index other : mesh.facets[f])
                    if (other != at) shortest = std::min(shortest, (mesh.vertices[other] - middle).norm());
            }
    std::vector<std::pair<Index, Index>> rim; // of neighbours: the vertex before them
    const auto rim_of = [&](Index other) {
        const auto known =
            std::find_if(rim.begin(), rim.end(), [&](const auto& pair) { return pair.first == other; });
        if (known != rim.end()) return known->second;
        const double length = (mesh.vertices[other] - middle).norm();
        const double t = length > 0 ? end_hole * shortest / length : 0;
        const auto made = Index(mesh.vertices.size());
        mesh.vertices.push_back(middle + t * (mesh.vertices[other] - middle));
        piece.added.push_back({at, other, t});
        rim.emplace_back(other, made);
        return made;
    };
    for (const std::size_t f : about) {
        Facet corners = mesh.facets[f];
        while (corners[0] != at)
            std::rotate(corners.begin(), corners.begin() + 1, corners.end());
        const Index a = rim_of(corners[1]), b = rim_of(corners[2]);
        mesh.facets[f] = {a, corners[1], corners[2]};
        mesh.facets.push_back({a, corners[2], b});
        piece.facet_of.push_back(piece.facet_of[f]);
    }
}

/// A piece with two ends, the higher one first.
struct RingPiece {
    PieceEdges edges;
    RingEnds ends;
};

/// Opens the end of a piece that has one border alone, if it bulges by as much as asked, steradians.
std::optional<RingPiece> ring_piece(DerivedMesh& piece, double min_bulge, const Progress& progress) {
    RingPiece found;
    found.edges = piece_edges(piece.mesh, progress);
    std::optional<RingEnds> ends = ring_ends(ring_borders(piece.mesh, found.edges));
    if (!ends) return std::nullopt;
    if (ends->second.loop.empty()) {
        if (bulge(piece.mesh, found.edges) < min_bulge) return std::nullopt;
        const Index end = farthest_from(piece.mesh, found.edges, ends->first.loop, progress);
        if (end == no_index) return std::nullopt;
        const std::size_t before = piece.mesh.vertices.size();
        open_hole(piece, end);
        found.edges = piece_edges(piece.mesh, progress);
        for (RingBorder& border : ring_borders(piece.mesh, found.edges))
            if (border.loop.front() >= before) ends->second = std::move(border);
        if (ends->second.loop.empty()) return std::nullopt;
    }
    if (ends->second.height > ends->first.height) std::swap(ends->first, ends->second);
    found.ends = std::move(*ends);
    return found;
}

class RingMaker {
public:
    RingMaker(const Mesh& mesh, RingPiece piece, const Progress& progress)
        : mesh_(mesh), edges_(std::move(piece.edges)), ends_(std::move(piece.ends)), progress_(progress),
          all_(mesh.facet_count()) {
        std::iota(all_.begin(), all_.end(), Index(0));
    }

    PassMap run() {
        level_rings();
        go_round();
        turn_to_the_right();
        map_.flattest_v = std::clamp(flattest_, PassMap::min_flattest, 1.0);
        for (std::size_t f = 0; f < mesh_.facet_count(); ++f) {
            map_.gradients.push_back(value_gradient(mesh_, f, map_.v));
            map_.steepest_u = std::max(map_.steepest_u, value_gradient(mesh_, f, map_.u, map_.period).norm());
        }
        return std::move(map_);
    }

    bool is_crossed() const { return !route_across().empty(); }

    /// v, the whole of it; its least steepness but for what is left out.
    double level_rings() {
        const std::size_t n = mesh_.vertices.size();
        std::vector<double> fixed(n, free_value);
        for (const Index i : ends_.first.loop)
            fixed[i] = 0;
        for (const Index i : ends_.second.loop)
            fixed[i] = 1;
        map_.v.assign(n, 0.5);
        solve_harmonic(edges_.pulls, fixed, map_.v, progress_.part(0.2, 0.6));
        std::vector<char> used(n, 0);
        for (const Facet& facet : mesh_.facets)
            for (const Index i : facet)
                used[i] = 1;
        std::vector<Index> vertices;
        for (std::size_t i = 0; i < n; ++i)
            if (used[i]) vertices.push_back(Index(i));
        stretch_value(mesh_, all_, map_.v, vertices);
        return flattest_ = steepness_at(mesh_, all_, map_.v, left_out_share);
    }

private:
    /// What lies beyond each side of a facet, and which border the side is of.
    struct Beyond {
        std::vector<Index> facet;
        std::vector<char> is_first, is_second;
    };

    Beyond beyond() const {
        Beyond b;
        b.facet.assign(3 * mesh_.facet_count(), no_index);
        b.is_first.assign(b.facet.size(), 0);
        b.is_second = b.is_first;
        std::vector<char> first(mesh_.vertices.size(), 0), second = first;
        for (const Index i : ends_.first.loop)
            first[i] = 1;
        for (const Index i : ends_.second.loop)
            second[i] = 1;
        const EdgeTable table(mesh_, progress_.part(0.6, 0.6));
        for (std::size_t low = 0; low < table.vertex_count(); ++low)
            table.for_edges(low, [&](Index high, std::span<const EdgeSide> sides) {
                if (sides.size() == 1) {
                    b.is_first[sides[0].side] = char(first[low] && first[high]);
                    b.is_second[sides[0].side] = char(second[low] && second[high]);
                } else if (sides.size() == 2) {
                    b.facet[sides[0].side] = sides[1].facet();
                    b.facet[sides[1].side] = sides[0].facet();
                }
            });
        return b;
    }

    /// Sides that a way over facets from the first border to the second one crosses, out of the facets that
    /// they are named by; the first one is where it comes in. None where no way leads there.
    std::vector<std::size_t> route_across() const {
        const Beyond b = beyond();
        std::vector<std::size_t> from(mesh_.facet_count(), std::size_t(-1));
        std::vector<Index> open;
        for (std::size_t side = 0; side < b.facet.size(); ++side)
            if (b.is_first[side] && from[side / 3] == std::size_t(-1)) {
                from[side / 3] = side;
                open.push_back(Index(side / 3));
            }
        for (std::size_t i = 0; i < open.size(); ++i)
            for (std::size_t k = 0; k < 3; ++k) {
                const std::size_t side = 3 * std::size_t(open[i]) + k;
                if (b.is_second[side] && from[open[i]] != side) return traced(from, b, side);
                const Index to = b.facet[side];
                if (to == no_index || from[to] != std::size_t(-1)) continue;
                from[to] = side;
                open.push_back(to);
            }
        return {};
    }
    static std::vector<std::size_t> traced(const std::vector<std::size_t>& from, const Beyond& b,
                                           std::size_t last) {
        std::vector<std::size_t> route{last};
        for (std::size_t f = last / 3;;) {
            const std::size_t side = from[f];
            route.push_back(side);
            if (side / 3 == f && b.is_first[side]) break; // came in from outside
            f = side / 3;
        }
        std::reverse(route.begin(), route.end());
        return route;
    }

    Pull& pull_of(Index a, Index b) {
        const auto at = std::lower_bound(
            edges_.pulls.begin(), edges_.pulls.end(), std::minmax(a, b),
            [](const Pull& p, const std::pair<Index, Index>& ends) { return std::pair(p.a, p.b) < ends; });
        return *at;
    }

    /// u: once round it grows by 1, then by a length.
    void go_round() {
        const std::vector<std::size_t> route = route_across();
        for (std::size_t i = 0; i < route.size(); ++i) {
            // Out of a facet the end of the side is to the left of the route; into it, its start.
            Index right = side_start(mesh_, route[i]), left = side_end(mesh_, route[i]);
            if (i == 0) std::swap(right, left);
            Pull& pull = pull_of(left, right);
            pull.jump = pull.a == left ? -1 : 1;
        }
        std::vector<double> round(mesh_.vertices.size(), 0);
        solve_harmonic(edges_.pulls, std::vector<double>(round.size(), free_value), round,
                       progress_.part(0.6, 1));
        const double steepest = steepness_at(mesh_, all_, round, 1 - left_out_share, 1);
        map_.period = 1 / std::max(steepest, 1e-12);
        map_.u_hi = 2 * map_.period;
        const double begin = flattest_round(round);
        map_.u = std::move(round);
        for (double& u : map_.u) {
            u = map_.period * (u - begin - std::floor(u - begin));
            if (!(u < map_.period)) u = 0;
        }
    }

    /// Where in a round, from 0 to 1, the surface is flattest: lines begin and end there, not at the edge of
    /// a blade.
    double flattest_round(const std::vector<double>& round) const {
        std::array<Vec3, seam_places> sum;
        sum.fill(Vec3::Zero());
        std::array<double, seam_places> area{};
        for (std::size_t f = 0; f < mesh_.facet_count(); ++f) {
            const double at = round[mesh_.facets[f][0]];
            const auto k = std::min(std::size_t(seam_places * (at - std::floor(at))), seam_places - 1);
            sum[k] += mesh_.facet_cross(f);
            area[k] += mesh_.facet_cross(f).norm();
        }
        std::size_t flattest = 0;
        const auto flatness = [&](std::size_t k) { return area[k] > 0 ? sum[k].norm() / area[k] : 0; };
        for (std::size_t k = 1; k < seam_places; ++k)
            if (flatness(k) > flatness(flattest) + seam_gain) flattest = k;
        return (double(flattest) + 0.5) / double(seam_places);
    }

    /// v grows to the right of u.
    void turn_to_the_right() {
        double left = 0;
        for (const Index f : all_)
            left += mesh_.facet_cross(f)
                        .cross(value_gradient(mesh_, f, map_.u, map_.period))
                        .dot(value_gradient(mesh_, f, map_.v));
        if (!(left > 0)) return;
        for (double& u : map_.u)
            u = u > 0 ? map_.period - u : 0;
    }

    const Mesh& mesh_;
    PieceEdges edges_;
    RingEnds ends_;
    const Progress& progress_;
    std::vector<Index> all_; ///< facets
    PassMap map_;
    double flattest_ = 0;
};

} // namespace

bool goes_round(const Mesh& piece, const Progress& progress) {
    DerivedMesh own;
    own.mesh = piece;
    own.facet_of.resize(piece.facet_count());
    std::optional<RingPiece> found = ring_piece(own, pi, progress.part(0, 0.2));
    if (!found) return false;
    RingMaker maker(own.mesh, std::move(*found), progress);
    return maker.is_crossed() && maker.level_rings() >= PassMap::min_flattest;
}

PassMap ring_map(DerivedMesh& piece, const Progress& progress) {
    std::optional<RingPiece> found = ring_piece(piece, -infinity, progress.part(0, 0.2));
    if (!found) throw Error(ErrorCode::internal, "passes", "rings need a border to lie along", "report this");
    return RingMaker(piece.mesh, std::move(*found), progress).run();
}

} // namespace facetmill
