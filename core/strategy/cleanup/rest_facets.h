// The part's facets, divided finely where a cutter leaves something. Millimetres, part coordinates.
#pragma once

#include "core/strategy/cleanup/valley.h"

namespace facetmill {

/// A piece of a facet of the part.
struct RestFacet {
    std::array<Index, 3> corner; ///< indices in RestFacets::points
    Index facet;
};

struct RestFacets {
    std::vector<Vec3> points;      ///< the part's vertices, then the points that dividing made
    std::vector<RestFacet> facets; ///< where material may be left; no cracks between them
};

RestFacets divided_near_rest(const ValleyInput& input, const std::vector<RestSample>& samples,
                             const Progress& progress);

} // namespace facetmill
