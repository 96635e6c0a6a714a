#include "core/strategy/waterline/level_choice.h"

#include "core/base/parallel.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace facetmill {

namespace {

/// Between two neighbours of the grid stands a wall where the tip rises by more than so many times what their
/// slopes say, and by more than their distance.
constexpr double wall_share = 3;
const double steepest_known = std::tan(radians(87)), wall_slope = radians(85), foot_change = radians(25);
/// Contacts that move by more than so many times what the tips do jump from flank to flank.
constexpr double flank_ratio = 4;
/// Of what lies between two levels so much may ask for less: that gets pieces of levels.
constexpr double partial_share = 0.05;
/// Halvings of a gap, at most.
constexpr int max_halvings = 4;
/// The first level lies by so much of a step below the highest place.
constexpr double first_share = 0.1;
constexpr double same_step = 0.97;

} // namespace

/// How many cells ask for how large a step, height by height.
class LevelChoice::Bins {
public:
    static constexpr std::size_t sizes = 64;
    static constexpr double per_octave = 8;
    using Counts = std::array<double, sizes>;

    Bins(const std::vector<Ask>& asks, double bottom, double top, double longest, const Progress& progress)
        : bottom_(bottom), longest_(longest) {
        std::vector<float> steps;
        steps.reserve(asks.size());
        for (const Ask& a : asks)
            steps.push_back(a.step);
        constexpr double small_share = 0.02, bins_a_step = 8, max_bins = 20000;
        const auto nth = steps.begin() + std::ptrdiff_t(small_share * double(steps.size()));
        std::nth_element(steps.begin(), nth, steps.end());
        height_ = std::max({double(*nth) / bins_a_step, (top - bottom) / max_bins, 1e-9});
        bins_ = std::size_t(std::ceil((top - bottom) / height_)) + 1;
        std::vector<std::array<std::int32_t, sizes>> change(bins_ + 1);
        for (std::size_t i = 0; i < asks.size(); ++i) {
            if (i % 8192 == 0) progress.check();
            const Ask& a = asks[i];
            if (double(a.hi) < bottom) continue;
            const std::size_t size = size_of(double(a.step));
            ++change[bin(double(a.lo))][size];
            --change[bin(double(a.hi)) + 1][size];
        }
        counts_.resize(bins_);
        std::array<std::int32_t, sizes> now{};
        for (std::size_t b = 0; b < bins_; ++b)
            for (std::size_t s = 0; s < sizes; ++s) {
                now[s] += change[b][s];
                counts_[b][s] = float(now[s]);
            }
    }
    std::size_t bin(double z) const {
        return std::size_t(std::clamp((z - bottom_) / height_, 0.0, double(bins_ - 1)));
    }
    double low_of(std::size_t b) const { return bottom_ + double(b) * height_; }

    /// The lowest height to which a gap that begins at `z` may reach; `z` itself where nothing is asked for
    /// as far down as the longest step.
    double reach(double z) const {
        Counts sum{};
        double total = 0, best = z;
        for (std::size_t b = bin(z) + 1; b-- > 0;) {
            for (std::size_t s = 0; s < sizes; ++s) {
                sum[s] += double(counts_[b][s]);
                total += double(counts_[b][s]);
            }
            const double low = std::max(low_of(b), bottom_), gap = z - low;
            if (gap <= 0) continue;
            if (gap > longest_) break;
            double less = 0;
            for (std::size_t s = size_of(gap / same_step) + 1; s < sizes; ++s)
                less += sum[s];
            if (less > partial_share * total) break;
            if (total > 0) best = low;
        }
        // At least one step of the smallest kind.
        return best < z ? best : total > 0 ? std::max(bottom_, z - height_) : z;
    }
    /// The highest place at or below z at which something is asked for.
    std::optional<double> next_asked(double z) const {
        for (std::size_t b = bin(z) + 1; b-- > 0;)
            for (const float n : counts_[b])
                if (n > 0) return std::min(z, low_of(b) + height_);
        return std::nullopt;
    }

private:
    std::size_t size_of(double step) const {
        const double octaves = std::log2(std::max(longest_ / std::max(step, 1e-12), 1.0));
        return std::min(std::size_t(std::ceil(per_octave * octaves)), sizes - 1);
    }
    double bottom_, longest_, height_ = 1;
    std::size_t bins_ = 1;
    std::vector<std::array<float, sizes>> counts_;
};

bool LevelChoice::is_jump(const TipTouch& a, const TipTouch& b) const {
    const double dz = std::abs(a.tip_z - b.tip_z);
    if (std::isnan(dz)) return false; // nothing below either
    const auto steep = [](const TipTouch& t) {
        return t.any ? std::min(std::tan(t.slope()), steepest_known) : 0;
    };
    return dz > (wall_share * std::max(steep(a), steep(b)) + 1) * spacing_;
}

