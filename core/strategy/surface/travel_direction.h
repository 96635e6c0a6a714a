// The direction in which parallel passes travel. Radians from X, part coordinates.
#pragma once

#include "core/strategy/plan/operation.h"

namespace facetmill {

/// Direction of travel, as an angle from X: as asked for, or for "auto" along x or y, whichever way normals
/// change less (Lu 3.12 over several drive planes each); where they change alike, along the longer side.
double travel_direction(const NumberOrWord& asked, const PlanContext& context, const Progress& progress);

} // namespace facetmill
