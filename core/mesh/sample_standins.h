// The valleys of the samples `pillar` and `gap`, so that what finds valleys can be measured against them.
// Millimetres.
#pragma once

#include "core/base/vec.h"

#include <vector>

namespace facetmill::sample {

/// The middles of both blends between flange and wall, whose radius in sections across X falls from 7.6 to
/// 4.6; from x = 0 on.
std::vector<std::vector<Vec3>> pillar_valleys();
/// The middles of both blends between the gap's floor and its walls, of radius 3.8; from x = 0 on.
std::vector<std::vector<Vec3>> gap_valleys();
/// The middle of the gap's floor, from x = 0 on.
std::vector<Vec3> gap_floor();

} // namespace facetmill::sample
