#include "core/strategy/cleanup/valley.h"

#include "core/strategy/cleanup/pencil_probe.h"
#include "core/strategy/cleanup/rest_samples.h"
#include "core/strategy/cleanup/valley_nodes.h"
#include "core/strategy/cleanup/valley_scale.h"
#include "core/strategy/surface/point_grid.h"

namespace facetmill {

namespace {

/// All tips of traced curves, with the run that has one nearest to them, if one is near.
std::vector<Valleys::Tip> owned_tips(const std::vector<TracedValley>& traced,
                                     const std::vector<ValleyRun>& runs, double step) {
    PointGrid tips(2 * step);
    std::vector<int> owner;
    for (std::size_t r = 0; r < runs.size(); ++r)
        for (const PencilPoint& p : runs[r].curve.points) {
            tips.add(p.tip);
            owner.push_back(int(r));
        }
    std::vector<Valleys::Tip> result;
    for (const TracedValley& t : traced)
        for (const PencilPoint& p : t.curve.points) {
            int curve = -1;
            double least = step;
            tips.near(p.tip, step, [&](std::size_t i) {
                const double d = (tips.points()[i] - p.tip).norm();
                if (d < least) {
                    least = d;
                    curve = owner[i];
                }
            });
            result.push_back({p.tip, curve});
        }
    return result;
}

} // namespace

Valleys find_valleys(const ValleyInput& input, const Progress& progress) {
    Valleys result;
    result.step = ValleyScale(input).step;
    result.samples =
        rest_samples(input, progress.part(0, 0.5, "Looking where the previous cutter left something"));
    const auto seeds = pencil_seeds(input, result.samples, progress.part(0.5, 0.75));
    const auto traced = trace_valleys(input, seeds, progress.part(0.75, 0.95, "Following valleys"));
    const Progress measuring = progress.part(0.95, 1);
    std::vector<ValleyRun> runs = valley_runs(input, traced, measuring);
    result.tips = owned_tips(traced, runs, result.step);
    join_valleys(input, std::move(runs), result);
    measuring.set(1);
    return result;
}

} // namespace facetmill
