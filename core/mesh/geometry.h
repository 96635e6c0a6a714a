// Local geometry of the mesh: vertex normals (Lu 3.1-3.4, corrected), normals along edges (3.5), principal
// curvatures and directions (Meyer et al.).
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

/// Unit normals per vertex, oriented as the facets are; zero where no facet has area or the sum vanishes. A
/// facet that is flatter than the rounding of its corners (tolerance::coordinate_rounding) has no trustworthy
/// normal: it counts only at vertices that have no other.
///
/// Lu's third normal (3.3, 3.4) is not offered: it is the mean-curvature normal, zero on flat and balanced
/// saddle points and turned inside out where the surface is concave. It serves `vertex_curvatures`.
std::vector<Vec3> vertex_normals(const Mesh& mesh, NormalWeight weight, const Progress& progress);

/// Normal at p = v1 + t (v2 - v1), 0 <= t <= 1, on the edge between two vertices with unit normals: Lu 3.5,
/// made unit length. Zero where the two cancel (opposite normals, t = 1/2) or are zero themselves.
Vec3 edge_normal(const Vec3& n1, const Vec3& n2, double t);

/// Per vertex. Curvatures are 1/mm, positive where the surface curves towards the outside normal's back (a
/// sphere with outward normals has both = +1/R). All NaN at boundary, non-manifold and isolated vertices,
/// where facets round the vertex are wound against each other, and where the normal is zero.
struct VertexCurvature {
    double k1 = 0, k2 = 0; ///< k1 >= k2
    Vec3 direction1 = Vec3::Zero(),
         direction2 = Vec3::Zero(); ///< unit, perpendicular; largest component positive
    double mean = 0, gauss = 0;
    double mixed_area = 0; ///< mm^2; over a closed mesh they add up to its area
};

/// `mean`, `gauss` and `mixed_area` by Meyer et al. 2003: the cotangent operator (Lu 3.3) divided by the
/// mixed area (Voronoi area in acute facets; of an obtuse one half its area at the obtuse corner, a quarter
/// at the others; Lu 3.4 prints the whole facet for acute ones, wrong) and the angle defect. `mean` is the
/// operator's component along `normals`.
///
/// `k1`, `k2` and the directions come from a least-squares height function over the vertices up to two edges
/// away, in the frame of the vertex normal, with its slope left free: cubic from 12 vertices on, quadratic
/// from 7, purely quadratic below. Meyer's own fit of normal curvatures along edges is not used: an error of
/// the vertex normal enters it undamped, so that it does not converge on uneven meshes, and its weights may
/// be negative; nor do his k1, k2 from mean and gauss converge there. So (k1 + k2) / 2 is not exactly `mean`.
/// At umbilic points the directions mean nothing; where the fit has no unique answer k1 and k2 follow from
/// mean and gauss, and the directions are zero.
std::vector<VertexCurvature> vertex_curvatures(const Mesh& mesh, const std::vector<Vec3>& normals,
                                               const Progress& progress);

struct MeshGeometry {
    std::vector<Vec3> vertex_normals; ///< by angle
    std::vector<Vec3> facet_normals;  ///< by the winding; zero for degenerate facets
};

/// Cancellation as for `vertex_normals`.
std::shared_ptr<const MeshGeometry> compute_geometry(const Mesh& mesh, const Progress& progress);

} // namespace facetmill
