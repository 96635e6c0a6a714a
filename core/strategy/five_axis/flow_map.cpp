#include "core/strategy/five_axis/flow_map.h"

#include "core/strategy/five_axis/surface_values.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

namespace facetmill {

namespace {

/// How far to either side of a corner the border is looked at, as a share of its length, and what a sharp
/// turn there counts against where the corner lies.
constexpr double turn_reach = 0.02, turn_counts = 0.8;
/// Places of a border that may be its first corner, at most.
constexpr std::size_t max_starts = 64;

class FlowMaker {
public:
    FlowMaker(const Mesh& mesh, const DriveFrame& frame, double gap, const Progress& progress)
        : mesh_(mesh), frame_(frame), gap_(gap), progress_(progress) {}

    PassMap run() {
        const std::size_t n = mesh_.vertices.size();
        map_.u.resize(n);
        map_.v.resize(n);
        for (std::size_t i = 0; i < n; ++i) {
            map_.u[i] = frame_.u(mesh_.vertices[i]);
            map_.v[i] = frame_.v(mesh_.vertices[i]);
        }
        edges_ = piece_edges(mesh_, progress_.part(0, 0.1));
        find_pieces();
        fixed_u_.assign(n, free_value);
        fixed_v_ = fixed_u_;
        flows_.assign(piece_count_, false);
        find_sides();
        for (std::size_t i = 0; i < n; ++i)
            if (!flows_[piece_[i]]) {
                fixed_u_[i] = map_.u[i];
                fixed_v_[i] = map_.v[i];
            }
        solve_harmonic(edges_.pulls, fixed_u_, map_.u, progress_.part(0.2, 0.6));
        solve_harmonic(edges_.pulls, fixed_v_, map_.v, progress_.part(0.6, 1));
        stretch();
        return std::move(map_);
    }

private:
    using Loop = std::vector<Index>;

    /// Vertices that edges join are of one piece.
    void find_pieces() {
        std::vector<Index> root(mesh_.vertices.size());
        std::iota(root.begin(), root.end(), Index(0));
        const auto find = [&](Index i) {
            while (root[i] != i)
                i = root[i] = root[root[i]];
            return i;
        };
        for (const Pull& p : edges_.pulls) {
            const Index a = find(p.a), b = find(p.b);
            root[std::max(a, b)] = std::min(a, b);
        }
        piece_.assign(root.size(), no_index);
        for (std::size_t i = 0; i < root.size(); ++i) {
            const Index r = find(Index(i));
            if (r == Index(i)) piece_[i] = Index(piece_count_++);
            piece_[i] = piece_[r];
        }
    }

    Vec2 seen(Index vertex) const {
        return {frame_.u(mesh_.vertices[vertex]), frame_.v(mesh_.vertices[vertex])};
    }

    struct Extent {
        Vec2 lo = Vec2::Constant(infinity), hi = Vec2::Constant(-infinity);
        void add(const Vec2& p) {
            lo = lo.cwiseMin(p);
            hi = hi.cwiseMax(p);
        }
    };

    void find_sides() {
        const std::vector<Loop> loops = border_of(edges_);
        std::vector<const Loop*> outer(piece_count_, nullptr);
        std::vector<double> widest(piece_count_, 0);
        for (const Loop& loop : loops) {
            Extent extent;
            for (const Index i : loop)
                extent.add(seen(i));
            const double size = (extent.hi - extent.lo).norm();
            const Index piece = piece_[loop.front()];
            if (!(size > widest[piece])) continue;
            widest[piece] = size;
            outer[piece] = &loop;
        }
        for (std::size_t k = 0; k < piece_count_; ++k)
            if (outer[k]) flows_[k] = set_sides(*outer[k]);
    }

