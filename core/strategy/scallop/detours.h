// Lines that go out of their way: to a spot beside them that they leave too high, and back. Shorter than a
// line of its own there, and nothing that has to be entered. Millimetres.
#pragma once

#include "core/strategy/scallop/left_by_lines.h"

namespace facetmill {

struct SpotsLeft {
    const LeftByLines& left;
    const std::vector<double>& heights; ///< what is left over the places of the field
    double cusp = 0;                    ///< that may be left
    double largest = 0;                 ///< of a spot, mm
};

/// Lengthens `lines`, those that `spots.left` was made of, by the shortest detour to every connected piece of
/// `marks` that one detour takes down to the cusp; those marks are taken away.
void add_detours(const ScallopField& field, const AxialLift& lift, const SpotsLeft& spots,
                 std::vector<FieldContour>& lines, std::vector<char>& marks, const Progress& progress);

} // namespace facetmill
