#include "core/strategy/cleanup/rest_band.h"

#include "core/base/parallel.h"
#include "core/base/tolerances.h"
#include "core/strategy/cleanup/nearest_place.h"
#include "core/strategy/surface/point_grid.h"

#include <map>
#include <numeric>
#include <unordered_map>

namespace facetmill {

namespace {

constexpr std::size_t check_every = 2048;
/// Edges of facets in a band are not longer than this many radii of the cutter.
constexpr double edge_share = 0.07;
/// Cells that say where a band may be, in radii.
constexpr double mark_share = 0.12;
constexpr int max_divisions = 24;
/// Normals nearer to each other than this (cosine) ask the same.
constexpr double same_normal = 0.9999;
/// Of the tip's way: a centre that moves by less stands still.
constexpr double standing = 0.3;
/// Tips are asked up to this many radii aside: an upright wall is just at the radius.
constexpr double aside = 1.02;

/// Of the tolerance: two valleys that leave the same within this leave alike.
constexpr double alike = 0.25;
/// Of an edge between two bands: neither gets less.
constexpr double min_part = 0.02;
/// The place where the cutter leaves least is looked for in steps down to this, in radii.
constexpr double last_step = 0.02;

/// Cells, seen from above, near to which something is left.
class Marks {
public:
    Marks(const Box3& box, double cell, double margin)
        : lo_(box.lo.head<2>() - Vec2::Constant(margin + 2 * cell)), cell_(cell) {
        const Vec2 size = box.hi.head<2>() - box.lo.head<2>() + Vec2::Constant(2 * margin + 4 * cell);
        columns_ = int(size.x() / cell) + 1;
        rows_ = int(size.y() / cell) + 1;
        sum_.assign(std::size_t(columns_ + 1) * std::size_t(rows_ + 1), 0);
    }
    void mark(const Vec2& at, double radius) {
        const auto [x0, y0] = cell_of(at - Vec2::Constant(radius));
        const auto [x1, y1] = cell_of(at + Vec2::Constant(radius));
        for (int y = y0; y <= y1; ++y)
            for (int x = x0; x <= x1; ++x)
                sum_[at_corner(x + 1, y + 1)] = 1;
    }
    /// After the last mark, before the first question.
    void finish() {
        for (int y = 1; y <= rows_; ++y)
            for (int x = 1; x <= columns_; ++x)
                sum_[at_corner(x, y)] +=
                    sum_[at_corner(x - 1, y)] + sum_[at_corner(x, y - 1)] - sum_[at_corner(x - 1, y - 1)];
    }
    bool any(const Vec2& lo, const Vec2& hi) const {
        const auto [x0, y0] = cell_of(lo);
        const auto [x1, y1] = cell_of(hi);
        return sum_[at_corner(x1 + 1, y1 + 1)] - sum_[at_corner(x0, y1 + 1)] - sum_[at_corner(x1 + 1, y0)]
                   + sum_[at_corner(x0, y0)]
               > 0;
    }

private:
    std::array<int, 2> cell_of(const Vec2& p) const {
        return {std::clamp(int(std::floor((p.x() - lo_.x()) / cell_)), 0, columns_ - 1),
                std::clamp(int(std::floor((p.y() - lo_.y()) / cell_)), 0, rows_ - 1)};
    }
    std::size_t at_corner(int x, int y) const {
        return std::size_t(y) * std::size_t(columns_ + 1) + std::size_t(x);
    }
    Vec2 lo_;
    double cell_;
    int columns_ = 0, rows_ = 0;
    std::vector<std::int64_t> sum_;
};

std::uint64_t pair_of(Index a, Index b) {
    return (std::uint64_t(std::min(a, b)) << 32) | std::max(a, b);
}

class Bands {
public:
    Bands(const ValleyInput& input, const Valleys& valleys)
        : in_(input), valleys_(valleys), radius_(input.cover->radius()), longest_(edge_share * radius_),
          marks_(input.mesh->box(), mark_cell(), radius_) {}

    std::vector<RestBand> run(const Progress& progress) {
        mark(progress.part(0, 0.05));
        divide(progress.part(0.05, 0.25));
        measure(progress.part(0.25, 0.85, "Measuring what is left"));
        own(progress.part(0.85, 0.87));
        return cut_out(progress.part(0.87, 1));
    }

private:
    struct Leaf {
        std::array<Index, 3> corner;
        Index facet;
        int owner = -1; ///< a curve, or behind them a hollow
        bool in = false;
    };

