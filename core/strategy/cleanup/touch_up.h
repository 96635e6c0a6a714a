// Last passes of clean-up: over places of the bands on which the passes before leave more than the tolerance
// though the cutter could go deeper. Passes beside a valley are as far from each other as most places along
// them ask for; where the valley turns, forks, ends at a rim or is rough from noise, single places keep
// more, and the border between two bands may be left by both. Millimetres, part coordinates, axis +Z.
//
// The bands are sampled. A sample on which more stays is held against the least that the cutter can leave
// there, over all places it may take near by; where that is less by more than the tolerance, the cutter's
// place there is known, and such places, one after the other along the ridge that they stand on, are a pass.
#pragma once

#include "core/strategy/cleanup/strip_passes.h"

#include <span>

namespace facetmill {

/// How closely bands are looked at.
struct TouchUpSampling {
    /// Samples are this share of half the distance apart that two passes over a plane have: so several of
    /// them lie on every ridge that is too high.
    double sample_share = 0.22;
    /// Passes are taken for single places of the cutter so near to each other that this share of what may be
    /// left stays between two.
    double stand_share = 0.02;
};

/// Passes are added behind those that each band has.
void touch_up(const StripCutting& with, std::span<const BandCut> bands, const Progress& progress,
              const TouchUpSampling& sampling = {});

} // namespace facetmill
