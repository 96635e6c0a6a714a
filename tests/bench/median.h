// The middle one of several measurements.
#pragma once

#include <algorithm>
#include <vector>

namespace facetmill::bench {

/// Of an even number the upper of the two in the middle; there is at least one.
inline double median(std::vector<double> values) {
    const auto middle = values.begin() + std::ptrdiff_t(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

} // namespace facetmill::bench
