#include "core/cspace/choose.h"

namespace facetmill {

namespace {

/// Of the room between bottom and top that a posture at the CM2 lead has to have, nothing: any is taken.
bool serves(double bottom, double top) {
    return bottom <= top;
}

} // namespace

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
        const auto tried = [&](double lambda) {
            const double bottom = builder.bottom(point.frame, lambda, 0, hint);
            const double top = builder.top(point.frame, lambda, 0, *point.curves);
            if (!serves(bottom, top)) return false;
            choice.posture = {lambda, 0, bottom};
            const Kinematics* machine = builder.input().kinematics;
            const CutterProfile& cutter = builder.input().lift->cutter();
            choice.free = !machine || machine->reaches(posture_pose(cutter, point.frame, choice.posture));
            return choice.free;
        };
        // Inclined further until it need not be lifted more than the tolerance allows.
        if (!tried(point.cm2_lambda))
            for (const double lambda : grid.lambda)
                if (lambda > point.cm2_lambda && tried(lambda)) break;
        chosen.push_back(choice);
    }
    return chosen;
}

} // namespace facetmill
