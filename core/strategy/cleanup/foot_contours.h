// Passes along the foot of steep walls, with the tip as low as it may be. What the previous cutter left there
// is a fillet no higher than its radius: one contour cuts it, where lines over the strip would go up and down
// the wall beside each other, each down to a place or two. Millimetres, part coordinates.
#pragma once

#include "core/strategy/cleanup/cleanup_job.h"
#include "core/strategy/cleanup/left_strip.h"
#include "core/strategy/surface/point_grid.h"
#include "core/strategy/waterline/contour_passes.h"

#include <vector>

namespace facetmill {

class FootContours {
public:
    /// The job has to live as long as this.
    FootContours(const CleanupJob& job, const Progress& progress);

    /// The contours of the lowest height that the tip may have, where the cutter touches beside the strip.
    /// None where the strip is so shallow that its upper border would keep more than the tolerance, or where
    /// no contour comes by. Any thread may ask.
    std::vector<Pass> passes(const LeftStrip& strip, const Progress& progress) const;

private:
    bool is_cut_by_one_level(const Mesh& strip) const;
    std::vector<Pass> beside(const Pass& pass, const PointGrid& samples) const;

    const CleanupJob& job_;
    double lowest_;
    Interval slopes_;
    TouchTeller tell_;
    SlopeSteps steps_;
    ContourPasses maker_;
};

} // namespace facetmill
