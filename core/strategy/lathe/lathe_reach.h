// Where on a turning part the cutter cannot go: the promise that nothing stays uncut in silence.
//
// The part's facets are sampled. At every sample the place (theta, y) is taken at which the cutter would
// touch the facet's plane there, and the cutter lowered as far as part, chuck and core radius let it. Where
// it leaves more over the sample, along the facet's normal, than a cusp may, the places of an even grid
// within the cutter's radius, at each of which it is lowered once for all samples, are tried, and then those
// about the one that brings it nearest. Samples that no place serves are put together into regions, by the
// reason:
//
//  - narrow: hollows narrower than the cutter, inner edges, feet of walls. A smaller tool helps.
//  - covered: the part itself lies over the place along the tool's axis: undercuts, bores. Only another axis
//  helps.
//  - shaft: shank or holder meet the part first. A longer tool helps.
//  - core: the core radius holds the tip.
//  - held: chuck or tailstock, with the clearance.
//
// Ends that face along the axis are no part of what turning cuts and are left out, and so is what lies beyond
// a start or stop that the settings name.
//
// Creases. The side feed (lathe_feed.h) comes from the cusps over what the tips touch. In an edge of the part
// that is hollow the cutter rolls from one facet to the other and leaves a fillet, which no tip touches; a
// ball of radius r between planes that turn by delta leaves r (1 / cos(delta / 2) - 1). What two neighbouring
// turns leave there stands on the fillet. So every such edge, and every corner where such edges meet, is
// looked at with two cutters a side feed apart, and limits the feed where both together would be more than
// is allowed.
#pragma once

#include "core/strategy/lathe/lathe_creases.h"

namespace facetmill {

struct LatheReach {
    double area = 0;                      ///< all that was looked at, mm^2
    std::vector<UnreachedRegion> regions; ///< the largest first
    std::vector<FeedLimit> limits;        ///< creases that the feed must pass more slowly
    double crease_cusp = 0; ///< largest height that the feed, before the limits, leaves at a crease
};

/// `allowed`: what may stay above the allowance, mm, > 0. Costs a lift per sample, and where the
/// first place does not serve one for every place of the grid and some 30 per sample.
LatheReach lathe_reach(const LatheCommon& settings, const LatheField& field, const PlanContext& context,
                       const LatheRange& range, double allowed, const ReachFeed& feed,
                       const Progress& progress);

/// One warning for every reason, with area, share, and angle and length of the largest regions.
std::vector<std::string> reach_warnings(const LatheReach& reach, LengthUnit unit);

} // namespace facetmill
