#include "core/strategy/rough/rough_setup.h"

#include "core/base/tolerances.h"
#include "core/strategy/plan/budget.h"
#include "core/strategy/plan/plan_text.h"
#include "core/strategy/surface/stock_before.h"

#include <algorithm>
#include <cmath>

namespace facetmill {

namespace {

/// Lu's safety factor c of the step-over.
constexpr double stepover_share = 0.95;
/// What is too little to be cut, in diameters; where shank or holder come by, skins as thin are cut all the
/// same.
constexpr double min_share = 2e-3;
/// The margin is at most this share of the tolerance, and what is too little to be cut at most that.
constexpr double margin_of_tolerance = 0.05, min_of_tolerance = 0.1;
/// Layers are made no thinner than this, in diameters, for the shank to slide by what they leave.
constexpr double min_for_shank = 0.1;
/// Lines on floors are at most so many times closer than others.
constexpr int max_divisions = 64;

double stepover_of(const RoughSettings& settings, const PlanContext& context, double diameter) {
    if (!settings.stepover.is_number()) return stepover_share * diameter;
    const double step = settings.stepover.number;
    const PlanText text{context.unit, context.to_setup};
    if (!(step > 0) || step > diameter)
        throw Error(ErrorCode::out_of_range, "stepover",
                    "a step-over of " + text(step) + " with a cutter of diameter " + text(diameter)
                        + " leaves walls between the lines",
                    "choose at most the diameter");
    return step;
}

void check_depth(const RoughSettings& settings, const PlanContext& context) {
    if (!settings.depth.is_number()) return;
    const double depth = settings.depth.number;
    const PlanText text{context.unit, context.to_setup};
    if (!(depth > 0))
        throw Error(ErrorCode::out_of_range, "depth", "the depth of the layers is not above 0",
                    "enter a length above 0, or let it follow from the tolerance");
    if (depth > context.tool.flute_length)
        throw Error(ErrorCode::out_of_range, "depth",
                    "layers of " + text(depth) + " are deeper than the flutes of the tool, "
                        + text(context.tool.flute_length),
                    "choose a smaller depth or a longer tool");
}

/// How deep layers may be for what one of them leaves of a wall to be out of the way of the shank, which the
/// next one brings there: where the shank begins the cutter must be as wide on the layer above. Infinite
/// where that is asked of no layer, or where they would be too thin.
double depth_for_shank(const PlanContext& context, const RoughMeasures& measures, double height) {
    const Tool& tool = context.tool;
    const double radius = 0.5 * tool.shank_diameter, widest = measures.profile.max_radius();
    if (!(tool.shank_length > 0) || height <= tool.flute_length
        || radius > widest * (1 + tolerance::figure_rounding))
        return infinity;
    const double depth = tool.flute_length - measures.profile.height_at(std::min(radius, widest));
    return depth < min_for_shank * measures.diameter ? infinity : depth;
}

double lowest_tip(const PlanContext& context, const StockField& field) {
    return std::max(field.box().lo.z(), context.part_box.lo.z());
}

} // namespace

RoughMeasures::RoughMeasures(const RoughSettings& settings, const PlanContext& context)
    : profile(context.tool.cutter()),
      diameter(context.tool.diameter > 0 ? std::min(2 * profile.max_radius(), context.tool.diameter)
                                         : 2 * profile.max_radius()),
      budget(cusp_budget(settings, context)),
      allowance(settings.allowance + context.tessellation_tolerance[1]),
      margin(std::max(std::min(settings.margin_share * diameter, margin_of_tolerance * budget),
                      tolerance::smallest_chord)),
      min_work(std::min(min_share * diameter, min_of_tolerance * budget)),
      stepover(stepover_of(settings, context, diameter)) {
    check_depth(settings, context);
    // On each layer material would stay over its wide end, in the way of the neck, the shank and every rapid.
    if (is_undercut(profile))
        throw Error(ErrorCode::out_of_range, "tool",
                    "roughing with a tool that is narrower above its end leaves material hanging over it",
                    "rough with a tool whose taper angle is 0 or more");
}

StockField rough_stock(const RoughSettings& settings, const PlanContext& context,
                       const RoughMeasures& measures, const Progress& progress) {
    StockField field = stock_before(context, settings.cell_share * measures.diameter, progress);
    const double top = field.highest(), low = lowest_tip(context, field);
    const PlanText text{context.unit, context.to_setup};
    if (!(top > low))
        throw Error(ErrorCode::empty_result, settings.name,
                    top == -infinity
                        ? "there is no stock"
                        : "the stock ends at z = " + text(top) + ", the part begins at z = " + text(low),
                    "check the stock's size and place");
    return field;
}

RoughHeights::RoughHeights(const RoughSettings& settings, const PlanContext& context,
                           const RoughMeasures& measures, const StockField& field, const Progress& progress)
    : low(lowest_tip(context, field)) {
    const PlanText text{context.unit, context.to_setup};
    LayerInput input;
    input.mesh = context.part.get();
    input.cutter = &measures.profile;
    input.allowance = measures.allowance;
    input.margin = measures.margin;
    input.top = field.highest();
    input.low = low;
    if (settings.depth.is_number()) {
        input.depth = settings.depth.number;
    } else {
        // The floor between lines takes a share of what may stay, the layers have the rest: few lines make
        // many layers, many lines few. Cheapest is what makes the least length of lines.
        input.excess = measures.budget - 2 * measures.margin - measures.min_work;
        input.deepest = std::min({context.tool.flute_length, measures.diameter,
                                  depth_for_shank(context, measures, input.top - input.low)});
        double best = infinity;
        for (int m = 1; m <= max_divisions; ++m) {
            const double rest = input.excess - measures.profile.height_at(0.5 * measures.stepover / m);
            if (!(rest > 0)) continue;
            const double count = std::max(1.0, (input.top - input.low) / std::min(rest, input.deepest));
            if (const double cost = count + (m > 1 ? m : 0); cost < best) {
                best = cost;
                divisions = m;
            }
        }
        if (best == infinity)
            throw Error(ErrorCode::out_of_range, "tolerance",
                        "no lines of this tool leave as little as " + text(settings.tolerance),
                        "allow a larger tolerance, set a depth, or take a tool with a flat end");
    }
    input.stepover = measures.stepover / divisions;
    layers = layer_heights(input, progress);
    expected = layers.excess + 2 * measures.margin + measures.min_work;
}

LayerPreview Rough::preview_layers(const PlanContext& context, const Progress& progress) const {
    check_plannable(context, settings_);
    const RoughMeasures measures(settings_, context);
    const StockField field = rough_stock(settings_, context, measures, progress.part(0, 0.5));
    const RoughHeights heights(settings_, context, measures, field, progress.part(0.5, 1));
    LayerPreview preview;
    preview.heights = heights.layers.heights;
    preview.depth_min = heights.layers.depth_min;
    preview.depth_max = heights.layers.depth_max;
    preview.stepover = measures.stepover / heights.divisions;
    preview.remaining = heights.expected + context.tessellation_tolerance[1];
    preview.stock = field.box();
    preview.stock.hi.z() = field.highest();
    return preview;
}

} // namespace facetmill
