// What of clean-up's passes takes nothing away of the stock as it stands when they are cut. Millimetres, part
// coordinates, upright tools.
#pragma once

#include "core/strategy/finish3/left_out.h"
#include "core/strategy/plan/operation.h"

#include <vector>

namespace facetmill {

/// Leaves out stretches of passes, in the order in which they are cut, along which a cutter of this radius
/// takes away no more than a tenth of `tolerance` anywhere, so that no place keeps more than that for it:
/// what is left out is not taken for cut. Ends go a little farther, and gaps that are shorter than what going
/// out and in again takes are cut.
void leave_out_idle(std::vector<Pass>& passes, const PlanContext& context, double radius, double tolerance,
                    const ContactAt& contact, const Progress& progress);

} // namespace facetmill
