// Where a cutter stands at a contact point: the frames and angles of the configuration space (Lu 3.5.5, Fig.
// 3-24).
//
//   GCS  the part's coordinates: all points and poses that are passed about.
//   LCS  at a contact point of the part: origin there, x along the feed, z the surface normal away from the
//   part,
//        y = z cross x, to the left. `ContactFrame`.
//   TCS  of the tool: origin at its tip, z along its axis to the holder. `ToolPose` (core/setup/tool_pose.h).
//
// A posture is (lambda, omega, delta). Inclination lambda: the axis leans from the normal towards the feed.
// Yaw omega: the lean is then turned about the normal, to the left. So the axis in the LCS is (sin lambda cos
// omega, sin lambda sin omega, cos lambda). A negative lambda is -lambda at omega + pi. Delta: with delta = 0
// the cutter touches the tangent plane at the contact point; then it is moved by delta along its *axis* (as
// in Lu's formulas 3.8 and 3.87; his text says along the normal).
//
// The cutter touches with the point of its lower surface that has the plane's normal. An upright flat end
// (lambda = 0) touches with its whole end; here it stands as in the limit lambda -> 0+, on its rim in the
// direction of the lean, as a cutter does that is about to lean. So poses are continuous in lambda >= 0 and
// omega, but where lambda is the angle of a straight piece of the profile (a conical bottom): there the
// cutter slides along that line. With lambda < 0 a flat end stands on the opposite rim.
#pragma once

#include "core/cutter/cutter.h"
#include "core/setup/tool_pose.h"

#include <vector>

namespace facetmill {

/// LCS: unit vectors, right-handed; millimetres, part coordinates.
struct ContactFrame {
    Vec3 point = Vec3::Zero();
    Vec3 feed = Vec3::UnitX(), left = Vec3::UnitY(), normal = Vec3::UnitZ();

    /// `normal` of any length above 0, away from the part. `travel`: where the pass goes; the part of it
    /// across the normal is the feed. Where it has none, some direction across the normal. Throws
    /// Error(internal) for a normal without direction, or values that are not finite.
    static ContactFrame at(const Vec3& point, const Vec3& normal, const Vec3& travel);
};

/// Radians, radians, mm.
struct PostureValue {
    double lead = 0, yaw = 0, delta = 0;
};

/// Unit vector from the tip to the holder.
Vec3 posture_axis(const ContactFrame& frame, double lead, double yaw);

/// Lambda from 0 to pi, omega in (-pi, pi], 0 where the axis is the normal; delta 0. The inverse of
/// posture_axis for lambda >= 0.
PostureValue posture_of_axis(const ContactFrame& frame, const Vec3& axis);

/// Whether the cutter can touch a plane from which its axis leans by lambda: with a point of its lower
/// surface that is below `flutes` (height above the tip up to which the tool cuts; 0: the cutter's own
/// height). Not where a taper or a cone would stand on its upper rim, and not from 90 degrees on.
bool can_touch(const CutterProfile& cutter, double lead, double flutes = 0);

/// Where the cutter touches the tangent plane at the frame's point, moved by delta along the axis. Where it
/// cannot touch (see can_touch) it stands on the upper rim of its lower surface. Every cutter, every finite
/// value: a finite pose.
ToolPose posture_pose(const CutterProfile& cutter, const ContactFrame& frame, const PostureValue& posture);

/// Inclinations and yaws at which a configuration space is known.
struct PostureGrid {
    static constexpr std::size_t max_nodes = 1'000'000;

    std::vector<double> lead, yaw; ///< radians, ascending, both limits included

    /// Evenly, no farther apart than `step`. Throws Error(out_of_range) whose place is the key: "lead_limits"
    /// and "yaw_limits" that are reversed, not finite, or beyond 90 and 180 degrees on either side;
    /// "grid_degrees" for a step that is not above 0, or so fine that there are more than max_nodes.
    static PostureGrid make(double lead_lo, double lead_hi, double yaw_lo, double yaw_hi, double step);

    std::size_t size() const { return lead.size() * yaw.size(); }
    /// Lambda number `il`, omega number `io`.
    std::size_t node(std::size_t il, std::size_t io) const { return il * yaw.size() + io; }
};

} // namespace facetmill
