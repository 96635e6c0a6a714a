#include "core/strategy/cleanup/valley.h"

#include "core/strategy/cleanup/pencil_probe.h"
#include "core/strategy/cleanup/rest_samples.h"
#include "core/strategy/cleanup/valley_nodes.h"
#include "core/strategy/cleanup/valley_runs.h"
#include "core/strategy/cleanup/valley_scale.h"
#include "core/strategy/surface/point_grid.h"

namespace facetmill {

void own_tips(Valleys& valleys) {
    PointGrid tips(2 * valleys.step);
    std::vector<int> owner;
    for (std::size_t c = 0; c < valleys.curves.size(); ++c)
        for (const PencilPoint& p : valleys.curves[c].points) {
            tips.add(p.tip);
            owner.push_back(int(c));
        }
    for (Valleys::Tip& t : valleys.tips) {
        t.curve = -1;
        double least = valleys.step;
        tips.near(t.tip, valleys.step, [&](std::size_t i) {
            if (const double d = (tips.points()[i] - t.tip).norm(); d < least) {
                least = d;
                t.curve = owner[i];
            }
        });
    }
}

Valleys find_valleys(const ValleyInput& input, const Progress& progress) {
    Valleys result;
    result.step = ValleyScale(input).step;
    result.samples =
        rest_samples(input, progress.part(0, 0.5, "Looking where the previous cutter left something"));
    const auto seeds = pencil_seeds(input, result.samples, progress.part(0.5, 0.75));
    const auto traced = trace_valleys(input, seeds, progress.part(0.75, 0.95, "Following valleys"));
    const Progress measuring = progress.part(0.95, 1);
    for (const TracedValley& t : traced)
        for (const PencilPoint& p : t.curve.points)
            result.tips.push_back({p.tip, -1});
    std::vector<std::array<bool, 2>> open;
    for (ValleyRun& run : valley_runs(input, traced, measuring)) {
        open.push_back(run.open);
        result.curves.push_back(std::move(run.curve));
    }
    own_tips(result);
    join_valleys(input, open, result);
    measuring.set(1);
    return result;
}

} // namespace facetmill
