// Finishing with a vertical tool axis along parallel drive planes (Lu 3.5), with any generalized cutter.
//
// The tip moves in the drive plane. Lu puts the tip above the contact point and lifts it along Z until
// nothing is gouged; one can also move the tip sideways so that the cutter touches the contact point itself.
// Then the contact points lie in the drive plane, but the tip leaves it and jumps at every crease, and where
// the cutter cannot reach the point the lifted tip stands anywhere. Kept in the plane, tips of neighbouring
// passes are the step-over apart everywhere, every pass is straight seen from above, and the lift over the
// whole plane is the exact path that never gouges and leaves no gap. The contact point (CC) of a tip is then
// where the cutter touches: on the part, beside the plane where the part is steep across it. Where Lu loses
// places, the domain (contact_domain.h) makes up for it: the tip goes as far beyond a border as touching the
// border takes.
//
// Passes are as far apart as most of them allows; partial passes lie between where a range asks for more
// (partial_lines.h). `drive_planes` counts those over the whole part.
//
// Only what the cutter meets from above is cut: undersides and places under an overhang get no pass, and a
// solid, whose slices have a top and a bottom, is passed once.
//
// The safe machining region (Lu 3.13-3.15): the part was tessellated from a surface that lies between t_out
// below and t_in above the mesh. With machining tolerances m_out (excess, called tau- by Lu) = tolerance and
// m_in = 0 (no gouge at all), the lowest surface that is safe, S12, is the mesh lifted by t_in; what may stay
// above it is tau = tolerance - t_in - t_out. The cutter is kept off S12 + allowance, and cusps are held to
// tau. That is 3.15 with the tolerances on the sides where Fig. 3-8 has them.
//
// Shank and holder keep out of the part: the cutter is not moved where they would come into it, nor where
// they would come into what stands of the stock above the flutes (left_stock.h). What that leaves is said,
// and how long a tool would reach it.
//
// As a semi-finish it keeps an allowance. Asked to, it cuts only where more than the tolerance stands of the
// stock, as raw material and earlier operations left it (stock_field.h): the passes are those of a plan over
// the whole part, less what would be air.
#pragma once

#include "core/strategy/finish3/pass_filter.h"
#include "core/strategy/plan/operation.h"

namespace facetmill {

/// How finely cusps between two lines are looked at.
struct CuspLook {
    double share = 0.08; ///< distance of places along a line, in radii of the cutter
    /// Contacts are looked for between two that are farther apart than this share of the step on a level
    /// plane: where the contact jumps from flank to flank in a hollow, and beside an edge, where what is left
    /// rises steeply, finely.
    double jump_gap = 0.4, edge_gap = 0.05;
};

struct Finish3Settings : OperationCommon {
    enum class Topology { parallel }; ///< course of the passes; another gets a case in the planner
    enum class Pattern { zigzag, oneway };

    Finish3Settings() { name = "Finish"; }
    NumberOrWord stepover{0, "adaptive"}; ///< mm
    Topology topology = Topology::parallel;
    Pattern pattern = Pattern::zigzag;
    NumberOrWord chord_tolerance{0, "auto"}; ///< mm; auto: see chord_budget
    double normal_limit = radians(5);
    double holder_clearance = 0; ///< mm, kept between shank or holder and the part
    double tilt_limit = 0; ///< largest inclination of the axis where shank or holder would touch, radians
    bool rest_only = false;
    /// How finely cusps are looked at. No parameters: step-overs rest on it, and tests halve and double it.
    CuspLook look;
};

const ParameterTable<Finish3Settings>& finish3_parameters();

class Finish3 : public OperationWith<Finish3Settings, finish3_parameters> {
public:
    using OperationWith::OperationWith;

    std::string_view kind() const override { return "finish3"; }
    std::unique_ptr<Operation> clone() const override { return std::make_unique<Finish3>(settings_); }
    bool keeps_axis() const override { return settings_.tilt_limit == 0; }
    bool reads_stock() const override { return true; }
    double holder_clearance() const override { return settings_.holder_clearance; }

    /// Throws Error(empty_result) when no facet faces up, Error(out_of_range) when the tessellation
    /// tolerances leave nothing of the tolerance or the cutter is impossible, Error(limit_exceeded) beyond
    /// 100 000 drive planes.
    StrategyResult plan(const PlanContext& context, const Progress& progress) const override;
};

/// The passes of such a plan as a part of another operation's, which asks itself what stays uncut. Throws
/// what Finish3::plan does.
PlannedPasses finish3_passes(const Finish3Settings& settings, const PlanContext& context,
                             const Progress& progress);

} // namespace facetmill
