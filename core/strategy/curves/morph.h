// Morph: passes that go over from one curve to another, along the way the part flows: blades from edge to
// edge, channels from wall to wall. An upright tool, any generalized cutter.
//
// Seen from above a pass is a blend of the two curves, place by place at the same share of their lengths, so
// passes lie close together where the curves are near each other and far apart where they are not. What is
// cut is what of the part lies between the curves. The passes are as close as the tolerance asks where the
// strip is widest; where it is narrow every second, third ... of them is left out (line_family.h).
//
// Curves are those of boundaries. With none named the outline of what is cut is divided where it reaches
// farthest in the direction of travel, either way, and its halves are taken.
#pragma once

#include "core/strategy/curves/curve_job.h"

namespace facetmill {

struct MorphSettings : CurveCommon {
    MorphSettings() { name = "Morph"; }
    std::string first_curve, second_curve; ///< names of boundaries; both empty: halves of the outline
    bool open = true;                      ///< drawn curves end at their last corners
};

const ParameterTable<MorphSettings>& morph_parameters();

class Morph : public OperationWith<MorphSettings, morph_parameters> {
public:
    using OperationWith::OperationWith;

    std::string_view kind() const override { return "morph"; }
    std::unique_ptr<Operation> clone() const override { return std::make_unique<Morph>(settings_); }
    bool keeps_axis() const override { return settings_.tilt_limit == 0; }
    bool reads_stock() const override { return true; }
    std::vector<std::string> curve_keys() const override { return {"first_curve", "second_curve"}; }
    double holder_clearance() const override { return settings_.holder_clearance; }

    /// Throws Error(missing_reference) where only one curve is named, Error(out_of_range) where the two cross
    /// or their blend folds over, with the place, Error(empty_result) where nothing of the part lies between
    /// them, and what finish3 does of part, tool and tolerance.
    StrategyResult plan(const PlanContext& context, const Progress& progress) const override;
};

} // namespace facetmill
