#include "core/strategy/rough/rough_floor.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace facetmill {

namespace {

/// Walls are not judged as steeper than that: what stays on them is under the cutter's side.
const double steepest = 85 * pi / 180;
/// Tangent: where a floor rises more than that, it is a corner of walls, which layers cut.
constexpr double steepest_floor = 0.5;

} // namespace

FloorJudge::FloorJudge(const CutterProfile& profile, const std::vector<double>& heights, double top,
                       double most, double least)
    : cover_(profile, 0), heights_(heights), top_(top), max_(most), min_(least) {}

double FloorJudge::left(const FloorPlace& place) const {
    const auto below = std::upper_bound(heights_.begin(), heights_.end(), place.z, std::greater<>());
    const double above = below == heights_.begin() ? top_ : *(below - 1);
    const double high = above - place.z - place.rise;
    if (high <= min_) return 0;
    const double slope = std::min(std::atan(place.slope), steepest);
    const Vec3 n(std::sin(slope), 0, std::cos(slope));
    // The cutter that touches the place, raised to the layer above.
    const Vec3 raised = cover_.tip_offset(n) + Vec3(0, 0, high);
    const double over = cover_.ray_entry(Vec3::Zero(), n, raised, infinity);
    if (!(place.fall > 0) || below == heights_.end()) return over;
    // The next layer's border on the other side, and behind it the wall that the cutter left.
    const double aside = (place.z - *below) / place.fall + place.rise / std::max(place.slope, place.fall);
    return std::min(over, aside / n.x());
}

std::vector<std::vector<Vec3>> floor_stretches(const std::vector<Vec3>& tips, const std::vector<char>& busy,
                                               const std::vector<double>& stand, double gap, double beyond,
                                               double shortest) {
    std::vector<std::vector<Vec3>> stretches;
    const std::size_t n = tips.size();
    const auto piece = [&](std::size_t k) { return (tips[k + 1] - tips[k]).norm(); };
    const auto passable = [&](std::size_t k) {
        const Vec3 d = tips[k + 1] - tips[k];
        return std::abs(d.z()) <= steepest_floor * d.head<2>().norm();
    };
    for (std::size_t i = 0; i + 1 < n;) {
        if (!busy[i] || !passable(i)) {
            ++i;
            continue;
        }
        std::size_t from = i, to = i + 1;
        double length = 0, open = 0;
        for (std::size_t k = i; k + 1 < n && open <= gap && passable(k); ++k) {
            open = busy[k] ? 0 : open + piece(k);
            if (busy[k]) to = k + 1;
        }
        for (std::size_t k = from; k < to; ++k)
            length += piece(k);
        i = to;
        const auto stands_free = [&](std::size_t place, std::size_t end) {
            return stand[place] <= tips[end].z();
        };
        double back = 0, ahead = 0;
        std::size_t first = from, last = to;
        while (!stands_free(first, from) && first > 0 && back <= beyond && passable(first - 1))
            back += piece(--first);
        while (!stands_free(last, to) && last + 1 < n && ahead <= beyond && passable(last))
            ahead += piece(last++);
        const bool before = stands_free(first, from) && back <= beyond,
                   behind = stands_free(last, to) && ahead <= beyond;
        const bool low_end = before && !(behind && tips[last].z() < tips[first].z());
        std::vector<Vec3> route;
        if (low_end)
            for (std::size_t k = first; k < from; ++k)
                route.emplace_back(tips[k].x(), tips[k].y(), std::max(tips[k].z(), stand[first]));
        for (std::size_t k = from; k <= to; ++k)
            route.push_back(tips[k]);
        if (behind && !low_end)
            for (std::size_t k = to + 1; k <= last; ++k)
                route.emplace_back(tips[k].x(), tips[k].y(), std::max(tips[k].z(), stand[last]));
        if (!before && !behind)
            for (bool more = true; more && length < shortest;) {
                more = false;
                if (to + 1 < n && passable(to)) {
                    length += piece(to++);
                    route.push_back(tips[to]);
                    more = true;
                }
                if (from > 0 && passable(from - 1)) {
                    length += piece(--from);
                    route.insert(route.begin(), tips[from]);
                    more = true;
                }
            }
        stretches.push_back(std::move(route));
    }
    return stretches;
}

} // namespace facetmill
