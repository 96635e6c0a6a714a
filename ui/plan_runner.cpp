#include "ui/plan_runner.h"

#include "core/job/asked_operations.h"
#include "core/job/stock_solid.h"
#include "core/job/work_estimate.h"
#include "ui/all_setups.h"
#include "ui/messages.h"
#include "ui/part_controller.h"
#include "ui/plan_messages.h"
#include "ui/properties_panel.h"
#include "ui/setup_results.h"
#include "ui/text.h"
#include "ui/verification_controller.h"
#include "ui/worded.h"

#include <numeric>

namespace facetmill::ui {

/// One planning job: what it plans from, and what it came to.
struct PlanRunner::Work {
    Project project;
    std::vector<std::size_t> wanted;    ///< places of the operations
    std::vector<int> ids;               ///< their ids in the document
    std::optional<SetupResults> before; ///< what is planned of others, where their stock is asked for
    LoadedPart part;                    ///< all of it only when the part had to be read again
    bool read_part = false;
    // In the window's thread.
    bool part_shown = false, before_taken = false;
    QStringList planned, failures; ///< names; what failed, in words
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

void PlanRunner::verify(std::optional<std::size_t> up_to) {
    if (job_.running() || !document_.has_part()) return;
    if (properties_.commit() && verification_.can_verify(up_to)) {
        messages_.dismiss();
        verification_.verify(up_to);
        return;
    }
    if (up_to) {
        std::vector<std::size_t> wanted;
        for (std::size_t i = 0; i <= *up_to && i < document_.operation_count(); ++i)
            if (!document_.is_off(i)) wanted.push_back(i);
        start(wanted);
    } else {
        plan(); // or says why it cannot
    }
    verify_next_ = job_.running();
    verify_to_ = up_to;
}

void PlanRunner::plan(std::optional<std::size_t> only) {
    std::vector<std::size_t> wanted;
    for (std::size_t i = 0; i < document_.operation_count(); ++i)
        if (only ? *only == i : !document_.is_off(i)) wanted.push_back(i);
    start(wanted);
}

void PlanRunner::start(const std::vector<std::size_t>& wanted) {
    if (job_.running() || !document_.has_part()) return;
    if (!properties_.commit()) {
        messages_.warning(tr("A parameter is not valid: correct it, then plan."));
        return;
    }
    emit about_to_plan();
    if (wanted.empty()) {
        messages_.warning(document_.operation_count() > 0
                              ? tr("All operations are switched off: switch one on in its menu.")
                              : tr("There is no operation to plan: add one below the project tree."));
        return;
    }
    auto work = std::make_shared<Work>();
    work->project = document_.project();
    work->wanted = wanted;
    std::vector<std::string> names;
    for (const std::size_t i : wanted) {
        work->ids.push_back(document_.operation_id(i));
        names.push_back(work->project.operations[i]->common().name);
    }
    work->read_part = !document_.part_is_current() || !document_.has_stock();
    if (work->read_part && work->project.stock.kind == StockSpec::Kind::rest) work->before.emplace(document_);
    if (document_.part()
        && !may_plan(large_work(work->project, *document_.part(), names), qobject_cast<QWidget*>(parent())))
        return;
    messages_.dismiss();
    if (!work->read_part) work->part.part = document_.part();
    document_.show_program(nullptr);
    document_.set_planning(work->ids);
    job_.start(
        tr("Planning"),
        [this, work, planner = planner_, earlier = earlier_](const Progress& progress) {
            run(*work, *planner, *earlier, progress, [this, work](const OperationOutcome& outcome) {
                // Comes to the window before the end of the job does.
                QMetaObject::invokeMethod(
                    this, [this, work, outcome] { take(*work, outcome); }, Qt::QueuedConnection);
            });
        },
        [this, work](const JobEnd& end) { finish(*work, end); });
}

namespace {

/// Shares of the time that operations will take, as far as that can be told before; they sum up to 1.
std::vector<double> shares_of(const Project& project, const PreparedPart* part,
                              const std::vector<std::string>& names) {
    /// Of an operation that is estimated at nothing, of the mean: indexing, links and what an estimate
    /// forgets.
    constexpr double least = 0.1;
    std::vector<double> shares(names.size(), 1.0);
    for (std::size_t k = 0; part && k < names.size(); ++k) {
        const std::vector<WorkEstimate> estimates = estimate_plan(project, *part, names[k]);
        if (!estimates.empty()) shares[k] = std::max(estimates.front().seconds, 1e-6);
    }
    double sum = std::accumulate(shares.begin(), shares.end(), 0.0);
    for (double& share : shares)
        share += least * sum / double(shares.size());
    sum *= 1 + least;
    for (double& share : shares)
        share /= sum;
    return shares;
}

/// In the words of a message; names stay as they are, a parameter is called as in the form.
QString planning_failure(const Error& e, const Operation& operation, LengthUnit unit) {
    std::string where = e.where();
    const std::size_t colon = where.rfind(": "), begin = colon == std::string::npos ? 0 : colon + 2;
    if (const std::string key = where.substr(begin); operation.has(key))
        where.replace(begin, key.size(), operation.parameter(key).label);
    return with_lengths_in(worded(Error(e.code(), where, e.message(), e.remedy())), unit);
}

} // namespace

void PlanRunner::run(Work& work, Planner& planner, SetupPlanners& earlier, const Progress& progress,
                     const std::function<void(const OperationOutcome&)>& planned) {
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
    std::vector<std::string> names;
    for (const std::size_t i : work.wanted)
        names.push_back(work.project.operations[i]->common().name);
    const double rest = 1 - from;
    const std::vector<double> shares = shares_of(work.project, work.part.part.get(), names);
    for (std::size_t k = 0; k < work.wanted.size(); ++k) {
        const double to = k + 1 < work.wanted.size() ? from + rest * shares[k] : 1.0;
        OperationOutcome outcome;
        outcome.id = work.ids[k];
        outcome.fingerprint = Document::fingerprint(work.project, work.wanted[k]);
        progress.task(task_text(names[k], k, names.size()));
        try {
            const auto result = planner.plan(work.project, names[k], progress.part(from, to));
            outcome.result = result->operations.empty() ? result->idle.at(0) : result->operations.front();
        } catch (const Error& e) {
            // The other operations may still be planned.
            outcome.failure =
                planning_failure(e, *work.project.operations[work.wanted[k]], work.project.unit);
        }
        planned(outcome);
        from = to;
    }
}

void PlanRunner::take(Work& work, const OperationOutcome& outcome) {
    const auto place = document_.index_of(outcome.id);
    if (!place) return; // removed in the meantime
    if (work.read_part && !std::exchange(work.part_shown, true)
        && Document::part_key(document_.project()) == work.part.key)
        part_.show(work.part, false);
    if (work.before && !std::exchange(work.before_taken, true)) document_.take(work.before->outcomes());
    document_.take({outcome});
    const QString name = text(document_.operation(*place).common().name);
    if (outcome.result) {
        work.planned << name;
        tell_operation(messages_, outcome.result, document_.unit());
    } else {
        work.failures << (outcome.failure.contains(name) ? outcome.failure : said_of(name, outcome.failure));
    }
}

void PlanRunner::finish(Work& work, const JobEnd& end) {
    document_.set_planning({});
    const bool verify_now = std::exchange(verify_next_, false);
    const auto verify_to = std::exchange(verify_to_, std::nullopt);
    // What was planned is not out of date by it.
    if (!work.planned.isEmpty() || end.done())
        if (const QString change = part_.taken_change(); !change.isEmpty()) messages_.information(change);
    if (!end.done()) {
        if (end.how == JobEnd::How::cancelled && !work.planned.isEmpty())
            messages_.information(tr("What was planned before is kept: %1.").arg(some_of(work.planned)));
        return; // the states of all others are what they were
    }
    if (document_.part())
        for (const std::string& warning :
             stock_warnings(document_.project().stock, *document_.part(), document_.unit()))
            messages_.warning(worded(warning), false);
    if (work.failures.isEmpty())
        messages_.succeeded();
    else
        messages_.fail(work.failures.join(QChar('\n')));
    if (!work.wanted.empty()) emit planned(work.wanted.front());
    if (verify_now) verification_.verify(verify_to); // unless an operation failed: then that is what was said
}

} // namespace facetmill::ui
