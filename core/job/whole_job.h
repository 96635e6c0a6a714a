// A project from its file to programs and to a verdict, as everybody goes who has no window: the command
// line, Python, studies.
#pragma once

#include "core/job/chain_verification.h"
#include "core/job/setup_plan.h"
#include "core/job/work_estimate.h"

#include <filesystem>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace facetmill {

/// What is told while a project is planned; each may be empty, and may throw.
struct PlanWatch {
    /// How much work an operation will be, before any is planned.
    std::function<void(const WorkEstimate&)> before_work;
    /// An operation that has nothing to do.
    std::function<void(const OperationResult&)> idle;
};

/// For those who cannot be asked: throws Error(limit_exceeded) where it is more than usual. `remedy` is what
/// to do then.
void refuse_large(const WorkEstimate& estimate, const std::string& remedy);

/// How each setup is planned: its files looked for, its settings checked, its programs checked. Throws what
/// check_inputs, check_project, Planner::plan and PlanResult::check_programs do.
PlanSetup checked_planning(PlanWatch watch = {});

/// A project planned: what `facetmill-cli plan` writes.
struct PlannedJob {
    std::vector<SetupPlan> setups;
    std::vector<std::vector<double>> air; ///< feed_in_air of each setup that was asked for

    /// report.json.
    std::string report() const;
    /// Throws what PlanResult::check_reach does.
    void check_reach() const;
    /// As write_setups. Throws what that and check_reach do.
    std::vector<std::filesystem::path> write(const std::filesystem::path& folder, const Progress& progress,
                                             const std::function<void()>& before = {}) const;
};

/// What is planned, whether or not a machine can make all its motions.
enum class Reach : std::uint8_t { any, within };

/// Plans all setups, or what one operation needs, and looks how much of it cuts air. Throws what
/// check_all_posting, plan_setups and feed_in_air do; where it has to be within reach also what check_reach
/// does.
PlannedJob plan_job(const Project& project, const std::string& only_operation, SetupPlanners& planners,
                    const PlanWatch& watch, Reach reach, const Progress& progress);

/// Changes what is asked of the judge; `programs`: those of each setup of the chain.
using AskJudge = std::function<void(VerifySettings& settings, std::span<const SetupPlan> chain,
                                    std::span<const std::vector<VerifyProgram>> programs)>;

/// A verdict on planned programs: what `facetmill-cli simulate` writes.
struct JudgedJob {
    std::vector<JudgedChain> chains;

    Verdict verdict() const { return verdict_of(chains); }
    /// findings_line.
    std::string findings() const;
    /// verify.json: of a project with one setup verify_json, else chains_json.
    std::string json() const;
    /// As write_verification, or write_chains.
    std::vector<std::filesystem::path> write(const std::filesystem::path& folder, const Progress& progress,
                                             const std::function<void()>& before = {}) const;

private:
    /// The only chain of a project with one setup, else null.
    const JudgedChain* single() const;
};

/// Judges planned setups chain by chain; they must outlive what is returned. Throws what `ask` and
/// judge_chain do.
JudgedJob judge_job(std::span<const SetupPlan> setups, const AskJudge& ask, const Progress& progress);

} // namespace facetmill
