// What a finished path leaves standing: the promise that nothing stays uncut in silence.
//
// The facets that face up are sampled, evenly and at least once each. At every sample the place as far above
// it, along the facet's normal, as may stay is looked for in the cutter that the passes move, so whatever the
// planner overlooked shows. What is left above the allowed height
// has one of four reasons:
//
//  - out of reach: wherever the cutter touches down here, the part around it holds it up; hollows narrower
//    than the cutter, inner edges, feet of walls. Only another cutter helps.
//  - passed by: the cutter would reach the place, but no pass goes there; a step-over that is too large.
//  - held: passes over it are left out, because shank or holder would come into the part.
//  - covered: the part itself lies over the place, seen from above. Counted where the facets' winding tells
//    which side is out (a closed mesh); on an open sheet the facet may just as well be an underside.
#pragma once

#include "core/strategy/plan/path.h"
#include "core/strategy/surface/contact_domain.h"

#include "core/gouge/axial_lift.h"

#include <span>

namespace facetmill {

/// The cutter as passes move it, endless upward.
class SweptPasses {
public:
    virtual ~SweptPasses() = default;
    /// Lowest height that it comes down to over q, or any height not above `enough`. Places near `hint`, a
    /// tip, are looked at first. Any thread may ask.
    virtual double lowest(const Vec3& q, const Vec3& hint, double enough) const = 0;
};

struct UncutInput {
    const Mesh* mesh = nullptr;
    ContactIndexPtr contact;
    const AxialLift* lift = nullptr; ///< the cutter's, with the allowance
    const CutterCover* cover = nullptr;
    DriveFrame frame;
    double allowance = 0; ///< all that is to stay along the normal, as in `lift`
    double allowed = 0;   ///< height above it that may stay, > 0
    double top = 0;       ///< height of the stock, for places that no pass comes over
    std::span<const Pass> passes;
    std::span<const Pass> left_out; ///< for shank and holder
    /// Both instead of those above, for passes that lie in no drive planes.
    const SweptPasses *swept = nullptr, *swept_left_out = nullptr;
    /// The facets are some of a closed mesh, wound with the outside up: what lies under the part counts.
    bool outside_up = false;
    double lowest_tip = -infinity; ///< places that only a lower tip would touch do not count
    bool tell_passed = false;      ///< every place that is passed by
};

struct UncutPlaces {
    double area = 0; ///< mm^2
    /// Largest, within a hundredth: along the normal (upright where no pass crosses it), but no more than
    /// what stands is away from all of the part.
    double height = 0;
    Vec3 at = Vec3::Zero(); ///< where that is, on the part
};

struct UncutReport {
    double area = 0; ///< all facets that were looked at, mm^2
    UncutPlaces out_of_reach, passed_by, held, covered;
    double below = 0; ///< of it, what only a tip below the lowest would touch and is not cut, mm^2
    std::size_t samples = 0;
    std::vector<Vec3> passed_tips; ///< where they are asked for: tips that would cut what is passed by
};

/// Cost: below a microsecond a sample where the path is good, some ten where it is not; at least one sample a
/// facet, at most about four million beyond that.
/// thread count.
UncutReport find_uncut(const UncutInput& input, const Progress& progress);

} // namespace facetmill
