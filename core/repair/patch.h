// A patch over a hole: triangles between the corners of a closed curve, divided and faired where it is to go
// on as the surface around it. Internal to the room.
#pragma once

#include "core/base/progress.h"
#include "core/mesh/mesh.h"

#include <functional>
#include <optional>
#include <vector>

namespace facetmill::detail {

/// A closed curve with what lies around it. Numbers count corners from 0.
struct PatchRim {
    std::vector<Vec3> points;
    std::vector<Vec3> normals;   ///< of the facet beyond the side from each corner to the next; unit or zero
    std::vector<double> spacing; ///< mean length of the edges at each corner
    std::vector<std::vector<Vec3>> beyond; ///< at each corner the neighbors that are not on the patch
    /// Whether an edge between two corners that are not neighbors would be one too many.
    std::function<bool(Index, Index)> is_taken;
};

/// Corners first, then the vertices added.
struct Patch {
    std::vector<Vec3> points;
    std::vector<Facet> facets;
    double min_fold =
        0; ///< least angle between a facet and the one beyond the rim's side; 0: it goes straight on
};

/// Triangles between the corners that bend least (Liepa, "Filling holes in meshes", 2003), of long curves by
/// their projection onto the plane that they lie in most. None where there are no such triangles.
std::optional<Patch> flat_patch(const PatchRim& rim, const Progress& progress);

/// Divides the facets until they are as large as those around, and moves the added vertices to where the
/// surface bends most evenly: the least sum of squared Laplacians over them and the rim. Throws
/// Error(limit_exceeded) for millions of facets.
void fair_patch(Patch& patch, const PatchRim& rim, const Progress& progress);

} // namespace facetmill::detail
