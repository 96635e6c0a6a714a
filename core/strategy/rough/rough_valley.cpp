#include "core/strategy/rough/rough_valley.h"

#include "core/base/golden_section.h"
#include "core/base/parallel.h"

#include <algorithm>
#include <cmath>

namespace facetmill {

namespace {

/// Shares of a cell of the grid: to the first the floor is known; in the next row it lies on no farther aside
/// than the second.
constexpr double floor_accuracy = 0.004, farthest_aside = 2;
/// Nearer than this share of a cell a node says nothing of how steep the side is.
constexpr double min_run = 0.1;
/// The lift of a level floor bends from node to node by less than this share of the margin.
constexpr double min_bend = 0.02;
/// Halvings of a straight line along a floor that bends.
constexpr int max_valley_halvings = 6;

/// A place of a floor on a row or a column of the grid.
struct RowPlace {
    double at = 0; ///< along the row, in cells
    Vec3 tip = Vec3::Zero();
    double seen = 0;
    std::array<Vec2, 2> beside;
    bool deep = false, used = false;
};

class Finder {
public:
    Finder(const RoughReach& reach, const ReachGrid& grid, double low, double high, double reach_up,
           const FloorTooHigh& too_high, bool by_rows)
        : reach_(reach), grid_(grid), low_(low), high_(high), reach_up_(reach_up), too_high_(too_high),
          by_rows_(by_rows), lines_(by_rows ? grid.rows() : grid.columns()),
          length_(by_rows ? grid.columns() : grid.rows()) {}

    void run(std::vector<ReachValley>& valleys, const Progress& progress) {
        places_.resize(lines_);
        parallel_for(lines_, 1, progress, [&](std::size_t line) { look_along(line, progress); });
        for (std::size_t line = 0; line + 1 < lines_; ++line) {
            progress.check();
            for (RowPlace& p : places_[line])
                if (!p.used) follow(line, p, valleys);
        }
    }

private:
    double height(std::size_t line, std::size_t k) const {
        return by_rows_ ? grid_.height(k, line) : grid_.height(line, k);
    }
    Vec2 node(std::size_t line, std::size_t k) const {
        return by_rows_ ? grid_.place(k, line) : grid_.place(line, k);
    }

    /// Twice the height of the lift's chord over a node.
    double bend(std::size_t line, std::size_t k) const {
        return height(line, k - 1) + height(line, k + 1) - 2 * height(line, k);
    }

    void look_along(std::size_t line, const Progress& progress) {
        RoughReach::Hints hints;
        for (std::size_t k = 1; k + 1 < length_; ++k) {
            const double h = height(line, k), before = height(line, k - 1), after = height(line, k + 1);
            if (!(h > low_) || h == -infinity || before == -infinity || after == -infinity) continue;
            const double bent = bend(line, k);
            const bool lowest_node = h <= before && h < after;
            const bool sharp = bent > 2 * reach_.margin();
            if (!sharp && !(lowest_node && bent > min_bend * reach_.margin())) continue;
            // An edge between two nodes bends the lift at both, a hollow at many: the floor is at the lowest.
            const std::size_t lower = before < after ? k - 1 : k + 1;
            if (!lowest_node && lower > 0 && lower + 1 < length_ && bend(line, lower) > 2 * reach_.margin())
                continue;
            progress.check();
            const Vec2 from = node(line, k - 1), across_node = node(line, k + 1) - from;
            RowPlace p;
            p.at = double(k);
            p.tip = Vec3(node(line, k).x(), node(line, k).y(), h);
            if (sharp) {
                // Both sides rise as seen from the slope between theirs.
                const double tilt = lowest_node ? 0 : after - before;
                const auto lift = [&](double t) {
                    return reach_.tip_z(from + t * across_node, hints) - tilt * t;
                };
                const LowPlace lowest = golden_minimum(lift, 0, 1, 0.5 * floor_accuracy, -infinity);
                if (lowest.value + 0.5 * tilt < h) {
                    const Vec2 q = from + lowest.at * across_node;
                    p.at += 2 * lowest.at - 1;
                    p.tip = Vec3(q.x(), q.y(), std::max(lowest.value + tilt * lowest.at, low_));
                }
            }
            if (!(p.tip.z() < high_)) continue;
            p.seen = std::min({h, before, after});
            // The lowest node is one of them, unless it is the place itself.
            p.beside = {node(line, p.at > double(k) ? k : k - 1), node(line, p.at < double(k) ? k : k + 1)};
            p.deep = is_deep(line, k, p);
            places_[line].push_back(p);
        }
    }

