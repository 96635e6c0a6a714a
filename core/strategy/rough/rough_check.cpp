#include "core/strategy/rough/rough_check.h"

#include "core/base/parallel.h"

#include <cmath>

namespace facetmill {

RoughDepth deepest_in_allowance(const AxialLift& exact, std::span<const Pass> passes, double spacing,
                                const Progress& progress) {
    return parallel_reduce(
        passes.size(), 1, RoughDepth(), progress,
        [&](std::size_t begin, std::size_t end) {
            RoughDepth worst;
            LiftHint hint;
            const auto look = [&](const std::vector<CutterLocation>& route) {
                for (std::size_t k = 1; k < route.size(); ++k) {
                    progress.check();
                    const Vec3 &a = route[k - 1].tip, &b = route[k].tip;
                    const double n = std::max(1.0, std::ceil((b - a).norm() / spacing));
                    for (double i = 0; i <= n; ++i) {
                        const Vec3 p = a + (i / n) * (b - a);
                        const double depth = exact.tip_z(p.x(), p.y(), hint, p.z() + worst.depth) - p.z();
                        if (depth > worst.depth) worst = {depth, p};
                    }
                }
            };
            for (std::size_t i = begin; i < end; ++i) {
                look(passes[i].entry);
                look(passes[i].cl);
            }
            return worst;
        },
        [](const RoughDepth& a, const RoughDepth& b) { return b.depth > a.depth ? b : a; });
}

ShortTool find_short_tool(const ReachGrid& grid, const RoughHeights& heights, const StockField& field,
                          const StockCutter& cutter, const Progress& progress) {
    const std::vector<double>& layers = heights.layers.heights;
    ShortTool found;
    for (const ReachGrid::HeldUp& p : grid.held_up()) {
        progress.check();
        // The deepest layer that the cutter could be on.
        const auto deeper = std::upper_bound(layers.begin(), layers.end(), p.cutter, std::greater<>());
        if (deeper == layers.begin()) continue;
        const double z = *(deeper - 1);
        const Vec3 tip(p.place.x(), p.place.y(), z);
        if (z >= p.tool || !field.has_work(cutter, tip, tip, heights.expected + field.cell())) continue;
        ++found.places;
        if (p.tool - z > found.lacks) {
            found.lacks = p.tool - z;
            found.at = tip;
        }
    }
    return found;
}

} // namespace facetmill
