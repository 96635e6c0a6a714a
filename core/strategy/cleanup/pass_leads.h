// Smooth runs into passes of clean-up and out of them. Millimetres, part coordinates.
#pragma once

#include "core/strategy/cleanup/strip_passes.h"

namespace facetmill {

/// Adds to each end an arc that leaves along the pass and turns upwards. Where the arc meets the part, a
/// straight move along the vector given for that end; where both do, nothing. The pass has two points or
/// more. `front`, `back`: which ends get one.
void add_leads(const StripCutting& with, Pass& pass, const Vec3& up_front, const Vec3& up_back,
               bool front = true, bool back = true);

} // namespace facetmill
