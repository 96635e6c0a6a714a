// An operation as it stands half way: what the tool has left behind is seen by its deviations, what is still
// to come by its path.
#pragma once

#include "core/base/progress.h"
#include "core/verify/verify.h"
#include "viz/path_display.h"

#include <memory>
#include <vector>

namespace facetmill {

struct HalfDone {
    CutterLocation pose;     ///< where the tool stands
    PathSource ahead;        ///< what it has not cut yet
    std::vector<float> done; ///< per sample of the surface: 0 ahead of the tool, 1 well behind it
};

/// At a share of the operation's cuts, 0 to 1. Throws Error(empty_result) where it cuts nothing.
HalfDone half_done(const std::shared_ptr<const OperationResult>& operation, const DeviationSurface& surface,
                   double share, const Progress& progress);

} // namespace facetmill
