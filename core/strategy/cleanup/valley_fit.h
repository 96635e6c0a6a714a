// The vectors along which a valley's curve is cleaned up, fitted along it (Lu 3.6.2), and where the cutter
// rolls out of the valley, which says nothing of them. Millimetres, part coordinates.
#pragma once

#include "core/strategy/cleanup/valley.h"

#include <cstdint>
#include <vector>

namespace facetmill {

/// Where the cutter rolls out of a valley's end, over its rim or over the part's border, both touched points
/// stay behind and the centre runs back while the tip goes on.
enum class Rolls : std::uint8_t { no, on_one_side, out };

/// For every point of the curve; looks up to `window` along it to either side.
std::vector<Rolls> rolling(const ValleyInput& input, const ValleyCurve& curve, double window);
/// From a to b the centre goes the other way than the tip.
bool runs_back(const PencilPoint& a, const PencilPoint& b);
/// The points' vectors `up`: averages of the flanks' normals up to `window` along the curve to either side,
/// without what the cutter touches where it rolls out. They never point down.
void fit_up(ValleyCurve& curve, double window, const std::vector<Rolls>& rolls);

} // namespace facetmill
