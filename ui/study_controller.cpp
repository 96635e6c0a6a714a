#include "ui/study_controller.h"

#include "core/base/file.h"
#include "ui/export.h"
#include "ui/file_writing.h"
#include "ui/settings.h"
#include "ui/study_adoption.h"
#include "ui/study_chart.h"
#include "ui/study_form.h"
#include "ui/study_place.h"
#include "ui/study_sight.h"
#include "ui/study_story.h"
#include "ui/text.h"
#include "ui/verification_model.h"
#include "ui/worded.h"

#include <QFileDialog>
#include <QPushButton>
#include <QScreen>
#include <QTabWidget>
#include <functional>

#include <algorithm>
#include <system_error>

namespace facetmill::ui {

namespace fs = std::filesystem;

namespace {

constexpr int news_ms = 250, slurm_ms = 5000;
constexpr QSize picture_size(1600, 1000);
} // namespace

StudyController::StudyController(Document& document, const VerificationModel& verification, QWidget* window)
    : Controller(window), document_(document), verification_(verification), window_(window) {
    poll_.setInterval(news_ms);
    connect(&poll_, &QTimer::timeout, this, &StudyController::take_news);
    slurm_.setInterval(slurm_ms);
    connect(&slurm_, &QTimer::timeout, this, &StudyController::watch_slurm);
    connect(&job_, &BackgroundJob::ended, this, &StudyController::settled);
}

StudyController::~StudyController() {
    if (dialog_) dialog_->disconnect(this);
    delete dialog_;
}

StudyDialog* StudyController::dialog() {
    if (dialog_) return dialog_;
    dialog_ = new StudyDialog(window_);
    connect_dialog();
    dialog_->sight()->set_palette(palette_);
    return dialog_;
}

void StudyController::connect_dialog() {
    connect(dialog_->sight(), &StudySight::settled, this, &StudyController::settled);
    connect(dialog_->sight(), &StudySight::failed, this, [this](const QString& why) {
        problem_ = sentence(why);
        refresh();
    });
    connect(dialog_, &StudyDialog::start_wanted, this, &StudyController::start);
    connect(dialog_, &StudyDialog::stop_wanted, this, &StudyController::stop);
    connect(dialog_, &StudyDialog::open_wanted, this, &StudyController::ask_for_study);
    connect(dialog_, &StudyDialog::new_wanted, this, &StudyController::new_study);
    connect(dialog_, &StudyDialog::adopt_wanted, this, &StudyController::adopt);
    connect(dialog_, &StudyDialog::table_wanted, this, &StudyController::export_table);
    connect(dialog_, &StudyDialog::picture_wanted, this, &StudyController::export_picture);
    connect(dialog_, &StudyDialog::candidate_chosen, this, &StudyController::refresh);
    const auto asked_otherwise = [this] {
        problem_.clear();
        refresh();
    };
    connect(dialog_->form(), &StudyForm::changed, this, asked_otherwise);
    connect(dialog_->place(), &StudyPlaceForm::changed, this, asked_otherwise);
}

bool StudyController::busy() const {
    return job_.running() || (dialog_ && dialog_->isVisible() && dialog_->sight()->busy());
}

void StudyController::palette_changed(Palette palette) {
    palette_ = palette;
    if (dialog_) dialog_->sight()->set_palette(palette);
    refresh();
}

void StudyController::open() {
    (void)dialog();
    if (!folder_ && !job_.running() && document_.has_part()) {
        const std::string now = project_to_json(document_.project());
        if (now != drafted_) {
            drafted_ = now;
            dialog_->form()->set_draft(draft_for(document_.project()));
        }
    }
    if (!dialog_->isVisible()) {
        const QRect screen = dialog_->parentWidget()->screen()->availableGeometry();
        dialog_->resize(dialog_->sizeHint().boundedTo(screen.size() - QSize(0, 40)));
    }
    dialog_->show();
    dialog_->raise();
    dialog_->activateWindow();
    refresh();
}

void StudyController::project_opened() {
    // One that is open stays, so that its project can be opened to take over what it found.
    if (dialog_ && !running_ && !folder_) new_study();
}

void StudyController::new_study() {
    if (running_) return;
    job_.cancel();
    slurm_.stop();
    handed_.clear();
    source_ = {};
    folder_ = nullptr;
    problem_.clear();
    drafted_.clear();
    dialog_->show_title({}, {});
    dialog_->show_question({});
    take(nullptr);
    dialog_->pages()->setCurrentIndex(0);
    if (document_.has_part()) {
        drafted_ = project_to_json(document_.project());
        dialog_->form()->set_draft(draft_for(document_.project()));
    }
    refresh();
}

void StudyController::ask_for_study() {
    QFileDialog dialog(dialog_, tr("Open study"), settings::last_folder(),
                       tr("Studies (*.study.json request.json)") + QStringLiteral(";;")
                           + tr("All files (*)"));
    dialog.setFileMode(QFileDialog::ExistingFile);
    if (dialog.exec() != QDialog::Accepted || dialog.selectedFiles().isEmpty()) return;
    open_study(dialog.selectedFiles().front());
}

void StudyController::open_study(const QString& path) {
    if (running_) return;
    (void)dialog();
    const fs::path named = path_of(path);
    std::error_code ec;
    Source source;
    if (named.filename() == "request.json")
        source.folder = named.parent_path();
    else if (fs::is_directory(named, ec))
        source.folder = named;
    else
        source.file = named;
    new_study();
    source_ = source;
    dialog_->show_title(path_text(named.filename()), path);
    auto opened = std::make_shared<StudyLookPtr>();
    job_.start(
        tr("Opening the study"),
        [opened, source](const Progress& p) {
            *opened = look_into(open_study_folder(source.file, source.folder, false), p);
        },
        [this, opened](const JobEnd& end) {
            if (end.how == JobEnd::How::failed) problem_ = sentence(end.message);
            if (!end.done()) return refresh();
            folder_ = (*opened)->folder;
            source_.folder = folder_->path();
            take(*opened);
            dialog_->show_question(study_question_html(*folder_));
            dialog_->pages()->setCurrentIndex(1);
            if (look_->outcome.decision.winner) dialog_->choose(*look_->outcome.decision.winner);
        });
    refresh();
}

/// The study's file from the form, beside the project. False where that does not work.
bool StudyController::write_file() {
    if (document_.project().path.empty() || document_.modified()) emit save_wanted();
    if (document_.project().path.empty() || document_.modified()) {
        problem_ = tr("A study works on the project as it is saved: save it first.");
        return false;
    }
    try {
        const fs::path project = document_.project().path;
        const std::string content = dialog_->form()->draft().json(project.filename().string());
        const fs::path file = free_study_file(project, content);
        OutputFile out(file);
        out.write(content);
        out.commit();
        source_ = {};
        source_.file = file;
    } catch (const Error& e) {
        problem_ = sentence(worded(e));
        return false;
    }
    dialog_->show_title(path_text(source_.file.filename()), path_text(source_.file));
    return true;
}

void StudyController::start() {
    if (job_.running()) return;
    problem_ = dialog()->place()->problem();
    if (!problem_.isEmpty()) return refresh();
    const bool asked_here = source_.file.empty() && source_.folder.empty();
    if (asked_here && !write_file()) return refresh();
    const StudyPlace place = dialog_->place()->place();
    if (place.where == StudyPlace::Where::slurm)
        run_on_slurm(!folder_, place);
    else
        run(!folder_, place);
}

void StudyController::run(bool make, const StudyPlace& place) {
    running_ = true;
    news_ = std::make_shared<StudyNews>();
    auto found = std::make_shared<StudyLookPtr>();
    job_.start(
        tr("Working on the study"),
        [found, make, place, source = source_, news = news_](const Progress& p) {
            *found = carry_out(open_study_folder(source.file, source.folder, make), place, *news, p);
        },
        [this, found](const JobEnd& end) { this->end(*found, end); });
    poll_.start();
    dialog_->pages()->setCurrentIndex(1);
    refresh();
}

void StudyController::run_on_slurm(bool make, const StudyPlace& place) {
    struct Handed {
        StudyLookPtr look;
        std::optional<SlurmStep> step;
    };
    auto handed = std::make_shared<Handed>();
    running_ = true;
    job_.start(
        tr("Handing the study over"),
        [handed, make, source = source_, workers = place.workers](const Progress& p) {
            const auto folder = open_study_folder(source.file, source.folder, make);
            handed->step = hand_over(*folder, workers, p.part(0, 0.8));
            handed->look = look_into(folder, p.part(0.8, 1));
        },
        [this, handed](const JobEnd& end) {
            if (end.done() && handed->step) {
                handed_ = tr("Step %1 is with Slurm, jobs %2 and %3.")
                              .arg(handed->step->number)
                              .arg(text(handed->step->array), text(handed->step->gather));
                slurm_.start();
            }
            this->end(handed->look, end);
        });
    dialog_->pages()->setCurrentIndex(1);
    refresh();
}

void StudyController::stop() {
    if (!handed_.isEmpty()) {
        // What is with Slurm goes on there: it is its user's to cancel.
        slurm_.stop();
        problem_ = tr("%1 It goes on there: scancel ends it.").arg(handed_);
        handed_.clear();
    }
    job_.cancel();
    refresh();
}

void StudyController::end(StudyLookPtr look, const JobEnd& end) {
    running_ = false;
    poll_.stop();
    take_news();
    dialog_->show_progress(-1);
    if (end.how == JobEnd::How::failed) problem_ = sentence(end.message);
    if (end.how == JobEnd::How::cancelled) problem_ = tr("Stopped. Resume goes on with what was found.");
    if (look) {
        folder_ = look->folder;
        source_.folder = folder_->path();
        dialog_->show_question(study_question_html(*folder_));
        take(std::move(look));
        if (!dialog_->chosen() && look_->outcome.decision.winner)
            dialog_->choose(*look_->outcome.decision.winner);
        if (handed_.isEmpty()) tell_outcome();
    }
    refresh();
}

void StudyController::watch_slurm() {
    if (job_.running() || !folder_) return;
    auto seen = std::make_shared<StudyLookPtr>();
    job_.start(
        tr("Looking at the study"),
        [seen, folder = folder_](const Progress& p) { *seen = look_into(folder, p); },
        [this, seen](const JobEnd& end) {
            if (!*seen || handed_.isEmpty()) return;
            take(*seen);
            if (look_->outcome.decision.missing.empty()) {
                slurm_.stop();
                handed_.clear();
                tell_outcome();
            }
            if (end.how == JobEnd::How::failed) problem_ = sentence(end.message);
            refresh();
        });
}

void StudyController::take_news() {
    if (!news_) return;
    const auto told = news_->take();
    if (!told) return;
    if (!folder_) {
        folder_ = told->look->folder;
        source_.folder = folder_->path();
    }
    take(told->look);
    dialog_->show_progress(study_share_done(told->stand));
    if (running_) dialog_->show_status(study_stand_words(told->stand), false);
}

void StudyController::take(StudyLookPtr look) {
    look_ = std::move(look);
    dialog_->show_study(look_, look_ ? study_figures(*look_) : nullptr);
    refresh();
}

/// For who looks elsewhere.
void StudyController::tell_outcome() {
    if (!dialog_->isActiveWindow())
        emit said(MessageBar::Kind::information, (look_ ? study_outcome_words(*look_) : QString()), true);
}

void StudyController::refresh() {
    if (!dialog_) return;
    const bool asks = !look_ && source_.file.empty() && source_.folder.empty();
    const QString wrong = asks ? dialog_->form()->draft().problem() : QString();
    // What was lost is asked for again.
    const bool missing = !look_ || !look_->outcome.decision.missing.empty() || !look_->outcome.lost.empty();
    const auto chosen = dialog_->chosen();
    const bool adoptable = chosen && look_ && why_not_adopted(*look_, *chosen).isEmpty();
    const bool at_work = running_ || !handed_.isEmpty();
    const bool ready = asks ? document_.has_part() && wrong.isEmpty() : missing;
    dialog_->show_can({.start = ready && !job_.running() && !at_work,
                       .stop = at_work && !(running_ && job_.cancelling()),
                       .adopt = adoptable,
                       .save = look_ != nullptr,
                       .renew = !at_work && document_.has_part() && !asks,
                       .start_text = look_ ? tr("&Resume") : tr("&Start")});
    if (asks && document_.has_part())
        dialog_->form()->show_estimate(
            wrong.isEmpty() ? study_estimate_words(dialog_->form()->draft(), document_, verification_)
                            : wrong,
            !wrong.isEmpty());
    if (running_) {
        if (job_.cancelling())
            dialog_->show_status(tr("Stopping…"), false);
        else if (!look_)
            dialog_->show_status(tr("Looking at what is known…"), false);
        return;
    }
    if (!problem_.isEmpty()) return dialog_->show_status(problem_, true);
    if (!handed_.isEmpty()) {
        std::size_t missing_looks = look_ ? look_->outcome.decision.missing.size() : 0;
        return dialog_->show_status(
            tr("%1 Looks that are missing: %2.").arg(handed_).arg(count_text(missing_looks)), false);
    }
    if (look_)
        return dialog_->show_status((look_ ? study_outcome_words(*look_) : QString()),
                                    !look_->outcome.decision.winner && !missing);
    dialog_->show_status(document_.has_part() ? QString() : tr("Nothing is open."), false);
}

void StudyController::adopt(std::size_t candidate) {
    if (!look_) return;
    const Adoption adoption = adopt_candidate_into(document_, *look_, candidate);
    problem_ = adoption.problem;
    refresh();
    if (!problem_.isEmpty()) return;
    dialog_->show_status(adoption.words, false);
    emit said(MessageBar::Kind::information, adoption.words, true);
}

/// Writes to a path what `bytes` returns, aside, and tells what came of it.
static std::function<void(const QString&)>
written_aside(QObject& owner, const Document& document, std::function<std::string()> bytes,
              std::function<void(const QString& path, const QString& wrong)> told) {
    return [&owner, &document, bytes = std::move(bytes), told = std::move(told)](const QString& path) {
        write_file(owner, document, path, bytes, [told, path](const QString& wrong) { told(path, wrong); });
    };
}

void StudyController::export_table() {
    if (!look_) return;
    const auto lines = [look = look_] { return study_csv(*look->folder, look->outcome); };
    const auto told = std::bind_front(&StudyController::report_written, this);
    export_file(dialog_, tr("Export table"), ExportFormat::table, tr("study"),
                written_aside(*this, document_, lines, told));
}

void StudyController::export_picture() {
    const auto png = [picture = dialog_->picture()->picture(picture_size)] { return png_bytes(picture); };
    const auto told = std::bind_front(&StudyController::report_written, this);
    export_file(dialog_, tr("Export picture"), ExportFormat::picture, tr("study"),
                written_aside(*this, document_, png, told));
}

} // namespace facetmill::ui
