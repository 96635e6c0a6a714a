// Tools against what holds the part: no body of a tool may come into a fixture, in cuts or in rapids.
#pragma once

#include "core/base/progress.h"
#include "core/verify/removal.h"

#include <span>
#include <vector>

namespace facetmill {

/// The deepest place of a fixture's surface inside a body of the tool, for every motion, body and fixture.
/// Places are asked on its surface, so near to each other that a cutter which comes in by a hundredth of its
/// radius has one inside. `bound` (mm): motions whose axis turns are followed this exactly. A program that
/// begins within a fixture has a collision of its first motion. Programs without fixtures are passed over.
std::vector<Collision> fixture_touches(std::span<const VerifyProgram> programs, double bound,
                                       const Progress& progress);

} // namespace facetmill