bool LevelChoice::is_foot(const TipTouch& high, const TipTouch& low, bool jump) const {
    if (!low.any || !low.surface || !(low.slope() < slopes_.lo)) return false;
    return jump || (wanted(high) && high.slope() - low.slope() > foot_change);
}

void LevelChoice::surface_ask(const TipTouch* const (&corner)[4], std::uint32_t cell, Found& found) const {
    double slope = 0, lo = infinity, hi = -infinity;
    int count = 0;
    for (const TipTouch* t : corner) {
        if (!t->any) continue;
        lo = std::min(lo, t->tip_z);
        hi = std::max(hi, t->tip_z);
        if (!wanted(*t)) continue;
        slope += t->slope();
        ++count;
    }
    if (count == 0) return;
    slope /= count;
    const TipTouch &a = *corner[0], &b = *corner[1], &c = *corner[2];
    double ratio = 1;
    if (a.any && b.any && c.any) {
        const Vec2 rise((b.tip_z - a.tip_z) / spacing_, (c.tip_z - a.tip_z) / spacing_);
        const double grade = rise.norm();
        if (grade > 0) {
            const Vec3 moved =
                ((b.point - a.point) * rise.x() + (c.point - a.point) * rise.y()) / (grade * spacing_);
            const Vec3 tip(rise.x() / grade, rise.y() / grade, grade);
            const double jump = moved.norm() / tip.norm();
            if (jump < flank_ratio) ratio = std::max(0.0, moved.dot(tip) / tip.squaredNorm());
        }
    }
    found.asks.push_back(
        {float(lo), float(hi), float(steps_.step(slope, ratio)), float(slope), float(ratio), cell});
}

void LevelChoice::look_at(const TipTouch* const (&corner)[4], std::uint32_t cell, Found& found) const {
    bool any = false, steep = false;
    for (const TipTouch* t : corner) {
        any = any || t->any;
        steep = steep || (t->any && t->slope() >= slopes_.lo && t->slope() <= slopes_.hi);
    }
    if (!any) return;
    bool jumps = false;
    for (const int other : {1, 2}) {
        const TipTouch &a = *corner[0], &b = *corner[other];
        const TipTouch &high = a.tip_z > b.tip_z ? a : b, &low = a.tip_z > b.tip_z ? b : a;
        if (!high.any) continue;
        const bool jump = is_jump(a, b);
        if (jump && slopes_.hi >= wall_slope) {
            jumps = true;
            found.asks.push_back({float(low.tip_z), float(high.tip_z), float(steps_.step(0.5 * pi, 1)),
                                  float(0.5 * pi), 1, cell});
        }
        if (is_foot(high, low, jump)) found.feet.push_back({float(low.tip_z), cell});
    }
    if (!jumps) surface_ask(corner, cell, found);
    if (steep || jumps) found.steep.push_back(cell);
}

void LevelChoice::look(int first, int columns, std::span<const TipTouch> touches, const Progress& progress) {
    const std::size_t width = std::size_t(columns), rows = touches.size() / width;
    if (rows < 2) return;
    std::vector<Found> found(rows - 1);
    parallel_for(rows - 1, 1, progress, [&](std::size_t row) {
        for (std::size_t i = 0; i + 1 < width; ++i) {
            const TipTouch* at = &touches[row * width + i];
            const TipTouch* const corner[4] = {at, at + 1, at + width, at + width + 1};
            look_at(corner, std::uint32_t((std::size_t(first) + row) * width + i), found[row]);
        }
    });
    mark_steep(found, width, (std::size_t(first) + rows) * width);
    for (const Found& f : found) {
        asks_.insert(asks_.end(), f.asks.begin(), f.asks.end());
        feet_.insert(feet_.end(), f.feet.begin(), f.feet.end());
        for (const Ask& a : f.asks)
            highest_ = std::max(highest_, double(a.hi));
    }
}

/// With the cells around them. `cells`: so many are known by now.
void LevelChoice::mark_steep(std::span<const Found> found, std::size_t width, std::size_t cells) {
    constexpr std::int64_t around = 3;
    steep_.resize(cells + around * width, 0);
    for (const Found& f : found)
        for (const std::uint32_t cell : f.steep)
            for (std::int64_t row = -around; row <= around; ++row)
                for (std::int64_t column = -around; column <= around; ++column) {
                    const std::int64_t at = std::int64_t(cell) + row * std::int64_t(width) + column;
                    if (at >= 0 && at < std::int64_t(steep_.size())) steep_[std::size_t(at)] = 1;
                }
}