    double mark_cell() const {
        const Vec3 size = in_.mesh->box().size();
        return std::max(mark_share * radius_, std::sqrt(size.x() * size.y() / 1.6e7));
    }

    void mark(const Progress& progress) {
        // Samples are not farther apart than a quarter of the radius.
        for (std::size_t i = 0; i < valleys_.samples.size(); ++i) {
            if (i % check_every == 0) progress.check();
            marks_.mark(valleys_.samples[i].point.head<2>(), 0.25 * radius_);
        }
        marks_.finish();
    }

    Index middle(Index a, Index b) {
        const auto [found, is_new] = middles_.try_emplace(pair_of(a, b), Index(points_.size()));
        if (is_new) points_.push_back(0.5 * (points_[a] + points_[b]));
        return found->second;
    }

    bool splits(Index a, Index b) const {
        const Vec3 &p = points_[a], &q = points_[b];
        return (p - q).norm() > longest_ && marks_.any(p.cwiseMin(q).head<2>(), p.cwiseMax(q).head<2>());
    }

    /// Edges are halved by what they are themselves, so that neighbours agree.
    void divide(const std::array<Index, 3>& c, Index facet, int depth) {
        const Vec3 lo = points_[c[0]].cwiseMin(points_[c[1]]).cwiseMin(points_[c[2]]);
        const Vec3 hi = points_[c[0]].cwiseMax(points_[c[1]]).cwiseMax(points_[c[2]]);
        if (!marks_.any(lo.head<2>(), hi.head<2>())) return;
        int split = -1, splits_count = 0, whole = -1;
        for (int k = 0; k < 3; ++k) {
            if (splits(c[std::size_t(k)], c[std::size_t((k + 1) % 3)])) {
                ++splits_count;
                split = k;
            } else {
                whole = k;
            }
        }
        // A large facet of which no edge is near to a band may still hold one.
        bool inside = false;
        if (splits_count == 0) {
            double longest = 0;
            for (std::size_t k = 0; k < 3; ++k)
                longest = std::max(longest, (points_[c[k]] - points_[c[(k + 1) % 3]]).norm());
            inside = longest > longest_;
        }
        if (depth == max_divisions || (splits_count == 0 && !inside)) {
            leaves_.push_back({c, facet, -1, false});
            return;
        }
        const auto at = [&](int k) { return c[std::size_t(k % 3)]; };
        if (splits_count == 0) {
            const auto center = Index(points_.size());
            points_.push_back((points_[c[0]] + points_[c[1]] + points_[c[2]]) / 3);
            for (int k = 0; k < 3; ++k)
                divide({at(k), at(k + 1), center}, facet, depth + 1);
        } else if (splits_count == 3) {
            const Index m[3] = {middle(c[0], c[1]), middle(c[1], c[2]), middle(c[2], c[0])};
            divide({c[0], m[0], m[2]}, facet, depth + 1);
            divide({m[0], c[1], m[1]}, facet, depth + 1);
            divide({m[2], m[1], c[2]}, facet, depth + 1);
            divide({m[0], m[1], m[2]}, facet, depth + 1);
        } else if (splits_count == 1) {
            const Index m = middle(at(split), at(split + 1));
            divide({at(split), m, at(split + 2)}, facet, depth + 1);
            divide({m, at(split + 1), at(split + 2)}, facet, depth + 1);
        } else {
            // The edge from `whole` stays; both others are halved.
            const Index m1 = middle(at(whole + 1), at(whole + 2)), m2 = middle(at(whole + 2), at(whole));
            divide({m2, m1, at(whole + 2)}, facet, depth + 1);
            divide({at(whole), at(whole + 1), m1}, facet, depth + 1);
            divide({at(whole), m1, m2}, facet, depth + 1);
        }
    }

    void divide(const Progress& progress) {
        const Mesh& mesh = *in_.mesh;
        points_ = mesh.vertices;
        if (valleys_.samples.empty()) return;
        for (std::size_t f = 0; f < mesh.facet_count(); ++f) {
            if (f % check_every == 0) progress.set(double(f) / double(mesh.facet_count()));
            const Vec3 n = in_.side->towards_tool(mesh.facet_normal(f));
            if (n == Vec3::Zero() || n.z() < -tolerance::vertical_normal_z) continue;
            divide(mesh.facets[f], Index(f), 0);
        }
    }

