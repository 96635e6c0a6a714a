// Where a surface runs through itself.
#pragma once

#include "core/base/progress.h"
#include "core/mesh/mesh.h"

#include <utility>
#include <vector>

namespace facetmill {

/// Pairs of facets (the lower number first, ascending) that run through each other: a side of one comes
/// through the inside of the other. What only touches, and what lies in one plane, does not. Signs of volumes
/// are taken where their rounding leaves no doubt. About as long as to read the mesh.
std::vector<std::pair<Index, Index>> crossing_facets(const Mesh& mesh, const Progress& progress);

} // namespace facetmill
