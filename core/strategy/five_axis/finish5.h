// Finishing with five axes along parallel drive planes, postures from the configuration space (Lu 3.5.2,
// 3.5.5).
//
// Contact points lie in drive planes, on the surface; at each the tool touches with an inclination and a yaw
// against the surface's normal and the travel (core/cspace says how they are measured). The step over to the
// next plane is the largest at which a posture close to the curvature-matched one (CM2) on either side leaves
// no cusp above the tolerance (tilted_stepover.h), or a larger one with partial passes over the ranges where
// that leaves too much, where that makes less travel (partial_passes.h). The strips between planes being
// fixed, every contact point has its configuration space, and the postures are chosen in it: `cm2`, `local`
// (Lu) or `global` (core/cspace/choose.h). Between contact points the motion is checked and divided until it
// neither gouges nor leaves the configuration space (posture_path.h). Points without a free posture are left
// to clean-up.
//
// As with three axes (finish3.h), the part's tessellation tolerances are taken off the tolerance, and the
// tool stays away from the part by the inner one.
#pragma once

#include "core/strategy/five_axis/manual_posture.h"
#include "core/strategy/plan/operation.h"

namespace facetmill {

struct Finish5Settings : OperationCommon {
    enum class Pattern { zigzag, oneway };
    enum class PostureChoice { cm2, local, global };
    /// Whether the part is cut from above only, or side by side where it has other sides (part_sides.h).
    enum class Sides { automatic, top };
    /// Passes in parallel planes, from one edge of each piece of the surface to the other (flow_map.h), or in
    /// rings about what goes round (ring_map.h) and from edge to edge over the rest.
    enum class Passes { parallel, morph, around };

    Finish5Settings() {
        name = "Finish5";
        tolerance = 0.1;
    }
    PostureChoice posture = PostureChoice::global;
    double grid_step = radians(3);
    std::array<double, 2> lead_limits{0, radians(45)};
    std::array<double, 2> yaw_limits{radians(-45), radians(45)};
    NumberOrWord stepover{0, "adaptive"}; ///< mm
    Pattern pattern = Pattern::zigzag;
    Sides sides = Sides::automatic;
    Passes passes = Passes::parallel;
    /// The largest lead where a part is cut side by side and no lead within the limits reaches a place.
    double reach_lead = radians(85);
    NumberOrWord chord_tolerance{0, "auto"}; ///< mm; auto: see chord_budget
    double normal_limit = radians(5);
    double turn_limit = radians(15); ///< between neighbouring tool axes
    double holder_clearance = 0;     ///< mm, kept between shank or holder and the part
    bool accelerations = false;      ///< the global choice and the reported time mind those of the axes
    /// Used whatever `posture` says where they are free; where they are not, a warning names the point.
    std::vector<ManualPosture> manual_postures;
    // No parameters: what plans keep safe by, which tests halve and double.
    /// The share of the chord tolerance that motions may use along the axis at the places looked at, so that
    /// what lies between them stays within the tolerance too: with half of it motions are divided more often,
    /// with twice as much the tolerance may be exceeded.
    double motion_share = 0.6;
    /// Room that postures keep to the top, in chord tolerances: what motions between them may miss their
    /// strip by, and as much again. Motions between postures on the border of their spaces leave these.
    double room_chords = 3;
    /// How far along the travel a contact point's own line is looked at, in radii of the cutter. Short, for
    /// safety: a flat end lifted off a bend that is hollow along the travel may hold a far place of the line
    /// with its heel at one pose and with its toe at the next, and what lies between is left.
    double own_reach = 0.25;
    /// Distance of the lines beside a pass by which the width of its strip is found, in radii of the cutter:
    /// what stands between two of them is not seen.
    double strip_look_share = 1.0 / 16;
    /// Axes that lean farther from +Z are not held, whatever the machine can.
    double max_tilt = pi;
};

const ParameterTable<Finish5Settings>& finish5_parameters();

/// Finishes a piece of a part: `context.part` is the piece, `context.contact` what must not be cut. Partial
/// passes stand wherever they make less travel. Places whose strips are narrower than `leave` (mm) are cut in
/// passing only. There are no warnings about what is left,
/// and no passes where nothing can be cut. Otherwise as Finish5::plan.
StrategyResult finish_piece(const Finish5Settings& settings, const PlanContext& context,
                            const Progress& progress, double leave = 0);

class Finish5 : public OperationWith<Finish5Settings, finish5_parameters> {
public:
    using OperationWith::OperationWith;

    std::string_view kind() const override { return "finish5"; }
    std::unique_ptr<Operation> clone() const override { return std::make_unique<Finish5>(settings_); }
    bool keeps_axis() const override { return false; }
    double holder_clearance() const override { return settings_.holder_clearance; }
    bool accelerations() const override { return settings_.accelerations; }

    /// Throws Error(empty_result) when no drive plane meets the part or no posture is free anywhere,
    /// Error(out_of_range) for limits that leave nothing, Error(limit_exceeded) beyond 100 000 drive planes.
    StrategyResult plan(const PlanContext& context, const Progress& progress) const override;
};

} // namespace facetmill
