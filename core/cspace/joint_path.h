// Joint positions as posture choice compares them: every pose with both solutions of the machine for it, in
// seconds of each axis at its largest speed.
#pragma once

#include "core/setup/kinematics.h"

#include <algorithm>
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
    struct Solutions {
        int count = 0;
        std::array<Times, 2> at{};
    };
    /// Joint positions that hold a pose, with their rotary axes within travel where that is limited; none:
    /// out of reach. At singular poses the free axis takes `near`'s.
    Solutions solutions(const ToolPose& pose, const Times* near = nullptr) const;

    /// Seconds between two: the slowest axis; rotary axes that may go round turn in the shorter direction.
    double between(const Times& a, const Times& b) const {
        double slowest = 0;
        for (const double d : difference(a, b))
            slowest = std::max(slowest, std::abs(d));
        return slowest;
    }

    /// Seconds that the slowest axis takes to go from one speed to another; shares of the largest speeds.
    /// Axes without a stated acceleration take none.
    double changing(const Times& from, const Times& to) const {
        double slowest = 0;
        for (std::size_t k = 0; k < 5; ++k)
            slowest = std::max(slowest, std::abs(to[k] - from[k]) * change_[k]);
        return slowest;
    }

    /// The tool axis with the rotary axes at a share of their way from a to b.
    Vec3 axis_between(const Times& a, const Times& b, double share) const;

    /// From a to b, in the shorter direction where an axis may go round.
    Times difference(const Times& a, const Times& b) const {
        Times d;
        for (std::size_t k = 0; k < 5; ++k) {
            d[k] = b[k] - a[k];
            if (std::abs(d[k]) > half_turn_[k]) d[k] -= std::copysign(2 * half_turn_[k], d[k]);
        }
        return d;
    }

private:
    const Kinematics* machine_;
    std::array<double, 5> per_unit_{};  ///< s per mm or radian
    std::array<double, 5> half_turn_{}; ///< s; +inf for axes that cannot go round
    std::array<double, 5> change_{};    ///< s, half of what it takes to come to the largest speed
};

/// A pose and one joint position that holds it.
struct Stand {
    ToolPose pose;
    JointClock::Times joints{};
};

/// What moves at feed cost, s.
class MoveClock : public JointClock {
public:
    /// `feed` of the tip, mm/s.
    MoveClock(const Kinematics* machine, double feed) : JointClock(machine), per_feed_(1 / feed) {}

    using JointClock::between;
    /// The time of the tip at feed or of the slowest axis, whichever is longer; and a little of the joints'
    /// time besides: of moves that take the same time, the one that turns less.
    double between(const Stand& a, const Stand& b) const {
        const double joints = between(a.joints, b.joints);
        return std::max((b.pose.tip - a.pose.tip).norm() * per_feed_, joints) + joint_share * joints;
    }
    /// The time alone.
    double seconds(const Stand& a, const Stand& b) const {
        return std::max((b.pose.tip - a.pose.tip).norm() * per_feed_, between(a.joints, b.joints));
    }
    /// Speeds of the joints on a move, shares of the largest; 0 where nothing moves.
    Times speeds(const Stand& a, const Stand& b) const {
        Times d = difference(a.joints, b.joints);
        const double time =
            std::max((b.pose.tip - a.pose.tip).norm() * per_feed_, between(a.joints, b.joints));
        for (double& v : d)
            v = time > 0 ? v / time : 0;
        return d;
    }
    /// By how much the rotary axes change their speed at b, shares of their largest speeds.
    double bend(const Stand& a, const Stand& b, const Stand& c) const {
        const Times in = speeds(a, b), out = speeds(b, c);
        return std::abs(out[3] - in[3]) + std::abs(out[4] - in[4]);
    }
    /// From a stand to the cheaper solution of a pose; +inf where there is none.
    double to(const ToolPose& pose, const Stand& from) const {
        const Solutions held = solutions(pose, &from.joints);
        double least = infinity;
        for (int w = 0; w < held.count; ++w)
            least = std::min(least, between(from, Stand{pose, held.at[std::size_t(w)]}));
        return least;
    }
    /// The cheapest stand of a pose after another; the pose with joints at zero where it is out of reach.
    Stand stand(const ToolPose& pose, const Stand* after) const {
        const Solutions held = solutions(pose, after ? &after->joints : nullptr);
        Stand best{pose, {}};
        double least = infinity;
        for (int w = 0; w < held.count; ++w) {
            const Stand s{pose, held.at[std::size_t(w)]};
            const double cost = after ? between(*after, s) : 0;
            if (cost < least) {
                least = cost;
                best = s;
            }
        }
        return best;
    }

private:
    static constexpr double joint_share = 0.04;
    double per_feed_;
};

} // namespace facetmill
