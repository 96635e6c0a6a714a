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

/// Passes of a direction as they are planned.
struct PlannedTravel {
    double length = 0; ///< `travel_length`, mm
    double left = 0;   ///< share of the surface that stays uncut where the cutter could go
};

/// Where more than this share of the surface stays that the cutter could reach, the other direction is
/// planned too. What leaves less counts as if it left so much.
inline constexpr double much_left = 0.002;

/// Whether passes of another direction are clearly better. What stays has to be cut by another operation, so
/// as many times as less of it stays, as many times as long the passes may be: three times as long to leave
/// nothing instead of three hundredths, but not to leave thirteen instead of fourteen.
bool is_better(const PlannedTravel& other, const PlannedTravel& than);

} // namespace facetmill
