#include "core/job/whole_job.h"

#include "core/base/error.h"
#include "core/job/posting.h"
#include "core/job/program_files.h"
#include "core/job/project_inputs.h"
#include "core/job/report.h"

#include <utility>

namespace facetmill {

namespace fs = std::filesystem;

void refuse_large(const WorkEstimate& estimate, const std::string& remedy) {
    if (estimate.large())
        throw Error(ErrorCode::limit_exceeded, estimate.what, "would take " + estimate.text(), remedy);
}

PlanSetup checked_planning(PlanWatch watch) {
    return [watch = std::move(watch)](Planner& planner, const Project& view, const std::string& only,
                                      const Progress& progress) {
        check_inputs(view);
        check_project(view);
        if (watch.before_work) {
            const auto part = planner.prepare(view, progress.part(0, 0.05));
            for (const WorkEstimate& estimate : estimate_plan(view, *part, only))
                watch.before_work(estimate);
        }
        auto plan = planner.plan(view, only, progress.part(0.05, 1));
        plan->check_programs();
        if (watch.idle)
            for (const auto& operation : plan->idle)
                watch.idle(*operation);
        return plan;
    };
}

std::string PlannedJob::report() const {
    return setups_report_json(setups, air);
}

void PlannedJob::check_reach() const {
    for (const SetupPlan& setup : setups)
        if (setup.asked) setup.plan->check_reach();
}

std::vector<fs::path> PlannedJob::write(const fs::path& folder, const Progress& progress,
                                        const std::function<void()>& before) const {
    check_reach();
    return write_setups(setups, folder, progress, air, before);
}

PlannedJob plan_job(const Project& project, const std::string& only_operation, SetupPlanners& planners,
                    const PlanWatch& watch, Reach reach, const Progress& progress) {
    check_all_posting(project);
    constexpr double planned = 0.92;
    PlannedJob job;
    job.setups =
        plan_setups(project, only_operation, planners, progress.part(0, planned), checked_planning(watch));
    if (reach == Reach::within) job.check_reach();
    const Progress looking = progress.part(planned, 1, "Looking for air");
    job.air.resize(job.setups.size());
    for (std::size_t i = 0; i < job.setups.size(); ++i) {
        if (!job.setups[i].asked) continue;
        const double n = double(job.setups.size()), at = double(i);
        job.air[i] =
            feed_in_air(job.setups[i].project, job.setups[i].plan, looking.part(at / n, (at + 1) / n));
    }
    return job;
}

const JudgedChain* JudgedJob::single() const {
    const bool one = chains.size() == 1 && setup_count(chains.front().setups.front().project) == 1;
    return one ? &chains.front() : nullptr;
}

std::string JudgedJob::findings() const {
    return findings_line(chains);
}

std::string JudgedJob::json() const {
    const JudgedChain* one = single();
    if (!one) return chains_json(chains);
    return verify_json(one->setups.front().project, one->programs.programs, *one->result);
}

std::vector<fs::path> JudgedJob::write(const fs::path& folder, const Progress& progress,
                                       const std::function<void()>& before) const {
    const JudgedChain* one = single();
    if (!one) return write_chains(chains, folder, progress, before);
    return write_verification(one->setups.front().project, one->programs.programs, *one->result, folder,
                              progress, before);
}

JudgedJob judge_job(std::span<const SetupPlan> setups, const AskJudge& ask, const Progress& progress) {
    const std::vector<std::span<const SetupPlan>> chains = stock_chains(setups);
    JudgedJob job;
    const double n = double(chains.size());
    for (const std::span<const SetupPlan> chain : chains) {
        const std::vector<std::vector<VerifyProgram>> programs = planned_programs(chain);
        VerifySettings settings = chain_settings(chain);
        if (ask) ask(settings, chain, programs);
        const double at = double(job.chains.size());
        job.chains.push_back(judge_chain(chain, programs, settings, progress.part(at / n, (at + 1) / n)));
    }
    return job;
}

} // namespace facetmill
