// Arcs of circles and helices in the planes of a machine: the shape itself, and the runs of straight motions
// that one stands for. Internal to the room. Millimetres, radians.
#pragma once

#include "core/base/vec.h"

#include <array>
#include <optional>
#include <span>

namespace facetmill {

/// An arc about an axis of the machine; across its plane it runs evenly. The radius may differ between its
/// ends by what rounding does: it changes evenly, so both ends are met.
struct PlaneArc {
    int normal = 2; ///< axis across the plane: 2 for G17, 1 for G18, 0 for G19
    Vec3 from = Vec3::Zero(), to = Vec3::Zero();
    Vec3 centre = Vec3::Zero(); ///< at the height of `from`
    double angle = 0;           ///< swept, positive anticlockwise as seen from the normal's end

    /// The axes of the plane, the first turned onto the second by the normal's right hand.
    int first() const { return (normal + 1) % 3; }
    int second() const { return (normal + 2) % 3; }
    double radius() const; ///< at `from`
    double radius_at_end() const;
    double length() const;
    Vec3 at(double t) const; ///< t from 0 to 1
};

/// The arc with these ends and centre (its part along the normal counts for nothing); a whole turn where the
/// ends are the same in the plane.
PlaneArc arc_about(const Vec3& from, const Vec3& to, const Vec3& centre, int normal, bool clockwise);
/// The arc with this radius, of less than half a turn where it is positive and of more where it is not;
/// nothing where the ends are the same in the plane or farther apart than twice the radius (by more than
/// `slack`).
std::optional<PlaneArc> arc_with_radius(const Vec3& from, const Vec3& to, double radius, int normal,
                                        bool clockwise, double slack);

/// What an arc in place of straight motions must keep to.
struct ArcLimits {
    double off = 0.002;   ///< how far the ends of the motions may be from it
    double bulge = 0.004; ///< how far it may be from the motions between their ends
    double smallest_radius = 0.1, largest_radius = 1000, largest_angle = pi;
    std::array<bool, 3> normals{true, true, true}; ///< planes, by the axis across
    bool helix = true;                             ///< it may climb
};

struct ArcRun {
    PlaneArc arc;
    std::size_t motions = 0; ///< that it stands for
};
/// The longest arc that stands for motions from points.front() on, of the runs that were looked at, from end
/// to end; nothing where fewer than three of them lie on one.
std::optional<ArcRun> arc_run(std::span<const Vec3> points, const ArcLimits& limits);

} // namespace facetmill
