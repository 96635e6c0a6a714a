// The valleys of the sample `mould`, so that what finds valleys can be measured against them. Millimetres.
#pragma once

#include "core/base/vec.h"

#include <vector>

namespace facetmill::sample {

/// Between walls and vertical.
inline constexpr double mould_draft = 3.0 * pi / 180;

/// Polylines: the foot of the pocket's walls and the foot of the boss's, each closed (its first point
/// repeated), then the pocket's four corners from the opening down.
std::vector<std::vector<Vec3>> mould_valleys();

} // namespace facetmill::sample
