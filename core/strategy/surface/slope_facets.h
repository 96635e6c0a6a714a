// How steep the facets of a part are as an upright tool comes to them, and the pieces of its surface between
// two slopes. Millimetres, radians from level.
#pragma once

#include "core/strategy/plan/operation.h"
#include "core/strategy/surface/contact_domain.h"

#include <optional>
#include <vector>

namespace facetmill {

/// Slopes that an operation cuts by its settings, radians: what is steeper or shallower it leaves to others.
/// None: it has no such limits.
std::optional<Interval> slope_limits_of(const Operation& operation);

/// The slope of each facet: 0 a floor, pi/2 a wall, more for what faces down; infinity without area. `turn`
/// turns the mesh so that the tool is upright. `as_wound`: facets face as they are wound; else of a sheet the
/// upper side counts.
std::vector<double> facet_slopes(const Mesh& mesh, bool as_wound, const Mat3& turn, const Progress& progress);

/// How many facets of a context's contact index are those of its part, or of the piece that is cut; others
/// follow them.
std::size_t facets_of_part(const PlanContext& context);

/// What of a part faces up (tolerance::vertical_normal_z) with a slope between two.
struct SlopePiece {
    MeshPtr mesh;                            ///< null: nothing
    double area = 0, shallower = 0, all = 0; ///< of it; of what is less steep; of all that faces up; mm^2
    double walls = 0;                        ///< of what faces neither up nor down; not among `all`
};
SlopePiece piece_between(const PlanContext& context, const Interval& slopes, const Progress& progress);

} // namespace facetmill
