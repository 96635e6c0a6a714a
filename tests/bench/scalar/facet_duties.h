// Which vertices and edges of a mesh a cutter coming down along Z can touch, each given to one facet.
#pragma once

#include "core/base/progress.h"
#include "core/mesh/mesh.h"

#include <cstdint>
#include <vector>

namespace facetmill::scalar {

/// FacetDuty bits per facet, corners as in the mesh: the edges of core's facet_duties, and the vertices of
/// those edges.
std::vector<std::uint8_t> facet_duties(const Mesh& mesh, const Progress& progress);

} // namespace facetmill::scalar
