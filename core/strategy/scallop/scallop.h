// Constant scallop: passes that lie everywhere as far apart as the cusp between them allows, and follow the
// border of what is cut or a curve, or circle a place on it. An upright tool, any generalized cutter.
//
// What is constant is the height of the cusps, not the distance of the passes: distances over the surface are
// counted in steps, which are narrow where the surface bulges or is steep across the passes and wide in
// hollows (scallop_field.h), and every pass is one step from its neighbours. Passes go out to corners that
// they would leave too high, and back (detours.h); where those that come from two sides meet, others go
// between them. Closed passes within each other may be
// joined to a spiral, whose turns go evenly from one to the next. The tip is the axial lift of the
// cutter over the line, as in finish3.h: no place is too low, whatever the metric says.
//
// Steep walls stand still seen from above: surface steeper than the limit is for levels (waterline.h). What
// stays there is said.
#pragma once

#include "core/strategy/finish3/pass_filter.h"
#include "core/strategy/plan/operation.h"

namespace facetmill {

struct ScallopSettings : OperationCommon {
    enum class From { border, curve, place };
    enum class Pattern { zigzag, oneway };

    ScallopSettings() { name = "Constant scallop"; }
    NumberOrWord stepover{0, "adaptive"}; ///< over the surface, mm
    From from = From::border;
    std::string curve;                    ///< name of a boundary, with From::curve; empty: the border
    bool open = false;                    ///< the curve's last corner is not joined to the first
    std::array<double, 3> place{0, 0, 0}; ///< on the part, mm
    bool spiral = false;                  ///< closed passes that lie within each other are joined to one
    double slope_limit = radians(70);     ///< from level
    Pattern pattern = Pattern::zigzag;
    NumberOrWord chord_tolerance{0, "auto"}; ///< mm; auto: see chord_budget
    double holder_clearance = 0;             ///< mm, kept between shank or holder and the part
    double tilt_limit = 0; ///< largest inclination of the axis where shank or holder would touch, radians
    bool rest_only = false;
};

const ParameterTable<ScallopSettings>& scallop_parameters();

class Scallop : public OperationWith<ScallopSettings, scallop_parameters> {
public:
    using OperationWith::OperationWith;

    std::string_view kind() const override { return "scallop"; }
    std::unique_ptr<Operation> clone() const override { return std::make_unique<Scallop>(settings_); }
    bool keeps_axis() const override { return settings_.tilt_limit == 0; }
    bool reads_stock() const override { return true; }
    std::vector<std::string> curve_keys() const override { return {"curve"}; }
    double holder_clearance() const override { return settings_.holder_clearance; }

    /// Throws Error(empty_result) when nothing of the part is as level as asked for, or can be cut;
    /// Error(out_of_range) when the curve lies off what is cut, when the tessellation tolerances leave
    /// nothing of the tolerance or the cutter is impossible, Error(limit_exceeded) for a part that is too
    /// large for its tool or tolerance.
    StrategyResult plan(const PlanContext& context, const Progress& progress) const override;
};

/// The passes of such a plan as a part of another operation's, which asks itself what stays uncut. Throws
/// what Scallop::plan does.
PlannedPasses scallop_passes(const ScallopSettings& settings, const PlanContext& context,
                             const Progress& progress);

} // namespace facetmill
