// The facets that a cutter may touch which is moved over a band. Millimetres, part coordinates.
#pragma once

#include "core/strategy/cleanup/rest_band.h"
#include "core/strategy/surface/facet_grid.h"

#include <vector>

namespace facetmill {

struct BandFacet {
    Index facet;
    Vec3 middle;
    double size; ///< of the corner that is farthest from the middle
};

/// Those no farther than `within` from a band, or a little farther, in their order. Throws Cancelled within
/// 100 ms; the same for every thread count.
std::vector<BandFacet> facets_beside(const Mesh& mesh, const FacetGrid& grid, const RestBand& band,
                                     double within, const Progress& progress);

} // namespace facetmill
