// Lines at the feet of walls, moved as near to them as the cutter goes: the field knows a foot to a place of
// its grid. Millimetres, seen from above.
#pragma once

#include "core/strategy/scallop/field_contours.h"
#include "core/strategy/scallop/scallop_field.h"

namespace facetmill {

/// Moves places of a line beside a foot to where the tip begins to rise more steeply than `steepest`
/// (radians), but for what a chord between two of them needs.
void move_to_feet(const ScallopField& field, const AxialLift& lift, double steepest, FieldContour& line,
                  const Progress& progress);

/// Whether a tip between the places of a field and a wall stands at its foot, not above it.
bool stands_at_foot(const ScallopField& field, const Vec3& tip, double steepest);

} // namespace facetmill
