#include "core/strategy/five_axis/run_out.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

namespace facetmill {

namespace {

/// In radii of the cutter: how finely the motion is looked at, how far back and ahead, and how far apart the
/// lines are whose ends count. No pose reaches farther than two radii from its contact.
constexpr double run_step_share = 1.0 / 32, run_back_share = 2, run_ahead_share = 2, line_share = 1.0 / 16;

} // namespace

std::optional<ContactPlace> run_out(const FiveAxisField& field, const SurfaceLine& line,
                                    const ContactPlace& end, const PostureValue& posture, int travel,
                                    bool last) {
    const double r = field.radius();
    const SurfaceLines& lines = field.lines();
    const bool low = last == (travel < 0); // the end of the line with the smaller u
    const Vec3& own = (low ? line.points.front() : line.points.back()).point;
    const Vec3 onward = last ? end.frame.feed : Vec3(-end.frame.feed);
    const ToolPose pose = posture_pose(field.cutter(), end.frame, posture);
    const double raised = field.allowance() + field.cusp() - 0.5 * field.chord();
    const long apart = std::max(1L, std::lround(field.fineness() * line_share * r / lines.spacing()));
    const int back = int(run_back_share / run_step_share), ahead = int(run_ahead_share / run_step_share);

    int need = 0;
    const auto look = [&](const Vec3& border) {
        const RaisedCurve point{border + raised * end.frame.normal};
        const auto holds = [&](int k) {
            const ToolPose there{pose.tip + k * run_step_share * r * onward, pose.axis};
            return field.builder().reaches(there, std::span(&point, 1), 0);
        };
        for (int k = 0; k >= -back; --k)
            if (holds(k)) return;
        for (int k = 1; k <= ahead; ++k)
            if (holds(k)) {
                need = std::max(need, k);
                return;
            }
    };
    const auto ends = [&](long plane) {
        std::vector<Vec3> near;
        for (const SurfaceSlice::End& other : lines.slice(plane)->ends())
            if (other.first == low && (other.point - own).norm() <= 2 * r) near.push_back(other.point);
        return near;
    };
    const long middle = lines.beyond(end.v, end.v);
    for (const long side : {lines.beyond(end.v_lo, end.v), lines.beyond(end.v_hi, end.v)}) {
        // The outermost line counts most; where the surface ends within the strip that is its last one.
        long outermost = side;
        if (ends(side).empty()) {
            long inside = middle, outside = side;
            while (std::abs(outside - inside) > 1) {
                const long between = inside + (outside - inside) / 2;
                (ends(between).empty() ? outside : inside) = between;
            }
            outermost = inside;
        }
        const long step = outermost < middle ? apart : -apart;
        for (long k = outermost; step > 0 ? k < middle : k > middle; k += step)
            for (const Vec3& border : ends(k))
                look(border);
    }
    for (const Vec3& border : ends(middle))
        look(border);
    if (need == 0) return std::nullopt;

    const double distance = need * run_step_share * r;
    ContactPlace further = field.place(line, end.s + (low ? -distance : distance), end.v, travel);
    further.v_lo = end.v_lo;
    further.v_hi = end.v_hi;
    ToolLift::Hint hint;
    const double bottom = field.builder().bottom(further.frame, posture.lead, posture.yaw, hint);
    if (bottom > posture.delta || !field.builder().holds(further.frame, posture)) return std::nullopt;
    return further;
}

} // namespace facetmill