    void measure(const Progress& progress) {
        // The facets that each corner is seen with, of corner c facets[first[c]] and on, and the corners of
        // any.
        std::vector<std::uint32_t> first(points_.size() + 1, 0);
        for (const Leaf& l : leaves_)
            for (const Index c : l.corner)
                ++first[c + 1];
        std::vector<Index> asked;
        for (std::size_t c = 0; c < points_.size(); ++c) {
            if (first[c + 1] > 0) asked.push_back(Index(c));
            first[c + 1] += first[c];
        }
        std::vector<Index> facets(first.back());
        std::vector<std::uint32_t> next(first.begin(), first.end() - 1);
        for (const Leaf& l : leaves_)
            for (const Index c : l.corner)
                facets[next[c]++] = l.facet;
        progress.check();
        PointGrid tips(radius_);
        for (std::size_t i = 0; i < valleys_.tips.size(); ++i) {
            const Vec3& tip = valleys_.tips[i].tip;
            tips.add(Vec3(tip.x(), tip.y(), 0));
        }
        gap_.assign(points_.size(), 0);
        nearest_.assign(points_.size(), -1);
        parallel_blocks(asked.size(), 64, progress, [&](std::size_t begin, std::size_t end) {
            LiftHint hint;
            for (std::size_t s = begin; s < end; ++s) {
                const Index v = asked[s];
                const Vec3& p = points_[v];
                RestSample nearest;
                nearest.gap = infinity;
                Vec3 last = Vec3::Zero();
                for (std::uint32_t i = first[v]; i < first[v + 1] && nearest.gap > in_.tolerance; ++i) {
                    const Vec3 n = in_.side->towards_tool(in_.mesh->facet_normal(facets[i]));
                    if (n.dot(last) > same_normal) continue;
                    last = n;
                    const RestSample by = nearest_touch(in_, p, n, hint);
                    if (by.gap < nearest.gap) nearest = by;
                }
                if (nearest.gap > in_.tolerance) {
                    double least = infinity;
                    // What a curve's tips leave, of those that come near.
                    std::vector<std::pair<int, double>> by_curve;
                    // A cutter is nearer than the distance of its axis less the radius nowhere.
                    for (const double share : {aside, 1.5, 2.5, 4.0}) {
                        const double within = share * radius_;
                        by_curve.clear();
                        tips.near(Vec3(p.x(), p.y(), 0), within, [&](std::size_t t) {
                            const Valleys::Tip& tip = valleys_.tips[t];
                            const Vec3 rel = p - tip.tip;
                            const double most = least + alike * in_.tolerance + radius_;
                            if (rel.head<2>().squaredNorm() > most * most) return;
                            const double d = in_.cover->distance(rel);
                            least = std::min(least, d);
                            for (auto& [curve, left] : by_curve)
                                if (curve == tip.curve) {
                                    left = std::min(left, d);
                                    return;
                                }
                            by_curve.emplace_back(tip.curve, d);
                        });
                        if (least + radius_ <= within) break;
                    }
                    const int by = owner_of(p, by_curve, least);
                    nearest_[v] = by;
                    // Of a valley's band the valley's own tips come nearest; a place for which they do not
                    // may have a normal that says nothing, of a needle on a noisy plane.
                    nearest.gap =
                        nearest.gap < least
                            ? nearest_about(in_, nearest, in_.tolerance, last_step * radius_, hint).gap
                            : least;
                }
                gap_[v] = nearest.gap;
            }
        });
    }

    /// The curve that a place of a band belongs to. Where two leave alike, as about the corner in which they
    /// meet, it is the one with the nearer centre; -1 where none comes near.
    int owner_of(const Vec3& p, const std::vector<std::pair<int, double>>& left, double least) const {
        const auto is_alike = [&](const auto& by) { return by.second <= least + alike * in_.tolerance; };
        // Mostly there is one, and nothing to compare.
        if (std::count_if(left.begin(), left.end(), is_alike) == 1)
            return std::find_if(left.begin(), left.end(), is_alike)->first;
        int owner = -1;
        double nearest = infinity;
        for (const auto& by : left) {
            if (!is_alike(by)) continue;
            const int curve = by.first;
            const double away = curve >= 0 ? from_center(p, curve) : infinity;
            if (away > nearest || (away == nearest && owner >= 0 && (curve < 0 || owner < curve))) continue;
            owner = curve;
            nearest = away;
        }
        return owner;
    }
    double from_center(const Vec3& p, int curve) const {
        double least = infinity;
        for (const PencilPoint& q : valleys_.curves[std::size_t(curve)].points)
            least = std::min(least, (q.center - p).squaredNorm());
        return least;
    }

