// Vertices that are left over when facets go.
#pragma once

#include "core/base/progress.h"
#include "core/mesh/mesh.h"

namespace facetmill {

/// Leaves out the vertices that no facet names; the order of the rest stays.
void drop_unused_vertices(Mesh& mesh, const Progress& progress);

} // namespace facetmill
