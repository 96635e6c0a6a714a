// Passes of clean-up between their points: straight moves that stay clear of the part. Millimetres.
#pragma once

#include "core/strategy/cleanup/strip_passes.h"

#include <vector>

namespace facetmill {

/// Puts in what straight moves need to stay clear of the part within half of the chord tolerance, out of the
/// valley where that helps, else up. Throws Cancelled within 100 ms.
void clear_passes(const StripCutting& with, std::vector<Pass>& passes, const Progress& progress);

} // namespace facetmill
