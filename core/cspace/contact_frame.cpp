#include "core/cspace/contact_frame.h"

#include "core/base/error.h"
#include "core/base/tolerances.h"
#include "core/base/units.h"
#include "core/cspace/posture_terms.h"
#include "core/gouge/tool_lift.h"

#include <cmath>

namespace facetmill {

ContactFrame ContactFrame::at(const Vec3& point, const Vec3& normal, const Vec3& travel) {
    const double length = normal.norm();
    if (!(length > 0) || !std::isfinite(length) || !point.allFinite() || !travel.allFinite())
        throw Error(ErrorCode::internal, "ContactFrame", "was asked for at a point without a normal",
                    "report this");
    ContactFrame frame;
    frame.point = point;
    frame.normal = normal / length;
    const Vec3 across = travel - frame.normal.dot(travel) * frame.normal;
    const double size = across.norm();
    frame.feed =
        size > tolerance::vanishing_sum * travel.norm() ? Vec3(across / size) : frame.normal.unitOrthogonal();
    // Once more: what was left of a travel that is nearly the normal carries its rounding.
    frame.feed = (frame.feed - frame.normal.dot(frame.feed) * frame.normal).normalized();
    frame.left = frame.normal.cross(frame.feed);
    return frame;
}

Vec3 posture_axis(const ContactFrame& frame, double lead, double yaw) {
    return LeanTerms(lead).axis(frame, TurnTerms(yaw));
}

PostureValue posture_of_axis(const ContactFrame& frame, const Vec3& axis) {
    const double x = axis.dot(frame.feed), y = axis.dot(frame.left), z = axis.dot(frame.normal);
    const double across = std::hypot(x, y);
    if (!(across > tolerance::unit_rounding)) return {z < 0 ? pi : 0, 0, 0};
    const double yaw = std::atan2(y, x);
    return {std::atan2(across, z), yaw <= -pi ? pi : yaw, 0};
}

bool can_touch(const CutterProfile& cutter, double lead, double flutes) {
    const double angle = std::abs(lead),
                 end = flutes > 0 ? std::min(flutes, cutter.height()) : cutter.height();
    return angle < pi / 2 && plane_contact(cutter, angle).y() < end;
}

ToolPose posture_pose(const CutterProfile& cutter, const ContactFrame& frame, const PostureValue& posture) {
    return LeanTerms(posture.lead).pose(cutter, frame, TurnTerms(posture.yaw), posture.delta);
}

namespace {

std::vector<double> evenly(double lo, double hi, double step, const std::string& key, double most) {
    if (!(std::abs(lo) <= most) || !(std::abs(hi) <= most) || !(lo <= hi)) {
        const auto text = [](double angle) { return format_number(degrees(angle)); };
        throw Error(ErrorCode::out_of_range, key,
                    "from " + text(lo) + "° to " + text(hi) + "° is no range of postures",
                    "give two angles between " + text(-most) + "° and " + text(most)
                        + "°, the smaller first");
    }
    const double steps = std::ceil((hi - lo) / step - tolerance::grid_rounding);
    if (!(step > 0) || !(steps < double(PostureGrid::max_nodes)))
        throw Error(ErrorCode::out_of_range, "grid_degrees",
                    format_number(degrees(step)) + "° is no usable step between postures",
                    "choose a larger angle, such as 3°");
    const auto count = std::size_t(std::max(0.0, steps));
    std::vector<double> values(count + 1, lo);
    for (std::size_t i = 1; i <= count; ++i)
        values[i] = i == count ? hi : lo + (hi - lo) * double(i) / double(count);
    return values;
}

} // namespace

PostureGrid PostureGrid::make(double lead_lo, double lead_hi, double yaw_lo, double yaw_hi, double step) {
    PostureGrid grid;
    grid.lead = evenly(lead_lo, lead_hi, step, "lead_limits", pi / 2);
    grid.yaw = evenly(yaw_lo, yaw_hi, step, "yaw_limits", pi);
    if (grid.lead.size() > max_nodes / grid.yaw.size())
        throw Error(ErrorCode::out_of_range, "grid_degrees",
                    format_number(degrees(step)) + "° asks for "
                        + format_number(double(grid.lead.size()) * double(grid.yaw.size()))
                        + " postures at every point",
                    "choose a larger angle, such as 3°, or narrower limits");
    return grid;
}

} // namespace facetmill
