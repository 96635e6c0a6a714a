// A project's setups planned one after the other, each on the stock that those before it leave, and judged
// together: a setup with a stock of its own and those after it that go on with the rest of it are a chain.
#pragma once

#include "core/base/progress.h"
#include "core/job/planner.h"
#include "core/job/project.h"
#include "core/verify/verify.h"

#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace facetmill {

struct SetupPlan {
    Project project; ///< the view on the setup
    std::shared_ptr<const PlanResult> plan;
    bool asked = true; ///< false: planned for the stock that a later setup begins with
};

/// A planner for each setup of a project, which keep what they have planned.
class SetupPlanners {
public:
    /// `meshes`: of all its planners (Planner).
    explicit SetupPlanners(std::shared_ptr<KnownMeshes> meshes = nullptr);
    Planner& at(std::size_t setup);
    /// The rest that the chosen setup begins with, where it was carried to its planner; null where it was
    /// not, or was made from anything else than the project says now.
    std::shared_ptr<const CarriedStock> known_rest(const Project& project);

private:
    std::shared_ptr<KnownMeshes> meshes_;
    std::vector<std::unique_ptr<Planner>> planners_;
};

/// How one setup is planned; its Planner has the stock carried to it.
using PlanSetup = std::function<std::shared_ptr<const PlanResult>(
    Planner& planner, const Project& view, const std::string& only_operation, const Progress& progress)>;

/// Plans all setups, or what one operation needs (empty: all): its own setup, and those whose stock that goes
/// on with. In machining order, without setups whose operations are all switched off. Throws what
/// Planner::plan and PlanResult::check_programs do, of several setups within "setup 'Bottom'";
/// Error(missing_reference) for an unknown operation, Error(out_of_range) where a setup's own stock does not
/// meet that of the setup before it, and what carried_stock does.
std::vector<SetupPlan> plan_setups(const Project& project, const std::string& only_operation,
                                   SetupPlanners& planners, const Progress& progress,
                                   const PlanSetup& plan = {});

/// The stock that the chosen setup begins with where that is a rest, else null: plans the setups before it.
/// Throws likewise.
std::shared_ptr<const CarriedStock> stock_before(const Project& project, SetupPlanners& planners,
                                                 const Progress& progress, const PlanSetup& plan = {});

/// The setups that cut one stock with this one: from `first` to before `last`, in machining order.
struct SetupRange {
    std::size_t first = 0, last = 0;
};
SetupRange setups_of_stock(const Project& project, std::size_t setup);
/// The setups that cut one stock, each chain in machining order.
std::vector<std::span<const SetupPlan>> stock_chains(std::span<const SetupPlan> setups);

/// What a chain leaves of its stock, in the coordinates of the setup that is to go on with it: cut as for the
/// verification, coarser where its surface would come in millions of facets. Throws what verify does,
/// Error(empty_result) where nothing is left.
std::shared_ptr<const CarriedStock> carried_stock(std::span<const SetupPlan> chain, const Project& next,
                                                  const Progress& progress);

/// From the coordinates of one setup to those of another.
SetupFrame frame_between(const Setup& from, const Setup& to);
/// A program of one setup in the coordinates of another.
VerifyProgram moved_program(const VerifyProgram& program, const SetupFrame& frame);

/// A chain as the judge sees it: all in the coordinates of its first setup.
struct ChainPrograms {
    std::vector<VerifyProgram> programs;
    std::vector<std::size_t> setups; ///< for each the place of its setup in the chain
};
/// `programs`: those of each setup, in its own coordinates.
ChainPrograms chain_programs(std::span<const SetupPlan> chain,
                             std::span<const std::vector<VerifyProgram>> programs);
/// The planned programs of each setup of a chain.
std::vector<std::vector<VerifyProgram>> planned_programs(std::span<const SetupPlan> chain);
/// What leaves the least counts, as in verify_settings; of setups that leave the same the largest tolerance
/// and gouge limit.
VerifySettings chain_settings(std::span<const SetupPlan> chain);
/// A sentence where the tolerance is not that of all setups; else empty.
std::string tolerance_remark(std::span<const SetupPlan> chain);

} // namespace facetmill
