// A mesh ready to be drawn: points as float around the part's centre, normals split at creases, sharp and
// open edges.
#pragma once

#include "core/base/progress.h"
#include "core/mesh/mesh.h"
#include "viz/sight_tree.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace facetmill {

/// A coarse copy of a large part, drawn while the view moves.
struct PartPreview {
    std::vector<float> points, normals;  ///< as in PartDisplay
    std::vector<std::int32_t> triangles; ///< empty: the part is small enough to be drawn itself
    std::vector<std::int32_t> merged;    ///< its vertex for every display vertex of the part
};

/// Flat arrays in the graphics card's types. Positions are relative to `centre`, because a float holds a part
/// far from the origin too coarsely.
struct PartDisplay {
    MeshPtr mesh;
    Vec3 center = Vec3::Zero();
    Box3 box;
    std::vector<float> points;           ///< 3 per display vertex
    std::vector<float> normals;          ///< 3 per display vertex, unit
    std::vector<std::int32_t> triangles; ///< 3 per facet, in the mesh's order
    std::vector<std::int32_t>
        lines; ///< 2 per edge that is open, non-manifold or sharper than the crease angle
    std::vector<std::int32_t> edges; ///< 2 per edge, every edge once
    PartPreview preview;
    SightTree sights;        ///< lines of sight on `mesh`, for picking
    bool has_border = false; ///< some edge has one facet, or more than two: a back side may be seen
};

using PartDisplayPtr = std::shared_ptr<const PartDisplay>;

/// Facets that meet at less than this are shaded as one smooth surface.
inline constexpr double crease_angle = 30.0 * (pi / 180.0);

/// Parts of more facets have a preview.
inline constexpr std::size_t largest_part_without_preview = 50'000;

/// Joins the vertices in each cell of a grid of about 100 cells a side, those that face one way (of six) in
/// each cell, so that edges stay edges. About 10 ms per 100 000 facets.
PartPreview make_preview(const PartDisplay& part, const Progress& progress);
/// The same of any surface; `size` is that of its box, with the points around the box's middle. `merged`,
/// unless null, gets the preview's vertex of every vertex.
PartPreview make_preview(const std::vector<float>& points, const std::vector<float>& normals,
                         const std::vector<std::int32_t>& triangles, const Vec3& size,
                         std::vector<std::int32_t>* merged, const Progress& progress);

/// Any mesh, also open, non-manifold or degenerate.
PartDisplayPtr prepare_part_display(MeshPtr mesh, const Progress& progress);

} // namespace facetmill
