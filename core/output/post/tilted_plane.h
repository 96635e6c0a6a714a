// Tilted planes of controls: a frame that is the part's, turned so that its Z is the axis of the tool.
// Internal to the room. Radians.
#pragma once

#include "core/base/vec.h"

namespace facetmill {

/// Two turns are enough for any axis: about the part's Z, then about the X that came of that. So X of the
/// frame stays level. They are Euler's angles with the third 0, and spatial angles about fixed X, Y, Z with
/// the one about Y 0.
struct TiltedPlane {
    double about_z = 0, about_x = 0;

    Mat3 frame() const; ///< its columns are the frame's X, Y, Z on the part
    Vec3 axis() const { return frame().col(2); }
};
/// The plane across a unit vector; about_x is from 0 to pi.
TiltedPlane plane_across(const Vec3& axis);

} // namespace facetmill