    /// How much the border turns about each of its places, to the left: 1 for a right angle or more.
    std::vector<double> turns(const Loop& loop) const {
        const std::size_t n = loop.size();
        std::vector<double> arc(n + 1, 0), turn(n);
        for (std::size_t i = 0; i < n; ++i)
            arc[i + 1] = arc[i] + (seen(loop[(i + 1) % n]) - seen(loop[i])).norm();
        const double reach = turn_reach * arc[n];
        for (std::size_t i = 0; i < n; ++i) {
            std::size_t before = 0, after = 0;
            const auto away = [&](std::size_t from, std::size_t to) {
                return to >= from ? arc[to] - arc[from] : arc[n] - arc[from] + arc[to];
            };
            while (before + 1 < n && away((i + n - before) % n, i) < reach)
                ++before;
            while (after + 1 < n && away(i, (i + after) % n) < reach)
                ++after;
            const Vec2 p = seen(loop[i]), from = p - seen(loop[(i + n - before) % n]),
                       to = seen(loop[(i + after) % n]) - p;
            const double cross = from.x() * to.y() - from.y() * to.x();
            turn[i] = std::clamp(std::atan2(cross, from.dot(to)) / (0.5 * pi), 0.0, 1.0);
        }
        return turn;
    }

    /// Places of the four corners of a border of four places or more: the ends of the first side, those of
    /// the other one. One after the other along the border, so that what reaches as far twice is two corners.
    std::array<std::size_t, 4> corners(const Loop& loop, const Vec2& middle, const Vec2& half) const {
        constexpr std::array<std::array<int, 2>, 4> towards{{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}};
        const std::size_t n = loop.size();
        const std::vector<double> turn = turns(loop);
        std::array<std::vector<double>, 4> score;
        for (std::size_t k = 0; k < 4; ++k)
            for (std::size_t i = 0; i < n; ++i) {
                const Vec2 p = (seen(loop[i]) - middle).cwiseQuotient(half);
                score[k].push_back(p.x() * towards[k][0] + p.y() * towards[k][1] + turn_counts * turn[i]);
            }
        std::vector<std::size_t> starts;
        for (std::size_t i = 0; i < n; ++i)
            if (score[0][i] >= score[0][(i + 1) % n] && score[0][i] > score[0][(i + n - 1) % n])
                starts.push_back(i);
        std::stable_sort(starts.begin(), starts.end(),
                         [&](std::size_t a, std::size_t b) { return score[0][a] > score[0][b]; });
        if (starts.size() > max_starts) starts.resize(max_starts);
        if (starts.empty()) starts.push_back(0); // it reaches as far everywhere
        /// The best of the corners up to one of them, along the border from the first one on.
        struct Chosen {
            double sum = -infinity;
            std::array<std::size_t, 4> corner{};
        };
        Chosen best;
        for (const std::size_t start : starts) {
            std::array<Chosen, 4> upto;
            upto[0].sum = score[0][start];
            upto[0].corner[0] = start;
            for (std::size_t away = 1; away < n; ++away) {
                const std::size_t i = (start + away) % n;
                for (std::size_t k = 3; k >= 1; --k) {
                    if (!(upto[k - 1].sum + score[k][i] > upto[k].sum)) continue;
                    upto[k] = upto[k - 1];
                    upto[k].sum += score[k][i];
                    upto[k].corner[k] = i;
                }
            }
            if (upto[3].sum > best.sum) best = upto[3];
        }
        return best.corner;
    }

