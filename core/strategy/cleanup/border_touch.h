// Where a cutter rolls over the border of a sheet instead of touching its surface: there is nothing beyond.
// Millimetres, part coordinates.
#pragma once

#include "core/strategy/surface/facet_grid.h"
#include "core/strategy/surface/up_side.h"

namespace facetmill {

/// True where `touch` lies on an edge that only one facet has, and the cutter's `normal` there (unit, away
/// from the part) is not that of a facet beside the edge, within what noise turns them.
bool rolls_over_border(const Mesh& mesh, const FacetGrid& grid, const UpSide& side, const Vec3& touch,
                       const Vec3& normal);

} // namespace facetmill
