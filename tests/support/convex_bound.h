// A bound of convex functions from their values, for searches that may end early.
#pragma once

#include <algorithm>

namespace facetmill::test {

/// What a convex function with these values at a < b < c < d is nowhere below between a and d: beyond two
/// places it lies above the line through them.
template <class Real>
Real no_lower(Real a, Real b, Real c, Real d, Real fa, Real fb, Real fc, Real fd) {
    const Real slope = (fc - fb) / (c - b);
    const Real before = std::min(fb, fb - slope * (b - a)), behind = std::min(fc, fc + slope * (d - c));
    const Real from_left = std::min(fb, fb + (fb - fa) / (b - a) * (c - b)),
               from_right = std::min(fc, fc - (fd - fc) / (d - c) * (c - b));
    return std::min({before, behind, std::max(from_left, from_right)});
}

} // namespace facetmill::test
