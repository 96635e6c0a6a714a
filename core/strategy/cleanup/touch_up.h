// Last passes of clean-up: over places of the bands on which the passes before leave more than the tolerance
// though the cutter could go deeper. Passes beside a valley are as far from each other as most places along
// them ask for; where the valley turns, forks, ends at a rim or is rough from noise, single places keep more,
// and the border between two bands may be left by both. Millimetres, part coordinates, axis +Z.
//
// The bands are sampled. A sample on which more stays is held against the least that the cutter can leave
// there, over all places it may take near by; where that is less by more than the tolerance, the cutter's
// place there is known, and such places, one after the other along the ridge that they stand on, are a pass.
#pragma once

#include "core/strategy/cleanup/strip_passes.h"

#include <span>

namespace facetmill {

/// A band and what has been cut of it.
struct BandCut {
    const RestBand* band = nullptr;
    StripCut* cut = nullptr; ///< its passes come to stand behind those that it has
};

/// Throws Cancelled within 100 ms. The same bits for every thread count.
void touch_up(const StripCutting& with, std::span<const BandCut> bands, const Progress& progress);

} // namespace facetmill
