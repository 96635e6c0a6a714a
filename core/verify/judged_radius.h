// How fine a tool a verification can judge.
#pragma once

#include "core/verify/verify.h"

namespace facetmill {

/// The radius (mm) of the narrowest cutter that is judged on a part with these settings, both as another
/// verification of it left them, about: of a narrower one, places that are near enough to each other would
/// be more than are looked at.
double narrowest_judged(const DeviationSurface& part, const VerifySettings& used);

} // namespace facetmill
