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
    Strip strip;            ///< its band, boundaries, area and length; without a name
    std::size_t places = 0; ///< how many of them are on it
    double height = 0;      ///< the largest of theirs
};

/// `spacing`: of the places; gaps up to it are closed. `offset`: how far strips go beyond them. Strips that
/// measure less than `smallest` across are left out. In the order of the area, the largest first. Throws
/// Error(limit_exceeded), Cancelled within 100 ms. The same bits for every thread count.
std::vector<LeftStrip> left_strips(const PlanContext& context, const std::vector<LeftPlace>& places,
                                   double spacing, double offset, double smallest, const Progress& progress);

/// A vertical tool's passes over a strip; none where it can stand nowhere. Nothing of the whole part is cut
/// into. Throws Cancelled.
StrategyResult cut_left(const PlanContext& context, const OperationCommon& common, bool one_way,
                        const LeftStrip& strip, const Progress& progress);

} // namespace facetmill
