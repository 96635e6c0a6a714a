// What of a part is seen from above, in connected pieces: for passes that follow the surface from border to
// border, which have to know where it ends.
#pragma once

#include "core/strategy/five_axis/part_sides.h"

#include <span>

namespace facetmill {

/// A piece of a mesh by itself. `normals`, `curvatures`: of the mesh's vertices; normals count where the
/// mesh has no edge.
PartPiece side_piece(const Mesh& mesh, std::span<const Index> facets, const std::vector<Vec3>& normals,
                     const std::vector<VertexCurvature>& curvatures, const Progress& progress);

/// Pieces of the part that face up, with the settings' own lead limits. `top_only` stays.
PartSides find_tops(const PlanContext& context, const Finish5Settings& settings, const Progress& progress);

} // namespace facetmill
