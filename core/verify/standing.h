// How much of what stands on a place is excess. Internal to this room.
//
// At the foot of a wall the line along the floor's normal runs up within the skin that a path may leave on
// the wall: as high as the wall, and yet nowhere farther from the part than the skin is thick. So what stands
// is measured by how far it is from all of the part: max over the line of the distance to the nearest facet.
// On an open surface that is the line's own length.
#pragma once

#include "core/mesh/sight.h"

namespace facetmill {

class StandingMaterial {
public:
    /// `allowance`: what is to be made is the part grown by this. `far` (mm): what is nearer than this is
    /// told as no more than that, however the lines run.
    StandingMaterial(const MeshSight& sight, double allowance, double far)
        : sight_(sight), allowance_(allowance), far_(far) {}

    /// How far material on p + t n, t in [0, top], is away from the part; p lies on the part grown, n leads
    /// outward. At most `top`, which is no more than up to where the line meets the part again: beyond, it
    /// stands on another place. Whether that is more than `far` is exact; what is higher is told to a
    /// thirtieth of the line's length, what is lower rounded up to a half, a quarter or an eighth of `far`.
    double off_part(const Vec3& p, const Vec3& n, double top) const;

private:
    double distance(const Vec3& q, double most, double share) const {
        return std::max(0.0, sight_.distance(q, most + allowance_, share, allowance_) - allowance_);
    }
    double far_place(const Vec3& p, const Vec3& n, double length, double limit) const;

    const MeshSight& sight_;
    double allowance_, far_;
};

} // namespace facetmill
