// Lifts along a valley's fitted vectors, over the facets beside its band that face along them. Millimetres,
// part coordinates.
#pragma once

#include "core/gouge/vector_lift.h"
#include "core/strategy/cleanup/strip_passes.h"

#include <memory>
#include <vector>

namespace facetmill {

/// The lift to use at each point of the curve; points near each other share one, null where no facet faces
/// along the vector.
std::vector<std::shared_ptr<const VectorLift>> lifts_along(const StripCutting& with, const ValleyCurve& curve,
                                                           const RestBand& band, const Progress& progress);

} // namespace facetmill
