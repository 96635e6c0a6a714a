#include "core/strategy/five_axis/axis_reach.h"

#include "core/base/tolerances.h"
#include "core/cspace/contact_frame.h"
#include "core/strategy/plan/budget.h"

#include <algorithm>
#include <cmath>

namespace facetmill {

namespace {

/// The axes by which a place is tried: leads from the least to the largest, turned evenly.
constexpr int tried_leads = 4, tried_yaws = 12;

std::vector<double> leads_between(double lo, double hi) {
    std::vector<double> leads(tried_leads);
    for (int l = 0; l < tried_leads; ++l)
        leads[std::size_t(l)] = lo + (hi - lo) * l / (tried_leads - 1);
    return leads;
}

} // namespace

AxisReach::AxisReach(const PlanContext& context, const Finish5Settings& settings)
    : settings_(settings), allowance_(settings.allowance + context.tessellation_tolerance[1]),
      cusp_(cusp_budget(settings, context)),
      lift_(context.contact, context.tool,
            {allowance_, settings.holder_clearance, settings.holder_clearance}),
      cutter_alone_(context.contact, lift_.cutter(), allowance_),
      kinematics_(context.machine, gauge_length(context.tool),
                  default_part_origin(context.machine, context.part_box)),
      within_(leads_between(settings.lead_limits[0], settings.lead_limits[1])) {
    if (widest_lead() > settings.lead_limits[1])
        beyond_ = leads_between(settings.lead_limits[1], widest_lead());
}

double AxisReach::widest_lead() const {
    return std::max(settings_.lead_limits[1], settings_.reach_lead);
}

bool AxisReach::too_low(const Vec3& normal) const {
    const double lowest = std::acos(tolerance::lowest_axis_z) + widest_lead(); // from +Z
    return normal.z() < std::cos(std::min(lowest, pi));
}

AxisReach::Found AxisReach::at(const Vec3& place, const Vec3& normal, ToolLift::Hint& hint) const {
    const auto frame = ContactFrame::at(place + allowance_ * normal, normal, Vec3::UnitX());
    Found found;
    found.block = ReachBlock::below;
    const auto any_of = [&](const std::vector<double>& leads) {
        for (const double lead : leads)
            for (int y = 0; y < (lead == 0 ? 1 : tried_yaws); ++y) {
                const double yaw = -pi + 2 * pi * y / tried_yaws;
                if (posture_axis(frame, lead, yaw).z() < tolerance::lowest_axis_z) continue;
                if (!can_touch(lift_.cutter(), lead)) continue;
                const ToolPose pose = posture_pose(lift_.cutter(), frame, {lead, yaw, 0});
                if (!lift_.is_deeper(pose, cusp_, hint) && kinematics_.reaches(pose)) return true;
                found.block = std::min(found.block, block(pose));
            }
        return false;
    };
    found.reached = any_of(within_);
    if (!found.reached) found.reached = found.far = any_of(beyond_);
    if (found.reached) found.block = ReachBlock::none;
    return found;
}

ReachBlock AxisReach::block(const ToolPose& pose) const {
    ToolLift::Hint own, alone;
    const ToolContact contact = lift_.contact_above(pose, cusp_, own);
    if (contact.body == ToolBody::none) return ReachBlock::machine;
    if (contact.body == ToolBody::cutter || cutter_alone_.is_deeper(pose, cusp_, alone))
        return ReachBlock::cutter;
    return contact.body == ToolBody::holder ? ReachBlock::holder : ReachBlock::shank;
}

} // namespace facetmill
