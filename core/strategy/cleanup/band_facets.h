// The facets that a cutter may touch which is moved over a band. Millimetres, part coordinates.
#pragma once

#include "core/strategy/cleanup/rest_band.h"
#include "core/strategy/surface/facet_grid.h"

#include <vector>

namespace facetmill {

struct BandFacet {
    Index facet;
    Vec3 middle;
    double size; ///< distance of its farthest corner from the middle
};

/// All facets no farther than `within` from a band, and some a little farther, in the mesh's order.
std::vector<BandFacet> facets_beside(const Mesh& mesh, const FacetGrid& grid, const RestBand& band,
                                     double within, const Progress& progress);

} // namespace facetmill
