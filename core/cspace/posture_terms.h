// Sines and cosines of a posture's angles, so that a grid needs each of them once. All poses are computed
// here: a node of a grid has the very pose of its angles given one by one.
#pragma once

#include "core/cspace/contact_frame.h"
#include "core/gouge/tool_lift.h"

#include <cmath>

namespace facetmill {

struct TurnTerms {
    double cosine, sine;
    explicit TurnTerms(double yaw) : cosine(std::cos(yaw)), sine(std::sin(yaw)) {}
};

/// Terms of the lead's size; a negative lead leans in the opposite direction.
struct LeanTerms {
    double angle, cosine, sine, sign;
    explicit LeanTerms(double lead)
        : angle(std::abs(lead)), cosine(std::cos(angle)), sine(std::sin(angle)), sign(lead < 0 ? -1 : 1) {}

    Vec3 direction(const ContactFrame& frame, const TurnTerms& turn) const {
        return sign * (turn.cosine * frame.feed + turn.sine * frame.left);
    }
    Vec3 axis(const ContactFrame& frame, const TurnTerms& turn) const {
        return cosine * frame.normal + sine * direction(frame, turn);
    }
    /// `at`: the cutter's plane_contact at this angle. From there the axis is at distance at.x in the
    /// direction that the normal has across the axis, normal - cosine * axis = sine * (sine * normal - cosine
    /// * direction): its unit vector has a limit where the sine vanishes.
    ToolPose pose(const Vec2& at, const ContactFrame& frame, const TurnTerms& turn, double delta) const {
        const Vec3 to = direction(frame, turn);
        const Vec3 along = cosine * frame.normal + sine * to, across = sine * frame.normal - cosine * to;
        return {frame.point + at.x() * across + (delta - at.y()) * along, along};
    }
    ToolPose pose(const CutterProfile& cutter, const ContactFrame& frame, const TurnTerms& turn,
                  double delta) const {
        return pose(plane_contact(cutter, angle), frame, turn, delta);
    }
};

} // namespace facetmill
