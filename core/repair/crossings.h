// Where a surface runs through itself.
#pragma once

#include "core/base/progress.h"
#include "core/mesh/mesh.h"

#include <utility>
#include <vector>

namespace facetmill {

/// Pairs of facets (the lower number first, ascending) that run through each other (triangles_cross): what
/// only touches, and what lies in one plane, does not. Exact for the vertices as they are. About as long as
/// to read the mesh.
std::vector<std::pair<Index, Index>> crossing_facets(const Mesh& mesh, const Progress& progress);

} // namespace facetmill
