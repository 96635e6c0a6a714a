// What a finished plan of roughing is asked: whether a pass comes into the allowance, and where the tool is
// too short. Millimetres.
#pragma once

#include "core/strategy/plan/path.h"
#include "core/strategy/rough/rough_reach.h"
#include "core/strategy/rough/rough_setup.h"

#include <span>
#include <string>

namespace facetmill {

struct RoughDepth {
    double depth = 0; ///< upright
    Vec3 at = Vec3::Zero();
};

/// How deep passes and their entries come into what `exact` keeps, looked at in places `spacing` apart.
RoughDepth deepest_in_allowance(const AxialLift& exact, std::span<const Pass> passes, double spacing,
                                const Progress& progress);

/// Places where the part keeps shank or holder away though the cutter alone could go there, and something is
/// left that it would have cut.
struct ShortTool {
    std::size_t places = 0;
    double lacks = 0; ///< the most length missing
    Vec3 at = Vec3::Zero();
};
ShortTool find_short_tool(const ReachGrid& grid, const RoughHeights& heights, const StockField& field,
                          const StockCutter& cutter, const Progress& progress);

} // namespace facetmill
