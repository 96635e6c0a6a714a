// To float, never to the wrong side: for bounds that are kept small.
#pragma once

#include <cmath>
#include <limits>

namespace facetmill {

inline float rounded_down(double v) {
    const float f = float(v);
    return double(f) > v ? std::nextafter(f, -std::numeric_limits<float>::infinity()) : f;
}
inline float rounded_up(double v) {
    const float f = float(v);
    return double(f) < v ? std::nextafter(f, std::numeric_limits<float>::infinity()) : f;
}

} // namespace facetmill
