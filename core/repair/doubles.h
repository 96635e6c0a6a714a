// Facets that occur more than once.
#pragma once

#include "core/base/progress.h"
#include "core/mesh/mesh.h"

#include <vector>

namespace facetmill::detail {

/// For each facet whether one before it has the same three vertices, in whichever order.
std::vector<char> doubled_facets(const Mesh& mesh, const Progress& progress);

} // namespace facetmill::detail