    /// Values at the four sides of a piece; false: it has no such sides.
    bool set_sides(Loop loop) {
        if (loop.size() < 4) return false;
        double area = 0;
        Extent extent;
        for (std::size_t i = 0; i < loop.size(); ++i) {
            const Vec2 a = seen(loop[i]), b = seen(loop[(i + 1) % loop.size()]);
            area += a.x() * b.y() - a.y() * b.x();
            extent.add(a);
        }
        if (area < 0) std::reverse(loop.begin(), loop.end()); // a sheet that is wound the other way
        const Vec2 middle = 0.5 * (extent.lo + extent.hi), half = 0.5 * (extent.hi - extent.lo);
        if (!(half.minCoeff() > 0)) return false;
        const std::array<std::size_t, 4> corner = corners(loop, middle, half);
        std::rotate(loop.begin(), loop.begin() + long(corner[0]), loop.end());
        const std::size_t n = loop.size();
        const auto from_first = [&](std::size_t k) { return (corner[k] + n - corner[0]) % n; };
        const std::size_t first_end = from_first(1), second = from_first(2), second_end = from_first(3);
        const double u_size = 2 * half.x(), v_size = 2 * half.y();
        for (std::size_t i = 0; i < n; ++i) {
            if (i <= first_end) fixed_v_[loop[i]] = 0;
            if (i >= first_end && i <= second) fixed_u_[loop[i]] = u_size;
            if (i >= second && i <= second_end) fixed_v_[loop[i]] = v_size;
            if (i == 0 || i >= second_end) fixed_u_[loop[i]] = 0;
        }
        const Vec2 lo = extent.lo;
        const Index piece = piece_[loop.front()];
        for (std::size_t i = 0; i < piece_.size(); ++i)
            if (piece_[i] == piece) {
                map_.u[i] = std::clamp(map_.u[i] - lo.x(), 0.0, u_size);
                map_.v[i] = std::clamp(map_.v[i] - lo.y(), 0.0, v_size);
            }
        return true;
    }

    void stretch() {
        std::vector<std::vector<Index>> facets(piece_count_), vertices(piece_count_);
        for (std::size_t f = 0; f < mesh_.facet_count(); ++f)
            facets[piece_[mesh_.facets[f][0]]].push_back(Index(f));
        for (std::size_t i = 0; i < piece_.size(); ++i)
            vertices[piece_[i]].push_back(Index(i));
        double begin = 0;
        map_.flattest_v = 1;
        for (std::size_t k = 0; k < piece_count_; ++k) {
            if (facets[k].empty()) continue;
            progress_.check();
            if (flows_[k]) {
                stretch_value(mesh_, facets[k], map_.u, vertices[k]);
                stretch_value(mesh_, facets[k], map_.v, vertices[k]);
            }
            map_.flattest_v =
                std::min(map_.flattest_v, steepness_at(mesh_, facets[k], map_.v, left_out_share));
            double lo = infinity, hi = -infinity, u_lo = infinity;
            for (const Index i : vertices[k]) {
                lo = std::min(lo, map_.v[i]);
                hi = std::max(hi, map_.v[i]);
                u_lo = std::min(u_lo, map_.u[i]);
            }
            for (const Index i : vertices[k]) {
                map_.v[i] += begin - lo;
                map_.u[i] -= u_lo;
                map_.u_hi = std::max(map_.u_hi, map_.u[i]);
            }
            begin += hi - lo + gap_;
        }
        map_.flattest_v = std::clamp(map_.flattest_v, PassMap::min_flattest, 1.0);
        for (std::size_t f = 0; f < mesh_.facet_count(); ++f) {
            map_.gradients.push_back(value_gradient(mesh_, f, map_.v));
            map_.steepest_u = std::max(map_.steepest_u, value_gradient(mesh_, f, map_.u).norm());
        }
    }

    const Mesh& mesh_;
    const DriveFrame& frame_;
    double gap_;
    const Progress& progress_;
    PassMap map_;
    PieceEdges edges_;
    std::vector<Index> piece_; ///< per vertex
    std::size_t piece_count_ = 0;
    std::vector<bool> flows_; ///< per piece: it has sides
    std::vector<double> fixed_u_, fixed_v_;
};

} // namespace

PassMap flow_map(const Mesh& mesh, const DriveFrame& frame, double gap, const Progress& progress) {
    return FlowMaker(mesh, frame, gap, progress).run();
}

} // namespace facetmill
