#include "core/strategy/five_axis/even_motion.h"

#include "core/strategy/five_axis/posture_path.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace facetmill {

namespace {

/// Halvings of a motion: pieces that turn by less than what is allowed are even, wherever they are.
constexpr int max_cuts = 12;
/// No point of a cutter's working end is farther from the tip, in radii.
constexpr double end_reach = 2;
/// Shank and holder are far from the tip: their axes differ by no more than this, whatever the cutter allows.
const double max_axis_apart = radians(0.5);

} // namespace

EvenMotion::EvenMotion(const Kinematics& kinematics, double radius, double limit)
    : kinematics_(kinematics), max_apart_(std::min(max_axis_apart, limit / (end_reach * radius))) {}

bool EvenMotion::even(const CutterLocation& a, const CutterLocation& b) const {
    if (a.axis == b.axis) return true;
    const std::array<double, 3> shares{0.25, 0.5, 0.75};
    std::array<Vec3, 3> circle;
    for (std::size_t k = 0; k < shares.size(); ++k) {
        circle[k] = location_on_route(a, b, shares[k]).axis;
        const Vec3 straight = (a.axis + shares[k] * (b.axis - a.axis)).normalized();
        if ((straight - circle[k]).norm() > max_apart_) return false;
    }
    const Kinematics::Solutions held = kinematics_.within_travel({a.tip, a.axis}, Joints{});
    // At the pole one joint may stand anywhere, and turns to where it is needed while the axis comes off.
    if (held.count > 0 && held.singular) return (b.axis - a.axis).norm() <= max_apart_;
    for (int i = 0; i < held.count; ++i) {
        const Joints from = held.at[std::size_t(i)];
        const auto to = kinematics_.nearest({b.tip, b.axis}, from);
        if (!to) continue;
        for (std::size_t k = 0; k < shares.size(); ++k) {
            Joints on = from;
            for (std::size_t r = 0; r < on.rotary.size(); ++r)
                on.rotary[r] += shares[k] * (to->rotary[r] - from.rotary[r]);
            if ((kinematics_.forward(on).axis - circle[k]).norm() > max_apart_) return false;
        }
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
