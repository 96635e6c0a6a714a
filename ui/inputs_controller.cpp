#include "ui/inputs_controller.h"

#include "core/job/posting.h"
#include "core/setup/machine.h"
#include "ui/messages.h"
#include "ui/settings.h"
#include "ui/text.h"
#include "ui/worded.h"

#include <QFileDialog>
#include <QFileInfo>

#include <algorithm>
#include <utility>

namespace facetmill::ui {

using InputKind = ProjectInput::Kind;

namespace {

bool is_mesh(InputKind kind) {
    return kind != InputKind::machine && kind != InputKind::post;
}

QString file_name(const ProjectInput& input) {
    return path_text(input.path.filename());
}

QString folder_name(const ProjectInput& input) {
    return path_text(input.path.lexically_normal().parent_path());
}

/// "the part's file “a.stl”".
QString named(const ProjectInput& input) {
    return QObject::tr("the %1's file “%2”").arg(worded(input_name(input.kind)), file_name(input));
}

} // namespace

InputsController::InputsController(Document& document, std::shared_ptr<Planner> planner, BackgroundJob& job,
                                   Messages& messages, PartController& part, QWidget* window)
    : Controller(window), document_(document), planner_(std::move(planner)), job_(job), messages_(messages),
      part_(part), window_(window) {
    // Later: the window says first what went wrong.
    connect(&job_, &BackgroundJob::ended, this, &InputsController::offer_for_message, Qt::QueuedConnection);
}

void InputsController::project_opened() {
    missing_.clear();
    told_.clear();
}

void InputsController::look() {
    std::vector<ProjectInput> missing = missing_inputs(document_.project());
    if (missing == missing_) return;
    missing_ = std::move(missing);
    tell();
}

QString InputsController::missing_text() const {
    const ProjectInput& first = missing_.front();
    QString all =
        sentence(tr("%1 is missing. It was looked for in %2.").arg(named(first), folder_name(first)));
    QStringList others;
    for (auto other = missing_.begin() + 1; other != missing_.end(); ++other)
        others << (folder_name(*other) == folder_name(first)
                       ? named(*other)
                       : tr("%1 (%2)").arg(named(*other), folder_name(*other)));
    if (!others.isEmpty()) all += QChar(' ') + tr("Missing too: %1.").arg(others.join(QStringLiteral(", ")));
    return all + QChar(' ') + tr("Locate it, or put it back: the rest of the project stays as it is.");
}

/// `before`: what is to be said first.
void InputsController::tell(const QString& before, bool warn) {
    if (missing_.empty()) {
        if (before.isEmpty() && !told_.isEmpty() && messages_.bar().message() == told_) messages_.dismiss();
        told_.clear();
        if (!before.isEmpty())
            messages_.tell(warn ? MessageBar::Kind::warning : MessageBar::Kind::information, before);
        return;
    }
    const QString message = (before.isEmpty() ? QString() : before + QChar(' ')) + missing_text();
    if (missing_.front().kind == InputKind::part)
        messages_.fail(message);
    else
        messages_.warning(message);
    told_ = messages_.bar().message();
    messages_.offer(locate_action());
}

MessageAction InputsController::locate_action() {
    return {tr("Locate…"), [this] { locate_with_dialog(); }};
}

void InputsController::offer_for_message() {
    const auto meant = [&](const ProjectInput& input) {
        return messages_.bar().message().contains(text(printable(input.path.string(), 400)));
    };
    if (std::any_of(missing_.begin(), missing_.end(), meant)) messages_.offer(locate_action());
}

QString InputsController::chosen_file(const QString& title, const std::filesystem::path& before,
                                      const QString& filter) const {
    // Where it was is a good place to begin, if that is there.
    const QString folder = path_text(before.lexically_normal().parent_path());
    QString path = QFileDialog::getOpenFileName(
        window_, title, QFileInfo(folder).isDir() ? folder : settings::last_folder(), filter);
    if (!path.isEmpty()) settings::set_last_folder(QFileInfo(path).absolutePath());
    return path;
}

void InputsController::locate_with_dialog() {
    if (missing_.empty()) return;
    look(); // it may be there by now
    if (missing_.empty()) return part_.reload();
    const ProjectInput first = missing_.front();
    const QString path =
        chosen_file(tr("Locate “%1”").arg(elided(file_name(first), 50)), first.path,
                    is_mesh(first.kind) ? mesh_filters() : tr("Descriptions (*.json);;All files (*)"));
    if (!path.isEmpty()) locate(path);
}

void InputsController::locate(const QString& file) {
    if (missing_.empty()) return;
    const ProjectInput asked = missing_.front();
    const std::filesystem::path path = path_of(QFileInfo(file).absoluteFilePath());
    Project candidate = document_.project();
    const std::vector<ProjectInput> others = locate_input(candidate, asked, path);
    const ProjectInput located{asked.kind, path};
    QString found = tr("Found %1 in %2.").arg(named(located), folder_name(located));
    QStringList names;
    for (const ProjectInput& other : others)
        names << named(other);
    if (!names.isEmpty())
        found += QChar(' ') + tr("Found there too: %1.").arg(names.join(QStringLiteral(", ")));
    take_located(candidate, asked, found);
}

void InputsController::take_located(const Project& candidate, const ProjectInput& asked,
                                    const QString& found) {
    try {
        if (asked.kind == InputKind::machine) project_machine(candidate);
        if (asked.kind == InputKind::post) project_post(candidate, candidate.programs.post);
    } catch (const Error& e) {
        messages_.fail(worded(e));
        messages_.offer(locate_action());
        return;
    }
    const QString step = tr("Locate %1").arg(worded(input_name(asked.kind)));
    if (Document::part_key(candidate) == Document::part_key(document_.project())) {
        // No mesh is another one.
        missing_ = missing_inputs(candidate);
        document_.change(step, [&](Project& p) { take_inputs(p, candidate); });
        tell(found);
        return;
    }
    take(candidate, step, found, asked.kind == InputKind::stock);
}

void InputsController::take(const Project& candidate, const QString& step, const QString& found,
                            bool for_stock) {
    auto loaded = std::make_shared<LoadedPart>();
    part_.begin_opening();
    job_.start(
        tr("Reading %1").arg(elided(path_text(candidate.part_path().filename()), 30)),
        [loaded, candidate, planner = planner_](const Progress& p) {
            *loaded = load_part(*planner, candidate, p);
        },
        [this, loaded, candidate, step, found, for_stock](const JobEnd& end) {
            const bool bad_stock = !loaded->stock_failure.isEmpty() && !is_missing(loaded->stock_file.path);
            const bool refused = for_stock && bad_stock;
            if (refused) messages_.fail(loaded->stock_failure);
            // What went wrong is in the bar by now.
            if ((refused || end.how == JobEnd::How::failed) && !missing_.empty())
                messages_.offer(locate_action());
            if (refused || !end.done()) return part_.end_opening();
            messages_.succeeded();
            missing_ = missing_inputs(candidate); // told with the rest
            part_.show_with_step(*loaded, step, [&](Project& p) { take_inputs(p, candidate); });
            QStringList said{found, part_.taken_change()};
            if (bad_stock) said << sentence(loaded->stock_failure);
            said.removeAll(QString());
            if (said.isEmpty())
                said << tr("“%1” is the part now: %2 facets.")
                            .arg(path_text(loaded->part_file.path.filename()),
                                 count_text(loaded->part->report.facets));
            tell(said.join(QChar(' ')), bad_stock);
            part_.end_opening();
        });
}

void InputsController::replace_part_with_dialog() {
    if (!document_.has_part()) return;
    const QString path = chosen_file(tr("Replace part"), document_.project().part_path(), mesh_filters());
    if (!path.isEmpty()) replace_part(path);
}

void InputsController::replace_part(const QString& file) {
    if (!document_.has_part()) return;
    const std::filesystem::path path = path_of(QFileInfo(file).absoluteFilePath());
    std::error_code ec;
    if (std::filesystem::equivalent(path, document_.project().part_path(), ec)) {
        messages_.information(tr("“%1” is the part already.").arg(path_text(path.filename())));
        return;
    }
    Project candidate = document_.project();
    set_input(candidate, {InputKind::part, {}}, path);
    take(candidate, tr("Replace part"), QString());
}

} // namespace facetmill::ui
