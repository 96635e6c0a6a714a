// The flat face that a facet belongs to.
#pragma once

#include "core/mesh/mesh.h"

namespace facetmill {

/// Facets that lie in the plane of `facet` and hang together with it by their corners, itself among them, in
/// rising order. Corners are level with it within a millionth of the mesh's size, as those of an STL file.
/// A facet without area is alone. Linear in the number of facets.
std::vector<Index> flat_face(const Mesh& mesh, Index facet);
/// Middle of their area; of facets without area the middle of their corners. Millimetres.
Vec3 middle_of(const Mesh& mesh, const std::vector<Index>& facets);

} // namespace facetmill
