// Finishing on a lathe-mill (Jasra 3.2, 3.4): a radial cutter follows the part along a helix, rings or
// lengthwise lines. See lathe.h for the frame and the papers' formulas, lathe_line.h for the motion between
// places, lathe_feed.h for the side feed.
//
// As for three axes (finish3.h), of the tolerance the part's tessellation tolerances are taken off, and the
// inner one is kept off the part.
#pragma once

#include "core/strategy/lathe/lathe.h"

namespace facetmill {

struct LatheFinishSettings : LatheCommon {
    LatheFinishSettings() { name = "LatheFinish"; }
};

const ParameterTable<LatheFinishSettings>& lathe_finish_parameters();

class LatheFinish : public TurningOperation<LatheFinishSettings, lathe_finish_parameters> {
public:
    using TurningOperation::TurningOperation;

    std::string_view kind() const override { return "lathe_finish"; }
    std::unique_ptr<Operation> clone() const override { return std::make_unique<LatheFinish>(settings_); }

    /// A pass per turn (ring, line); each begins where the one before ended. Throws Error(out_of_range) for
    /// an axis that misses the part and settings that leave nothing, Error(empty_result) where nothing faces
    /// outward or holds the tool, Error(limit_exceeded) for more than 40 million places. Cancelled within
    /// 100 ms.
    StrategyResult plan(const PlanContext& context, const Progress& progress) const override;
};

} // namespace facetmill
