#include "ui/project_saving.h"

#include "core/base/file.h"
#include "core/job/project_inputs.h"
#include "ui/aside.h"
#include "ui/export.h"
#include "ui/messages.h"
#include "ui/properties_panel.h"
#include "ui/settings.h"
#include "ui/text.h"
#include "ui/worded.h"

#include <QEventLoop>
#include <QFileDialog>
#include <QFileInfo>
#include <QTimer>

#include <exception>
#include <utility>

namespace facetmill::ui {

namespace {

constexpr int told_after_ms = 500; ///< a disk that takes longer is worth a word

/// Copies `from` into `folder` unless the same bytes are there already; a name that is taken by other bytes
/// gets a number.
std::filesystem::path copy_beside(const std::filesystem::path& from, const std::filesystem::path& folder) {
    const InputFile source(from);
    for (int n = 1;; ++n) {
        std::filesystem::path to = folder / from.filename();
        if (n > 1)
            to.replace_filename(from.stem().string() + "-" + std::to_string(n) + from.extension().string());
        if (std::filesystem::exists(to)) {
            try {
                if (InputFile(to).bytes() == source.bytes()) return to;
            } catch (const Error&) {
                // unreadable, empty or a folder: another file that keeps its name
            }
            continue;
        }
        OutputFile out(to);
        out.write(source.bytes());
        out.commit();
        return to;
    }
}

} // namespace

struct ProjectSaving::Writing {
    Project project;
    std::filesystem::path target;
    std::filesystem::path part;
    bool takes_part = false; ///< its mesh lies among the program's own files
    std::string part_beside; ///< what the copy of that mesh is called, where one was made
    int opened = 0, changes = 0;
    QString failure; ///< why it could not be written

    /// In a thread of its own.
    void write() {
        try {
            move_project(project, target);
            if (takes_part)
                project.part.file = part_beside = copy_beside(part, target.parent_path()).filename().string();
            save_project(project, target);
        } catch (const std::exception& e) {
            failure = worded(std::string_view(e.what()));
        }
    }
};

ProjectSaving::ProjectSaving(Document& document, Messages& messages, PropertiesPanel& properties,
                             std::filesystem::path sample_folder, QWidget* window)
    : document_(document), messages_(messages), properties_(properties),
      sample_folder_(std::move(sample_folder)), window_(window) {
    connect(&document_, &Document::opened, this, [this] { ++opened_; });
    connect(&document_, &Document::changed, this, [this] { ++changes_; });
}

ProjectSaving::~ProjectSaving() {
    if (busy()) finish_aside();
}

bool ProjectSaving::save() {
    // One that has got its name a moment ago is not asked for another.
    const std::filesystem::path& path = busy() && !last_.empty() ? last_ : document_.project().path;
    return path.empty() ? save_as() : save_to(path_text(path));
}

bool ProjectSaving::save_as() {
    const QString start =
        document_.project().path.empty()
            ? settings::last_folder() + QChar('/') + document_.name() + QStringLiteral(".facetmill")
            : path_text(document_.project().path);
    const QString path = ask_project_name(window_, tr("Save project"), start);
    return !path.isEmpty() && save_to(path);
}

bool ProjectSaving::save_to(const QString& path) {
    if (!document_.has_part()) return false;
    if (!properties_.commit()) {
        messages_.warning(tr("A parameter is not valid: correct it before the project is saved."));
        return false;
    }
    const auto writing = std::make_shared<Writing>();
    writing->target = path_of(QFileInfo(path).absoluteFilePath());
    try {
        keep_program(document_, writing->target);
    } catch (const Error& e) {
        messages_.fail(worded(e));
        return false;
    }
    writing->project = document_.project();
    writing->part = writing->project.part_path();
    writing->takes_part = writing->part.parent_path() == sample_folder_ && !is_missing(writing->part);
    writing->opened = opened_;
    writing->changes = changes_;
    ++begun_;
    last_ = writing->target;
    QTimer::singleShot(told_after_ms, this, [this, writing] {
        if (busy() && last_ == writing->target)
            messages_.show(tr("Saving %1…").arg(elided(path_text(writing->target), 90)));
    });
    do_aside([this, writing] {
        writing->write();
        QMetaObject::invokeMethod(
            this, [this, writing] { end(*writing); }, Qt::QueuedConnection);
    });
    return true;
}

void ProjectSaving::end(const Writing& written) {
    --begun_;
    written_ = written.failure.isEmpty();
    if (!busy()) last_.clear();
    if (written_)
        take(written);
    else
        messages_.fail(written.failure);
    emit settled();
}

void ProjectSaving::take(const Writing& written) {
    const QString path = path_text(written.target);
    // Another project may be shown by now, or this one have been changed.
    if (written.opened == opened_) {
        Project now = document_.project();
        const bool same_part = now.part_path() == written.part;
        move_project(now, written.target);
        if (!written.part_beside.empty() && same_part) now.part.file = written.part_beside;
        const int changes = changes_;
        document_.saved(now, written.changes == changes);
        changes_ = changes; // files of other names are no change of the user's
    }
    settings::add_recent_file(path);
    settings::set_last_folder(path_text(written.target.parent_path()));
    messages_.dismiss();
    messages_.information(tr("Saved %1.").arg(path), false);
    emit saved(path);
}

bool ProjectSaving::finish() {
    while (busy()) {
        QEventLoop loop;
        connect(this, &ProjectSaving::settled, &loop, &QEventLoop::quit);
        loop.exec(QEventLoop::ExcludeUserInputEvents);
    }
    return written_;
}

QString ask_project_name(QWidget* window, const QString& title, const QString& start) {
    QFileDialog dialog(window, title, QFileInfo(start).absolutePath(),
                       QObject::tr("Facetmill projects (*.facetmill)"));
    dialog.setAcceptMode(QFileDialog::AcceptSave);
    dialog.setDefaultSuffix(QStringLiteral("facetmill")); // before the question whether to replace
    dialog.selectFile(QFileInfo(start).fileName());
    if (dialog.exec() != QDialog::Accepted || dialog.selectedFiles().isEmpty()) return {};
    return dialog.selectedFiles().front();
}

} // namespace facetmill::ui
