// Bands cut out of divided facets where the tolerance is left, and divided where two valleys meet.
// Millimetres, part coordinates.
#pragma once

#include "core/strategy/cleanup/rest_band.h"
#include "core/strategy/cleanup/rest_owners.h"

namespace facetmill {

struct OutlinedBands {
    std::vector<RestBand> bands; ///< one an owner: band, boundaries, area and depth
    std::vector<Vec3> points;    ///< those of the facets and those that cutting made
    /// A point of the band of an owner.
    struct BandPoint {
        Index owner, point;
        auto operator<=>(const BandPoint&) const = default;
    };
    std::vector<BandPoint> band_points; ///< in order, none twice
};

OutlinedBands cut_out(const ValleyInput& input, const Valleys& valleys, RestFacets rest, const RestGaps& gaps,
                      const RestOwners& owners, const Progress& progress);

} // namespace facetmill
