// Roughing on a lathe-mill (Jasra 3.3): the path of finishing over the part grown by an allowance, cut from
// the stock's outside inward in passes of a depth of cut.
//
// Jasra compares, at every point of the path, the depth of the pass (U_selected) with the depth at which the
// part is touched (U_file) and keeps the outer one. So do we; U_file is the lift with the finishing allowance
// kept along the surface's normals, where he keeps it along the radius, so that steep places keep no less.
// Where the tool would come no deeper than the raw material, or than the pass before, it cuts nothing: that
// is left out, and the passes join around it. Jasra knows round stock only; here the stock is what the
// project says, and the same lift over its facets says where it stands.
//
// Every pass that starts in the material comes down on a ramp: a turn in place before its first (lengthwise:
// the first line there and back).
#pragma once

#include "core/strategy/lathe/lathe.h"

namespace facetmill {

struct LatheRoughSettings : LatheCommon {
    LatheRoughSettings() {
        name = "LatheRough";
        tolerance = 0.5;
    }
    double depth_of_cut = 2;          ///< mm
    double finishing_allowance = 0.5; ///< mm, beside `allowance`
};

const ParameterTable<LatheRoughSettings>& lathe_rough_parameters();

class LatheRough : public TurningOperation<LatheRoughSettings, lathe_rough_parameters> {
public:
    using TurningOperation::TurningOperation;

    std::string_view kind() const override { return "lathe_rough"; }
    Purpose purpose() const override { return Purpose::roughing; }
    std::unique_ptr<Operation> clone() const override { return std::make_unique<LatheRough>(settings_); }
    double left_on_purpose() const override { return settings_.allowance + settings_.finishing_allowance; }

    /// `layers` are the passes' tip distances u from the axis, from outside. Throws what LatheFinish does,
    /// and Error(empty_result) where nothing of the stock stands above part and allowance.
    StrategyResult plan(const PlanContext& context, const Progress& progress) const override;
};

} // namespace facetmill
