#include "ui/plan_messages.h"

#include "core/job/work_estimate.h"
#include "ui/messages.h"
#include "ui/text.h"
#include "ui/worded.h"

#include <QMessageBox>
#include <QPushButton>

namespace facetmill::ui {

namespace {

void tell_program(Messages& messages, const OperationResult& program, LengthUnit unit) {
    const QString name = text(program.name);
    messages.information(QObject::tr("Planned “%1” in %2: %3 passes, cut length %4, machining time %5.",
                                     nullptr, program.path.drive_planes)
                             .arg(name, duration_text(program.seconds_planning),
                                  count_text(std::size_t(program.path.drive_planes)),
                                  shown_length(program.totals.cut_length, unit, 5),
                                  duration_text(program.totals.time_seconds)),
                         false);
    for (const std::string& warning : program.warnings())
        messages.warning(said_of(name, with_lengths_in(worded(warning), unit)), false);
}

} // namespace

QStringList large_work(const Project& project, const PreparedPart& part,
                       const std::vector<std::string>& operations) {
    QStringList large;
    try {
        check_project(project);
        for (const std::string& name : operations)
            for (const WorkEstimate& e : estimate_plan(project, part, name))
                if (e.large()) large << tr("%1: %2").arg(worded(e.what), worded(e.text()));
    } catch (const Error&) {
        return {};
    }
    return large;
}

bool may_plan(const QStringList& large, QWidget* window) {
    if (large.isEmpty()) return true;
    QMessageBox box(QMessageBox::Question, tr("Plan that much?"),
                    tr("This is more work than usual: a tolerance or a step-over may be too small."),
                    QMessageBox::Cancel, window);
    box.setInformativeText(kept_together(large.join(QChar('\n'))));
    const QAbstractButton* go_on = box.addButton(tr("Plan anyway"), QMessageBox::AcceptRole);
    box.setDefaultButton(QMessageBox::Cancel);
    box.exec();
    return box.clickedButton() == go_on;
}

void tell_operation(Messages& messages, const std::shared_ptr<const OperationResult>& operation,
                    LengthUnit unit) {
    if (!operation->nothing_to_do.empty())
        messages.information(
            tr("“%1” has nothing to do: %2.")
                .arg(text(operation->name), with_lengths_in(worded(operation->nothing_to_do), unit)),
            false);
    for (const auto& program : programs_of(operation))
        tell_program(messages, *program, unit);
}

} // namespace facetmill::ui
