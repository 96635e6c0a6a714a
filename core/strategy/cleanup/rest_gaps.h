// How much a cutter leaves at the corners of facets, and by which valley. Millimetres, part coordinates.
#pragma once

#include "core/strategy/cleanup/rest_facets.h"

namespace facetmill {

struct RestGaps {
    std::vector<double> gap; ///< what is left at each point; 0 where none was asked for
    std::vector<int> curve;  ///< the valley it belongs to; -1: none comes near
};

RestGaps measure_gaps(const ValleyInput& input, const Valleys& valleys, const RestFacets& rest,
                      const Progress& progress);

/// Square of the distance from the nearest centre of a curve.
double square_from_centers(const Vec3& p, const ValleyCurve& curve);

} // namespace facetmill
