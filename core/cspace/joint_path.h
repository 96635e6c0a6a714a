// Joint positions as posture choice compares them: every pose with both ways to hold it, in seconds of each
// axis at its largest speed.
#pragma once

#include "core/setup/kinematics.h"

#include <array>
#include <cmath>
#include <vector>

namespace facetmill {

class JointClock {
public:
    /// `machine` may be nullptr: a machine whose axes cost nothing.
    explicit JointClock(const Kinematics* machine);

    /// Joint values over the largest speeds, s.
    using Times = std::array<double, 5>;
    struct Ways {
        int count = 0;
        std::array<Times, 2> at{};
    };
    /// The ways to hold a pose, with their rotary axes within travel where that is limited; none: out of
    /// reach. At singular poses the free axis takes `near`'s.
    Ways ways(const ToolPose& pose, const Times* near = nullptr) const;

    /// Seconds between two: the slowest axis; rotary axes that may go round take the shorter way.
    double between(const Times& a, const Times& b) const {
        double slowest = 0;
        for (std::size_t k = 0; k < 5; ++k) {
            double d = std::abs(a[k] - b[k]);
            if (d > half_turn_[k]) d = std::abs(2 * half_turn_[k] - d);
            slowest = std::max(slowest, d);
        }
        return slowest;
    }

private:
    const Kinematics* machine_;
    std::array<double, 5> per_unit_{};  ///< s per mm or radian
    std::array<double, 5> half_turn_{}; ///< s; +inf for axes that cannot go round
};

} // namespace facetmill