std::vector<double> LevelChoice::whole_levels(const Limits& limits, double bottom,
                                              const Progress& progress) const {
    std::vector<double> all;
    if (limits.step) {
        for (double z = highest_ - *limits.step; z > bottom; z -= *limits.step)
            all.push_back(z);
        return all;
    }
    const Bins bins(asks_, bottom, highest_, steps_.longest(), progress);
    double z = highest_;
    bool begun = false;
    while (z > bottom) {
        progress.check();
        double next = bins.reach(z);
        if (!(next < z)) {
            // Nothing asks for a level here.
            const auto asked = bins.next_asked(z - steps_.longest());
            if (!asked) break;
            z = *asked;
            begun = false;
            continue;
        }
        if (!begun) next = z - first_share * (z - next);
        begun = true;
        if (next <= bottom) break;
        all.push_back(next);
        z = next;
    }
    return all;
}

void LevelChoice::add_partial(std::vector<Level>& levels, const Progress& progress) const {
    std::vector<double> z;
    for (const Level& l : levels)
        z.push_back(l.z);
    std::map<double, std::vector<std::uint32_t>, std::greater<>> between;
    for (std::size_t i = 0; i < asks_.size(); ++i) {
        if (i % 8192 == 0) progress.check();
        const Ask& a = asks_[i];
        // The first level that is not above the ask's top.
        const auto from = std::lower_bound(z.begin(), z.end(), double(a.hi), std::greater<>());
        for (auto k = from == z.begin() ? std::size_t(1) : std::size_t(from - z.begin()); k < z.size(); ++k) {
            const double high = z[k - 1], gap = high - z[k];
            if (high < double(a.lo)) break;
            if (double(a.step) >= same_step * gap) continue;
            const int halvings = std::min(
                max_halvings, int(std::ceil(std::log2(gap / std::max(double(a.step), 1e-9)) - 0.05)));
            for (int m = 1; m <= halvings; ++m) {
                const double part = gap / double(1 << m);
                for (int odd = 1; odd < (1 << m); odd += 2) {
                    const double at = high - odd * part;
                    if (at - part <= double(a.hi) && at + part >= double(a.lo)) between[at].push_back(a.cell);
                }
            }
        }
    }
    for (auto& [at, cells] : between) {
        std::sort(cells.begin(), cells.end());
        cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
        levels.push_back({at, std::move(cells)});
    }
}

void LevelChoice::add_feet(std::vector<Level>& levels, const Limits& limits) const {
    std::vector<Foot> feet;
    for (const Foot& f : feet_)
        if (double(f.z) >= limits.lowest) feet.push_back(f);
    std::sort(feet.begin(), feet.end(),
              [](const Foot& a, const Foot& b) { return a.z > b.z || (a.z == b.z && a.cell < b.cell); });
    for (std::size_t i = 0; i < feet.size();) {
        // What lies within the height is cleared by one level.
        Level level{double(feet[i].z) + limits.above_floor, {}};
        for (const float top = feet[i].z; i < feet.size() && double(top - feet[i].z) < limits.above_floor;
             ++i)
            level.cells.push_back(feet[i].cell);
        std::sort(level.cells.begin(), level.cells.end());
        level.cells.erase(std::unique(level.cells.begin(), level.cells.end()), level.cells.end());
        levels.push_back(std::move(level));
    }
}

std::vector<Level> LevelChoice::levels(const Limits& limits, const Progress& progress) const {
    double bottom = infinity;
    for (const Ask& a : asks_)
        bottom = std::min(bottom, double(a.lo));
    // Beside the part nothing ends a wall but what holds the stock.
    const bool down_to_end = bottom <= limits.lowest;
    bottom = std::max(bottom, limits.lowest);
    std::vector<Level> levels;
    if (!(bottom < highest_)) return levels;
    for (const double z : whole_levels(limits, bottom, progress))
        levels.push_back({z, {}});
    const double last = down_to_end ? bottom : bottom + limits.above_floor;
    if (last <= highest_ && (levels.empty() || levels.back().z > last)) levels.push_back({last, {}});
    if (!limits.step) add_partial(levels, progress);
    add_feet(levels, limits);
    std::stable_sort(levels.begin(), levels.end(), [](const Level& a, const Level& b) { return a.z > b.z; });
    return levels;
}

double LevelChoice::cusp_at(double step) const {
    double highest = 0;
    for (const Ask& a : asks_)
        highest = std::max(highest, steps_.cusp(double(a.slope), double(a.ratio), step));
    return highest;
}

} // namespace facetmill
