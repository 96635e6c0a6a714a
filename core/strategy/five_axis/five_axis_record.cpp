#include "core/strategy/five_axis/five_axis_record.h"

#include <algorithm>

namespace facetmill {

const FiveAxisRecord::Line& FiveAxisRecord::line_of(std::size_t point) const {
    return *std::upper_bound(lines.begin(), lines.end(), point,
                             [](std::size_t p, const Line& line) { return p < line.end; });
}

} // namespace facetmill