    void own(const Progress& progress) {
        const int curves = int(valleys_.curves.size());
        // The leaves in the band at point c: at[first[c]] and on.
        std::vector<std::uint32_t> first(points_.size() + 1, 0);
        for (std::size_t i = 0; i < leaves_.size(); ++i) {
            if (i % check_every == 0) progress.check();
            Leaf& l = leaves_[i];
            double most = 0;
            for (const Index c : l.corner) {
                l.in = l.in || gap_[c] > in_.tolerance;
                if (nearest_[c] >= 0 && gap_[c] > most) {
                    most = gap_[c];
                    l.owner = nearest_[c];
                }
            }
            if (!l.in) continue;
            for (const Index c : l.corner)
                ++first[c + 1];
        }
        std::partial_sum(first.begin(), first.end(), first.begin());
        std::vector<std::uint32_t> at(first.back()), next(first.begin(), first.end() - 1);
        for (std::size_t i = 0; i < leaves_.size(); ++i)
            if (leaves_[i].in)
                for (const Index c : leaves_[i].corner)
                    at[next[c]++] = std::uint32_t(i);
        // What has no valley above it belongs to the valley beside it.
        std::vector<std::uint32_t> queue;
        const auto spread = [&](std::size_t begin) {
            for (std::size_t q = begin; q < queue.size(); ++q) {
                if (q % check_every == 0) progress.check();
                const Leaf l = leaves_[queue[q]];
                for (const Index c : l.corner)
                    for (std::uint32_t k = first[c]; k < first[c + 1]; ++k)
                        if (const std::uint32_t o = at[k]; leaves_[o].owner < 0 && gap_[c] > in_.tolerance) {
                            leaves_[o].owner = l.owner;
                            queue.push_back(o);
                        }
            }
        };
        for (std::size_t i = 0; i < leaves_.size(); ++i)
            if (leaves_[i].in && leaves_[i].owner >= 0) queue.push_back(std::uint32_t(i));
        spread(0);
        owners_ = curves;
        for (std::size_t i = 0; i < leaves_.size(); ++i) {
            if (!leaves_[i].in || leaves_[i].owner >= 0) continue;
            leaves_[i].owner = owners_++;
            queue.push_back(std::uint32_t(i));
            spread(queue.size() - 1);
        }
    }

    /// Where the gap is the tolerance on the edge between two points.
    Index crossing(Index a, Index b) {
        const auto [found, is_new] = crossings_.try_emplace(pair_of(a, b), Index(points_.size()));
        if (is_new) {
            const Index lo = std::min(a, b), hi = std::max(a, b);
            const double t = std::clamp((in_.tolerance - gap_[lo]) / (gap_[hi] - gap_[lo]), 0.0, 1.0);
            points_.push_back(points_[lo] + t * (points_[hi] - points_[lo]));
        }
        return found->second;
    }

    /// Where the centres of two points' curves are equally far on the edge between them.
    Index border(Index a, int owner_a, Index b, int owner_b) {
        const auto [found, is_new] = borders_.try_emplace(pair_of(a, b), Index(points_.size()));
        if (is_new) {
            const auto nearer = [&](Index c, int mine, int others) {
                return std::sqrt(from_center(points_[c], others)) - std::sqrt(from_center(points_[c], mine));
            };
            const double at_a = std::max(nearer(a, owner_a, owner_b), 0.0),
                         at_b = std::max(nearer(b, owner_b, owner_a), 0.0);
            const double t = at_a + at_b > 0 ? at_a / (at_a + at_b) : 0.5;
            points_.push_back(points_[a] + std::clamp(t, min_part, 1 - min_part) * (points_[b] - points_[a]));
        }
        return found->second;
    }

