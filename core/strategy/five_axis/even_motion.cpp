#include "core/strategy/five_axis/even_motion.h"

#include "core/strategy/five_axis/posture_path.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace facetmill {

namespace {

/// Halvings of a motion: pieces that turn by less than what is allowed are even, wherever they are.
constexpr int max_cuts = 12;
/// No point of a cutter's working end is farther from the tip, in radii.
constexpr double end_reach = 2;
/// Shank and holder are far from the tip: their axes differ by no more than this, whatever the cutter allows.
const double max_axis_apart = radians(0.5);
constexpr std::array<double, 3> looked_at{0.25, 0.5, 0.75}; ///< shares of a motion

} // namespace

EvenMotion::EvenMotion(const Kinematics& kinematics, double radius, double limit)
    : kinematics_(kinematics), max_apart_(std::min(max_axis_apart, limit / (end_reach * radius))) {}

bool EvenMotion::even(const CutterLocation& a, const CutterLocation& b) const {
    if (a.axis == b.axis) return true;
    for (const double share : looked_at) {
        const Vec3 straight = (a.axis + share * (b.axis - a.axis)).normalized();
        if ((straight - location_on_route(a, b, share).axis).norm() > max_apart_) return false;
    }
    const Kinematics::Solutions held = kinematics_.within_travel({a.tip, a.axis}, Joints{});
    // At the pole one joint may stand anywhere, and turns to where it is needed while the axis comes off.
    if (held.count > 0 && held.singular) return (b.axis - a.axis).norm() <= max_apart_;
    for (int i = 0; i < held.count; ++i) {
        const Joints& from = held.at[std::size_t(i)];
        const Kinematics::Solutions ends = kinematics_.within_travel({b.tip, b.axis}, from);
        std::optional<Joints> nearest;
        double least = infinity;
        for (int k = 0; k < ends.count; ++k) {
            Joints to = ends.at[std::size_t(k)];
            for (std::size_t r = 0; r < to.rotary.size(); ++r)
                to.rotary[r] = from.rotary[r] + std::remainder(to.rotary[r] - from.rotary[r], 2 * pi);
            if (const double time = kinematics_.time(from, to); time < least) {
                least = time;
                nearest = to;
            }
        }
        if (nearest && !even(a, b, from, *nearest)) return false;
    }
    return true;
}

bool EvenMotion::even(const CutterLocation& a, const CutterLocation& b, const Joints& from,
                      const Joints& to) const {
    if ((b.axis - a.axis).norm() <= max_apart_ && kinematics_.inverse({a.tip, a.axis}, from).singular)
        return true;
    for (const double share : looked_at) {
        Joints on = from;
        for (std::size_t r = 0; r < on.rotary.size(); ++r)
            on.rotary[r] += share * (to.rotary[r] - from.rotary[r]);
        if ((kinematics_.forward(on).axis - location_on_route(a, b, share).axis).norm() > max_apart_)
            return false;
    }
    return true;
}

std::vector<double> EvenMotion::cuts(const CutterLocation& a, const CutterLocation& b) const {
    std::vector<double> shares;
    cut(a, b, 0, 1, 0, shares);
    return shares;
}

void EvenMotion::cut(const CutterLocation& a, const CutterLocation& b, double from, double to, int depth,
                     std::vector<double>& shares) const {
    if (depth == max_cuts || even(location_on_route(a, b, from), location_on_route(a, b, to))) return;
    const double middle = 0.5 * (from + to);
    cut(a, b, from, middle, depth + 1, shares);
    shares.push_back(middle);
    cut(a, b, middle, to, depth + 1, shares);
}

} // namespace facetmill
