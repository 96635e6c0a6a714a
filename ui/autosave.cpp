#include "ui/autosave.h"

#include "ui/aside.h"
#include "ui/messages.h"
#include "ui/project_files.h"
#include "ui/text.h"
#include "ui/worded.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <QLocale>
#include <QMessageBox>
#include <QPushButton>

#include <algorithm>
#include <exception>
#include <utility>

namespace facetmill::ui {

namespace {

constexpr int max_path_characters = 90;

QString moment(const QDateTime& when) {
    return QLocale().toString(when, QLocale::ShortFormat);
}

QString shown(const std::filesystem::path& path) {
    return elided(path_text(path), max_path_characters);
}

QString what_of_its_file(const KeptWork& work) {
    if (work.project().empty()) return QObject::tr("It was never saved under a name.");
    const QFileInfo own(path_text(work.project()));
    if (!own.exists())
        return QObject::tr("The project's own file, %1, is not there any more.").arg(shown(work.project()));
    if (own.lastModified() > work.when())
        return QObject::tr("The project's own file, %1, is newer: it was saved on %2. Restored, the older "
                           "state is shown, and the file stays as it is until you save.")
            .arg(shown(work.project()), moment(own.lastModified()));
    return QObject::tr("The project's own file, %1, was last saved on %2, and stays as it is until you save.")
        .arg(shown(work.project()), moment(own.lastModified()));
}

} // namespace

Autosave::Autosave(Document& document, BackgroundJob& job, ProjectFiles& files, Messages& messages,
                   QWidget* window)
    : document_(document), files_(files), messages_(messages), window_(window) {
    timer_.setSingleShot(true);
    connect(&timer_, &QTimer::timeout, this, &Autosave::keep);
    connect(&job, &BackgroundJob::started, this, &Autosave::keep);
    connect(&document_, &Document::opened, this, [this] {
        discard(); // the project that was there before
        if (restored_) place_ = std::make_shared<Place>(Place{std::move(restored_)});
        follow();
    });
    connect(&document_, &Document::changed, this, &Autosave::follow);
    connect(&document_, &Document::modified_changed, this, &Autosave::follow);
}

Autosave::~Autosave() {
    discard();
    finish_aside();
}

void Autosave::follow() {
    if (!document_.has_part() || !document_.modified()) return discard();
    due_ = true;
    if (!timer_.isActive()) timer_.start();
}

void Autosave::keep() {
    timer_.stop();
    if (!due_) return;
    due_ = false;
    if (!place_) place_ = std::make_shared<Place>();
    do_aside([this, place = place_, name = document_.name(),
              project = std::make_shared<const Project>(document_.project())] {
        QString why;
        try {
            if (!place->work) place->work = KeptWork::make();
            place->work->write(*project, name);
        } catch (const std::exception& e) {
            why = worded(std::string_view(e.what()));
        }
        QMetaObject::invokeMethod(
            this, [this, why] { why.isEmpty() ? void(told_ = false) : failed(why); }, Qt::QueuedConnection);
    });
}

void Autosave::failed(const QString& why) {
    if (!told_)
        messages_.warning(
            tr("What is not saved cannot be kept for the case of a crash: %1. Save the project.").arg(why));
    told_ = true;
    if (!document_.modified()) return;
    due_ = true;
    if (!timer_.isActive()) timer_.start(); // there may be room by then
}

void Autosave::discard() {
    timer_.stop();
    due_ = false;
    if (!place_) return;
    do_aside([place = std::exchange(place_, nullptr)] {
        if (place->work) place->work->remove();
    });
}

void Autosave::finish() {
    finish_aside();
    QCoreApplication::sendPostedEvents(this, QEvent::MetaCall);
}

bool Autosave::offer(const QString& first) {
    std::vector<std::unique_ptr<KeptWork>> all = KeptWork::abandoned();
    std::stable_partition(all.begin(), all.end(), [&](const auto& work) {
        std::error_code ec;
        return !first.isEmpty() && std::filesystem::equivalent(work->project(), path_of(first), ec);
    });
    for (auto& work : all) {
        switch (ask(*work)) {
        case Answer::restore:
            if (restore(std::move(work))) return true;
            break;
        case Answer::later:
            messages_.information(
                tr("Not restored: %1. It is offered again at the next start.").arg(path_text(work->file())),
                false);
            break;
        case Answer::discard:
            work->remove();
            break;
        }
    }
    return false;
}

Autosave::Answer Autosave::ask(const KeptWork& work) {
    QMessageBox box(QMessageBox::Question, tr("Unsaved work"),
                    tr("Facetmill ended without saving “%1”.").arg(elided(work.name(), 60)),
                    QMessageBox::NoButton, window_);
    box.setObjectName(QStringLiteral("unsaved_work"));
    box.setInformativeText(
        tr("It was kept as it stood on %1, in %2.").arg(moment(work.when()), shown(work.file())) + QChar('\n')
        + what_of_its_file(work));
    QPushButton* restore = box.addButton(tr("&Restore"), QMessageBox::AcceptRole);
    QPushButton* later = box.addButton(tr("&Not now"), QMessageBox::RejectRole);
    const QPushButton* discard = box.addButton(tr("&Discard"), QMessageBox::DestructiveRole);
    later->setToolTip(tr("It is offered again at the next start"));
    box.setDefaultButton(restore);
    box.setEscapeButton(later);
    box.exec();
    if (box.clickedButton() == discard) return Answer::discard;
    return box.clickedButton() == restore ? Answer::restore : Answer::later;
}

bool Autosave::restore(std::unique_ptr<KeptWork> work) {
    const QString name = work->name(), when = moment(work->when()), file = path_text(work->file());
    try {
        Project project = work->read();
        restored_ = std::move(work);
        files_.restore(std::move(project), name);
    } catch (const Error& e) {
        messages_.fail(worded(e));
        return false;
    }
    messages_.information(tr("Restored “%1” as it stood on %2. Save it: until then it is kept in %3.")
                              .arg(elided(name, 60), when, file));
    return true;
}

} // namespace facetmill::ui
