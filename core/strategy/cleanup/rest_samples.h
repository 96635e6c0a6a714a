// Where a cutter leaves more than the tolerance, by samples of the surface. Millimetres, part coordinates.
#pragma once

#include "core/strategy/cleanup/valley.h"

namespace facetmill {

/// The samples on which the cutter, let down as near to touching them as the part allows, leaves more than
/// the tolerance.
std::vector<RestSample> rest_samples(const ValleyInput& input, const Progress& progress);

} // namespace facetmill
