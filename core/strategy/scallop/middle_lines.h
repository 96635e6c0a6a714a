// Lines along the middles of marked places of a grid: what is wide becomes a line (Zhang and Suen 1984),
// branches one each, loops closed. Millimetres, seen from above.
#pragma once

#include "core/strategy/scallop/field_contours.h"
#include "core/strategy/scallop/scallop_field.h"

namespace facetmill {

/// `marks`: one for each place of the field, 1 where it is marked; places at the grid's rim count as not
/// marked. Pieces no larger than `spot` get a short line over the highest of them, and lines shorter than
/// half of it are left out. The order is the field's.
std::vector<FieldContour> middle_lines(const ScallopField& field, const std::vector<double>& heights,
                                       std::vector<char> marks, double spot, const Progress& progress);

} // namespace facetmill
