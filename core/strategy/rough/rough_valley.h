// Floors of valleys, for roughing. A cutter that touches both sides of a valley comes to its floor only on a
// line, and the layer above is free on a strip about that line that may be narrower than the cells of the
// layers' grid: its nodes are all blocked, and the strip would be passed over. Here the floor itself is
// looked for: along the rows and columns of the grid the lift is lowest somewhere between two nodes, and
// those places, joined from row to row, are the line on which the tip comes lowest.
//
// A hollow edge of the lift where only one side rises, as at the foot of a wall, is followed too: a floor
// between two layers keeps the upper one's height there, and on the wall beside it that is more, along the
// normal, than layers leave on the wall itself. Millimetres.
#pragma once

#include "core/strategy/rough/rough_reach.h"

#include <array>
#include <functional>
#include <vector>

namespace facetmill {

/// The path of the tip along a floor. Between neighbours it is straight, and free but for three quarters
/// of the reach's margin: a quarter where it was looked at, half between.
struct ReachValley {
    std::vector<Vec3> tips;
    std::vector<double> seen;                ///< the lowest node of the grid beside each
    std::vector<char> deep;                  ///< layers leave too much beside it
    std::vector<std::array<Vec2, 2>> beside; ///< the nearest nodes across the valley, no lower than `seen`

    /// True for a tip that stands between two rows of the grid: no node is beside it.
    bool between(std::size_t i) const { return beside[i][0] == beside[i][1]; }
};

/// A floor, and what rises beside it.
struct FloorPlace {
    double z = 0;
    double fall = 0; ///< how steeply the tip goes down on the other side: a tangent; 0 where it does not
    /// How much higher the tip is at a place beside it, and how steeply it rises.
    double rise = 0, slope = 0;
};
/// Whether layers leave too much there.
using FloorTooHigh = std::function<bool(const FloorPlace& place)>;

/// Those whose floors the nodes miss by more than the margin somewhere, and those beside which layers leave
/// too much; nodes not above `low` and floors not below `high` are of no interest. `too_high` is asked from
/// many threads of places up to `reach_up` above the floor.
std::vector<ReachValley> find_valleys(const RoughReach& reach, const ReachGrid& grid, double low, double high,
                                      double reach_up, const FloorTooHigh& too_high,
                                      const Progress& progress);

/// What is free at z round the floors though no node beside it is, as far as the nearest places that the grid
/// sees: its borders, or the floor alone where both are next to it.
std::vector<FreeContour> unseen_channels(const RoughReach& reach, const std::vector<ReachValley>& valleys,
                                         double z, const Progress& progress);

} // namespace facetmill
