// Along a curve: the cutter follows a curve that is drawn on the part, or the border of a boundary, seen from
// above. For engraving, on the surface or so much below it, and for trimming, beside the curve. An upright
// tool, any generalized cutter.
//
// The tip runs over the curve, or at a distance to the left or the right of it (curves_beside), at the height
// at which the cutter touches the part there (curve_job.h); less the depth that is asked for. Where it passes
// the part by it is as low as anything that the part asks for. Several cuts follow one another, from above,
// each as deep below the one before as is asked for.
#pragma once

#include "core/strategy/curves/curve_job.h"

namespace facetmill {

struct AlongCurveSettings : CurveCommon {
    enum class Side { on, left, right };

    AlongCurveSettings() { name = "Along a curve"; }
    std::string curve;              ///< name of a boundary; empty: the outline of what is cut
    bool open = false;              ///< the curve's last corner is not joined to the first
    Side side = Side::on;           ///< seen along the curve; closed ones run counter-clockwise
    NumberOrWord offset{0, "auto"}; ///< mm to that side; auto: the cutter's radius and the allowance
    double depth = 0;               ///< mm below the surface
    long cuts = 1;
    double cut_depth = 1; ///< mm between them
};

const ParameterTable<AlongCurveSettings>& along_curve_parameters();

class AlongCurve : public OperationWith<AlongCurveSettings, along_curve_parameters> {
public:
    using OperationWith::OperationWith;

    std::string_view kind() const override { return "along_curve"; }
    std::unique_ptr<Operation> clone() const override { return std::make_unique<AlongCurve>(settings_); }
    bool keeps_axis() const override { return settings_.tilt_limit == 0; }
    bool reads_stock() const override { return true; }
    std::vector<std::string> curve_keys() const override { return {"curve"}; }
    double holder_clearance() const override { return settings_.holder_clearance; }

    /// Throws Error(out_of_range) where all of the curve lies off the part, also for a tilt limit with a
    /// depth, Error(empty_result) where nothing runs so far beside it, and what finish3 does of part, tool
    /// and tolerance.
    StrategyResult plan(const PlanContext& context, const Progress& progress) const override;
};

/// The curves that an operation follows: those of PlanContext::curves[i], opened where they are to be, or the
/// outline of the part where none is named.
std::vector<PlanCurve> followed_curves(const PlanContext& context, std::size_t i, bool open,
                                       const Progress& progress);

} // namespace facetmill
