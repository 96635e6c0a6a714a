// How far the bands of valleys reach to either side of their centres. Millimetres, part coordinates.
#pragma once

#include "core/strategy/cleanup/band_outlines.h"

namespace facetmill {

/// Fills in length, width, reach and flank of every valley's band.
void measure_reach(OutlinedBands& outlined, const Valleys& valleys, double radius, const Progress& progress);

} // namespace facetmill
