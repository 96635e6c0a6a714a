#include "core/study/evaluation.h"

#include "core/job/cache_key.h"
#include "core/job/whole_job.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace facetmill {

namespace {

/// Of a coarse look, in radii of the narrowest cutter: a third to a quarter of the time of a fine one, which
/// has a twentieth. What it finds is so; what it does not find may be there.
constexpr double coarse_resolution = 0.125, coarse_spacing = 0.2;

/// Says nothing of the candidate: another time, or on another machine, it may come out otherwise.
bool outer_error(ErrorCode code) {
    switch (code) {
    case ErrorCode::not_found:
    case ErrorCode::is_directory:
    case ErrorCode::unreadable:
    case ErrorCode::unwritable:
    case ErrorCode::internal:
        return true;
    default:
        return false;
    }
}

void measure_plan(const std::vector<SetupPlan>& setups, RungResult& result) {
    double time = 0, cut = 0, rapid = 0, cusp = 0;
    double changes = 0;
    for (const SetupPlan& setup : setups) {
        const double per = mm_per(setup.project.unit);
        const double leaves = verify_settings(setup.project, setup.plan.get()).allowance;
        long in_spindle = -1;
        for (const auto& o : setup.plan->operations) {
            time += o->totals.time_seconds;
            cut += o->totals.cut_length / per;
            rapid += o->totals.rapid_length / per;
            if (o->program.tool_number != in_spindle) ++changes;
            in_spindle = o->program.tool_number;
        }
        for (const Operation* o : operations_on(setup.project)) {
            if (o->left_on_purpose() > leaves) continue;
            for (const auto& planned : setup.plan->operations)
                if (planned->name == o->common().name) cusp = std::max(cusp, planned->path.cusp_max / per);
        }
    }
    Measures& m = result.measures;
    m[Measure::machining_time] = time;
    m[Measure::cut_length] = cut;
    m[Measure::rapid_length] = rapid;
    m[Measure::tool_changes] = changes;
    m[Measure::cusp_max] = cusp;
}

/// What the project as it stands asks of the same setups.
VerifySettings base_settings(const Project& base, std::span<const SetupPlan> chain) {
    std::vector<SetupPlan> asked;
    for (const SetupPlan& setup : chain) {
        const std::size_t i = std::min(chosen_setup(setup.project), setup_count(base) - 1);
        asked.push_back({view_of_setup(base, i), nullptr, true});
    }
    VerifySettings settings = chain_settings(chain);
    const VerifySettings own = chain_settings(asked);
    settings.tolerance = own.tolerance;
    settings.allowance = own.allowance;
    settings.gouge_limit = own.gouge_limit;
    settings.uncut_limit = own.uncut_limit;
    settings.before_work = [](const VerifyWork& work) {
        refuse_large(estimate_of(work), "let coarser settings vary");
    };
    return settings;
}

double narrowest_radius(std::span<const std::vector<VerifyProgram>> programs) {
    double radius = infinity;
    for (const std::vector<VerifyProgram>& setup : programs)
        for (const VerifyProgram& program : setup)
            radius = std::min(radius, program.tool.cutter.max_radius());
    return radius;
}

void raise(std::optional<double>& value, double to) {
    value = std::max(value.value_or(0), to);
}

void measure_judged(const JudgedChain& judged, RungResult& result) {
    const Verification& v = *judged.result;
    const double per = mm_per(judged.setups.front().project.unit);
    Measures& m = result.measures;
    raise(m[Measure::gouge_max], std::max(v.figures.gouge_max, v.border.gouge_max) / per);
    raise(m[Measure::excess_max], v.figures.excess_max / per);
    raise(m[Measure::excess_p99], v.figures.excess_p99 / per);
    raise(m[Measure::excess_p95], v.figures.excess_p95 / per);
    raise(m[Measure::uncut_share], v.uncut_share);
}

/// Of a tool, in all chains.
struct ToolLoad {
    double volume = 0, edges = 0; ///< mm^3; z d^2, mm^2
};

void measure_loads(const JudgedJob& judged, RungResult& result) {
    constexpr long usual_edges = 2;
    std::map<long, ToolLoad> tools;
    Measures& m = result.measures;
    double per = 1;
    for (const JudgedChain& chain : judged.chains) {
        std::size_t program = 0;
        for (const SetupPlan& setup : chain.setups) {
            per = mm_per(setup.project.unit);
            for (const auto& operation : setup.plan->operations) {
                const CuttingLoad& load = chain.result->program_loads.at(program);
                const double wide = 2 * chain.programs.programs[program].tool.cutter.max_radius();
                const Tool* tool = find_tool(setup.project.tools, operation->program.tool_number);
                const long edges = tool && tool->flutes > 0 ? tool->flutes : usual_edges;
                ToolLoad& of = tools[operation->program.tool_number];
                of.volume += load.volume;
                of.edges = double(edges) * wide * wide;
                raise(m[Measure::peak_load], load.peak_rate / (per * per * per));
                ++program;
            }
        }
    }
    for (const auto& [number, tool] : tools)
        raise(m[Measure::wear], tool.volume / tool.edges / per);
}

/// `max_samples`: as VerifySettings has it.
void judge(SeenCandidate& seen, const Project& base, Rung rung, std::size_t max_samples,
           const Progress& progress) {
    RungResult& result = seen.result;
    JudgedJob judged = judge_job(
        seen.setups,
        [&](VerifySettings& settings, std::span<const SetupPlan> chain,
            std::span<const std::vector<VerifyProgram>> programs) {
            settings = base_settings(base, chain);
            settings.max_samples = max_samples;
            if (rung != Rung::coarse) return;
            const double radius = narrowest_radius(programs);
            settings.resolution = coarse_resolution * radius;
            settings.sample_spacing = coarse_spacing * radius;
        },
        progress);
    for (const JudgedChain& chain : judged.chains)
        measure_judged(chain, result);
    measure_loads(judged, result);
    const Verdict verdict = judged.verdict();
    result.passed = verdict == Verdict::verified;
    if (!result.passed) result.why = verdict_name(verdict) + ": " + judged.findings();
    seen.chains = std::move(judged.chains);
}

/// Fills in what a look comes to.
void look(SeenCandidate& seen, const Project& candidate, const Project& base, Rung rung,
          std::size_t max_samples, const std::function<void(const std::vector<SetupPlan>&)>& planned,
          const Progress& progress) {
    RungResult& result = seen.result;
    try {
        SetupPlanners planners;
        seen.setups = plan_setups(
            candidate, "", planners, progress.part(0, rung == Rung::estimate ? 1 : 0.3),
            checked_planning({[](const WorkEstimate& estimate) {
                                  refuse_large(estimate, "choose a larger tolerance or step-over");
                              },
                              {}}));
        if (planned) planned(seen.setups);
        measure_plan(seen.setups, result);
        for (const SetupPlan& setup : seen.setups)
            setup.plan->check_reach();
        result.passed = true;
        if (rung != Rung::estimate) judge(seen, base, rung, max_samples, progress.part(0.3, 1));
    } catch (const Error& e) {
        if (outer_error(e.code())) throw;
        result.passed = false;
        result.why = e.what();
    }
}

} // namespace

RungResult evaluate(const Project& candidate, const Project& base, Rung rung, const Progress& progress) {
    SeenCandidate seen;
    look(seen, candidate, base, rung, 0, {}, progress);
    return seen.result;
}

std::shared_ptr<const SeenCandidate>
see_candidate(const Project& candidate, const Project& base, std::size_t max_samples,
              const std::function<void(const std::vector<SetupPlan>&)>& planned, const Progress& progress) {
    auto seen = std::make_shared<SeenCandidate>();
    look(*seen, candidate, base, Rung::fine, max_samples, planned, progress);
    return seen;
}

std::string judging_key(const Project& base) {
    Key key;
    key.add(coarse_resolution).add(coarse_spacing);
    for (std::size_t i = 0; i < setup_count(base); ++i) {
        const VerifySettings s = verify_settings(view_of_setup(base, i), nullptr);
        key.add(s.tolerance).add(s.allowance).add(s.gouge_limit).add(s.uncut_limit);
    }
    return key.text();
}

} // namespace facetmill
