// The curves along which a cutter touches twice, followed from places on them. Millimetres, part coordinates.
#pragma once

#include "core/strategy/cleanup/pencil_probe.h"

namespace facetmill {

/// Why a curve ends: the cutter no longer touches the same two flanks, another curve runs there, or it has
/// come to the part's border.
enum class CurveEnd { lost, joined, off_part };

struct TracedValley {
    ValleyCurve curve; ///< tips and touches only
    std::array<CurveEnd, 2> ends{CurveEnd::lost, CurveEnd::lost};
};

/// Curves that two seeds are on come once.
std::vector<TracedValley> trace_valleys(const ValleyInput& input, const std::vector<PencilSeed>& seeds,
                                        const Progress& progress);

} // namespace facetmill
