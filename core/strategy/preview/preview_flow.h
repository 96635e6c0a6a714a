// Lines that flow over the ground from one of its edges to the other, as passes of finishing with five axes
// may (five_axis/flow_map.h). Millimetres, coordinates of the view.
#pragma once

#include "core/strategy/preview/preview_lines.h"

namespace facetmill {

/// As far apart as the tolerance allows where they are farthest from each other. Throws
/// Error(limit_exceeded) for more than may be drawn. `without`: facets of the part that others cut; empty:
/// none.
std::vector<PlanLine> flow_lines(const PreviewField& field, const PreviewRequest& request,
                                 const PreviewStep& step, const std::vector<char>& without,
                                 const Progress& progress);

} // namespace facetmill
