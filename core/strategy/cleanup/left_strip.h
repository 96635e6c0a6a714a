// Strips of clean-up around places that operations before left: contact points without a free posture (Lu
// 3.6.1), and material that the verification found. Where such places lie no valley is known, so a strip is
// what lies within a distance of them on the surface (rework_region.h), and it is cut along parallel lines
// whose step-over follows the cusp (finish3.h). Millimetres, part coordinates.
#pragma once

#include "core/strategy/plan/operation.h"
#include "core/strategy/surface/region_field.h"

#include <vector>

namespace facetmill {

struct LeftStrip {
    PartPiece piece;
    Strip strip;            ///< band, boundaries, area and length; without a name
    std::size_t places = 0; ///< number of places on it
    double height = 0;      ///< the most that is left at one of them
};

/// Strips around places that are about `spacing` apart: gaps up to that are closed. They go on for `offset`
/// beyond the places; those that measure less than `smallest` without it are left out. The largest area comes
/// first. Throws Error(limit_exceeded).
std::vector<LeftStrip> left_strips(const PlanContext& context, const std::vector<LeftPlace>& places,
                                   double spacing, double offset, double smallest, const Progress& progress);

/// A vertical tool's passes over a strip, held off the whole part; none where it can stand nowhere.
StrategyResult cut_left(const PlanContext& context, const OperationCommon& common, bool one_way,
                        const LeftStrip& strip, const Progress& progress);

} // namespace facetmill
