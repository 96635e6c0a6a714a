#include "ui/setup_results.h"

#include "core/job/stock_solid.h"

#include <algorithm>

namespace facetmill::ui {

std::shared_ptr<PlanResult> plan_of(const Project& view, std::shared_ptr<const PreparedPart> part,
                                    const std::vector<std::shared_ptr<const OperationResult>>& results) {
    auto plan = std::make_shared<PlanResult>();
    plan->part = std::move(part);
    plan->stock = stock_solid(view.stock, *plan->part);
    plan->stock_warnings = stock_warnings(view.stock, *plan->part, view.unit);
    for (const auto& result : results) {
        if (!result) continue;
        auto programs = programs_of(result);
        if (programs.empty()) plan->idle.push_back(result);
        std::move(programs.begin(), programs.end(), std::back_inserter(plan->operations));
    }
    return plan;
}

SetupResults::SetupResults(const Document& document) : ids_(document.setup_ids()) {
    for (std::size_t k = 0; k < ids_.size(); ++k) {
        const Project view = view_of_setup(document.project(), k);
        for (std::size_t i = 0; i < ids_[k].size(); ++i) {
            const std::string fingerprint = Document::fingerprint(view, i);
            if (view.operations[i]->common().off)
                kept_[ids_[k][i]] = {ids_[k][i], nullptr, {}, fingerprint};
            else if (auto result = document.result_of(ids_[k][i], fingerprint))
                kept_[ids_[k][i]] = {ids_[k][i], std::move(result), {}, fingerprint};
        }
    }
}

std::vector<int> SetupResults::unplanned() const {
    std::vector<int> ids;
    for (const std::vector<int>& own : ids_)
        if (!std::all_of(own.begin(), own.end(), [&](int id) { return kept_.contains(id); }))
            ids.insert(ids.end(), own.begin(), own.end());
    return ids;
}

std::shared_ptr<const PlanResult> SetupResults::kept(Planner& planner, const Project& view,
                                                     const Progress& progress) const {
    const std::vector<int>& ids = ids_[chosen_setup(view)];
    for (std::size_t i = 0; i < ids.size(); ++i) {
        const auto it = kept_.find(ids[i]);
        // Files may have been written anew meanwhile.
        if (it == kept_.end() || it->second.fingerprint != Document::fingerprint(view, i)) return nullptr;
    }
    std::vector<std::shared_ptr<const OperationResult>> results;
    for (const int id : ids)
        results.push_back(kept_.at(id).result);
    return plan_of(view, planner.prepare(view, progress), results);
}

std::shared_ptr<const PlanResult> SetupResults::plan(Planner& planner, const Project& view,
                                                     const Progress& progress) {
    auto plan = kept(planner, view, progress);
    if (!plan) {
        const std::size_t setup = chosen_setup(view);
        std::vector<OperationOutcome> outcomes;
        std::vector<std::string> names;
        for (std::size_t i = 0; i < ids_[setup].size(); ++i) {
            if (view.operations[i]->common().off) continue;
            outcomes.push_back({ids_[setup][i], nullptr, {}, Document::fingerprint(view, i)});
            names.push_back(view.operations[i]->common().name);
        }
        plan = planner.plan(view, {}, progress);
        for (std::size_t k = 0; k < outcomes.size(); ++k)
            for (const auto* all : {&plan->operations, &plan->idle})
                for (const auto& result : *all)
                    if (result->name == names[k]) outcomes[k].result = result;
        std::move(outcomes.begin(), outcomes.end(), std::back_inserter(outcomes_));
    }
    plan->check_programs();
    return plan;
}

PlanSetup SetupResults::planning() {
    return [this](Planner& planner, const Project& view, const std::string&, const Progress& progress) {
        return plan(planner, view, progress);
    };
}

} // namespace facetmill::ui
