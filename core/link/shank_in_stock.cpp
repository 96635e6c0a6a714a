#include "core/link/shank_in_stock.h"

#include "core/strategy/lathe/lathe_field.h"
#include "core/strategy/plan/plan_text.h"
#include "core/strategy/surface/stock_before.h"
#include "core/strategy/tilt/tilted_stock.h"

#include <functional>

namespace facetmill {

namespace {
constexpr double cell_share = 0.25; ///< of the cutter's radius
/// Less than this share of the cuts is not worth a word.
constexpr double min_told_share = 0.005;
/// How deep in, in the cutter's radii, is worth a word.
constexpr double in_share = 0.01;

ShankInStock looked_at(const ToolMotions& motions, double spacing, const Progress& progress,
                       const std::function<bool(const CutterLocation&)>& in_stock) {
    ShankInStock found;
    double since = spacing; // the last look
    bool touches = false;
    for (std::size_t i = 1; i < motions.motions.size(); ++i) {
        if (i % 256 == 0) progress.check();
        const Motion& m = motions.motions[i];
        if (m.kind != MotionKind::cut) continue;
        const double length = (m.to.tip - motions.motions[i - 1].to.tip).norm();
        since += length;
        if (since >= spacing) {
            touches = in_stock(m.to);
            since = 0;
        }
        found.whole += length;
        if (touches) found.length += length;
    }
    return found;
}

} // namespace

ShankInStock shank_in_stock(const ToolMotions& motions, const PlanContext& context,
                            const Progress& progress) {
    const double radius = CutterProfile(context.tool.cutter()).max_radius();
    const TiltedStock stock(stock_before(context, cell_share * radius, progress), context.tool, radius, 0);
    return looked_at(motions, 2 * radius, progress,
                     [&](const CutterLocation& at) { return stock.holds_shank(at); });
}

ShankInStock shank_in_stock(const ToolMotions& motions, const LatheCommon& settings,
                            const PlanContext& context, const Progress& progress) {
    const double radius = CutterProfile(context.tool.cutter()).max_radius();
    const LatheFrame frame(settings, context);
    const LatheStock above(frame, context, LatheStock::Of::above_flutes, progress);
    LatheStock::Hint hint;
    return looked_at(motions, 2 * radius, progress, [&](const CutterLocation& at) {
        const LathePlace place = frame.place(at);
        return above.u(place, hint) > frame.height(at.tip, place.angle) + radius * in_share;
    });
}

std::string shank_in_stock_warning(const ShankInStock& touched, const PlanContext& context) {
    if (touched.length <= min_told_share * touched.whole) return {};
    const PlanText text{context.unit, context.to_setup};
    return "shank or holder come into the stock, as operations with the upright tool leave it, along "
           + text(touched.length) + " of " + text(touched.whole)
           + " of cuts, as far as passes before them have not cleared it: rough there first, or use longer "
             "flutes";
}

} // namespace facetmill
