#include "ui/plan_runner.h"

#include "core/job/stock_solid.h"
#include "core/job/work_estimate.h"
#include "ui/messages.h"
#include "ui/part_controller.h"
#include "ui/properties_panel.h"
#include "ui/text.h"
#include "ui/verification_controller.h"

#include <QMessageBox>
#include <QPushButton>

namespace facetmill::ui {

/// One planning job: what it plans from, and what it came to.
struct PlanRunner::Work {
    Project project;
    std::vector<std::size_t> wanted; ///< places of the operations
    std::vector<int> ids;            ///< their ids in the document
    std::vector<OperationOutcome> outcomes;
    LoadedPart part; ///< only when the part had to be read again
    bool read_part = false;
};

PlanRunner::PlanRunner(Document& document, std::shared_ptr<Planner> planner, BackgroundJob& job,
                       Messages& messages, PartController& part, PropertiesPanel& properties,
                       VerificationController& verification, QObject* window)
    : QObject(window), document_(document), planner_(std::move(planner)), job_(job), messages_(messages),
      part_(part), properties_(properties), verification_(verification) {}

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
    if (!may_be_large(*work)) return;
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

/// A slip by some zeros would take all memory and the rest of the day.
bool PlanRunner::may_be_large(const Work& work) {
    if (!document_.part()) return true;
    QStringList large;
    try {
        check_project(work.project);
        for (const std::size_t i : work.wanted)
            for (const WorkEstimate& e :
                 estimate_plan(work.project, *document_.part(), work.project.operations[i]->common().name))
                if (e.large()) large << tr("%1: %2").arg(text(e.what), text(e.text()));
    } catch (const Error&) {
        return true; // planning says it
    }
    if (large.isEmpty()) return true;
    QMessageBox box(QMessageBox::Question, tr("Plan that much?"),
                    tr("This is more work than usual: a tolerance or a step-over may be too small."),
                    QMessageBox::Cancel, qobject_cast<QWidget*>(parent()));
    box.setInformativeText(large.join(QChar('\n')));
    const QAbstractButton* go_on = box.addButton(tr("Plan anyway"), QMessageBox::AcceptRole);
    box.setDefaultButton(QMessageBox::Cancel);
    box.exec();
    return box.clickedButton() == go_on;
}

void PlanRunner::run(Work& work, Planner& planner, SetupPlanners& earlier, const Progress& progress) {
    double from = 0;
    if (work.read_part) {
        // A setup that goes on with the rest of another one needs the plan of that.
        if (work.project.stock.kind == StockSpec::Kind::rest) {
            check_project(work.project);
            planner.carry(stock_before(work.project, earlier, progress.part(0, 0.5)));
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
        if (!o.result->nothing_to_do.empty())
            messages_.information(tr("“%1” has nothing to do: %2.")
                                      .arg(text(o.result->name),
                                           with_lengths_in(text(o.result->nothing_to_do), document_.unit())),
                                  false);
        for (const auto& program : programs_of(o.result))
            tell_result(*program);
    }
    if (failures.isEmpty())
        messages_.succeeded();
    else
        messages_.fail(failures.join(QChar('\n')));
    if (!work.wanted.empty()) emit planned(work.wanted.front());
    if (verify_now) verification_.verify(); // unless an operation failed: then that is what was said
}

void PlanRunner::tell_result(const OperationResult& program) {
    const QString name = text(program.name);
    messages_.information(tr("Planned “%1” in %2: %3 passes, cut length %4, machining time %5.")
                              .arg(name, duration_text(program.seconds_planning),
                                   count_text(std::size_t(program.path.drive_planes)),
                                   shown_length(program.totals.cut_length, document_.unit(), 5),
                                   duration_text(program.totals.time_seconds)),
                          false);
    for (const std::string& warning : program.warnings())
        messages_.warning(name + QStringLiteral(": ") + with_lengths_in(text(warning), document_.unit()),
                          false);
}

} // namespace facetmill::ui
