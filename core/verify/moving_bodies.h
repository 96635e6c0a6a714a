// The bodies of a tool along the motions of its program, cuts and rapids apart.
#pragma once

#include "core/verify/probes.h"
#include "core/verify/removal.h"

#include <vector>

namespace facetmill {

struct MovingBody {
    Collision::Kind kind; ///< what it is when this body touches what it must not
    MotionProbes probes;
};

/// The cutter at feed, the cutter in rapids, and each section of shank and holder likewise; also where there
/// is no such motion. `bound` as that of MotionProbes.
std::vector<MovingBody> moving_bodies(const VerifyProgram& program, double bound, const Progress& progress);

} // namespace facetmill