    std::vector<RestBand> cut_out(const Progress& progress) {
        const int curves = int(valleys_.curves.size());
        std::vector<RestBand> bands;
        bands.resize(std::size_t(owners_));
        std::vector<std::unordered_map<std::uint64_t, int>> edges(bands.size());
        std::vector<std::array<Index, 2>> reach_at; // point, owner
        for (std::size_t i = 0; i < leaves_.size(); ++i) {
            if (i % check_every == 0) progress.check();
            const Leaf& l = leaves_[i];
            if (!l.in || l.owner < 0) continue;
            std::vector<Index> outline;
            std::vector<int> owner; // of its points
            for (std::size_t k = 0; k < 3; ++k) {
                const Index a = l.corner[k], b = l.corner[(k + 1) % 3];
                const bool in_a = gap_[a] > in_.tolerance, in_b = gap_[b] > in_.tolerance;
                const auto of = [&](Index c) { return nearest_[c] >= 0 ? nearest_[c] : l.owner; };
                if (in_a) {
                    outline.push_back(a);
                    owner.push_back(of(a));
                    RestBand& band = bands[std::size_t(of(a))];
                    band.depth = std::max(band.depth, gap_[a]);
                }
                if (in_a != in_b) {
                    outline.push_back(crossing(a, b));
                    owner.push_back(of(in_a ? a : b));
                }
            }
            const auto add = [&](const std::vector<Index>& part, int to) {
                RestBand& band = bands[std::size_t(to)];
                auto& map = edges[std::size_t(to)];
                for (std::size_t k = 0; k < part.size(); ++k) {
                    const Index a = part[k], b = part[(k + 1) % part.size()];
                    if (a == b) continue;
                    // An edge that another facet runs along the other way is inside.
                    const std::uint64_t there = (std::uint64_t(a) << 32) | b,
                                        back = (std::uint64_t(b) << 32) | a;
                    if (const auto twin = map.find(back); twin != map.end()) {
                        if (--twin->second == 0) map.erase(twin);
                    } else {
                        ++map[there];
                    }
                    reach_at.push_back({a, Index(to)});
                }
                for (std::size_t k = 2; k < part.size(); ++k) {
                    const Vec3 &a = points_[part[0]], &b = points_[part[k - 1]], &c = points_[part[k]];
                    band.band.push_back({a, b, c});
                    band.area += 0.5 * (b - a).cross(c - a).norm();
                }
            };
            // Where bands meet it is divided among them, where three do about its middle.
            const std::size_t n = outline.size();
            std::vector<std::size_t> first; // of the points of each
            for (std::size_t k = 0; k < n; ++k)
                if (owner[k] != owner[(k + n - 1) % n]) first.push_back(k);
            if (first.empty()) {
                add(outline, owner.front());
                continue;
            }
            Index middle = no_index;
            if (first.size() > 2) {
                Vec3 sum = Vec3::Zero();
                for (const Index p : outline)
                    sum += points_[p];
                middle = Index(points_.size());
                points_.push_back(sum / double(n));
            }
            for (std::size_t j = 0; j < first.size(); ++j) {
                const std::size_t from = first[j], to = first[(j + 1) % first.size()];
                const auto before = [&](std::size_t k) {
                    const std::size_t last = (k + n - 1) % n;
                    return border(outline[last], owner[last], outline[k], owner[k]);
                };
                std::vector<Index> part{before(from)};
                for (std::size_t k = from; k != to; k = (k + 1) % n)
                    part.push_back(outline[k]);
                part.push_back(before(to));
                if (middle != no_index) part.push_back(middle);
                add(part, owner[from]);
            }
        }
        for (std::size_t i = 0; i < bands.size(); ++i) {
            progress.check();
            bands[i].curve = int(i) < curves ? int(i) : -1;
            bands[i].boundaries = chained(edges[i]);
        }
        reach(bands, reach_at, progress);
        std::vector<RestBand> result;
        for (std::size_t i = 0; i < bands.size(); ++i) {
            RestBand& band = bands[i];
            if (band.band.empty()) continue;
            if (band.curve < 0) {
                Box3 box;
                for (const auto& t : band.band)
                    for (const Vec3& p : t)
                        box.add(p);
                if (box.diagonal() < 2 * in_.ripple) continue;
                band.length = box.diagonal();
            }
            result.push_back(std::move(band));
        }
        std::stable_sort(result.begin(), result.end(), [](const RestBand& a, const RestBand& b) {
            if ((a.curve < 0) != (b.curve < 0)) return b.curve < 0;
            return a.curve < 0 && a.area > b.area;
        });
        return result;
    }

    std::vector<std::vector<Vec3>> chained(const std::unordered_map<std::uint64_t, int>& edges) const {
        std::vector<std::pair<std::uint64_t, int>> ordered(edges.begin(), edges.end());
        std::sort(ordered.begin(), ordered.end());
        std::multimap<Index, Index> next;
        for (const auto& [edge, count] : ordered)
            for (int k = 0; k < count; ++k)
                next.emplace(Index(edge >> 32), Index(edge & 0xFFFFFFFFu));
        std::vector<std::vector<Vec3>> loops;
        while (!next.empty()) {
            std::vector<Vec3> loop;
            auto edge = next.begin();
            const Index first = edge->first;
            Index at = first;
            do {
                edge = next.find(at);
                if (edge == next.end()) break;
                loop.push_back(points_[at]);
                at = edge->second;
                next.erase(edge);
            } while (at != first);
            if (loop.size() > 2) loops.push_back(std::move(loop));
        }
        return loops;
    }

