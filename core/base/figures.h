// Figures as sentences, windows and sheets say them: no more digits than they are worth. Data has all digits.
#pragma once

#include <string>

namespace facetmill {

/// A share of 1 as "12.5 %", "0 %"; "< 0.01 %" where it is hardly anything.
std::string percent_text(double share, int digits = 3);

/// A coordinate or size in a unit of the edge, as format_number does it; "0" for what arithmetic left of
/// nothing.
std::string coordinate_text(double value, int digits = 5);

} // namespace facetmill
