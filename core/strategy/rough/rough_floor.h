// Which floors between two layers of roughing are to be cut by a pass of their own. Millimetres.
//
// Beside a floor that is h below the layer over it, the cutter of that layer is what comes nearest: a flat
// end leaves h / cos a on a wall of slope a, where layers leave h cos a once the next one runs along the
// wall. Where the floor goes down on the other side, the next layer may be near enough to
// take it away.
#pragma once

#include "core/strategy/rough/rough_valley.h"
#include "core/strategy/surface/cutter_cover.h"

#include <vector>

namespace facetmill {

class FloorJudge {
public:
    /// Layers at `heights`, which fall, in stock up to `top`; more than `most` is too much, less height
    /// than `least` is nothing.
    FloorJudge(const CutterProfile& profile, const std::vector<double>& heights, double top, double most,
               double least);

    /// What the layers above and below it leave there, along the normal.
    double left(const FloorPlace& place) const;
    bool too_high(const FloorPlace& place) const { return left(place) > max_; }

private:
    CutterCover cover_;
    const std::vector<double>& heights_;
    double top_, max_, min_;
};

/// The stretches of a floor on which the line from a tip to the next is `busy`; gaps up to `gap` are
/// closed. What stands holds the tip at `stand`: each goes on, up to `beyond`, to where that is not higher
/// than where it begins or ends, at the lower end if it can, so that the tool may come in there; over what it
/// goes on, tips are at that height. One that is shorter than `shortest` goes on without that. Steep lines
/// are corners of walls, which layers cut: they are left out.
std::vector<std::vector<Vec3>> floor_stretches(const std::vector<Vec3>& tips, const std::vector<char>& busy,
                                               const std::vector<double>& stand, double gap, double beyond,
                                               double shortest);

} // namespace facetmill
