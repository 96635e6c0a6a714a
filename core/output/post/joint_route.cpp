#include "core/output/post/joint_route.h"

#include "core/base/plane_geometry.h"
#include "core/base/tolerances.h"
#include "core/verify/sweep.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace facetmill {

namespace {

/// Halvings of a motion: enough to follow an axis round the pole of a machine.
constexpr int max_halvings = 40;
/// How far up a machine goes whose Z has no limit, above where it works; mm.
constexpr double free_lift = 100;
constexpr std::array<double, 3> looked_at = {0.25, 0.5, 0.75};
/// Rotary axes that turn farther in one block are looked at in pieces; radians.
constexpr double max_turn_looked_at = pi / 4;

bool strays(const Kinematics& kinematics, const JointMotion& m, const std::optional<TurningAxis>& turning,
            const StrayLimit& limit) {
    for (std::size_t r = 0; r < 2; ++r)
        if (std::abs(m.to_joints.rotary[r] - m.from_joints.rotary[r]) > max_turn_looked_at) return true;
    const Vec3 step = m.to.tip - m.from.tip;
    const double square = step.squaredNorm();
    for (const double t : looked_at) {
        const ToolPose is = kinematics.forward(joints_between(m.from_joints, m.to_joints, t));
        const CutterLocation meant = location_between(m.from, m.to, turning, t);
        Vec3 off = is.tip - meant.tip;
        // Being ahead or behind on a straight route is no error.
        if (!turning && square > 0) off -= step * (off.dot(step) / square);
        if (!(off.norm() <= limit.tip) || !(angle_between(is.axis, meant.axis) <= limit.axis)) return true;
    }
    return false;
}

/// The ways in which the machine can hold a pose, the nearest to where it stands first, within half a turn.
std::vector<Joints> holding_joints(const Kinematics& kinematics, const CutterLocation& at,
                                   const Joints& from) {
    constexpr double half_turn = pi * (1 + tolerance::figure_rounding);
    const auto& axes = kinematics.machine().rotary;
    std::vector<std::pair<double, Joints>> found;
    const auto add = [&](const Joints& held) {
        double turned = 0;
        for (std::size_t r = 0; r < axes.size(); ++r) {
            const double by = std::abs(held.rotary[r] - from.rotary[r]);
            if (by > half_turn || !axes[r].travel.contains(held.rotary[r])) return;
            turned += by;
        }
        found.emplace_back(turned, held);
    };
    const Kinematics::Solutions solutions = kinematics.within_travel({at.tip, at.axis}, from);
    for (int k = 0; k < solutions.count; ++k) {
        const Joints& held = solutions.at[std::size_t(k)];
        add(held);
        for (std::size_t r = 0; r < axes.size(); ++r)
            for (const double by : {-2 * pi, 2 * pi}) {
                Joints other = held;
                other.rotary[r] += by;
                add(other);
            }
    }
    std::stable_sort(found.begin(), found.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    std::vector<Joints> all;
    all.reserve(found.size());
    for (const auto& [turned, held] : found)
        all.push_back(held);
    return all;
}

bool same_rotary_angles(const Joints& a, const Joints& b) {
    return a.rotary == b.rotary;
}

class Divider {
public:
    Divider(const Kinematics& kinematics, const std::optional<TurningAxis>& turning, const StrayLimit& limit,
            std::vector<RoutePlace>& places)
        : kinematics_(kinematics), turning_(turning), limit_(limit), places_(places) {}

    bool divide(const JointMotion& m, double t0, double t1, int halvings) {
        if (same_rotary_angles(m.from_joints, m.to_joints) || !strays(kinematics_, m, turning_, limit_)) {
            places_.push_back({t1, m.to_joints, m.to});
            return true;
        }
        if (halvings == max_halvings) return false;
        const CutterLocation middle = location_between(m.from, m.to, turning_, 0.5);
        const auto held =
            kinematics_.nearest({middle.tip, middle.axis}, joints_between(m.from_joints, m.to_joints, 0.5));
        if (!held) return false;
        const double t = 0.5 * (t0 + t1);
        return divide({m.from, middle, m.from_joints, *held}, t0, t, halvings + 1)
               && divide({middle, m.to, *held, m.to_joints}, t, t1, halvings + 1);
    }

    void trace(const JointMotion& m, double t0, double t1, int halvings) {
        if (halvings == max_halvings || same_rotary_angles(m.from_joints, m.to_joints)
            || !strays(kinematics_, m, turning_, limit_)) {
            places_.push_back({t1, m.to_joints, m.to});
            return;
        }
        const Joints held = joints_between(m.from_joints, m.to_joints, 0.5);
        const ToolPose pose = kinematics_.forward(held);
        const CutterLocation middle{pose.tip, pose.axis};
        const double t = 0.5 * (t0 + t1);
        trace({m.from, middle, m.from_joints, held}, t0, t, halvings + 1);
        trace({middle, m.to, held, m.to_joints}, t, t1, halvings + 1);
    }

private:
    const Kinematics& kinematics_;
    const std::optional<TurningAxis>& turning_;
    const StrayLimit& limit_;
    std::vector<RoutePlace>& places_;
};

} // namespace

Joints joints_between(const Joints& from, const Joints& to, double t) {
    Joints at;
    at.linear = from.linear + t * (to.linear - from.linear);
    for (std::size_t r = 0; r < 2; ++r)
        at.rotary[r] = from.rotary[r] + t * (to.rotary[r] - from.rotary[r]);
    return at;
}

double travel_top(const Machine& machine, double z) {
    const Travel& t = machine.travel[2];
    return t.hi < infinity ? std::max(t.hi, z) : z + free_lift;
}

double seconds_over(const Kinematics& kinematics, const Joints& from, const Joints& to, double height) {
    Joints up = from, over = to;
    up.linear.z() = over.linear.z() = height;
    Joints turned = up;
    turned.rotary = to.rotary;
    return kinematics.time(from, up) + kinematics.time(up, turned) + kinematics.time(turned, over)
           + kinematics.time(over, to);
}

bool divide_motion(const Kinematics& kinematics, const JointMotion& motion,
                   const std::optional<TurningAxis>& turning, const StrayLimit& limit,
                   std::vector<RoutePlace>& places) {
    return Divider(kinematics, turning, limit, places).divide(motion, 0, 1, 0);
}

bool lead_motion(const Kinematics& kinematics, const JointMotion& motion, bool course_first,
                 const std::optional<TurningAxis>& turning, const StrayLimit& limit,
                 std::vector<RoutePlace>& places) {
    const auto reached = [&](const Joints& to) {
        places.clear();
        JointMotion m = motion;
        m.to_joints = to;
        return divide_motion(kinematics, m, turning, limit, places);
    };
    if (course_first && reached(motion.to_joints)) return true;
    for (const Joints& to : holding_joints(kinematics, motion.to, motion.from_joints))
        if (reached(to)) return true;
    places.clear();
    return false;
}

void trace_motion(const Kinematics& kinematics, const JointMotion& motion,
                  const std::optional<TurningAxis>& turning, const StrayLimit& limit,
                  std::vector<RoutePlace>& places) {
    Divider(kinematics, turning, limit, places).trace(motion, 0, 1, 0);
}

} // namespace facetmill
