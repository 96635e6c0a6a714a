// What stays between passes beside each other. Millimetres, part coordinates.
#pragma once

#include "core/strategy/cleanup/valley_spots.h"

namespace facetmill {

class BetweenPasses {
public:
    explicit BetweenPasses(const StripCutting& with)
        : with_(with), radius_(with.cover->radius()), reach_(reach_of(with)) {}

    /// The most that stays between two places of the cutter beside each other, moved along `travel`, more
    /// than it could leave. Where both touch a plane, or the part is round, that is no more than their ridge.
    /// In a hollow both come to nearly the same place and touch far from each other: there it is measured on
    /// the part, less what the cutter cannot reach at all.
    double left(const ValleySpot& a, const ValleySpot& b, const Vec3& travel) const;

private:
    /// A place of the part between two touched points.
    struct Between {
        Vec3 point;  ///< with the allowance
        Vec3 facet;  ///< normal of its facet
        Vec3 normal; ///< between those of the touched points
    };
    std::optional<Between> between(const ValleySpot& a, const ValleySpot& b, double share) const;
    double min_left(const Between& at, double rest, double known, LiftHint& hint) const;

    const StripCutting& with_;
    double radius_;
    ValleyInput reach_; ///< for what the cutter cannot reach
};

} // namespace facetmill
