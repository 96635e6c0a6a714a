// How large the surface of a mesh is.
#pragma once

#include "core/mesh/mesh.h"

namespace facetmill {

/// The area of all facets, whichever way they face, in the square of the mesh's unit.
inline double mesh_area(const Mesh& mesh) {
    double sum = 0;
    for (std::size_t f = 0; f < mesh.facet_count(); ++f)
        sum += 0.5 * mesh.facet_cross(f).norm();
    return sum;
}

} // namespace facetmill