    /// Looks along the row up either side, from node to node.
    bool is_deep(std::size_t line, std::size_t k, const RowPlace& p) const {
        const double cell = (node(line, k + 1) - node(line, k)).norm(), aside = (p.at - double(k)) * cell;
        FloorPlace floor;
        // By a hair higher than the node, it is still a floor at the node's height.
        floor.z = std::min(p.tip.z(), height(line, k));
        if (height(line, k - 1) >= floor.z && height(line, k + 1) >= floor.z && too_high_(floor)) return true;
        for (const bool up : {false, true}) {
            const auto next = [&](std::size_t i) { return up ? i + 1 : i - 1; };
            const std::size_t other = up ? k - 1 : k + 1;
            // Rather too gentle than too steep.
            floor.fall =
                std::max(0.0, (floor.z - height(line, other)) / std::max(cell + (up ? aside : -aside), cell));
            floor.rise = 0;
            double run = std::max(cell + (up ? -aside : aside), min_run * cell);
            for (std::size_t i = next(k); floor.rise < reach_up_; i = next(i)) {
                const double rise = height(line, i) - floor.z;
                if (!(rise > floor.rise) || !std::isfinite(rise)) break;
                floor.slope = std::hypot((rise - floor.rise) / run, across(line, i));
                if (too_high_(floor)) return true;
                if (i == 0 || i + 1 >= length_) break;
                floor.rise = rise;
                run = cell;
            }
        }
        return false;
    }

    /// How steep the lift is from row to row.
    double across(std::size_t line, std::size_t k) const {
        if (line == 0 || line + 1 >= lines_) return 0;
        const double rise = height(line + 1, k) - height(line - 1, k),
                     run = (node(line + 1, k) - node(line - 1, k)).norm();
        return std::isfinite(rise) && run > 0 ? std::abs(rise) / run : 0;
    }

    RowPlace* next_of(std::size_t line, const RowPlace& p) {
        RowPlace* best = nullptr;
        double nearest = farthest_aside;
        for (RowPlace& q : places_[line])
            if (const double d = std::abs(q.at - p.at); !q.used && d <= nearest) {
                nearest = d;
                best = &q;
            }
        return best;
    }

    void follow(std::size_t line, RowPlace& first, std::vector<ReachValley>& valleys) {
        ReachValley valley;
        const auto end = [&] {
            bool missed = false;
            for (std::size_t i = 0; i < valley.tips.size(); ++i)
                missed = missed || valley.deep[i]
                         || (!valley.between(i) && valley.seen[i] - valley.tips[i].z() > reach_.margin());
            if (valley.tips.size() > 1 && missed) valleys.push_back(std::move(valley));
            valley = {};
        };
        const auto add = [&](const RowPlace& p) {
            valley.tips.push_back(p.tip);
            valley.seen.push_back(p.seen);
            valley.deep.push_back(p.deep);
            valley.beside.push_back(p.beside);
        };
        first.used = true;
        add(first);
        const RowPlace* last = &first;
        RoughReach::Hints hints;
        for (++line; line < lines_; ++line) {
            RowPlace* next = next_of(line, *last);
            if (!next) break;
            next->used = true;
            const std::size_t before = valley.tips.size();
            if (!join(valley, *next, last->tip, next->tip, hints, 0)) {
                valley.tips.resize(before);
                valley.seen.resize(before);
                valley.deep.resize(before);
                valley.beside.resize(before);
                end();
            }
            add(*next);
            last = next;
        }
        end();
    }

