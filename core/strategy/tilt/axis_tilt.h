// Inclining the tool along a pass that was planned with a vertical axis, where shank or holder would touch
// the part (Lu 3.6 asks for it in steep valleys, and leaves open how). Millimetres, radians, part
// coordinates.
//
// Turned about the place that it touches, a ball cuts what it cut before; any other cutter is put back
// against the plane there, and drawn out along its axis until it cuts nothing. Axes are chosen at even steps
// along the pass, from those on a grid around the vertical that are free there and that the machine holds:
// dynamic programming finds the sequence that is inclined and turned least. Between the steps the axis turns
// evenly; every location and the motion between two is looked at again, and divided where it cuts deeper than
// the chord tolerance, or where a ball's middle leaves its way by a share of it. What machines would turn
// differently between two locations is divided as well (even_motion.h). Stock that stands is asked about in
// locations and places alone, a step apart.
#pragma once

#include "core/gouge/tool_lift.h"
#include "core/setup/kinematics.h"
#include "core/strategy/plan/path.h"
#include "core/strategy/surface/contact_domain.h"
#include "core/strategy/tilt/tilted_stock.h"

#include <vector>

namespace facetmill {

struct TiltInput {
    const ToolLift* whole = nullptr; ///< cutter (with the allowance), shank and holder
    double limit = 0;                ///< largest angle between axis and +Z; 0: upright only
    double chord = 0.0025;           ///< how far a motion may run into the part
    double raise = 0.0125;           ///< how far the tool may be drawn out: so much more may stay there
    /// Share of the chord tolerance that a motion may use up at the places where it is looked at. What it
    /// may cut deeper between two of these (posture_path.h: a quarter of the tolerance) has to fit beside
    /// it.
    double looked_share = 0.6;
    const Kinematics* machine = nullptr; ///< null: one that holds every axis
    /// Between locations of the upright pass shank and holder are looked at as often (body_step); +inf: they
    /// are looked at in locations alone.
    double look_step = infinity;
    const TiltedStock* stock = nullptr; ///< what else shank and holder keep out of
    /// Inclined only where the cutter touches with its ball end, upright and inclined: then it cuts the same.
    bool ball_only = false;
};

struct TiltedPass {
    std::vector<Pass> passes;     ///< what can be cut of the pass, in order
    std::vector<Interval> kept;   ///< the ranges of the pass's length that they cut
    double lost = 0;              ///< length of what cannot
    ToolBody by = ToolBody::none; ///< what would touch the part there
    double largest = 0;           ///< largest inclination used
};

/// A pass as it was where nothing touches, else with inclined axes.
TiltedPass tilted_where_held(const TiltInput& input, const Pass& pass, const Progress& progress);

/// Between places so far apart no body of a tool that moves past a corner comes nearer to it by more than
/// `chord`.
double body_step(const Tool& tool, double chord);

/// Radius of the cutter's ball end, mm; 0: it has none.
double ball_radius(const CutterProfile& cutter);

/// The location of a tool inclined to `axis` that cuts at `contact` what the upright one at `tip` does
/// there, before it is drawn out of what it would cut elsewhere. False where the cutter cannot touch a plane
/// so steep.
bool turned_about_contact(const CutterProfile& cutter, const CutterContact& contact, const Vec3& tip,
                          const Vec3& axis, CutterLocation& turned);

} // namespace facetmill
