// The vectors along which a valley is cleaned up, fitted along its curve (Lu 3.6.2), and where the cutter
// rolls out of the valley: what it touches there says nothing about them. Millimetres, part coordinates.
#pragma once

#include "core/strategy/cleanup/valley.h"

#include <cstdint>
#include <vector>

namespace facetmill {

/// Where the cutter rolls out of a valley's end, over its rim or over the part's border, both touched points
/// stay behind and the centre runs back while the tip goes on.
enum class Rolls : std::uint8_t { no, on_one_side, out };

/// How the cutter rolls at every point of the curve, seen from up to `window` along it to either side.
std::vector<Rolls> rolling(const ValleyInput& input, const ValleyCurve& curve, double window);
/// True where the centre moves from a to b against the movement of the tip.
bool runs_back(const PencilPoint& a, const PencilPoint& b);
/// Sets the points' vectors `up` to averages of the flanks' normals up to `window` along the curve to either
/// side, without those where the cutter rolls out. They never point down.
void fit_up(ValleyCurve& curve, double window, const std::vector<Rolls>& rolls);

} // namespace facetmill
