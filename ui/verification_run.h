// Verifying for the workbench: what a job's thread does. No widgets.
#pragma once

#include "core/job/kept_result.h"
#include "core/job/setup_plan.h"
#include "ui/verification_model.h"

#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace facetmill::ui {

/// A program is shown, or all operations up to one (none: all) are planned as they stand, and part and stock
/// are there.
bool can_judge(const Document& document, std::optional<std::size_t> up_to);
/// The plan that is shown up to the operation `up_to`, or the program in its place; operations that are not
/// switched off are planned as they stand.
std::shared_ptr<const PlanResult> plan_as_it_stands(const Document& document,
                                                    std::optional<std::size_t> up_to = std::nullopt);
std::vector<VerifyProgram> programs_as_they_stand(const Document& document,
                                                  const std::shared_ptr<const PlanResult>& plan);
/// What will be judged of the shown setup, before it is; `plan`: plan_as_it_stands.
std::shared_ptr<VerificationOutcome> outcome_to_be(const Document& document, const PlanResult& plan,
                                                   std::optional<std::size_t> up_to = std::nullopt);

/// The same without a document, of the first `operations` of a setup: `ids` and `results` of all of them,
/// null where one is switched off.
std::shared_ptr<VerificationOutcome>
outcome_to_be(const Project& view, const std::vector<int>& ids,
              const std::vector<std::shared_ptr<const OperationResult>>& results, std::size_t operations);
/// The same of setups that are judged as one job. `ids`: of the operations of each setup of the document.
std::shared_ptr<VerificationOutcome> outcome_to_be(std::span<const SetupPlan> chain,
                                                   const std::vector<std::vector<int>>& ids);
/// Takes over what was judged, as it is shown in each setup.
void show_judged(VerificationOutcome& outcome, const KeptVerdict& judged, LengthUnit unit,
                 const Progress& progress);

/// Fills in what an outcome of one setup says of its plan, or of the programs that stand in its place. Where
/// there is a control, what it will run is judged. Where it turns out that nothing can be verified, it is not
/// begun, unless it is wanted `anyway`, for the faults that are found. Throws what programs_to_judge and
/// verify do.
void judge(VerificationOutcome& outcome, const Project& project,
           const std::shared_ptr<const PlanResult>& plan, const std::vector<VerifyProgram>& programs,
           bool anyway, const Progress& progress);

/// The same of setups that cut one stock. `ids`: of the operations of each setup of the document. Throws what
/// judge_posted_chain does.
std::shared_ptr<const VerificationOutcome> judge_setups(std::span<const SetupPlan> chain,
                                                        const std::vector<std::vector<int>>& ids,
                                                        const Progress& progress);

} // namespace facetmill::ui
