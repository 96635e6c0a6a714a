#include "ui/scan_controller.h"

#include "core/job/placed_mesh.h"
#include "core/job/project_inputs.h"
#include "ui/hole_choice.h"
#include "ui/scan_rows.h"
#include "ui/scan_view.h"
#include "ui/scan_words.h"
#include "ui/settings.h"
#include "ui/text.h"

#include <QAction>
#include <QDockWidget>
#include <QFileDialog>
#include <QKeyEvent>

#include <algorithm>
#include <utility>

namespace facetmill::ui {

namespace {

/// False where the user gives up.
bool ask_for_scan(RepairStep& step, QWidget* window) {
    const QString file =
        QFileDialog::getOpenFileName(window, ScanController::tr("Scan that goes on where this one ends"),
                                     settings::last_folder(), mesh_filters());
    step.file = path_of(file).string();
    return !file.isEmpty();
}

/// What fields know by name.
NamedLengths lengths_of(const Vec3& size) {
    return {{"part.x", size.x()}, {"part.y", size.y()}, {"part.z", size.z()}};
}

} // namespace

ScanController::ScanController(Document& document, std::shared_ptr<KnownMeshes> meshes, Viewport& viewport,
                               QWidget* window)
    : Controller(window), document_(document), meshes_(std::move(meshes)), panel_(new ScanPanel(window)),
      view_(new ScanView(viewport, this)) {
    open_action_ = new QAction(tr("Scan room…"), this);
    open_action_->setData(QLatin1String(part_action));
    connect(open_action_, &QAction::triggered, this, &ScanController::open);
    connect_panel();
    panel_->show_head({}, {}, tr("Nothing is open."));
    connect(&job_, &BackgroundJob::progressed, this,
            [this](double fraction, const QString& label) { panel_->show_progress(fraction, label); });
    for (BackgroundJob* job : {&job_, &read_})
        connect(job, &BackgroundJob::ended, this, &ScanController::settled);
}

ScanController::~ScanController() = default;

void ScanController::connect_panel() {
    connect(panel_, &ScanPanel::add_wanted, this, &ScanController::add);
    connect(panel_, &ScanPanel::edited, this, &ScanController::edit);
    connect(panel_, &ScanPanel::suggest_wanted, this, &ScanController::suggest);
    connect(panel_, &ScanPanel::preview_wanted, this, &ScanController::preview);
    connect(panel_, &ScanPanel::stop_wanted, &job_, &BackgroundJob::cancel);
    connect(panel_, &ScanPanel::apply_wanted, this, &ScanController::apply);
    connect(panel_, &ScanPanel::part_chosen, view_, &ScanView::go_to);
    offer_hole_choices(
        *panel_, [this] { return scan_ && !job_.running() ? &scan_->survey.holes.holes : nullptr; }, draft_,
        [this](const std::vector<RepairStep>& recipe) { change(recipe, std::nullopt); });
    connect(panel_, &ScanPanel::step_chosen, this, [this] {
        chosen_ = panel_->chosen();
        show_steps();
        show_step();
    });
    connect(panel_, &ScanPanel::switched, this, [this](std::size_t i, bool on) {
        if (i >= draft_.size()) return;
        std::vector<RepairStep> recipe = draft_;
        recipe[i].off = !on;
        change(std::move(recipe), i);
    });
    connect(panel_, &ScanPanel::remove_wanted, this, [this] {
        if (!chosen_) return;
        std::vector<RepairStep> recipe = draft_;
        recipe.erase(recipe.begin() + std::ptrdiff_t(*chosen_));
        std::optional<std::size_t> next;
        if (!recipe.empty()) next = std::min(*chosen_, recipe.size() - 1);
        change(std::move(recipe), next);
    });
    connect(panel_, &ScanPanel::move_wanted, this, [this](int by) {
        if (!chosen_) return;
        const auto to = std::size_t(std::ptrdiff_t(*chosen_) + by);
        if (to >= draft_.size()) return;
        std::vector<RepairStep> recipe = draft_;
        std::swap(recipe[*chosen_], recipe[to]);
        change(std::move(recipe), to);
    });
    connect(panel_, &ScanPanel::side_wanted, this, [this](bool after) {
        side_ = after ? Side::after : Side::before;
        show_in_view();
        show_footer();
    });
    connect(panel_, &ScanPanel::reset_wanted, this, [this] {
        side_ = Side::none;
        job_.cancel();
        change(applied_, std::nullopt);
    });
}

void ScanController::open() {
    emit offered();
    if (auto* dock = qobject_cast<QDockWidget*>(panel_->parentWidget())) dock->raise();
    emit opened();
}

bool ScanController::busy() const {
    return job_.running() || read_.running() || view_->flying();
}

bool ScanController::take_key(const QKeyEvent& event) {
    if (event.key() != Qt::Key_Escape || !job_.running()) return false;
    job_.cancel();
    return true;
}

void ScanController::project_opened() {
    job_.cancel();
    read_.cancel();
    key_.clear();
    scan_ = nullptr;
    trial_ = known_ = nullptr;
    side_ = Side::none;
    applied_ = draft_ = document_.project().part.repair;
    chosen_.reset();
    refresh();
}

void ScanController::panel_seen(bool) {
    // Later: a dock says that it is hidden before what is in it is.
    QMetaObject::invokeMethod(
        this,
        [this] {
            seen_ = panel_->isVisible();
            refresh();
        },
        Qt::QueuedConnection);
}

/// What the history has changed, and what lies elsewhere now.
void ScanController::follow_project() {
    const auto& now = document_.project().part.repair;
    if (now != applied_) {
        if (draft_ != now) { // undone, or taken from elsewhere
            draft_ = now;
            chosen_.reset();
            side_ = Side::none;
        }
        applied_ = now;
    }
    if (const std::string place = scan_place_key(document_.project()); place != place_key_) {
        place_key_ = place;
        trial_ = nullptr; // its pictures are of another place
        side_ = Side::none;
        job_.cancel();
    }
    if (trial_ && !trial_->is_current()) {
        trial_ = known_ = nullptr;
        side_ = Side::none;
    }
}

void ScanController::refresh() {
    if (!seen_ || !document_.has_part()) {
        if (!document_.has_part()) panel_->show_head({}, {}, tr("Nothing is open."));
        return show_in_view();
    }
    follow_project();
    survey();
    if (scan_ && shown_unit_ != document_.unit()) list_survey();
    show_all();
}

void ScanController::list_survey() {
    shown_unit_ = document_.unit();
    panel_->show_survey(survey_rows(*scan_, nullptr, draft_, shown_unit_));
}

void ScanController::survey() {
    const std::string key = scan_key(document_.project());
    if (key == key_) return;
    key_ = key;
    job_.cancel();
    scan_ = nullptr;
    trial_ = known_ = nullptr;
    side_ = Side::none;
    failure_.clear();
    if (is_missing(document_.project().part_path())) {
        read_.cancel();
        failure_ = tr("The file of the part is missing.");
        return;
    }
    auto scan = std::make_shared<ScannedMeshPtr>();
    read_.start(
        tr("Looking over the part"),
        [scan, project = document_.project(), meshes = meshes_](const Progress& p) {
            *scan = read_scan(project, *meshes, p);
        },
        [this, scan, key](const JobEnd& end) {
            if (key != key_) return;
            if (end.how == JobEnd::How::cancelled) return key_.clear();
            if (!end.done()) failure_ = sentence(end.message);
            scan_ = *scan;
            if (scan_) list_survey();
            show_all();
        });
}

void ScanController::change(std::vector<RepairStep> recipe, std::optional<std::size_t> chosen) {
    draft_ = std::move(recipe);
    chosen_ = chosen;
    show_all();
}

void ScanController::add(RepairStep::Kind kind) {
    if (!scan_) return;
    RepairStep step = starting_step(kind, scan_->box, document_.unit());
    if (kind == RepairStep::Kind::join && !ask_for_scan(step, panel_)) return;
    std::vector<RepairStep> recipe = draft_;
    const std::size_t at = chosen_ ? *chosen_ + 1 : recipe.size();
    recipe.insert(recipe.begin() + std::ptrdiff_t(at), step);
    change(std::move(recipe), at);
}

void ScanController::edit(const std::string& key, const ParameterValue& value) {
    if (!chosen_ || *chosen_ >= draft_.size()) return;
    std::vector<RepairStep> recipe = draft_;
    ParameterView<RepairStep>(recipe[*chosen_], repair_step_parameters()).set(key, value);
    change(std::move(recipe), chosen_);
}

void ScanController::suggest() {
    if (!scan_) return;
    const auto& warnings = scan_->report.warnings;
    const bool inside_out = std::find(warnings.begin(), warnings.end(), "inside_out") != warnings.end();
    std::vector<RepairStep> recipe =
        suggested_recipe(*scan_->mesh, scan_->survey, inside_out, document_.unit());
    if (recipe.empty())
        emit said(MessageBar::Kind::information, tr("Nothing was found that a recipe would mend."), true);
    std::optional<std::size_t> first;
    if (!recipe.empty()) first = 0;
    change(std::move(recipe), first);
}

bool ScanController::is_tried() const {
    return trial_ && trial_->recipe == draft_ && trial_->display;
}

TriedStepPtr ScanController::tried(std::size_t i) const {
    for (const ScanTrialPtr& trial : {trial_, known_}) {
        if (!trial || i >= trial->recipe.size()) continue;
        if (std::equal(draft_.begin(), draft_.begin() + std::ptrdiff_t(i) + 1, trial->recipe.begin()))
            return trial->step(i);
    }
    return nullptr;
}

void ScanController::preview() {
    if (!scan_ || job_.running()) return;
    const std::shared_ptr<ScanTrial> trial = new_trial(document_.project(), draft_, scan_);
    const MeshPlace at = MeshPlace::of(document_.project().placed_part());
    job_.start(
        tr("Trying the recipe"),
        [trial, known = known_, unit = document_.unit(), at](const Progress& p) {
            try_recipe(
                *trial, known,
                [&at](const MeshPtr& mesh, const Progress& part) { return placed(mesh, at, part); }, unit, p);
        },
        [this, trial](const JobEnd& end) { end_preview(trial, end); });
    panel_->show_progress(0, {});
    show_footer();
}

void ScanController::end_preview(const std::shared_ptr<ScanTrial>& trial, const JobEnd& end) {
    panel_->show_progress(-1, {});
    const bool fits = scan_ && trial->before == scan_;
    if (fits && end.done()) meshes_->keep(trial->key, repaired(*trial)); // for when it is taken over
    if (fits && (!known_ || end.done() || trial->steps.size() > known_->steps.size())) known_ = trial;
    if (fits && end.how != JobEnd::How::cancelled) {
        if (end.how == JobEnd::How::failed && trial->failure.isEmpty()) trial->failure = end.message;
        trial_ = trial;
        side_ = end.done() ? Side::after : Side::none;
    }
    refresh();
}

void ScanController::apply() {
    side_ = Side::none; // the part itself is seen as soon as it is read
    show_in_view();
    document_.change(tr("Repair part"), [this](Project& p) { p.part.repair = draft_; });
}

void ScanController::show_in_view() {
    ScanSight sight;
    if (seen_ && document_.has_part()) {
        sight.scan = scan_;
        sight.recipe = draft_;
        if (is_tried() && side_ != Side::none) sight.trial = trial_;
        sight.after = side_ == Side::after;
        sight.place = MeshPlace::of(document_.project().placed_part());
    }
    view_->show(sight);
}

void ScanController::show_all() {
    const QString title = path_text(document_.project().part_path().filename());
    if (!scan_) {
        panel_->show_head(title, {},
                          failure_.isEmpty() ? tr("Looking for holes, pieces and other flaws…") : failure_);
        return show_in_view();
    }
    panel_->show_head(title, scan_size(*scan_, document_.project().part.scale != 1, document_.unit()), {});
    panel_->show_after(
        survey_rows(*scan_, is_tried() ? trial_->after.get() : nullptr, draft_, document_.unit()));
    show_footer();
    show_steps();
    show_step();
    show_in_view();
}

void ScanController::show_steps() {
    const auto& part = document_.part();
    const bool as_read = draft_ == applied_ && part && document_.part_is_current();
    std::vector<ScanPanel::Step> steps;
    std::size_t on = 0;
    for (std::size_t i = 0; i < draft_.size(); ++i) {
        const RepairStep& step = draft_[i];
        const StepReport* read = as_read && on < part->repairs.size() ? &part->repairs[on] : nullptr;
        const bool failed = trial_ && trial_->failed == i && trial_->recipe == draft_;
        steps.push_back(
            step_row(step, failed ? trial_->failure : QString(), tried(i), read, document_.unit()));
        on += !step.off;
    }
    if (chosen_ && *chosen_ >= draft_.size()) chosen_.reset();
    panel_->show_steps(steps, chosen_);
}

void ScanController::show_step() {
    if (!chosen_) {
        panel_->show_parameters(nullptr, document_.unit(), {});
        return panel_->show_remark({}, false);
    }
    RepairStep step = draft_[*chosen_];
    panel_->show_parameters(&step, document_.unit(), lengths_of(scan_->box.size()));
    const QString wrong = step_problem(draft_[*chosen_]);
    panel_->show_remark(wrong.isEmpty() ? step_remark(*scan_, draft_, *chosen_) : wrong, !wrong.isEmpty());
}

QString ScanController::summary() const {
    if (job_.running()) return {};
    if (trial_ && trial_->recipe == draft_ && !trial_->failure.isEmpty())
        return trial_->failed ? tr("Step %1 could not be carried out.").arg(*trial_->failed + 1)
                              : sentence(trial_->failure);
    if (!is_tried()) {
        if (trial_) return tr("The recipe is not the one of the preview.");
        if (draft_ == applied_ && !applied_.empty()) return tr("This recipe is in the project.");
        return {};
    }
    return trial_summary(*trial_, document_.unit());
}

void ScanController::show_footer() {
    bool valid = true;
    for (std::size_t i = 0; i < draft_.size(); ++i)
        valid = valid && step_problem(draft_[i]).isEmpty();
    const bool running = job_.running();
    const bool failed = trial_ && trial_->recipe == draft_ && !trial_->failure.isEmpty();
    const bool any = std::any_of(draft_.begin(), draft_.end(), [](const RepairStep& s) { return !s.off; });
    panel_->show_can({.edit = !running,
                      .preview = valid && any && !running && !(is_tried() && side_ != Side::none),
                      .apply = valid && !running && !failed && draft_ != applied_,
                      .reset = draft_ != applied_ || side_ != Side::none});
    std::optional<bool> after;
    if (side_ != Side::none) after = side_ == Side::after;
    panel_->show_sides(is_tried() && !running, after);
    panel_->show_summary(summary());
}

} // namespace facetmill::ui
