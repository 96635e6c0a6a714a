// Valleys on a coarse ground: where the cell that holds a cutter up jumps between neighbouring tips, and
// material stays between the two. Millimetres, coordinates of the view.
#pragma once

#include "core/strategy/preview/preview_lines.h"

namespace facetmill {

/// A place where a cutter touches twice.
struct PreviewTouch {
    Vec2 tip;
    Vec2 across;     ///< unit, from one of the touched places to the other
    double half = 0; ///< of their distance seen from above
};
struct PreviewValley {
    std::vector<PreviewTouch> touches; ///< in order along it
};

/// Valleys in which tips leave more than `left`, of those that cut; shorter ones than `shortest` are left
/// out.
std::vector<PreviewValley> preview_valleys(const PreviewField& field, double left, double shortest,
                                           const Progress& progress);

/// The course beside a valley, as far to its left; where `within` it ends where the touched places are nearer
/// than that.
std::vector<PlanLine> valley_lines(const PreviewValley& valley, double left, bool within);

} // namespace facetmill
