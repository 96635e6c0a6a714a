#include "core/strategy/five_axis/five_axis_record.h"

#include <algorithm>

namespace facetmill {

const FiveAxisRecord::Line& FiveAxisRecord::line_of(std::size_t point) const {
    return *std::upper_bound(lines.begin(), lines.end(), point,
                             [](std::size_t p, const Line& line) { return p < line.end; });
}

Finish5Settings FiveAxisRecord::settings_of(std::size_t piece) const {
    Finish5Settings own = settings;
    own.lead_limits = pieces[piece].lead_limits;
    own.passes = pieces[piece].passes;
    return own;
}

void FiveAxisRecord::append(const FiveAxisRecord& other, int drives) {
    for (const Line& line : other.lines)
        lines.push_back({points.size() + line.begin, points.size() + line.end, drives + line.drive,
                         pieces.size() + line.piece});
    points.insert(points.end(), other.points.begin(), other.points.end());
    pieces.insert(pieces.end(), other.pieces.begin(), other.pieces.end());
}

} // namespace facetmill
