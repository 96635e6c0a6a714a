#include "core/cspace/choose.h"

namespace facetmill {

std::vector<ChosenPosture> choose_cm2(std::span<const PassPoint> points, const ChooseInput& input,
                                      const Progress& progress) {
    std::vector<ChosenPosture> chosen;
    chosen.reserve(points.size());
    const CSpaceBuilder& builder = *input.builder;
    const PostureGrid& grid = *builder.input().grid;
    ToolLift::Hint hint;
    for (const PassPoint& point : points) {
        progress.check();
        if (point.kept) {
            chosen.push_back({true, *point.kept});
            continue;
        }
        ChosenPosture choice;
        const auto tried = [&](double lead) {
            const double bottom = builder.bottom(point.frame, lead, 0, hint);
            const double top = builder.top(point.frame, lead, 0, *point.curves);
            if (!(bottom <= top)) return false;
            choice.posture = {lead, 0, bottom};
            choice.free = builder.holds(point.frame, choice.posture);
            return choice.free;
        };
        // Inclined further until it need not be lifted more than the tolerance allows.
        if (!tried(point.cm2_lead))
            for (const double lead : grid.lead)
                if (lead > point.cm2_lead && tried(lead)) break;
        chosen.push_back(choice);
    }
    return chosen;
}

} // namespace facetmill
