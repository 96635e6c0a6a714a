// How short a path could be at least, whatever directions it takes: bounds that fields of directions are
// judged by before anybody makes one. Every place of the surface takes its share of area over the width of
// the strip that the operation's cutter clears there. Measured are the strips that five-axis finishing itself
// plans with (five_axis/contact_widths), at every place in eight directions, gone both ways.
#pragma once

#include "core/strategy/five_axis/finish5.h"

namespace facetmill {

/// Lengths of passes alone, mm: nothing is counted for links, nor for where passes end.
struct LeastLength {
    double area = 0; ///< surface that some posture serves in some direction, mm^2
    /// Any direction at every place by itself, however it turns from one to the next.
    double free = 0;
    /// The same where a place may be cleared by the best strip within half the cutter's radius.
    double near = 0;
    /// Any direction, but passes that run side by side lean against each other by 15 degrees at most: from a
    /// narrow place along the travel strips get wider at that rate.
    double steady = 0;
    /// One direction for the whole surface, passes as close as every place by itself asks for.
    double straight = 0;
    double straight_direction = 0; ///< its angle from X, radians
    /// Both: one direction, and passes that do not spread faster.
    double straight_steady = 0;
};

/// For the context's tool, from above. Throws what FiveAxisField throws.
LeastLength least_length(const PlanContext& context, const Finish5Settings& settings,
                         const Progress& progress);

} // namespace facetmill
