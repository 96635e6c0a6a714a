// From a part and a lead limit to rework regions: the assumed previous path, its screening, and the regions
// of the uncut places with their names, tools and reasons.
#pragma once

#include "core/strategy/global_local/global_local.h"

#include <memory>
#include <span>
#include <string>
#include <vector>

namespace facetmill {

/// Distance of the assumed path's trajectories, which regions are as exact as, mm. `radius`: the main
/// cutter's.
double trajectory_spacing(const Box3& part, double radius);

/// The assumed previous path over the context's part. With the direction auto: along X or Y, whichever the
/// estimate of main and rework time (tool_advice.h) prefers. A flat end's strips are wide where the part is
/// flat or hollow across the travel, so that need not be the direction in which the surface turns least.
/// Throws what FiveAxisField throws.
std::shared_ptr<const RegionSource>
region_source(const PlanContext& context, const GlobalLocalSettings& settings, const Progress& progress);

struct FoundRegions {
    std::vector<BoundaryPair> pairs;
    ReworkRegions regions;
};

/// Regions of a source by the settings' lead limit, offset, directions and edits, with their names, tools and
/// reasons; `further`: more uncut places. Fast enough for a dialog. Throws Error(out_of_range) for a lead
/// limit above the assumed one, an offset larger than the part, a view along the machining direction.
FoundRegions find_regions(const RegionSource& source, const GlobalLocalSettings& settings, LengthUnit unit,
                          std::span<const UncutPlace> further, const Progress& progress);

/// The travel of the rework path, radians from X; `main`: that of the main path, which "auto" takes.
double machining_angle(const NumberOrWord& asked, double main);

/// "12.5°".
std::string angle_text(double radians);

} // namespace facetmill
