#include "core/strategy/cleanup/body_clearance.h"

#include "core/base/parallel.h"
#include "core/base/tolerances.h"
#include "core/strategy/tilt/thinner_tool.h"

#include <cmath>

namespace facetmill {

namespace {

/// An inclined tool that would cut elsewhere is drawn out of it by no more than this share of the tolerance:
/// so much more may stay where it was to cut.
constexpr double raise_share = 0.25;
constexpr std::size_t locations_per_check = 256;

ToolLift whole_tool(const CleanupJob& job) {
    return thinner_tool(job.context.contact, job.context.tool, {job.allowance, 0, 0}, job.chord);
}

/// A pass without the motions on which shank or holder would touch.
class FreeRuns {
public:
    FreeRuns(const ToolLift& whole, double chord, double step) : whole_(whole), chord_(chord), step_(step) {}

    TiltedPass run(const Pass& pass, const Progress& progress) {
        run_ = pass;
        clear();
        for (std::size_t k = 0; k < pass.cl.size(); ++k) {
            if (k % locations_per_check == 0) progress.check();
            const double length = k > 0 ? (pass.cl[k].tip - pass.cl[k - 1].tip).norm() : 0;
            if (held(pass.cl[k].tip)) {
                kept_.lost += length;
                end();
                continue;
            }
            if (!run_.cl.empty() && held_between(pass.cl[k - 1].tip, pass.cl[k].tip, length)) {
                kept_.lost += length;
                end();
            }
            run_.cl.push_back(pass.cl[k]);
            run_.cc.push_back(pass.cc[k]);
        }
        end();
        return std::move(kept_);
    }

private:
    bool held(const Vec3& tip) {
        const ToolContact c = whole_.contact_above({tip, Vec3::UnitZ()}, chord_, hint_);
        if (c.body != ToolBody::shank && c.body != ToolBody::holder) return false;
        kept_.by = c.body;
        return true;
    }
    bool held_between(const Vec3& a, const Vec3& b, double length) {
        if (!(step_ < infinity)) return false;
        const auto parts = std::size_t(length / step_) + 1;
        for (std::size_t i = 1; i < parts; ++i)
            if (held(a + double(i) / double(parts) * (b - a))) return true;
        return false;
    }
    void end() {
        if (run_.cl.size() > 1) kept_.passes.push_back(run_);
        clear();
    }
    void clear() {
        run_.cl.clear();
        run_.cc.clear();
    }

    const ToolLift& whole_;
    double chord_, step_;
    ToolLift::Hint hint_;
    Pass run_;
    TiltedPass kept_;
};

} // namespace

std::vector<char> is_body_clear(const CleanupJob& job, const std::vector<Pass>& passes,
                                const Progress& progress) {
    const ToolLift whole = whole_tool(job);
    const double step = body_step(job.context.tool, job.chord);
    std::vector<char> clear(passes.size());
    parallel_for(passes.size(), 1, progress, [&](std::size_t i) {
        clear[i] = FreeRuns(whole, job.chord, step).run(passes[i], progress).by == ToolBody::none;
    });
    return clear;
}

ClearedPasses with_clear_body(const CleanupJob& job, const std::vector<Pass>& passes,
                              const Progress& progress) {
    const ToolLift whole = whole_tool(job);
    const double tilt_limit = job.settings.tilt_limit;
    const double step = body_step(job.context.tool, job.chord);
    const PlanContext& context = job.context;
    const Kinematics machine(context.machine, gauge_length(context.tool),
                             default_part_origin(context.machine, context.part_box));
    TiltInput tilt{&whole, tilt_limit, job.chord, raise_share * job.cusp};
    tilt.look_step = step;
    tilt.machine = &machine;
    std::vector<TiltedPass> kept(passes.size());
    parallel_for(passes.size(), 1, progress, [&](std::size_t i) {
        kept[i] = tilt_limit > 0 ? tilted_where_held(tilt, passes[i], progress)
                                 : FreeRuns(whole, job.chord, step).run(passes[i], progress);
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
