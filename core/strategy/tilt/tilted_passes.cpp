#include "core/strategy/tilt/tilted_passes.h"

#include "core/base/parallel.h"
#include "core/base/tolerances.h"
#include "core/strategy/plan/plan_text.h"
#include "core/strategy/tilt/tilted_record.h"

#include <algorithm>

namespace facetmill {

namespace {

/// Shank and holder a hair thinner: a shank as thick as the cutter runs along what the cutter has cut.
ToolLift thinner_tool(const PlanContext& context, const TiltOptions& options) {
    Tool tool = context.tool;
    const double thinner = 2 * std::max(options.chord, tolerance::contact_distance);
    tool.shank_diameter = std::max(tool.shank_diameter - thinner, 0.5 * tool.shank_diameter);
    for (HolderSection& s : tool.holder)
        s.diameter = std::max(s.diameter - thinner, 0.5 * s.diameter);
    const double body = options.allowance + options.holder_clearance;
    return {context.contact, tool, {options.allowance, body, body}};
}

} // namespace

PassTilter::PassTilter(const PlanContext& context, const TiltOptions& options)
    : whole_(thinner_tool(context, options)),
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

TiltedPass PassTilter::run(const Pass& pass, const Progress& progress) const {
    return tilted_where_held(input_, pass, progress);
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
    std::vector<TiltedPass> tilted(path.passes.size());
    parallel_for(tilted.size(), 1, progress.part(0, 0.9),
                 [&](std::size_t i) { tilted[i] = tilter.run(path.passes[i], progress.part(0.9, 0.9)); });
    path.passes.clear();
    TiltedPath own;
    own.lead_min = own.lead_max = 0;
    double lost = 0;
    for (TiltedPass& t : tilted) {
        lost += t.lost;
        own.lead_max = std::max(own.lead_max, t.largest);
        std::move(t.passes.begin(), t.passes.end(), std::back_inserter(path.passes));
    }
    if (path.passes.empty())
        throw Error(
            ErrorCode::empty_result, settings.name,
            "shank or holder would come into the part wherever the cutter could cut, however far it is "
            "inclined within the tilt limit",
            "use a longer tool, or allow a larger tilt limit");
    if (lost > options.chord)
        path.warnings.push_back("no inclined tool that turns steadily is free along "
                                + PlanText{context.unit, context.to_setup}(lost)
                                + " of the passes, which are left out: use a longer tool, or allow a larger "
                                  "tilt limit");
    own.record = tilted_record(path.passes, settings, context, options, progress.part(0.9, 1));
    path.detail = std::move(own);
}

} // namespace facetmill
