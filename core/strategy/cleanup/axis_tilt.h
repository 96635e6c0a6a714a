// Inclining the tool along a pass that was planned with a vertical axis, where shank or holder would touch
// the part (Lu 3.6 asks for it in steep valleys, and leaves open how). Millimetres, radians, part
// coordinates.
//
// Turned about the place that it touches, a ball cuts what it cut before; any other cutter is put back
// against the plane there, and drawn out along its axis until it cuts nothing. Axes are chosen at even steps
// along the pass: of all on a grid around the vertical those that are free, joined to the way that is
// inclined and turned least, by dynamic programming. Between the steps the axis turns evenly; every location
// and the motion between two is looked at again, and divided where it cuts deeper than the chord tolerance.
#pragma once

#include "core/gouge/tool_lift.h"
#include "core/strategy/plan/path.h"

#include <vector>

namespace facetmill {

struct TiltInput {
    const ToolLift* whole = nullptr; ///< cutter (with the allowance), shank and holder
    double limit = 0;                ///< of the angle between axis and +Z; 0: upright only
    double chord = 0.0025;           ///< how far a motion may run into the part
    double raise = 0.0125;           ///< the tool is drawn out of what it would cut by no more: so much stays
};

struct TiltedPass {
    std::vector<Pass> passes;     ///< what can be cut of it, in order
    double lost = 0;              ///< length of what cannot
    ToolBody by = ToolBody::none; ///< that stands in the way
    double largest = 0;           ///< inclination that is used
};

/// Throws Cancelled within 100 ms.
TiltedPass tilted_where_held(const TiltInput& input, const Pass& pass, const Progress& progress);

/// The location of a tool inclined to `axis` that cuts at `contact` what the upright one at `tip` does;
/// before it is drawn out of what it would cut elsewhere. False where the cutter cannot touch a plane so
/// steep.
bool turned_about_contact(const CutterProfile& cutter, const CutterContact& contact, const Vec3& tip,
                          const Vec3& axis, CutterLocation& turned);

} // namespace facetmill
