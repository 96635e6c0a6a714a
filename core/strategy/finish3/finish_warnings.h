// What a plan of 3-axis finishing says of what it leaves.
#pragma once

#include "core/strategy/finish3/finish3.h"
#include "core/strategy/finish3/left_stock.h"
#include "core/strategy/finish3/uncut.h"

namespace facetmill {

struct FinishWarnings {
    const Finish3Settings& settings;
    const PlanContext& context;
    const UncutReport& uncut;
    const HeldOut& held;
    const ClearOfStock& beside_stock;
    double cusp_allowed; ///< mm
    int unsatisfied;     ///< lines beside places that no step-over serves
    int lines;           ///< all of them
};

/// Adds the warnings, and sets the largest cusp to what was measured.
void add_finish_warnings(const FinishWarnings& w, StrategyResult& result);

} // namespace facetmill
