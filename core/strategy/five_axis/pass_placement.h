// From an estimated pass and the borders of its strip to contact places, each with the strip that its posture
// has to clear.
#pragma once

#include "core/strategy/five_axis/estimated_pass.h"
#include "core/strategy/five_axis/posture_path.h"

#include <vector>

namespace facetmill {

/// The lines of a pass in the order of travel. `border_lo`, `border_hi`: where its strip ends towards smaller
/// and larger v, per bin of u (TiltedStepOver::borders); empty: at the part's border. A line begins and ends
/// beyond the surface by as much as its strip reaches farther than the line does.
std::vector<PlacedLine> place_pass(const FiveAxisField& field, const PassEstimator& passes,
                                   const EstimatedPass& pass, const std::vector<double>& border_lo,
                                   const std::vector<double>& border_hi);

} // namespace facetmill
