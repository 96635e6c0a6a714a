// How fine a tool a verification can judge.
#pragma once

#include "core/verify/verify.h"

namespace facetmill {

/// Whether a cutter of this radius (mm) can be judged on a part with these settings, both as another
/// verification of it left them, about: else places that are near enough to each other would be more than are
/// looked at.
bool can_be_judged(double radius, const DeviationSurface& part, const VerifySettings& used);

} // namespace facetmill
