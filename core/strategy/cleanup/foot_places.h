// Places near the bottom of the stock that a large cutter cannot reach because its tip would go below it, and
// a smaller one can. A wall that leans keeps a fillet there as large as the cutter, though no valley is near.
// Millimetres, part coordinates.
#pragma once

#include "core/strategy/cleanup/cleanup_job.h"

#include <vector>

namespace facetmill {

struct FootPlaces {
    std::vector<LeftPlace> places; ///< height: as much as stands there, at most
    double spacing = 0;            ///< of the samples that were asked
};

/// Samples of surface that faces up on which more than the tolerance stands after all operations before,
/// since the previous cutter is kept above `lowest_allowed`, and on which the job's own, kept likewise,
/// leaves no more than the tolerance.
FootPlaces foot_places(const CleanupJob& job, const Progress& progress);

} // namespace facetmill
