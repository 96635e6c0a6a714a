// Round numbers for scales and axes of charts.
#pragma once

#include <vector>

namespace facetmill {

/// 1, 2 or 5 times a power of ten: the least step of which no more than `most` fit into `range`; 1 where the
/// range is not above 0 or not finite.
double round_step(double range, int most);
/// The multiples of round_step from lo to hi, both included.
std::vector<double> round_ticks(double lo, double hi, int most);

} // namespace facetmill
