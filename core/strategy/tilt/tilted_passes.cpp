#include "core/strategy/tilt/tilted_passes.h"

#include "core/base/tolerances.h"
#include "core/strategy/plan/plan_text.h"
#include "core/strategy/surface/stock_before.h"
#include "core/strategy/tilt/thinner_tool.h"
#include "core/strategy/tilt/tilted_record.h"

#include <algorithm>

namespace facetmill {

namespace {

/// The cells of the stock that shank and holder keep out of, in radii of the cutter.
constexpr double tilt_cell_share = 0.125;

} // namespace

PassTilter::PassTilter(const PlanContext& context, const TiltOptions& options)
    : whole_(thinner_tool(context.contact, context.tool,
                          {options.allowance, options.allowance + options.holder_clearance,
                           options.allowance + options.holder_clearance},
                          options.chord)),
      machine_(context.machine, gauge_length(context.tool),
               default_part_origin(context.machine, context.part_box)) {
    input_.whole = &whole_;
    input_.machine = &machine_;
    input_.limit = options.limit;
    // Upright passes run up to half of the chord tolerance below the exact path.
    input_.chord = input_.raise = options.chord;
    input_.ball_only = true;
    input_.look_step = body_step(context.tool, options.chord);
}

TiltedPass PassTilter::run(const Pass& pass, const Progress& progress, const TiltedStock* stock) const {
    TiltInput input = input_;
    input.stock = stock;
    return tilted_where_held(input, pass, progress);
}

void check_tilt(const PlanContext& context, double limit) {
    if (limit == 0 || ball_radius(CutterProfile(context.tool.cutter())) > 0) return;
    throw Error(ErrorCode::out_of_range, "tilt_limit",
                "only a ball cuts the same however it leans, and tool " + std::to_string(context.tool.number)
                    + " has no ball end",
                "take a tool that has one, set the tilt limit to 0, or finish with five axes (finish5)");
}

void tilt_passes(StrategyResult& path, const OperationCommon& settings, const PlanContext& context,
                 const TiltOptions& options, const Progress& progress) {
    const PassTilter tilter(context, options);
    const double radius = CutterProfile(context.tool.cutter()).max_radius();
    TiltedStock stock(stock_before(context, tilt_cell_share * radius, progress.part(0, 0.1)), context.tool,
                      radius, 0);
    const std::vector<Pass> upright = std::exchange(path.passes, {});
    TiltedPath own;
    own.lead_min = own.lead_max = 0;
    double lost = 0;
    // One after the other: what a pass has cut the next ones do not keep out of.
    for (std::size_t i = 0; i < upright.size(); ++i) {
        const Progress here = progress.part(0.1 + 0.8 * double(i) / double(upright.size()),
                                            0.1 + 0.8 * double(i + 1) / double(upright.size()));
        TiltedPass tilted = tilter.run(upright[i], here, &stock);
        lost += tilted.lost;
        own.lead_max = std::max(own.lead_max, tilted.largest);
        for (Pass& pass : tilted.passes) {
            for (std::size_t k = 1; k < pass.cl.size(); ++k)
                stock.cut(pass.cl[k - 1], pass.cl[k]);
            path.passes.push_back(std::move(pass));
        }
        here.set(1);
    }
    if (path.passes.empty())
        throw Error(
            ErrorCode::empty_result, settings.name,
            "shank or holder would come into the part, or into what stands of the stock, wherever the "
            "cutter could cut, however far it is inclined within the tilt limit",
            "rough before it, use a longer tool, or allow a larger tilt limit");
    if (lost > options.chord)
        path.warnings.push_back("no inclined tool that turns steadily is free of the part, and of what "
                                "stands of the stock, along "
                                + PlanText{context.unit, context.to_setup}(lost)
                                + " of the passes, which are left out: rough closer, use a longer tool, or "
                                  "allow a larger tilt limit");
    own.record = tilted_record(path.passes, settings, context, options, progress.part(0.9, 1));
    path.detail = std::move(own);
}

} // namespace facetmill
