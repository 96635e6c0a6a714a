// The box around a configuration space: its axes with their ticks, along the edges that are in front.
#pragma once

#include "viz/cspace_display.h"

namespace facetmill {

struct CSpaceTick {
    Vec3 at;
    std::string text;
};

struct CSpaceAxis {
    std::string name;
    Vec3 outward = Vec3::Zero(); ///< across the axis, away from the box
    Vec3 middle = Vec3::Zero();
    std::vector<CSpaceTick> ticks;
};

struct CSpaceAxes {
    /// How far a tick stands out, box lengths.
    static constexpr double tick = 0.02;

    std::size_t front = 0; ///< number of the floor's corner nearest to the eye
    CSpaceAxis lead, yaw, delta;
};

/// Four corners of the floor, around.
std::array<Vec2, 4> floor_corners(const CSpaceDisplay& display);

/// Along the edges of the floor that are in front, and the upright edge that is farthest to the left.
/// `camera`: right, up, towards the eye.
CSpaceAxes cspace_axes(const CSpaceDisplay& display, const Mat3& camera, LengthUnit unit);

/// The box: its floor, the back edges and the level delta = 0, with ticks along the axes.
CSpaceSegments cspace_frame(const CSpaceDisplay& display, const CSpaceAxes& axes);

} // namespace facetmill