    /// Points between a and b, on the lift where the straight line is not free. What lies between two places
    /// that were looked at is known only if they are near each other, upright too: where the lift jumps the
    /// floor ends.
    bool join(ReachValley& valley, const RowPlace& next, const Vec3& a, const Vec3& b,
              RoughReach::Hints& hints, int depth) const {
        Vec3 middle = 0.5 * (a + b);
        const double z = reach_.tip_z(middle.head<2>(), hints);
        const bool below = z - middle.z() > 0.25 * reach_.margin();
        if (!below && (b - a).norm() <= reach_.spacing()) return true;
        if (depth >= max_valley_halvings) return false;
        if (below) middle.z() = z;
        if (!join(valley, next, a, middle, hints, depth + 1)) return false;
        if (below) {
            valley.tips.push_back(middle);
            valley.seen.push_back(std::max(next.seen, z));
            valley.deep.push_back(next.deep);
            valley.beside.push_back({middle.head<2>(), middle.head<2>()});
        }
        return join(valley, next, middle, b, hints, depth + 1);
    }

    const RoughReach& reach_;
    const ReachGrid& grid_;
    double low_, high_, reach_up_;
    const FloorTooHigh& too_high_;
    bool by_rows_;
    std::size_t lines_, length_;
    std::vector<std::vector<RowPlace>> places_;
};

} // namespace

std::vector<ReachValley> find_valleys(const RoughReach& reach, const ReachGrid& grid, double low, double high,
                                      double reach_up, const FloorTooHigh& too_high,
                                      const Progress& progress) {
    std::vector<ReachValley> valleys;
    Finder(reach, grid, low, high, reach_up, too_high, true).run(valleys, progress.part(0, 0.5));
    Finder(reach, grid, low, high, reach_up, too_high, false).run(valleys, progress.part(0.5, 1));
    return valleys;
}

std::vector<FreeContour> unseen_channels(const RoughReach& reach, const std::vector<ReachValley>& valleys,
                                         double z, const Progress& progress) {
    std::vector<FreeContour> channels;
    RoughReach::Hints hints;
    for (const ReachValley& v : valleys) {
        const std::size_t n = v.tips.size();
        const auto free = [&](std::size_t i) { return v.tips[i].z() <= z; };
        const auto border = [&](std::size_t i, std::size_t side) {
            const Vec2 at = v.tips[i].head<2>(), to = v.beside[i][side];
            const double lift = reach.tip_z(to, hints);
            if (at == to || lift <= z) return to;
            return Vec2(at + reach.last_free(at, v.tips[i].z(), to, lift, z, hints) * (to - at));
        };
        for (std::size_t i = 0; i < n;) {
            if (!free(i) || v.seen[i] <= z) {
                ++i;
                continue;
            }
            std::size_t from = i, to = i;
            while (to + 1 < n && free(to + 1) && v.seen[to + 1] > z)
                ++to;
            i = to + 1;
            if (from > 0 && free(from - 1)) --from;
            if (to + 1 < n && free(to + 1)) ++to;
            if (to == from) continue;
            progress.check();
            FreeContour floor;
            std::array<FreeContour, 2> sides;
            double wide = 0;
            std::size_t last = from; // that had a border
            for (std::size_t k = from; k <= to; ++k) {
                floor.points.push_back(v.tips[k].head<2>());
                if (v.between(k)) continue;
                for (std::size_t side = 0; side < 2; ++side) {
                    std::vector<Vec2>& points = sides[side].points;
                    const Vec2 p = border(k, side);
                    // Where the sides bend so that the straight line is not free, along the floor.
                    if (!points.empty() && !reach.is_free(points.back(), p, z, hints))
                        for (std::size_t j = last; j <= k; ++j)
                            points.push_back(v.tips[j].head<2>());
                    points.push_back(p);
                }
                wide = std::max(wide, (sides[1].points.back() - sides[0].points.back()).norm());
                last = k;
            }
            if (wide <= reach.margin()) {
                channels.push_back(std::move(floor));
            } else {
                for (FreeContour& side : sides) {
                    side.points = thinned_route(side.points, 0.25 * reach.margin());
                    if (side.points.size() > 1) channels.push_back(std::move(side));
                }
            }
        }
    }
    return channels;
}

} // namespace facetmill
