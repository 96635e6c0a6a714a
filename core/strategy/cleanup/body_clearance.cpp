#include "core/strategy/cleanup/body_clearance.h"

#include "core/base/parallel.h"
#include "core/base/tolerances.h"
#include "core/gouge/tool_lift.h"

namespace facetmill {

namespace {

/// An inclined tool that would cut elsewhere is drawn out of it by no more than this share of the tolerance:
/// so much more may stay where it was to cut.
constexpr double raise_share = 0.25;
constexpr std::size_t locations_per_check = 256;

/// The whole tool, with shank and holder a hair thinner: a shank as thick as the cutter runs along what the
/// cutter has cut.
ToolLift whole_tool(const CleanupJob& job) {
    Tool tool = job.context.tool;
    const double thinner = 2 * std::max(job.chord, tolerance::contact_distance);
    tool.shank_diameter = std::max(tool.shank_diameter - thinner, 0.5 * tool.shank_diameter);
    for (HolderSection& s : tool.holder)
        s.diameter = std::max(s.diameter - thinner, 0.5 * s.diameter);
    return {job.context.contact, tool, {job.allowance, 0, 0}};
}

/// A pass without the locations at which shank or holder would touch.
TiltedPass upright_where_free(const ToolLift& whole, double chord, const Pass& pass,
                              const Progress& progress) {
    TiltedPass kept;
    ToolLift::Hint hint;
    Pass run = pass;
    run.cl.clear();
    run.cc.clear();
    for (std::size_t k = 0; k < pass.cl.size(); ++k) {
        if (k % locations_per_check == 0) progress.check();
        const ToolContact c = whole.contact_above({pass.cl[k].tip, pass.cl[k].axis}, chord, hint);
        if (c.body == ToolBody::shank || c.body == ToolBody::holder) {
            kept.by = c.body;
            if (k > 0) kept.lost += (pass.cl[k].tip - pass.cl[k - 1].tip).norm();
            if (run.cl.size() > 1) kept.passes.push_back(run);
            run.cl.clear();
            run.cc.clear();
            continue;
        }
        run.cl.push_back(pass.cl[k]);
        run.cc.push_back(pass.cc[k]);
    }
    if (run.cl.size() > 1) kept.passes.push_back(std::move(run));
    return kept;
}

} // namespace

ClearedPasses with_clear_body(const CleanupJob& job, const std::vector<Pass>& passes,
                              const Progress& progress) {
    const ToolLift whole = whole_tool(job);
    const double tilt_limit = job.settings.tilt_limit;
    std::vector<TiltedPass> kept(passes.size());
    parallel_for(passes.size(), 1, progress, [&](std::size_t i) {
        kept[i] = tilt_limit > 0 ? tilted_where_held({&whole, tilt_limit, job.chord, raise_share * job.cusp},
                                                     passes[i], progress)
                                 : upright_where_free(whole, job.chord, passes[i], progress);
    });
    ClearedPasses result;
    for (TiltedPass& k : kept) {
        result.held += k.lost;
        if (k.by != ToolBody::none) result.held_by = k.by;
        result.largest_tilt = std::max(result.largest_tilt, k.largest);
        for (Pass& p : k.passes)
            result.passes.push_back(std::move(p));
    }
    return result;
}

} // namespace facetmill
