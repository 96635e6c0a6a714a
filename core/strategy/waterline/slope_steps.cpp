#include "core/strategy/waterline/slope_steps.h"

#include "core/base/vec.h"

#include <algorithm>
#include <cmath>

namespace facetmill {

namespace {

/// Upright planes are touched along all of the side: the table ends a little before.
constexpr double steepest_asked = 0.5 * pi - 1e-3;
/// Ratios below this are as good as an edge.
constexpr double min_ratio = 1e-3;

/// The highest point that two places of the cutter leave between them on a plane.
double left_between(const CutterCover& cover, double slope, double apart) {
    const Vec3 n(std::sin(slope), 0, std::cos(slope)), down(std::cos(slope), 0, -std::sin(slope));
    const Vec3 first = cover.tip_offset(n), second = first + apart * down;
    const double limit = 4 * cover.radius();
    // What the first leaves grows downhill, what the second leaves falls.
    double lo = 0, hi = apart, left = 0;
    constexpr int halvings = 24;
    for (int k = 0; k < halvings; ++k) {
        const double middle = 0.5 * (lo + hi);
        const Vec3 p = middle * down;
        const double a = cover.ray_entry(p, n, first, limit), b = cover.ray_entry(p, n, second, limit);
        left = std::max(0.0, std::min(a, b));
        (a < b ? lo : hi) = middle;
    }
    return left;
}

double farthest_apart(const CutterCover& cover, double slope, double cusp, double longest) {
    if (left_between(cover, slope, longest) <= cusp) return longest;
    double lo = 0, hi = longest;
    constexpr int halvings = 26;
    for (int k = 0; k < halvings; ++k) {
        const double middle = 0.5 * (lo + hi);
        (left_between(cover, slope, middle) <= cusp ? lo : hi) = middle;
    }
    return lo;
}

} // namespace

SlopeSteps::SlopeSteps(const CutterCover& cover, double cusp, double longest)
    : cusp_(cusp), longest_(longest) {
    for (std::size_t i = 0; i < slopes; ++i) {
        const double slope = steepest_asked * double(i) / double(slopes - 1);
        const double far = std::max(4 * cover.radius(), longest / std::max(std::sin(slope), 0.1));
        Entry& e = entries_[i];
        e.along = farthest_apart(cover, slope, cusp, far);
        const double twice = farthest_apart(cover, slope, 2 * cusp, far);
        e.power = e.along > 0 && e.along < far ? std::clamp(std::log2(twice / e.along), 0.25, 1.0) : 0.5;
    }
}

SlopeSteps::Entry SlopeSteps::at(double slope) const {
    const double place = std::clamp(slope / steepest_asked, 0.0, 1.0) * double(slopes - 1);
    const std::size_t i = std::min(std::size_t(place), slopes - 2);
    const double t = place - double(i);
    const Entry &a = entries_[i], &b = entries_[i + 1];
    return {a.along + t * (b.along - a.along), a.power + t * (b.power - a.power)};
}

double SlopeSteps::step(double slope, double ratio) const {
    if (ratio < min_ratio) return longest_;
    const Entry e = at(slope);
    return std::min(longest_, e.along * std::pow(ratio, -e.power) * std::sin(slope));
}

double SlopeSteps::cusp(double slope, double ratio, double step) const {
    const Entry e = at(slope);
    const double on_plane = e.along * std::sin(slope);
    if (ratio < min_ratio || !(on_plane > 0)) return 0;
    return cusp_ * ratio * std::pow(step / on_plane, 1 / e.power);
}

} // namespace facetmill
