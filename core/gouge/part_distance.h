// How far a point is from the facets of a contact index, without another tree over them.
#pragma once

#include "core/gouge/contact_index.h"

namespace facetmill {

/// Distance of p from the nearest point of the mesh, mm, part coordinates; `most` where that is farther, or
/// where the mesh has no facet. Any thread may ask.
double part_distance(const ContactIndex& index, const Vec3& p, double most = infinity);

} // namespace facetmill
