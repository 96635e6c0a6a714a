// The course of a path over a turning part, as places (theta, y): helix, rings or lengthwise lines, from side
// feeds; where along the axis it begins and ends. Millimetres, radians.
#pragma once

#include "core/strategy/lathe/lathe_feed.h"

#include <functional>

namespace facetmill {

struct LatheRange {
    double from = 0, to = 0;
    double held_back = 0; ///< how much of the part's length chuck and tailstock take, mm
};

/// Where the path runs along the axis: over the part, as far beyond its ends as touching what faces outward
/// there takes, but within `start` and `stop`, and where chuck and tailstock let the tool down to the lowest
/// place that the part has. Throws Error(empty_result) where nothing faces outward, Error(out_of_range) where
/// nothing is left.
LatheRange lathe_range(const LatheCommon& settings, const LatheField& field, const PlanContext& context,
                       const Progress& progress);

struct LatheRoute {
    std::vector<LathePlace> places; ///< in machining order; the path runs straight between them
    std::vector<std::size_t> turns; ///< where each turn (of rings and lines: each of them) begins in `places`
    double feed_min = 0, feed_max = 0;
};

/// `advance`: mm in a turn, or radians between lengthwise lines, at a place. `steps`: of a turn. A helix
/// begins and ends with a full turn in place, so that both ends are cut fully. Throws Error(limit_exceeded).
LatheRoute lathe_route(LatheCommon::Pattern pattern, const LatheRange& range, std::size_t steps,
                       const std::function<double(double)>& advance, const Progress& progress);

/// Even steps of a turn: as asked for, times a whole number where the arcs between them would leave their
/// chords by more than `sagitta` at the radius of the path; then a reader of the program that takes motions
/// for straight is within the tolerance too. Throws Error(out_of_range) unless a number is whole.
std::size_t turn_steps(const NumberOrWord& asked, double radius, double sagitta);

} // namespace facetmill
