// A mesh ready to be drawn: points as float around the part's centre, normals split at creases, sharp and
// open edges.
#pragma once

#include "core/base/progress.h"
#include "core/mesh/mesh.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace facetmill {

/// Flat arrays in the graphics card's types. Positions are relative to `centre`, because a float holds a part
/// far from the origin too coarsely.
struct PartDisplay {
    MeshPtr mesh;
    Vec3 centre = Vec3::Zero();
    Box3 box;
    std::vector<float> points;           ///< 3 per display vertex
    std::vector<float> normals;          ///< 3 per display vertex, unit
    std::vector<std::int32_t> triangles; ///< 3 per facet, in the mesh's order
    std::vector<std::int32_t>
        lines;               ///< 2 per edge that is open, non-manifold or sharper than the crease angle
    std::vector<std::int32_t> edges;     ///< 2 per edge, every edge once
    bool has_border = false; ///< some edge has one facet, or more than two: a back side may be seen
};

using PartDisplayPtr = std::shared_ptr<const PartDisplay>;

/// Facets that meet at less than this are shaded as one smooth surface.
inline constexpr double crease_angle = 30.0 * (pi / 180.0);

/// Any mesh, also open, non-manifold or degenerate. Throws Cancelled within 20 ms.
PartDisplayPtr prepare_part_display(MeshPtr mesh, const Progress& progress);

} // namespace facetmill
