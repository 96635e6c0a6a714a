// Smooth ways into passes of clean-up and out of them. Millimetres, part coordinates.
#pragma once

#include "core/strategy/cleanup/strip_passes.h"

namespace facetmill {

/// An arc that leaves along the pass and turns upwards; where the part is in its way, out along the vector
/// given for that end; neither where both meet the part. The pass has two points or more.
void add_leads(const StripCutting& with, Pass& pass, const Vec3& up_front, const Vec3& up_back);

} // namespace facetmill
