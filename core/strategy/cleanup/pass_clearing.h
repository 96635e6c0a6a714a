// Straight moves between the points of clean-up passes, kept clear of the part. Millimetres.
#pragma once

#include "core/strategy/cleanup/strip_passes.h"

#include <vector>

namespace facetmill {

/// How closely moves are looked at.
struct Clearing {
    /// Share of the chord tolerance by which a move may run into the part at a place that is looked at.
    /// These places are so close together that between two of them it runs in by as much again at most: at a
    /// half both together are the chord tolerance.
    double dip_share = 0.5;
};

/// Puts in the points that moves need to stay clear of the part within the chord tolerance: out of the valley
/// where that helps, else up.
void clear_passes(const StripCutting& with, std::vector<Pass>& passes, const Progress& progress,
                  const Clearing& clearing = {});

} // namespace facetmill
