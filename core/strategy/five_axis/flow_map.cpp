#include "core/strategy/five_axis/flow_map.h"

#include "core/mesh/edge_table.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

namespace facetmill {

namespace {

/// Of two that pull at a vertex none pulls less than this: facets with obtuse corners would push.
constexpr double min_pull = 1e-4;
/// The solver stops at this share of the residual it began with, or after so many rounds.
constexpr double solved_share = 1e-9;
constexpr int max_rounds = 5000;
/// How far to either side of a corner the border is looked at, as a share of its length, and what a sharp
/// turn there counts against where the corner lies.
constexpr double turn_reach = 0.02, turn_counts = 0.8;
/// Places of a border that may be its first corner, at most.
constexpr std::size_t max_starts = 64;
/// What is left out of account where it is said how much a value changes: at corners it changes ever faster.
constexpr double left_out_share = 0.02;
constexpr double min_flattest = 1.0 / 8;
/// Pieces of a value's range that are stretched each by itself.
constexpr int stretch_pieces = 64;

constexpr double free_value = std::numeric_limits<double>::quiet_NaN();

/// How an edge pulls the values of its ends together.
struct Pull {
    Index a, b;
    double weight;
};

/// The value of every vertex that is the mean of its neighbours', by the cotangents of the angles across;
/// `value` begins as a guess, and stays where `fixed` is a number. Conjugate gradients.
void solve_harmonic(const std::vector<Pull>& pulls, const std::vector<double>& fixed,
                    std::vector<double>& value, const Progress& progress) {
    const std::size_t n = value.size();
    std::vector<double> diagonal(n, 0), residual(n), step(n, 0), scaled(n), pulled(n);
    for (const Pull& p : pulls) {
        diagonal[p.a] += p.weight;
        diagonal[p.b] += p.weight;
    }
    std::vector<char> is_free(n);
    for (std::size_t i = 0; i < n; ++i) {
        is_free[i] = std::isnan(fixed[i]) && diagonal[i] > 0;
        if (!std::isnan(fixed[i])) value[i] = fixed[i];
    }
    const auto pull_at = [&](const std::vector<double>& x, std::vector<double>& sum) {
        std::fill(sum.begin(), sum.end(), 0.0);
        for (const Pull& p : pulls) {
            const double d = p.weight * (x[p.a] - x[p.b]);
            sum[p.a] += d;
            sum[p.b] -= d;
        }
        for (std::size_t i = 0; i < n; ++i)
            if (!is_free[i]) sum[i] = 0;
    };
    const auto product = [n](const std::vector<double>& x, const std::vector<double>& y) {
        double sum = 0;
        for (std::size_t i = 0; i < n; ++i)
            sum += x[i] * y[i];
        return sum;
    };
    const auto scale = [&] {
        for (std::size_t i = 0; i < n; ++i)
            scaled[i] = is_free[i] ? residual[i] / diagonal[i] : 0;
    };
    pull_at(value, residual);
    for (double& r : residual)
        r = -r;
    scale();
    step = scaled;
    double energy = product(residual, scaled);
    const double enough = solved_share * solved_share * energy;
    for (int round = 0; round < max_rounds && energy > enough; ++round) {
        progress.check();
        pull_at(step, pulled);
        const double stiff = product(step, pulled);
        if (!(stiff > 0)) break;
        const double go = energy / stiff;
        for (std::size_t i = 0; i < n; ++i) {
            value[i] += go * step[i];
            residual[i] -= go * pulled[i];
        }
        scale();
        const double next = product(residual, scaled);
        const double keep = next / energy;
        energy = next;
        for (std::size_t i = 0; i < n; ++i)
            step[i] = scaled[i] + keep * step[i];
    }
}

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
        find_edges();
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
        solve_harmonic(pulls_, fixed_u_, map_.u, progress_.part(0.2, 0.6));
        solve_harmonic(pulls_, fixed_v_, map_.v, progress_.part(0.6, 1));
        stretch();
        return std::move(map_);
    }

private:
    using Loop = std::vector<Index>;

    double cotangent(std::size_t side) const {
        const Vec3& p = mesh_.vertices[side_across(mesh_, side)];
        const Vec3 a = mesh_.vertices[side_start(mesh_, side)] - p,
                   b = mesh_.vertices[side_end(mesh_, side)] - p;
        const double twice_area = a.cross(b).norm();
        return twice_area > 0 ? a.dot(b) / twice_area : 0;
    }

    void find_edges() {
        const EdgeTable edges(mesh_, progress_.part(0, 0.1));
        next_.assign(mesh_.vertices.size(), {});
        for (std::size_t low = 0; low < edges.vertex_count(); ++low) {
            if (low % 1024 == 0) progress_.check();
            edges.for_edges(low, [&](Index high, std::span<const EdgeSide> sides) {
                double weight = 0;
                for (const EdgeSide& side : sides)
                    weight += 0.5 * cotangent(side.side);
                pulls_.push_back({Index(low), high, std::max(weight, min_pull)});
                if (sides.size() == 1)
                    next_[side_start(mesh_, sides[0].side)].push_back(side_end(mesh_, sides[0].side));
            });
        }
    }

