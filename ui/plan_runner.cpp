#include "ui/plan_runner.h"

#include "core/job/stock_solid.h"
#include "ui/all_setups.h"
#include "ui/messages.h"
#include "ui/part_controller.h"
#include "ui/plan_messages.h"
#include "ui/properties_panel.h"
#include "ui/setup_results.h"
#include "ui/text.h"
#include "ui/verification_controller.h"

namespace facetmill::ui {

/// One planning job: what it plans from, and what it came to.
struct PlanRunner::Work {
    Project project;
    std::vector<std::size_t> wanted;    ///< places of the operations
    std::vector<int> ids;               ///< their ids in the document
    std::optional<SetupResults> before; ///< what is planned of others, where their stock is asked for
    std::vector<OperationOutcome> outcomes;
    LoadedPart part; ///< only when the part had to be read again
    bool read_part = false;
};

PlanRunner::PlanRunner(Document& document, std::shared_ptr<Planner> planner,
                       std::shared_ptr<SetupPlanners> planners, BackgroundJob& job, Messages& messages,
                       PartController& part, PropertiesPanel& properties,
                       VerificationController& verification, QObject* window)
    : QObject(window), document_(document), planner_(std::move(planner)), earlier_(std::move(planners)),
      job_(job), messages_(messages), part_(part), properties_(properties), verification_(verification) {
    all_setups_ = new AllSetups(document_, planner_, earlier_, job_, messages_, part_, properties_,
                                verification_, window);
    connect(all_setups_, &AllSetups::about_to_plan, this, &PlanRunner::about_to_plan);
}

bool PlanRunner::can_plan() const {
    return !job_.running() && document_.has_part() && document_.operation_count() > 0;
}

void PlanRunner::verify() {
    if (job_.running() || !document_.has_part()) return;
    if (properties_.commit() && verification_.can_verify()) {
        messages_.dismiss();
        verification_.verify();
        return;
    }
    plan(); // or says why it cannot
    verify_next_ = job_.running();
}

void PlanRunner::plan(std::optional<std::size_t> only) {
    if (job_.running() || !document_.has_part()) return;
    if (!properties_.commit()) {
        messages_.warning(tr("A parameter is not valid: correct it, then plan."));
        return;
    }
    emit about_to_plan();
    if (document_.operation_count() == 0) {
        messages_.warning(tr("There is no operation to plan: add one below the project tree."));
        return;
    }
    auto work = std::make_shared<Work>();
    work->project = document_.project();
    for (std::size_t i = 0; i < document_.operation_count(); ++i)
        if (!only || *only == i) {
            work->wanted.push_back(i);
            work->ids.push_back(document_.operation_id(i));
        }
    work->read_part = !document_.part_is_current() || !document_.has_stock();
    if (work->read_part && work->project.stock.kind == StockSpec::Kind::rest) work->before.emplace(document_);
    std::vector<std::string> names;
    for (const std::size_t i : work->wanted)
        names.push_back(work->project.operations[i]->common().name);
    if (document_.part()
        && !may_plan(large_work(work->project, *document_.part(), names), qobject_cast<QWidget*>(parent())))
        return;
    messages_.dismiss();
    document_.show_program(nullptr);
    document_.set_planning(work->ids);
    job_.start(
        tr("Planning"),
        [work, planner = planner_, earlier = earlier_](const Progress& progress) {
            run(*work, *planner, *earlier, progress);
        },
        [this, work](const JobEnd& end) { finish(*work, end); });
}

void PlanRunner::run(Work& work, Planner& planner, SetupPlanners& earlier, const Progress& progress) {
    double from = 0;
    if (work.read_part) {
        // A setup that goes on with the rest of another one needs the plan of that.
        if (work.before) {
            check_project(work.project);
            auto rest = stock_before(work.project, earlier, progress.part(0, 0.5), work.before->planning());
            earlier.at(chosen_setup(work.project)).carry(rest); // for whoever comes back to it
            planner.carry(std::move(rest));
            from = 0.5;
        }
        work.part = load_part(planner, work.project, progress.part(from, from + 0.2));
        from += 0.2;
    }
    check_project(work.project);
    const double share = (1 - from) / double(work.wanted.size());
    for (std::size_t k = 0; k < work.wanted.size(); ++k) {
        const std::size_t i = work.wanted[k];
        const std::string name = work.project.operations[i]->common().name;
        OperationOutcome outcome;
        outcome.id = work.ids[k];
        outcome.fingerprint = Document::fingerprint(work.project, i);
        try {
            const auto result =
                planner.plan(work.project, name,
                             progress.part(from + share * double(k), from + share * double(k + 1), name));
            outcome.result = result->operations.empty() ? result->idle.at(0) : result->operations.front();
        } catch (const Error& e) {
            // The other operations may still be planned. Names and places stay as they are.
            const LengthUnit unit = work.project.unit;
            const auto in_unit = [unit](const std::string& s) {
                return utf8(with_lengths_in(text(s), unit));
            };
            outcome.failure =
                text(Error(e.code(), e.where(), in_unit(e.message()), in_unit(e.remedy())).what());
        }
        work.outcomes.push_back(std::move(outcome));
    }
}

void PlanRunner::finish(Work& work, const JobEnd& end) {
    document_.set_planning({});
    const bool verify_now = std::exchange(verify_next_, false);
    if (!end.done()) return; // nothing was taken over: the states are what they were
    if (work.read_part && Document::part_key(document_.project()) == work.part.key)
        part_.show(work.part, false);
    // Operations that were removed in the meantime are forgotten.
    std::erase_if(work.outcomes, [this](const OperationOutcome& o) { return !document_.index_of(o.id); });
    if (work.before) document_.take(work.before->outcomes());
    document_.take(work.outcomes);
    // What was planned is not out of date by it.
    if (const QString change = part_.taken_change(); !change.isEmpty()) messages_.information(change);
    QStringList failures;
    if (document_.part())
        for (const std::string& warning :
             stock_warnings(document_.project().stock, *document_.part(), document_.unit()))
            messages_.warning(text(warning), false);
    for (const OperationOutcome& o : work.outcomes) {
        if (!o.result) {
            const QString name = text(document_.operation(*document_.index_of(o.id)).common().name);
            failures << (o.failure.contains(name) ? o.failure : name + QStringLiteral(": ") + o.failure);
            continue;
        }
        tell_operation(messages_, o.result, document_.unit());
    }
    if (failures.isEmpty())
        messages_.succeeded();
    else
        messages_.fail(failures.join(QChar('\n')));
    if (!work.wanted.empty()) emit planned(work.wanted.front());
    if (verify_now) verification_.verify(); // unless an operation failed: then that is what was said
}

} // namespace facetmill::ui
