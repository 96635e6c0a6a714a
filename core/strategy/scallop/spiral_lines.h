// Closed lines that lie one within the other, joined to spirals: each turn goes evenly from its line to the
// next. Millimetres, seen from above.
#pragma once

#include "core/strategy/scallop/field_contours.h"
#include "core/strategy/scallop/scallop_field.h"

namespace facetmill {

/// `lines`: those of distances first, first + 1, ... in steps, in this order, each with its value. A closed
/// line that has one other next to it on the far side, which has none but it on the near side, is joined to
/// that; the first and the last turn are whole lines. All others stay as they are.
std::vector<FieldContour> spiral_lines(const ScallopField& field, const std::vector<double>& distance,
                                       std::vector<FieldContour> lines, const Progress& progress);

} // namespace facetmill
