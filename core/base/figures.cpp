#include "core/base/figures.h"

#include "core/base/units.h"

#include <cmath>

namespace facetmill {

namespace {
constexpr double min_share = 1e-4;
/// In either unit: far below what a machine tells apart.
constexpr double nothing = 5e-6;
} // namespace

std::string percent_text(double share, int digits) {
    if (share > 0 && share < min_share) return "< " + format_number(100 * min_share) + " %";
    return format_number(100 * share, digits) + " %";
}

std::string coordinate_text(double value, int digits) {
    return std::abs(value) < nothing ? "0" : format_number(value, digits);
}

} // namespace facetmill
