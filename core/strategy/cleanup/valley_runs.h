// The stretches of traced curves along which the cutter leaves more than the tolerance, with centres on the
// part and fitted vectors. Millimetres, part coordinates.
#pragma once

#include "core/strategy/cleanup/valley_trace.h"

namespace facetmill {

struct ValleyRun {
    ValleyCurve curve;
    std::array<bool, 2> open{}; ///< ends at which a third flank stopped the cutter
};

/// In the order of the traced curves; a valley seen twice comes once.
std::vector<ValleyRun> valley_runs(const ValleyInput& input, const std::vector<TracedValley>& traced,
                                   const Progress& progress);

} // namespace facetmill
