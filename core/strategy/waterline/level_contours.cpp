#include "core/strategy/waterline/level_contours.h"

#include <algorithm>
#include <cmath>

namespace facetmill {

namespace {

/// How near to the border a free place is, in what the contour may lie beside it: as far as the first, so
/// that straight pieces between such places are free, but no lower than the third. On the steepest slopes
/// that would be too near to be found, and the second will do.
constexpr double border_share = 0.5, nearest_share = 0.1, lowest_share = 0.8;
/// Halvings between two crossings, at most: corners end where pieces are short.
constexpr int deepest_piece = 14;

} // namespace

/// From grid edge to grid edge, cell by cell, with what is too high on the left. An edge's number is twice
/// that of its first place, and one more where it runs along a column.
std::vector<std::pair<std::uint32_t, std::uint32_t>> ContourFinder::steps(double z,
                                                                          const Progress& progress) const {
    std::vector<std::pair<std::uint32_t, std::uint32_t>> all;
    const auto is_high = [&](int column, int row) { return field_.height(column, row) > z; };
    for (int row = 0; row + 1 < field_.rows(); ++row) {
        if (row % 64 == 0) progress.check();
        for (int b = 0; b < field_.blocks(); ++b) {
            if (!field_.crosses(row, b, z)) continue;
            const int end = std::min((b + 1) * LevelField::block, field_.columns() - 1);
            for (int column = b * LevelField::block; column < end; ++column) {
                // Corners counter-clockwise, and the edge from each to the next.
                const bool high[4] = {is_high(column, row), is_high(column + 1, row),
                                      is_high(column + 1, row + 1), is_high(column, row + 1)};
                if (high[0] == high[1] && high[1] == high[2] && high[2] == high[3]) continue;
                const auto edge = [&](int c, int r, unsigned along) {
                    return std::uint32_t(2 * field_.number(c, r) + along);
                };
                const std::uint32_t edges[4] = {edge(column, row, 0), edge(column + 1, row, 1),
                                                edge(column, row + 1, 0), edge(column, row, 1)};
                for (std::size_t k = 0; k < 4; ++k) {
                    if (!high[k] || high[(k + 1) % 4]) continue;
                    // High places that meet at a corner are taken to be joined.
                    std::size_t to = (k + 1) % 4;
                    while (high[to] || !high[(to + 1) % 4])
                        to = (to + 1) % 4;
                    all.emplace_back(edges[k], edges[to]);
                }
            }
        }
    }
    std::sort(all.begin(), all.end());
    return all;
}

std::vector<ContourFinder::Chain> ContourFinder::chains(double z, const Progress& progress) const {
    const auto all = steps(z, progress);
    std::vector<std::uint32_t> ends;
    ends.reserve(all.size());
    for (const auto& s : all)
        ends.push_back(s.second);
    std::sort(ends.begin(), ends.end());
    std::vector<char> used(all.size(), 0);
    std::vector<Chain> chains;
    const auto step_from = [&](std::uint32_t edge) {
        const auto at = std::lower_bound(all.begin(), all.end(), std::pair(edge, std::uint32_t(0)));
        return at != all.end() && at->first == edge ? std::size_t(at - all.begin()) : all.size();
    };
    const auto follow = [&](std::size_t first) {
        Chain chain;
        chain.edges.push_back(all[first].first);
        for (std::size_t i = first; i < all.size() && !used[i]; i = step_from(all[i].second)) {
            used[i] = 1;
            chain.edges.push_back(all[i].second);
        }
        if (chain.edges.front() == chain.edges.back()) {
            chain.closed = true;
            chain.edges.pop_back();
        }
        chains.push_back(std::move(chain));
    };
    // Those that begin at the field's border, then the closed ones.
    for (std::size_t i = 0; i < all.size(); ++i)
        if (!std::binary_search(ends.begin(), ends.end(), all[i].first)) follow(i);
    for (std::size_t i = 0; i < all.size(); ++i)
        if (!used[i]) follow(i);
    return chains;
}

/// The runs of chains whose edges are `in`.
std::vector<ContourFinder::Chain> ContourFinder::cut_to(std::vector<Chain> chains,
                                                        const std::function<bool(std::uint32_t)>& in) {
    std::vector<Chain> cut;
    for (Chain& chain : chains) {
        const std::size_t n = chain.edges.size();
        std::vector<char> inside(n);
        for (std::size_t i = 0; i < n; ++i)
            inside[i] = in(chain.edges[i]);
        const auto out = std::find(inside.begin(), inside.end(), 0);
        if (out == inside.end()) {
            cut.push_back(std::move(chain));
            continue;
        }
        // Of a closed one, from a place that is out, so that no run goes over its end.
        const auto first = chain.closed ? std::size_t(out - inside.begin()) : 0;
        Chain run;
        const auto finish = [&] {
            if (run.edges.size() > 1) cut.push_back(std::move(run));
            run = {};
        };
        for (std::size_t k = 0; k < n; ++k) {
            const std::size_t i = (first + k) % n;
            if (inside[i])
                run.edges.push_back(chain.edges[i]);
            else
                finish();
        }
        finish();
    }
    return cut;
}

std::vector<Contour> ContourFinder::contours(const Level& level, const Progress& progress) const {
    std::vector<Chain> all =
        cut_to(chains(level.z, progress), [this](std::uint32_t edge) { return choice_.is_steep(edge / 2); });
    if (!level.cells.empty()) {
        // Cells beside those that ask count too, two on either side.
        const auto columns = std::uint32_t(field_.columns());
        const auto asked = [&](std::uint32_t edge) {
            constexpr std::uint32_t around = 2;
            const std::uint32_t cell = edge / 2;
            for (std::uint32_t k = 0; k <= 2 * around; ++k) {
                const std::int64_t first =
                    std::int64_t(cell) + (std::int64_t(k) - around) * std::int64_t(columns) - around;
                if (first + 2 * around < 0) continue;
                const auto at = std::lower_bound(level.cells.begin(), level.cells.end(),
                                                 std::uint32_t(std::max<std::int64_t>(first, 0)));
                if (at != level.cells.end() && std::int64_t(*at) <= first + 2 * around) return true;
            }
            return false;
        };
        all = cut_to(std::move(all), asked);
    }
    std::vector<Contour> result;
    At at{level.z, {}, progress};
    for (const Chain& chain : all) {
        progress.check();
        Contour contour;
        contour.closed = chain.closed;
        std::vector<Vec2> nodes;
        nodes.reserve(chain.edges.size());
        for (std::size_t i = 0; i < chain.edges.size(); ++i) {
            if (i % 64 == 63) progress.check();
            nodes.push_back(crossing(chain.edges[i], at));
        }
        if (nodes.size() < 2) continue;
        contour.places.push_back({nodes.front(), true});
        for (std::size_t i = 1; i < nodes.size(); ++i) {
            if (i % 64 == 63) progress.check();
            divide(nodes[i - 1], nodes[i], 0, at, contour.places);
        }
        if (chain.closed) {
            divide(nodes.back(), nodes.front(), 0, at, contour.places);
            contour.places.front().joined = contour.places.back().joined;
            contour.places.pop_back();
        }
        result.push_back(std::move(contour));
    }
    return result;
}

Vec2 ContourFinder::crossing(std::uint32_t edge, At& at) const {
    const auto columns = std::uint32_t(field_.columns());
    const int column = int(edge / 2 % columns), row = int(edge / 2 / columns);
    const int next_column = column + (edge % 2 == 0 ? 1 : 0), next_row = row + (edge % 2 == 0 ? 0 : 1);
    const Vec2 a = field_.place(column, row), b = field_.place(next_column, next_row);
    const double za = field_.height(column, row), zb = field_.height(next_column, next_row);
    return za <= at.z ? border(a, za, b, zb, at) : border(b, zb, a, za, at);
}

/// A free place beside the border between a free place and one that is too high.
Vec2 ContourFinder::border(Vec2 free, double free_z, Vec2 blocked, double blocked_z, At& at) const {
    const double above = tolerance_.above, near = nearest_share * above;
    for (int k = 0;; ++k) {
        const double apart = (blocked - free).norm();
        // On a slope a free place is nearer to the border in the plan than its height is to the level.
        const bool is_slope = free_z > -infinity && blocked_z > free_z;
        const double slope = is_slope ? (blocked_z - free_z) / apart : 0.0;
        const double steep = std::max(slope, 1.0);
        const double below =
            std::max(near * steep, std::min(border_share * above * steep, lowest_share * above));
        if (!(apart > near) || at.z - free_z <= below) break;
        if (is_slope) at.slope = slope;
        // Straight between the two heights, mostly; halved where that comes no nearer.
        double share = 0.5;
        if (k % 3 != 2 && is_slope)
            share = std::clamp((at.z - 0.5 * below - free_z) / (blocked_z - free_z), 0.02, 0.98);
        const Vec2 p = free + share * (blocked - free);
        const double z = tip_z(p, at);
        if (z <= at.z) {
            free = p;
            free_z = z;
        } else {
            blocked = p;
            blocked_z = z;
        }
    }
    return free;
}

/// The border beside the middle of a piece, on the side on which it is.
std::optional<Vec2> ContourFinder::beside(const Vec2& a, const Vec2& b, bool middle_free, double middle_z,
                                          At& at) const {
    const Vec2 along = b - a, middle = 0.5 * (a + b);
    const double length = along.norm();
    const Vec2 left = Vec2(-along.y(), along.x()) / length, towards = middle_free ? left : Vec2(-left);
    Vec2 last = middle;
    double last_z = middle_z;
    // As far as the slope beside the last place says, and a little: then the border lies between.
    double away = tolerance_.above;
    if (at.slope > 0 && middle_z > -infinity)
        away = std::clamp(1.25 * std::abs(at.z - middle_z) / at.slope, away, 0.5 * length);
    for (; away <= 0.75 * length + tolerance_.above; away *= 2) {
        const Vec2 p = middle + away * towards;
        const double z = tip_z(p, at);
        if ((z <= at.z) != middle_free)
            return middle_free ? border(last, last_z, p, z, at) : border(p, z, last, last_z, at);
        last = p;
        last_z = z;
    }
    return std::nullopt;
}

/// Appends what lies between two free places, and the second.
void ContourFinder::divide(const Vec2& a, const Vec2& b, int depth, At& at,
                           std::vector<ContourPlace>& out) const {
    const double length = (b - a).norm();
    if (length <= tolerance_.shortest() || depth >= deepest_piece) {
        // As short as that hides nothing; at a guard's end the tool does not go straight.
        out.push_back({b, length <= 2 * tolerance_.above});
        return;
    }
    const Vec2 middle = 0.5 * (a + b);
    const double z = tip_z(middle, at);
    const bool free = z <= at.z;
    if (free) {
        const Vec2 left = Vec2(a.y() - b.y(), b.x() - a.x()) / length;
        const Vec2 p = middle + tolerance_.above * left;
        const bool ends =
            at.z - z <= border_share * tolerance_.above || lift_.is_above(p.x(), p.y(), at.z, at.hint);
        if (ends && length <= 2 * tolerance_.spacing) {
            out.push_back({middle, true});
            out.push_back({b, true});
            return;
        }
        if (ends) {
            divide(a, middle, depth + 1, at, out);
            divide(middle, b, depth + 1, at, out);
            return;
        }
    }
    const auto place = beside(a, b, free, z, at);
    if (place && (*place - a).norm() < length && (*place - b).norm() < length) {
        divide(a, *place, depth + 1, at, out);
        divide(*place, b, depth + 1, at, out);
        return;
    }
    if (free) { // a slit that is narrower than the grid: the contour does not go into it
        if (length <= 2 * tolerance_.spacing) {
            out.push_back({middle, true});
            out.push_back({b, true});
        } else {
            divide(a, middle, depth + 1, at, out);
            divide(middle, b, depth + 1, at, out);
        }
        return;
    }
    out.push_back({b, false});
}

} // namespace facetmill
