// Waterline finishing (constant Z): an upright tool goes round the part at heights chosen so that the cusps
// on its slopes stay within the tolerance. Any generalized cutter.
//
// A level's contour is the border of where the tip may stand at that height (level_contours.h): the axial
// lift of the whole cutter over the whole part is asked at every place, so the contours of islands, hollows
// and walls are exact for every cutter, and no place is too low. The step down follows the slopes between two
// levels and how the surface bends there (slope_steps.h); where few places ask for less, pieces of levels lie
// between (level_choice.h). The foot of a wall gets a level of its own, as near above the floor as half the
// chord tolerance.
//
// Only surface whose slope lies within limits is cut: on what is nearly level, levels would have to lie close
// together; that is for parallel passes. What stays there is said.
//
// Tolerances, shank and holder, stock, what is air and what stays uncut are as in finish3.h.
#pragma once

#include "core/strategy/finish3/pass_filter.h"
#include "core/strategy/plan/operation.h"

namespace facetmill {

struct WaterlineSettings : OperationCommon {
    enum class Pattern { zigzag, oneway };

    WaterlineSettings() { name = "Waterline"; }
    NumberOrWord stepdown{0, "adaptive"};                         ///< mm
    NumberOrWord max_stepdown{0, "auto"};                         ///< mm; auto: the cutter's diameter
    std::array<double, 2> slope_limits{radians(30), radians(90)}; ///< of the surface that is cut, from level
    Pattern pattern = Pattern::zigzag;
    NumberOrWord chord_tolerance{0, "auto"}; ///< mm; auto: see chord_budget
    double holder_clearance = 0;             ///< mm, kept between shank or holder and the part
    double tilt_limit = 0; ///< largest inclination of the axis where shank or holder would touch, radians
    bool rest_only = false;
    /// The distance of the places of the grid on which contours are looked for, in radii of the cutter. No
    /// parameter: islands and hollows that are narrower for the tip are missed, and tests halve it.
    double grid_share = 0.1;
};

const ParameterTable<WaterlineSettings>& waterline_parameters();

class Waterline : public OperationWith<WaterlineSettings, waterline_parameters> {
public:
    using OperationWith::OperationWith;

    std::string_view kind() const override { return "waterline"; }
    std::unique_ptr<Operation> clone() const override { return std::make_unique<Waterline>(settings_); }
    bool keeps_axis() const override { return settings_.tilt_limit == 0; }
    bool reads_stock() const override { return true; }
    double holder_clearance() const override { return settings_.holder_clearance; }

    /// Throws Error(empty_result) when nothing of the part is as steep as asked for, or nothing that is can
    /// be cut; Error(out_of_range) when the tessellation tolerances leave nothing of the tolerance or the
    /// cutter is impossible, Error(limit_exceeded) for a part that is too large for its tool or tolerance.
    StrategyResult plan(const PlanContext& context, const Progress& progress) const override;
};

/// The passes of such a plan as a part of another operation's, which asks itself what stays uncut. Throws
/// what Waterline::plan does.
PlannedPasses waterline_passes(const WaterlineSettings& settings, const PlanContext& context,
                               const Progress& progress);

} // namespace facetmill
