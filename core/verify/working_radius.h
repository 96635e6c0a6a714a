// How wide the working end of a cutter is: what says how far apart places may be that are looked at.
#pragma once

#include "core/cutter/cutter.h"

#include <algorithm>

namespace facetmill {

/// The largest radius at which its profile is no higher than wide. A ball's
/// and a flat end's own radius, near the tip of a taper; of a point a share of its largest.
inline double working_radius(const CutterProfile& cutter) {
    constexpr double point_share = 0.02;
    double lo = 0, hi = cutter.max_radius();
    if (cutter.height_at(hi) <= hi) return hi;
    for (int k = 0; k < 50; ++k) {
        const double mid = 0.5 * (lo + hi);
        (cutter.height_at(mid) <= mid ? lo : hi) = mid;
    }
    return std::max(lo, point_share * cutter.max_radius());
}

} // namespace facetmill