    /// How far the bands reach to either side of their curves.
    void reach(std::vector<RestBand>& bands, std::vector<std::array<Index, 2>>& at,
               const Progress& progress) const {
        std::sort(at.begin(), at.end(),
                  [](const auto& a, const auto& b) { return a[1] != b[1] ? a[1] < b[1] : a[0] < b[0]; });
        at.erase(std::unique(at.begin(), at.end()), at.end());
        std::size_t i = 0;
        for (std::size_t c = 0; c < valleys_.curves.size(); ++c) {
            const ValleyCurve& curve = valleys_.curves[c];
            RestBand& band = bands[c];
            const std::vector<Vec3> along = tangents(curve);
            band.reach.assign(curve.points.size(), {0, 0});
            band.flank.assign(curve.points.size(), {0, 0});
            PointGrid centers(radius_);
            for (std::size_t k = 0; k < curve.points.size(); ++k)
                centers.add(curve.points[k].center);
            for (std::size_t k = 1; k < curve.points.size() + (curve.closed ? 1 : 0); ++k)
                band.length +=
                    (curve.points[k % curve.points.size()].center - curve.points[k - 1].center).norm();
            for (; i < at.size() && at[i][1] <= c; ++i) {
                if (i % check_every == 0) progress.check();
                if (at[i][1] < c) continue;
                const Vec3& p = points_[at[i][0]];
                std::size_t nearest = curve.points.size();
                double least = infinity;
                for (double r = radius_; nearest == curve.points.size() && r < 64 * radius_; r *= 2)
                    centers.near(p, r, [&](std::size_t k) {
                        const double d = (curve.points[k].center - p).squaredNorm();
                        if (d < least || (d == least && k < nearest)) {
                            least = d;
                            nearest = k;
                        }
                    });
                if (nearest == curve.points.size()) continue;
                const PencilPoint& q = curve.points[nearest];
                const Vec3 rel = p - q.center;
                const double across = rel.dot(left_of(along[nearest], q.up));
                const std::size_t side = across >= 0 ? 0 : 1;
                band.reach[nearest][side] = std::max(band.reach[nearest][side], std::abs(across));
                const double flank = (rel - rel.dot(along[nearest]) * along[nearest]).norm();
                band.flank[nearest][side] = std::max(band.flank[nearest][side], flank);
            }
            for (const auto& f : band.flank)
                band.width = std::max(band.width, f[0] + f[1]);
        }
    }

    const ValleyInput& in_;
    const Valleys& valleys_;
    double radius_, longest_;
    Marks marks_;
    std::vector<Vec3> points_;
    std::vector<Leaf> leaves_;
    std::vector<double> gap_;
    std::vector<int> nearest_;
    std::unordered_map<std::uint64_t, Index> middles_, crossings_, borders_;
    int owners_ = 0;
};

} // namespace

std::vector<Vec3> tangents(const ValleyCurve& curve) {
    const auto& p = curve.points;
    const std::size_t n = p.size();
    std::vector<Vec3> result(n, Vec3::Zero());
    for (std::size_t i = 0; i < n; ++i) {
        const std::size_t before = i > 0          ? i - 1
                                   : curve.closed ? n - 1
                                                  : i,
                          after = i + 1 < n      ? i + 1
                                  : curve.closed ? 0
                                                 : i;
        const Vec3 center = p[after].center - p[before].center;
        Vec3 tip = p[after].tip - p[before].tip;
        tip -= tip.dot(p[i].up) * p[i].up;
        // Around the foot of an upright edge the centre stands still, and the tip goes on.
        const Vec3 d = center.norm() >= standing * tip.norm() ? center : tip;
        if (d.norm() > 0) result[i] = d.normalized();
    }
    return result;
}

Vec3 left_of(const Vec3& tangent, const Vec3& up) {
    const Vec3 left = up.cross(tangent);
    return left.norm() > tolerance::level_angle ? Vec3(left.normalized()) : Vec3(Vec3::Zero());
}

std::vector<RestBand> rest_bands(const ValleyInput& input, const Valleys& valleys, const Progress& progress) {
    return Bands(input, valleys).run(progress);
}

} // namespace facetmill