    /// Vertices that edges join are of one piece.
    void find_pieces() {
        std::vector<Index> root(mesh_.vertices.size());
        std::iota(root.begin(), root.end(), Index(0));
        const auto find = [&](Index i) {
            while (root[i] != i)
                i = root[i] = root[root[i]];
            return i;
        };
        for (const Pull& p : pulls_) {
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

    /// Closed ways along the border, each in the direction of the facets' winding.
    std::vector<Loop> border() {
        std::vector<Loop> loops;
        for (std::size_t start = 0; start < next_.size(); ++start)
            while (!next_[start].empty()) {
                Loop loop;
                auto at = Index(start);
                while (!next_[at].empty()) {
                    loop.push_back(at);
                    const Index to = next_[at].back();
                    next_[at].pop_back();
                    at = to;
                    if (at == Index(start)) break;
                }
                loops.push_back(std::move(loop));
            }
        return loops;
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
        std::vector<Loop> loops = border();
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

    /// What a value changes by over a facet, mm per mm.
    Vec3 gradient(std::size_t f, const std::vector<double>& value) const {
        const Vec3 cross = mesh_.facet_cross(f);
        const double square = cross.squaredNorm();
        if (!(square > 0)) return Vec3::Zero();
        Vec3 sum = Vec3::Zero();
        for (int k = 0; k < 3; ++k)
            sum += value[mesh_.facets[f][std::size_t(k)]]
                   * cross.cross(mesh_.corner(f, (k + 2) % 3) - mesh_.corner(f, (k + 1) % 3));
        return sum / square;
    }

    /// What a share of the area lies below, of the gradients of a value.
    double quantile(const std::vector<Index>& facets, const std::vector<double>& value, double share) const {
        std::vector<std::pair<double, double>> all;
        double area = 0, sum = 0;
        for (const Index f : facets) {
            all.emplace_back(gradient(f, value).norm(), mesh_.facet_cross(f).norm());
            area += all.back().second;
        }
        std::sort(all.begin(), all.end());
        for (const auto& [steepness, own] : all) {
            sum += own;
            if (sum >= share * area) return steepness;
        }
        return all.empty() ? 0 : all.back().first;
    }

    /// A value of one piece, so that it changes by as much everywhere along its own course, and hardly
    /// anywhere by more than a length does.
    void stretch_value(const std::vector<Index>& facets, std::vector<double>& value,
                       const std::vector<Index>& vertices) const {
        double lo = infinity, hi = -infinity;
        for (const Index i : vertices) {
            lo = std::min(lo, value[i]);
            hi = std::max(hi, value[i]);
        }
        if (!(hi > lo)) return;
        std::array<double, stretch_pieces> steepness{}, area{};
        const auto piece_of = [&](double x) {
            return std::size_t(std::clamp((x - lo) / (hi - lo) * stretch_pieces, 0.0, stretch_pieces - 1.0));
        };
        for (const Index f : facets) {
            const Facet& c = mesh_.facets[f];
            const std::size_t k = piece_of((value[c[0]] + value[c[1]] + value[c[2]]) / 3);
            const double own = mesh_.facet_cross(f).norm();
            area[k] += own;
            steepness[k] += own * gradient(f, value).norm();
        }
        std::array<double, stretch_pieces + 1> at{};
        double last = 1;
        for (std::size_t k = 0; k < stretch_pieces; ++k) {
            if (steepness[k] > 0) last = steepness[k] / area[k];
            at[k + 1] = at[k] + (hi - lo) / stretch_pieces / last;
        }
        for (const Index i : vertices) {
            const std::size_t k = piece_of(value[i]);
            const double share = (value[i] - lo) / (hi - lo) * stretch_pieces - double(k);
            value[i] = at[k] + share * (at[k + 1] - at[k]);
        }
        const double most = quantile(facets, value, 1 - left_out_share);
        if (!(most > 0)) return;
        for (const Index i : vertices)
            value[i] /= most;
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
                stretch_value(facets[k], map_.u, vertices[k]);
                stretch_value(facets[k], map_.v, vertices[k]);
            }
            map_.flattest_v = std::min(map_.flattest_v, quantile(facets[k], map_.v, left_out_share));
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
        map_.flattest_v = std::clamp(map_.flattest_v, min_flattest, 1.0);
        for (std::size_t f = 0; f < mesh_.facet_count(); ++f) {
            map_.gradients.push_back(gradient(f, map_.v));
            map_.steepest_u = std::max(map_.steepest_u, gradient(f, map_.u).norm());
        }
    }

    const Mesh& mesh_;
    const DriveFrame& frame_;
    double gap_;
    const Progress& progress_;
    PassMap map_;
    std::vector<Pull> pulls_;
    std::vector<std::vector<Index>> next_; ///< per vertex: where sides of one facet alone go from it
    std::vector<Index> piece_;             ///< per vertex
    std::size_t piece_count_ = 0;
    std::vector<bool> flows_; ///< per piece: it has sides
    std::vector<double> fixed_u_, fixed_v_;
};

} // namespace

PassMap flow_map(const Mesh& mesh, const DriveFrame& frame, double gap, const Progress& progress) {
    return FlowMaker(mesh, frame, gap, progress).run();
}

} // namespace facetmill
