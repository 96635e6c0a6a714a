// Lines through places that a plan passes by. The gap between two lines is judged by rows between them, and a
// side that is nearly upright and nearly along the passes may lie between two rows wherever they are; what
// looks at the whole surface finds it (uncut.h). Millimetres.
#pragma once

#include "core/strategy/finish3/partial_lines.h"

#include <vector>

namespace facetmill {

/// A tip that would cut what is passed by, and how far beside it, across the lines, another one still does.
struct OverlookedTip {
    double u = 0, v = 0, width = 0;
};

/// Partial lines such that each of the tips lies no farther than half of its width beside one of them, and
/// the line goes past it; gaps in a line that are no longer than `join` are passed through. In the order of
/// their planes. Widths are above 0.
std::vector<PlannedLine> overlooked_lines(std::vector<OverlookedTip> tips, double join);

} // namespace facetmill
