#include "core/link/joint_run.h"

#include "core/setup/joint_course.h"
#include "core/strategy/five_axis/posture_path.h"

namespace facetmill {

namespace {

ToolPose pose_of(const CutterLocation& at) {
    return {at.tip, at.axis};
}

} // namespace

void JointRun::begin(const CutterLocation& at) {
    at_ = at;
    stances_ = stances(*kinematics_, pose_of(at));
}

std::vector<Joints> JointRun::onward(const CutterLocation& to) const {
    std::vector<Joints> next;
    for (const Joints& from : stances_) {
        const auto held = kinematics_->within_travel(pose_of(to), from);
        for (int k = 0; k < held.count; ++k) {
            const Joints& stance = held.at[std::size_t(k)];
            const auto known = [&](const Joints& w) { return w.rotary == stance.rotary; };
            if (!turns_over(from, stance) && motion_->even(at_, to, from, stance)
                && std::none_of(next.begin(), next.end(), known))
                next.push_back(stance);
        }
    }
    return next;
}

bool JointRun::go(const CutterLocation& to) {
    std::vector<Joints> next = onward(to);
    if (next.empty() && !stances_.empty() && !stances(*kinematics_, pose_of(to)).empty()) return false;
    if (next.empty()) return begin(to), true;
    stances_ = std::move(next);
    at_ = to;
    return true;
}

std::size_t JointRun::reach(std::span<const CutterLocation> route) const {
    JointRun run = *this;
    for (std::size_t i = 0; i < route.size(); ++i)
        if (!run.go(route[i])) return i;
    return route.size();
}

double JointRun::share_to(const CutterLocation& to) const {
    constexpr int halvings = 40; // so that nobody misses what lies between the share and the next number
    double made = 0, not_made = 1;
    for (int i = 0; i < halvings; ++i) {
        const double middle = 0.5 * (made + not_made);
        (JointRun(*this).go(location_on_route(at_, to, middle)) ? made : not_made) = middle;
    }
    return made;
}

} // namespace facetmill
