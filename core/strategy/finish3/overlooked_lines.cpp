#include "core/strategy/finish3/overlooked_lines.h"

#include <algorithm>

namespace facetmill {

std::vector<PlannedLine> overlooked_lines(std::vector<OverlookedTip> tips, double join) {
    std::sort(tips.begin(), tips.end(), [](const OverlookedTip& a, const OverlookedTip& b) {
        return a.v < b.v || (a.v == b.v && a.u < b.u);
    });
    std::vector<PlannedLine> lines;
    for (std::size_t begin = 0, end = 0; begin < tips.size(); begin = end) {
        double width = tips[begin].width;
        std::vector<Interval> ranges;
        for (; end < tips.size(); ++end) {
            const double narrower = std::min(width, tips[end].width);
            if (end > begin && tips[end].v - tips[begin].v > narrower) break;
            width = narrower;
            ranges.push_back({tips[end].u, tips[end].u});
        }
        const double v = 0.5 * (tips[begin].v + tips[end - 1].v);
        for (const Interval& range : joined(std::move(ranges), join))
            lines.push_back({v, width, width, range});
    }
    return lines;
}

} // namespace facetmill
