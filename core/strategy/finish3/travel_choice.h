// What the passes of another direction of travel would be, without planning them all: a few gaps are planned
// as the whole would be, partial lines included.
#pragma once

#include "core/strategy/finish3/stepover.h"
#include "core/strategy/plan/path.h"

#include <vector>

namespace facetmill {

struct TravelEstimate {
    double length = 0;      ///< of all passes, with what pieces take beside their own length; mm
    double unsatisfied = 0; ///< share of lines beside places that no step serves
    /// Both in one: lines that leave something are worth many that do not.
    double cost() const;
};

TravelEstimate estimate_travel(const StepOverInput& input, const Progress& progress);

/// The same length of passes that are planned.
double travel_length(const std::vector<Pass>& passes, double radius);

} // namespace facetmill
