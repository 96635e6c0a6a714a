#include "ui/all_setups.h"

#include "ui/messages.h"
#include "ui/part_controller.h"
#include "ui/plan_messages.h"
#include "ui/properties_panel.h"
#include "ui/setup_results.h"
#include "ui/text.h"
#include "ui/verification_controller.h"
#include "ui/verification_run.h"

#include <algorithm>

namespace facetmill::ui {

struct AllSetups::Work {
    Project project;
    SetupResults results;
    bool verify = false;
    LoadedPart part; ///< of the shown setup
    std::shared_ptr<const CarriedStock> carried;
    std::vector<std::shared_ptr<const VerificationOutcome>> verdicts;
};

AllSetups::AllSetups(Document& document, std::shared_ptr<Planner> planner,
                     std::shared_ptr<SetupPlanners> planners, BackgroundJob& job, Messages& messages,
                     PartController& part, PropertiesPanel& properties, VerificationController& verification,
                     QObject* window)
    : QObject(window), document_(document), planner_(std::move(planner)), planners_(std::move(planners)),
      job_(job), messages_(messages), part_(part), properties_(properties), verification_(verification) {}

bool AllSetups::can_plan() const {
    return !job_.running() && document_.has_part() && setup_count(document_.project()) > 1;
}

void AllSetups::start(bool verify) {
    if (!can_plan()) return;
    if (!properties_.commit()) {
        messages_.warning(tr("A parameter is not valid: correct it, then plan."));
        return;
    }
    emit about_to_plan();
    auto work =
        std::make_shared<Work>(Work{document_.project(), SetupResults(document_), verify, {}, {}, {}});
    if (!may_be_large(*work)) return;
    messages_.dismiss();
    document_.show_program(nullptr);
    document_.set_planning(work->results.unplanned());
    job_.start(
        verify ? tr("Verifying all setups") : tr("Planning all setups"),
        [work, planners = planners_](const Progress& progress) { run(*work, *planners, progress); },
        [this, work](const JobEnd& end) { finish(*work, end); });
}

bool AllSetups::may_be_large(const Work& work) {
    // Sizes are those of the shown setup: the part is the same in all of them, whichever way it lies.
    if (!document_.part()) return true;
    QStringList large;
    for (std::size_t k = 0; k < setup_count(work.project); ++k) {
        const Project view = view_of_setup(work.project, k);
        std::vector<std::string> names;
        for (const auto& operation : view.operations)
            names.push_back(operation->common().name);
        large << large_work(view, *document_.part(), names);
    }
    return may_plan(large, qobject_cast<QWidget*>(parent()));
}

void AllSetups::run(Work& work, SetupPlanners& planners, const Progress& progress) {
    check_project(work.project);
    const std::size_t shown = chosen_setup(work.project);
    const PlanSetup plan = [&](Planner& planner, const Project& view, const std::string&, const Progress& p) {
        const bool is_shown = chosen_setup(view) == shown;
        if (is_shown) {
            work.part = load_part(planner, view, p.part(0, 0.1));
            work.carried = planner.carried();
        }
        return work.results.plan(planner, view, p.part(is_shown ? 0.1 : 0, 1, view.name));
    };
    const double planned = work.verify ? 0.6 : 1.0;
    const std::vector<SetupPlan> setups =
        plan_setups(work.project, {}, planners, progress.part(0, planned), plan);
    if (!work.verify) return;
    for (const SetupPlan& setup : setups)
        setup.plan->check_reach();
    const auto chains = stock_chains(setups);
    const double n = double(chains.size());
    for (std::size_t k = 0; k < chains.size(); ++k)
        work.verdicts.push_back(judge_setups(chains[k], work.results.ids(),
                                             progress.part(planned + (1 - planned) * double(k) / n,
                                                           planned + (1 - planned) * double(k + 1) / n)));
}

void AllSetups::finish(Work& work, const JobEnd& end) {
    document_.set_planning({});
    // What was planned before a later setup failed is good.
    document_.take(work.results.outcomes());
    if (work.part.part && Document::part_key(document_.project()) == work.part.key) {
        planner_->carry(work.carried);
        if (!document_.part_is_current() || !document_.has_stock()) part_.show(work.part, false);
    }
    for (const OperationOutcome& o : work.results.outcomes())
        if (o.result) tell_operation(messages_, o.result, document_.unit());
    if (!end.done()) return;
    messages_.succeeded();
    if (work.verify)
        verification_.take(work.verdicts);
    else
        messages_.information(tr("All setups are planned."));
}

} // namespace facetmill::ui
