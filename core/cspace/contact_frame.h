// Where a cutter stands at a contact point: the frames and angles of the configuration space (Lu 3.5.5, Fig.
// 3-24).
//
//   frame  origin             axes                                              type
//   GCS    the part's         the part's                                        Vec3
//   LCS    the contact point  x feed, y left (z cross x), z normal off the part ContactFrame
//   TCS    the tool's tip     z along its axis to the holder                    ToolPose
//
//   posture    meaning
//   lead   λ   the axis leans from the normal towards the feed
//   yaw    ω   the lean is then turned about the normal, to the left
//   delta  δ   lift along the tool's *axis*; with 0 the cutter touches the tangent plane
//
// So the axis in the LCS is (sin λ cos ω, sin λ sin ω, cos λ), and a negative lead is the positive one at the
// opposite yaw. Lu's formulas 3.8 and 3.87 take delta along the axis too; his text says along the normal.
//
// The cutter touches with the point of its lower surface that has the plane's normal. An upright flat end
// touches with its whole end; here it stands as in the limit of a lead that goes to 0 from above, on its rim
// in the direction of the lean, as a cutter does that is about to lean. So poses are continuous in yaw and
// in leads from 0 on, except where the lead is the angle of a straight piece of the profile (a conical
// bottom): there the cutter slides along that line. With a lead below 0 a flat end stands on the opposite
// rim.
#pragma once

#include "core/cutter/cutter.h"
#include "core/setup/tool_pose.h"

#include <vector>

namespace facetmill {

/// The LCS: unit vectors, right-handed; millimetres, part coordinates.
struct ContactFrame {
    Vec3 point = Vec3::Zero();
    Vec3 feed = Vec3::UnitX(), left = Vec3::UnitY(), normal = Vec3::UnitZ();

    /// `normal` of any length above 0, away from the part. `travel`: where the pass goes; its component
    /// across the normal gives the feed, some direction across the normal where there is none. Throws
    /// Error(internal) for a normal without direction, or values that are not finite.
    static ContactFrame at(const Vec3& point, const Vec3& normal, const Vec3& travel);
};

/// A posture: radians, radians, mm.
struct PostureValue {
    double lead = 0, yaw = 0, delta = 0;
};

/// Unit vector from the tip to the holder.
Vec3 posture_axis(const ContactFrame& frame, double lead, double yaw);

/// The inverse of posture_axis: lead from 0 to pi, yaw in (-pi, pi], 0 where the axis is the normal; delta 0.
PostureValue posture_of_axis(const ContactFrame& frame, const Vec3& axis);

/// Whether the cutter can touch a plane from which its axis leans by `lead`: with a point of its lower
/// surface that is below `flutes` (height above the tip up to which the tool cuts; 0: the cutter's own
/// height). Not where a taper or a cone would stand on its upper rim, and not from 90 degrees on.
bool can_touch(const CutterProfile& cutter, double lead, double flutes = 0);

/// The pose in which the cutter touches the tangent plane at the frame's point, moved by delta along the
/// axis. Where it cannot touch (see can_touch) it stands on the upper rim of its lower surface. The pose is
/// finite for every cutter and all finite values.
ToolPose posture_pose(const CutterProfile& cutter, const ContactFrame& frame, const PostureValue& posture);

/// Leads and yaws at which a configuration space is known.
struct PostureGrid {
    static constexpr std::size_t max_nodes = 1'000'000;

    std::vector<double> lead, yaw; ///< radians, ascending, both limits included

    /// Evenly spaced, no farther apart than `step`. Throws Error(out_of_range) whose place is the key:
    /// "lead_limits" and "yaw_limits" that are reversed, not finite, or beyond 90 and 180 degrees on either
    /// side; "grid_degrees" for a step that is not above 0, or so fine that there are more than max_nodes.
    static PostureGrid make(double lead_lo, double lead_hi, double yaw_lo, double yaw_hi, double step);

    std::size_t size() const { return lead.size() * yaw.size(); }
    std::size_t node(std::size_t lead_number, std::size_t yaw_number) const {
        return lead_number * yaw.size() + yaw_number;
    }
};

} // namespace facetmill
