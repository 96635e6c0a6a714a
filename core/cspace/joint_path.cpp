#include "core/cspace/joint_path.h"

#include "core/base/tolerances.h"

#include <cmath>

namespace facetmill {

JointClock::JointClock(const Kinematics* machine) : machine_(machine) {
    half_turn_.fill(infinity);
    if (!machine) return;
    const Machine& m = machine->machine();
    for (int k = 0; k < m.joints(); ++k) {
        per_unit_[std::size_t(k)] = 1 / m.speed(k);
        change_[std::size_t(k)] = m.speed(k) / (2 * m.acceleration(k));
        const Travel& travel = m.joint_travel(k);
        // An axis that winds up has to be wound back: only one with two turns of travel or more is taken to
        // go round.
        if (k >= 3 && !(travel.hi - travel.lo < 4 * pi - tolerance::level_angle))
            half_turn_[std::size_t(k)] = pi * per_unit_[std::size_t(k)];
    }
}

Vec3 JointClock::axis_between(const Times& a, const Times& b, double share) const {
    if (!machine_) return Vec3::UnitZ();
    const Times step = difference(a, b);
    Joints at;
    for (std::size_t k = 0; k < 2; ++k)
        if (per_unit_[3 + k] > 0) at.rotary[k] = (a[3 + k] + share * step[3 + k]) / per_unit_[3 + k];
    return machine_->forward(at).axis;
}

JointClock::Solutions JointClock::solutions(const ToolPose& pose, const Times* near) const {
    Solutions held;
    if (!machine_) {
        held.count = 1;
        return held;
    }
    Joints hint;
    if (near)
        for (std::size_t k = 0; k < 2; ++k)
            if (per_unit_[3 + k] > 0) hint.rotary[k] = (*near)[3 + k] / per_unit_[3 + k];
    const Kinematics::Solutions solutions = machine_->inverse(pose, hint);
    const Machine& m = machine_->machine();
    for (int i = 0; i < solutions.count; ++i) {
        const Joints& j = solutions.at[std::size_t(i)];
        Times times{};
        bool within = true;
        for (int k = 0; k < m.joints(); ++k) {
            const auto joint = std::size_t(k);
            double value = j[k];
            if (k >= 3 && half_turn_[joint] == infinity) {
                // Solutions come within half a turn of zero; the travel may lie elsewhere.
                const Travel& travel = m.joint_travel(k);
                const double slack = tolerance::level_angle;
                for (const double turn : {2 * pi, -2 * pi})
                    if (!travel.contains(value, slack) && travel.contains(value + turn, slack)) value += turn;
                within = within && travel.contains(value, slack);
            }
            times[joint] = value * per_unit_[joint];
        }
        if (within) held.at[std::size_t(held.count++)] = times;
    }
    return held;
}

} // namespace facetmill
