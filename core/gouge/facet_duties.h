// Which edges of a mesh a cutter can touch, each given to one facet.
#pragma once

#include "core/base/progress.h"
#include "core/mesh/mesh.h"

#include <cstdint>
#include <vector>

namespace facetmill {

/// The FacetDuty bits of each facet; its edges are numbered by its corners as in the mesh.
///
/// Every edge is owned by one facet, for cutters of any axis. For a cutter that comes down along Z it is left
/// out when it is surely a valley: two facets, on different sides of it seen along Z, the one above the plane
/// of the other. Were q, inside such an edge, the highest contact: the plane of one facet lies below the
/// other facet, so the lift over that plane has a maximum at q too, and the plane's own contact is found
/// there (or at another point as high, and going there the lift never falls). A vertex belongs to its edges,
/// so it is left out when they all are. Open, folded, vertical, coplanar and non-manifold neighbourhoods keep
/// everything; so does a facet that names a vertex twice.
///
/// `is_open`, if wanted, becomes 1 for every vertex whose facets do not surely lie around it as seen along Z:
/// some edge there does not have exactly two facets, one on each side of it.
std::vector<std::uint8_t> facet_duties(const Mesh& mesh, const Progress& progress,
                                       std::vector<std::uint8_t>* is_open = nullptr);

} // namespace facetmill
