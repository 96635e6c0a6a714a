// From chosen postures to cutter locations: the motion between contact points is checked and divided until
// it keeps clear of the part and within the configuration space (Lu checks contact points only).
//
// Between two locations the tip moves straight and the axis turns in one plane, as machines with tool centre
// point control do and as the verifier assumes.
#pragma once

#include "core/cspace/choose.h"
#include "core/strategy/five_axis/five_axis_field.h"
#include "core/strategy/plan/path.h"

namespace facetmill {

/// One line of the surface as it is to be cut: contact places in the order of travel.
struct PlacedLine {
    SurfaceLine line;
    int travel = 1;
    std::vector<ContactPlace> places;
    std::vector<ChosenPosture> choices;
    std::array<bool, 2> cut_short{}; ///< the surface goes on before the first place, after the last
    /// Where the pass begins before its first place and goes on to after its last (run_out.h), with the
    /// postures of those.
    std::optional<ContactPlace> before, after;
};

struct JoinedPasses {
    std::vector<Pass> passes;                         ///< their drive and offset are left to the caller
    std::vector<CutterContact> uncut;                 ///< contact points left to clean-up, on the part
    double cusp = 0;                                  ///< largest to expect along the line, mm
    double lead_min = infinity, lead_max = -infinity; ///< leads used, radians
};

/// Tip and axis between two locations, as they move.
CutterLocation location_on_route(const CutterLocation& a, const CutterLocation& b, double t);

/// Whether the tool, moving between two locations, cuts no deeper than `limit` along its axis; the locations
/// themselves are the caller's to judge. The motion is looked at every `step` (mm) that the tip or the
/// cutter's rim moves and at three places at least, and more closely where the tool comes into touch or
/// leaves it: over the border of a part or an edge the depth grows in proportion to the distance, not to its
/// square.
bool keeps_clear_between(const ToolLift& lift, const CutterLocation& a, const CutterLocation& b, double step,
                         double limit, ToolLift::Hint& hint);
/// The step for a chord tolerance: within it a cutter of this radius and a part as round as the cutter come
/// apart by no more than a quarter of the tolerance.
double looking_step(double radius, double chord);

/// Height of the cusp that a posture leaves over its strip, mm, without the chord's share.
double posture_cusp(const FiveAxisField& field, const ContactPlace& place, const PostureValue& posture);

/// Joins the chosen postures of a line to passes; what lies between two that cannot be joined is left.
JoinedPasses join_postures(const FiveAxisField& field, const PlacedLine& line, const Progress& progress);

} // namespace facetmill
