// Choosing postures along a pass, from the configuration spaces of its contact points (Lu 3.5.5.2). Three
// methods:
//
//   cm2     curvature matching: yaw 0 and the lead that matches the curvature across the feed; where that is
//           not free, inclined further, then lifted (Li and Jerard)
//   local   Lu: point by point the free posture nearest to the ideal one, by joint-motion time, searched from
//           the CM2 posture by the penalty method. The ideal is an axis that stays as it is: that of the
//           point before
//   global  the postures that take the machine least time over the whole pass and on to the next: the
//           cheapest path through all configuration spaces
//
// mm, radians, seconds; part coordinates.
#pragma once

#include "core/cspace/cspace.h"
#include "core/setup/kinematics.h"

#include <optional>
#include <span>
#include <vector>

namespace facetmill {

/// One contact point of a pass.
struct PassPoint {
    ContactFrame frame;
    const CSpace* space = nullptr;
    const std::vector<RaisedCurve>* curves = nullptr; ///< so that postures between nodes are judged exactly
    double cm2_lead = 0;                              ///< the CM2 lead, held to the lead limits
    /// Chosen by hand, and free: what every method takes at this point.
    std::optional<PostureValue> kept;
    /// Where no node of the grid is free: free postures between nodes (between_nodes.h), if any were found.
    /// The global choice alone takes them.
    std::vector<PostureValue> between;
};

/// Where it is not free the point is left to clean-up.
struct ChosenPosture {
    bool free = false;
    PostureValue posture;
};

struct ChooseInput {
    const CSpaceBuilder* builder = nullptr; ///< with the grid and, if any, the kinematics of its input
    double feed = 1000.0 / 60;              ///< the tip's, mm/s
    double turn_limit = radians(15);        ///< between neighbouring tool axes; more separates the pass there
    /// Distance that is kept from the top where there is as much, mm: local lifts no higher, global avoids
    /// postures that have less.
    double room = 0;
    bool accelerations = false;     ///< global: mind what axes take to change their speed
    std::optional<ToolPose> before; ///< where the tool comes from: the end of the pass before
    /// Where it goes to: the first points of the next pass, `choose_horizon` of them or fewer.
    std::span<const PassPoint> next;
};

/// How far into the next pass the global choice looks: far enough for the axis to turn to what comes.
constexpr std::size_t choose_horizon = 12;

/// One posture per point, in their order. Free postures lie in the configuration space: bottom <= delta <=
/// top, checked between nodes too.
std::vector<ChosenPosture> choose_cm2(std::span<const PassPoint> points, const ChooseInput& input,
                                      const Progress& progress);
std::vector<ChosenPosture> choose_local(std::span<const PassPoint> points, const ChooseInput& input,
                                        const Progress& progress);
std::vector<ChosenPosture> choose_global(std::span<const PassPoint> points, const ChooseInput& input,
                                         const Progress& progress);

} // namespace facetmill
