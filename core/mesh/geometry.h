// Local geometry of the mesh: vertex normals (Lu 3.1-3.4, corrected), normals along edges (3.5), principal curvatures and
// directions (Meyer et al.).
#pragma once

#include "core/base/progress.h"
#include "core/mesh/mesh.h"

#include <memory>
#include <vector>

namespace facetmill {

enum class NormalWeight {
    angle, ///< MWA, Lu 3.1: weights are the facet angles at the vertex
    area,  ///< MWAAT, Lu 3.2: weights are the facet areas
};

/// Unit normals per vertex, oriented as the facets are; zero where no facet has area or the sum vanishes. Cancellation
/// per block of 20 000 facets; the same bits for every thread count.
std::vector<Vec3> vertex_normals(const Mesh& mesh, NormalWeight weight, const Progress& progress);

/// Normal at p = v1 + t (v2 - v1), 0 <= t <= 1, on the edge between two vertices with unit normals (Lu 3.5), unit length.
Vec3 edge_normal(const Vec3& n1, const Vec3& n2, double t);

/// Per vertex. Curvatures are 1/mm, positive where the surface curves towards the outside normal's back (a sphere with
/// outward normals has both = +1/R). NaN at boundary, non-manifold and isolated vertices.
struct VertexCurvature {
    double k1 = 0, k2 = 0; ///< k1 >= k2
    Vec3 direction1 = Vec3::Zero(), direction2 = Vec3::Zero();
    double mean = 0, gauss = 0;
    double mixed_area = 0;
};

/// Cotangent operator with mixed Voronoi areas (Meyer et al. 2003; Lu 3.3-3.4 corrected).
std::vector<VertexCurvature> vertex_curvatures(const Mesh& mesh, const std::vector<Vec3>& normals,
                                               const Progress& progress);

struct MeshGeometry {
    std::vector<Vec3> vertex_normals;
    std::vector<Vec3> facet_normals;
};

std::shared_ptr<const MeshGeometry> compute_geometry(const Mesh& mesh, const Progress& progress);

} // namespace facetmill
