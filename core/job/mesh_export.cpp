#include "core/job/mesh_export.h"

namespace facetmill {

Mesh deviation_mesh(const DeviationSurface& surface) {
    Mesh mesh;
    mesh.vertices.reserve(surface.points.size());
    for (const auto& p : surface.points)
        mesh.vertices.emplace_back(double(p[0]), double(p[1]), double(p[2]));
    mesh.facets.assign(surface.triangles.begin(), surface.triangles.end());
    return mesh;
}

} // namespace facetmill
