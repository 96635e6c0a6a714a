// Which valley or hollow each facet of a band belongs to. Millimetres.
#pragma once

#include "core/strategy/cleanup/rest_gaps.h"

namespace facetmill {

struct RestOwners {
    std::vector<int> of; ///< per facet: a curve, or behind the curves a hollow; -1: outside all bands
    int count = 0;       ///< curves and hollows
};

RestOwners share_out(double tolerance, std::size_t curves, const RestFacets& rest, const RestGaps& gaps,
                     const Progress& progress);

} // namespace facetmill
