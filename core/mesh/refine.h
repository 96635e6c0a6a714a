// Meshes made from another one without changing its surface: facets divided until their edges are short, and
// facets cut where a value given at the vertices crosses zero. Both keep what neighbours share, so that a
// closed mesh stays closed. Millimetres.
//
// New vertices lie on edges, between two vertices that were there before: whatever is known per vertex
// (normals, curvatures, a field) can be carried over in the order of the vertices (`Between`).
#pragma once

#include "core/mesh/geometry.h"
#include "core/mesh/mesh.h"

#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace facetmill {

/// A vertex at (1 - t) a + t b; both have smaller numbers than it.
struct Between {
    Index a = no_index, b = no_index;
    double t = 0;
};

struct DerivedMesh {
    Mesh mesh;
    std::size_t kept = 0;        ///< the first vertices are those of the source
    std::vector<Between> added;  ///< the others, in order
    std::vector<Index> facet_of; ///< facet of the source that each facet is part of
};

/// Halves edges longer than `longest` (> 0) of the facets that are `wanted` (asked with their three corners)
/// until there are none; facets beside them are divided along. Facets that are not wanted and have no such
/// neighbour stay as they are, in their order. Throws Error(limit_exceeded) beyond `max_facets`, Cancelled
/// within 20 000 facets.
DerivedMesh refined(const Mesh& mesh, const std::function<bool(const std::array<Vec3, 3>&)>& wanted,
                    double longest, std::size_t max_facets, const Progress& progress);

/// The facets divided along value = 0, taken as linear over each facet. `value` has one number per vertex,
/// none of them 0. `inside[f]` of the result: value < 0 over facet f. Throws Error(internal) for a wrong
/// number of values.
struct DividedMesh {
    DerivedMesh derived;
    std::vector<bool> inside;
};
DividedMesh divided(const Mesh& mesh, std::span<const double> value);

/// The facets that are asked for with their vertices alone, in their order; `vertex_of`: where each vertex
/// comes from.
struct PartOfMesh {
    Mesh mesh;
    std::vector<Index> vertex_of;
};
PartOfMesh part_of(const Mesh& mesh, std::span<const Index> facets);

/// Facets joined by edges: a number from 0 for each of `facets`, in the order of the first facet of each
/// piece.
std::vector<std::size_t> connected_pieces(const Mesh& mesh, std::span<const Index> facets,
                                          std::size_t& count);

/// Closed curves along the edges that only one facet has, in the direction of the facet's winding. Curves
/// that touch at a vertex are parted there. Facets that no half-edge structure holds (topology.h) count as
/// missing.
std::vector<std::vector<Vec3>> border_loops(const Mesh& mesh);

/// The side of closed curves that is nearest to a place: from its corner `corner` of curve `loop` to the next
/// one. None where there are no curves.
struct LoopSide {
    std::size_t loop = 0, corner = 0;
};
std::optional<LoopSide> nearest_side(const std::vector<std::vector<Vec3>>& loops, const Vec3& p);

/// Curvatures of all vertices of `derived`: those of the source, between them those of the shape operator in
/// between, in the plane of `normals`. Where one of the two is not known, the other.
std::vector<VertexCurvature> carried_curvatures(const DerivedMesh& derived,
                                                std::span<const VertexCurvature> source,
                                                std::span<const Vec3> normals);
/// Unit normals likewise (edge_normal).
std::vector<Vec3> carried_normals(const DerivedMesh& derived, std::span<const Vec3> source);

} // namespace facetmill
