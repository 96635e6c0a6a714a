// Pencil: passes along the valleys in which the cutter touches the part at two places at once, and beside
// them. An upright tool, any generalized cutter.
//
// Valleys are those of clean-up (valley.h), asked of the operation's own cutter: where it leaves more than
// the tolerance because no place of it touches the bottom. Seen from above the first pass is the curve on
// which the cutter touches both flanks; further ones run beside it, to either side, as far apart as the
// tolerance allows on the flanks. Their heights are those of curve_job.h, so nothing is gouged where a valley
// is lost.
#pragma once

#include "core/strategy/curves/curve_job.h"

namespace facetmill {

struct PencilSettings : CurveCommon {
    PencilSettings() { name = "Pencil"; }
    long side_passes = 1;                    ///< to each side of the first one
    NumberOrWord smallest_valley{0, "auto"}; ///< mm; auto: the cutter's radius
};

const ParameterTable<PencilSettings>& pencil_parameters();

class Pencil : public OperationWith<PencilSettings, pencil_parameters> {
public:
    using OperationWith::OperationWith;

    std::string_view kind() const override { return "pencil"; }
    std::unique_ptr<Operation> clone() const override { return std::make_unique<Pencil>(settings_); }
    Purpose purpose() const override { return Purpose::cleaning; }
    bool keeps_axis() const override { return settings_.tilt_limit == 0; }
    bool reads_stock() const override { return true; }
    double holder_clearance() const override { return settings_.holder_clearance; }

    /// Throws NothingToDo where the cutter touches no two flanks of a valley that it leaves, and what finish3
    /// does of part, tool and tolerance.
    StrategyResult plan(const PlanContext& context, const Progress& progress) const override;
};

} // namespace facetmill
