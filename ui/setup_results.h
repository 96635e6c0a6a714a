// What a document has planned of its setups, for a job that needs plans of several of them. No widgets.
#pragma once

#include "core/job/setup_plan.h"
#include "ui/document.h"

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace facetmill::ui {

/// The plan of a setup whose operations came to these; null among them: switched off.
std::shared_ptr<PlanResult> plan_of(const Project& view, std::shared_ptr<const PreparedPart> part,
                                    const std::vector<std::shared_ptr<const OperationResult>>& results);

class SetupResults {
public:
    /// As the document stands now.
    explicit SetupResults(const Document& document);

    /// In the job's thread: the plan of a setup from what is planned as it stands; else it is planned, and is
    /// among the outcomes. Throws what Planner::plan and PlanResult::check_programs do.
    std::shared_ptr<const PlanResult> plan(Planner& planner, const Project& view, const Progress& progress);
    /// `plan` for plan_setups and stock_before; only as long as this lives.
    PlanSetup planning();

    const std::vector<std::vector<int>>& ids() const { return ids_; }
    /// Operations of setups that are not planned as they stand.
    std::vector<int> unplanned() const;
    /// What had to be planned.
    const std::vector<OperationOutcome>& outcomes() const { return outcomes_; }

private:
    std::shared_ptr<const PlanResult> kept(Planner& planner, const Project& view,
                                           const Progress& progress) const;

    std::vector<std::vector<int>> ids_;
    std::map<int, OperationOutcome> kept_; ///< by id; those that are switched off without a result
    std::vector<OperationOutcome> outcomes_;
};

} // namespace facetmill::ui
