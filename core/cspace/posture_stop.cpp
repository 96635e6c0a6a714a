#include "core/cspace/posture_stop.h"

#include <algorithm>
#include <cmath>

namespace facetmill {

namespace {
/// What a posture costs that has no room to the border of its space, s. Motions between postures on the
/// border leave the space, where it is hollow.
constexpr double crowded_seconds = 0.1;
} // namespace

PostureStops::PostureStops(const ChooseInput& input)
    : input_(input), clock_(input.builder->input().kinematics, input.feed) {}

double PostureStops::own_cost(const PostureValue& p, double top) const {
    if (!(top > 0 && std::isfinite(top))) return 0;
    const double missing = input_.room > 0 ? std::max(0.0, 1 - (top - p.delta) / input_.room) : 0;
    return lift_seconds * p.delta / top + crowded_seconds * missing * missing;
}

void PostureStops::add(const PassPoint& point, const PostureValue& posture, double top,
                       std::vector<PostureStop>& stops) const {
    const ToolPose pose = posture_pose(input_.builder->input().lift->cutter(), point.frame, posture);
    const JointClock::Solutions held = clock_.solutions(pose);
    for (int w = 0; w < held.count; ++w)
        stops.push_back({posture, {pose, held.at[std::size_t(w)]}, own_cost(posture, top)});
}

void PostureStops::add_free(const PassPoint& point, double lead, double yaw, CSpaceBuilder::Hints& hints,
                            std::vector<PostureStop>& stops) const {
    if (const auto found = input_.builder->free(point.frame, lead, yaw, *point.curves, hints))
        add(point, found->posture, found->top, stops);
}

} // namespace facetmill
