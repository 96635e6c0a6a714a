// How far down upright walls go, seen from above. Millimetres, part coordinates.
#pragma once

#include "core/strategy/surface/facet_grid.h"

namespace facetmill {

/// Upright facets (tolerance::vertical_normal_z) hold no tool up: one that passes beside them goes down as
/// far as they do, and clears them with its side.
class UprightWalls {
public:
    /// `reach`: of the tool's side from its axis.
    UprightWalls(const Mesh& mesh, double reach, const Progress& progress);

    /// The lowest point of walls within reach of an axis; +infinity without any.
    double lowest(const Vec2& axis) const;

private:
    double reach_;
    Mesh walls_;
    std::optional<FacetGrid> grid_;
};

} // namespace facetmill
