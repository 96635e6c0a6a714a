// What global-local CM2 finds beside its main path: the assumed previous path, the regions found, and what
// the rework tool does in them.
#pragma once

#include "core/strategy/global_local/assumed_path.h"
#include "core/strategy/plan/operation.h"
#include "core/strategy/surface/region_field.h"

#include <memory>
#include <vector>

namespace facetmill {

/// The part of finding regions that costs time: made once for a part, a tool and a travel, it serves every
/// lead limit and offset.
struct RegionSource {
    MeshPtr part;
    std::shared_ptr<const MeshGeometry> geometry;
    std::shared_ptr<const std::vector<VertexCurvature>> curvatures;
    AssumedPath assumed;
};

struct ReworkPlan {
    std::shared_ptr<const RegionSource> source;
    std::vector<BoundaryPair> pairs;
    ReworkRegions regions;
    /// Places of the part that the main path left although its lead would do there; they are in the regions.
    std::vector<UncutPlace> left_by_main;
    Tool tool;                 ///< the rework path's
    bool three_axis = true;    ///< every axis of the rework path is +Z
    StrategyResult path;       ///< no passes: none was asked for, or nothing is left to rework
    double part_area = 0;      ///< the surface that a tool can come to, mm^2
    double remaining_area = 0; ///< the share of it that neither path clears, mm^2
};

} // namespace facetmill
