#include "ui/cspace_controller.h"

#include "core/base/file.h"
#include "core/job/cspace_json.h"
#include "ui/cspace_panel.h"
#include "ui/cspace_view.h"
#include "ui/cspace_words.h"
#include "ui/elided_label.h"
#include "ui/export.h"
#include "ui/file_writing.h"
#include "ui/shown_paths.h"
#include "ui/text.h"
#include "ui/worded.h"

#include <QFileInfo>
#include <QImage>
#include <QKeyEvent>
#include <QLabel>
#include <QToolButton>

#include <algorithm>
#include <cmath>
#include <functional>

namespace facetmill::ui {

namespace {

constexpr QSize cspace_picture_size(1200, 900);

std::string free_text(const CSpaceContent& content) {
    return utf8(CSpaceController::tr("%1 of %2 postures free")
                    .arg(count_text(content.free_nodes), count_text(content.block.size())));
}

} // namespace

CSpaceController::CSpaceController(Document& document, QWidget* window)
    : Controller(window), document_(document), kept_(document), panel_(new CSpacePanel(window)),
      studies_(new CSpaceStudies(this)) {
    connect(panel_, &CSpacePanel::stepped, this, &CSpaceController::step);
    connect(panel_, &CSpacePanel::cancel_requested, this, [this] { studies_->cancel_job(); });
    connect(panel_, &CSpacePanel::back_requested, this, [this] { show_choice(cspace_choices - 1); });
    connect(panel_, &CSpacePanel::keep_requested, this, &CSpaceController::keep);
    connect(panel_, &CSpacePanel::remove_requested, this, &CSpaceController::remove_kept);
    connect(panel_, &CSpacePanel::kept_chosen, this, &CSpaceController::stand_at);
    connect(panel_->view(), &CSpaceView::hovered, this, &CSpaceController::show_hover);
    connect(panel_->view(), &CSpaceView::tried, this, &CSpaceController::try_posture);
    connect(panel_->view(), &CSpaceView::choice_clicked, this, &CSpaceController::show_choice);
    connect(&studies_->job(), &BackgroundJob::started, this, [this] { panel_->set_busy(true); });
    connect(&studies_->job(), &BackgroundJob::progressed, this,
            [this](double fraction, const QString&) { panel_->set_busy(true, fraction); });
    connect(&studies_->job(), &BackgroundJob::ended, this, [this](const JobEnd& end) {
        panel_->set_busy(false);
        if (end.how == JobEnd::How::failed) emit failed(end.message);
        emit settled();
    });
    connect(panel_, &CSpacePanel::picture_requested, this, [this] {
        export_file(panel_, tr("Export configuration space"), ExportFormat::picture, export_name(),
                    std::bind_front(&CSpaceController::save_picture, this));
    });
    connect(panel_, &CSpacePanel::table_requested, this, [this] {
        export_file(panel_, tr("Export postures"), ExportFormat::table, export_name(),
                    std::bind_front(&CSpaceController::save_table, this));
    });
    connect(studies_, &CSpaceStudies::ready, this, [this] {
        if (const auto point = at_ ? studies_->known(*at_) : nullptr) show_point(point);
    });
    connect(studies_, &CSpaceStudies::given_up, this, [this] {
        if (at_ && !shown_) clear_view(tr("Not studied. Step on, or pick a point."));
    });
    clear_view(tr("Pick a point on the path of a planned 5-axis operation"));
}

CSpaceController::~CSpaceController() = default;

/// The unit, and what is kept.
void CSpaceController::project_changed() {
    panel_->view()->scene().set_unit(document_.unit());
    panel_->view()->refresh();
    show_kept();
}

void CSpaceController::tool_placed(const ShownPaths& paths, const PathPick& pick) {
    const CutterContact* contact = paths.contact_of(pick);
    const Vec3 place = contact ? contact->point : pick.location.tip;
    if (go_near(paths.ids()[pick.source], paths.programs()[pick.source], place))
        offer();
    else
        leave();
}

bool CSpaceController::take_key(const QKeyEvent& event) {
    if (!active()) return false;
    const int by = event.modifiers() & Qt::ShiftModifier ? 10 : 1;
    switch (event.key()) {
    case Qt::Key_Left:
        return step(-by, 0), true;
    case Qt::Key_Right:
        return step(by, 0), true;
    case Qt::Key_Up:
        return step(0, -1), true;
    case Qt::Key_Down:
        return step(0, 1), true;
    default:
        return false;
    }
}

void CSpaceController::clear_view(const QString& text) {
    shown_.reset();
    tried_.reset();
    CSpaceScene& scene = panel_->view()->scene();
    scene.set_content(nullptr);
    scene.set_title({});
    scene.set_empty_text(utf8(text));
    panel_->show_legend();
    panel_->readout()->setText({});
    panel_->heading()->set_text(heading());
    panel_->set_ready(at_.has_value(), false);
    panel_->view()->refresh();
    show_kept();
}

bool CSpaceController::go_near(int operation, const std::shared_ptr<const OperationResult>& result,
                               const Vec3& place) {
    const auto record = result ? result->path.five_axis() : nullptr;
    if (!record || record->points.empty()) return false;
    if (record != record_) {
        studies_->set_record(record);
        record_ = record;
        cutter_ = std::make_shared<const CutterProfile>(record->context.tool.cutter());
    }
    kept_.look_at(operation, record);
    result_ = result;
    const std::size_t index = nearest_point(*record_, place, 0, record_->points.size());
    if (at_ == index && shown_ && !tried_) return true;
    at_ = index;
    tried_.reset();
    study();
    return true;
}

void CSpaceController::leave() {
    if (!record_ && !at_) return;
    studies_->set_record(nullptr);
    record_.reset();
    result_.reset();
    at_.reset();
    kept_.look_at(-1, nullptr);
    clear_view(tr("Pick a point on the path of a planned 5-axis operation"));
}

bool CSpaceController::active() const {
    // The view, as what scrolls covers the panel itself.
    return at_ && panel_->isVisible() && !panel_->view()->visibleRegion().isEmpty();
}

std::size_t CSpaceController::point_count() const {
    return record_ ? record_->points.size() : 0;
}

void CSpaceController::step(int points, int passes) {
    if (!at_ || !record_) return;
    const auto& lines = record_->lines;
    const FiveAxisRecord::Line& line = record_->line_of(*at_);
    std::size_t next = *at_;
    if (points != 0) {
        const auto last = std::ptrdiff_t(record_->points.size()) - 1;
        next = std::size_t(std::clamp<std::ptrdiff_t>(std::ptrdiff_t(next) + points, 0, last));
    }
    if (passes != 0) {
        // The point of the other line that lies nearest.
        const auto number = std::ptrdiff_t(&line - lines.data()) + passes;
        const auto& to =
            lines[std::size_t(std::clamp<std::ptrdiff_t>(number, 0, std::ptrdiff_t(lines.size()) - 1))];
        if (&to != &line)
            next = nearest_point(*record_, record_->points[next].place.surface, to.begin, to.end);
    }
    if (next == *at_ && !tried_) return;
    stand_at(next);
}

void CSpaceController::stand_at(std::size_t index) {
    at_ = index;
    const ChosenPosture& planned = record_->points[index].choice;
    show_tool(planned.free ? std::optional(planned.posture) : std::nullopt,
              planned.free ? tr("planned") : tr("left to clean-up"));
    tried_.reset();
    study();
}

CutterLocation CSpaceController::pose(const PostureValue& posture) const {
    const ToolPose p = posture_pose(*cutter_, record_->points[*at_].place.frame, posture);
    return {p.tip, p.axis};
}

QString CSpaceController::heading() const {
    if (!at_ || !record_ || !result_) return tr("No point");
    const FiveAxisRecord::Line& line = record_->line_of(*at_);
    return tr("Pass %1, point %2 of %3 · %4")
        .arg(line.drive + 1)
        .arg(count_text(*at_ - line.begin + 1), count_text(line.end - line.begin), text(result_->name));
}

void CSpaceController::show_tool(const std::optional<PostureValue>& posture, const QString& what) {
    const ContactPlace& place = record_->points[*at_].place;
    const QString said =
        posture ? tr("%1: lead %2, yaw %3, lift %4")
                      .arg(what, posture_angle_text(posture->lead), posture_angle_text(posture->yaw),
                           lift_text(posture->delta, document_.unit()))
                : what;
    emit tool_wanted(result_, posture ? std::optional(pose(*posture)) : std::nullopt,
                     Marker{place.surface, place.frame.normal}, {heading(), said});
}

void CSpaceController::panel_seen(bool seen) {
    if (seen && at_) study();
}

void CSpaceController::study() {
    panel_->heading()->set_text(heading());
    if (const auto point = studies_->known(*at_)) {
        studies_->cancel(); // of a line that was stepped over
        show_point(point);
        return;
    }
    clear_view(tr("Looking at the pass…"));
    if (panel_->isVisible()) studies_->look_at(*at_); // else nobody sees it
}

void CSpaceController::show_point(std::shared_ptr<const FiveAxisStudy::Point> point) {
    shown_ = std::move(point);
    tried_.reset();
    auto content = std::make_shared<CSpaceContent>(CSpaceContent::of(*shown_));
    CSpaceScene& scene = panel_->view()->scene();
    scene.set_unit(document_.unit());
    panel_->heading()->set_text(heading());
    scene.set_title({}, free_text(*content));
    scene.set_content(std::move(content));
    panel_->show_legend();
    // What was kept stands in the record also where it was not free.
    const auto& wish = shown_->place.kept;
    const bool by_hand = wish && shown_->planned.free && shown_->planned.posture.lead == (*wish)[0]
                         && shown_->planned.posture.yaw == (*wish)[1];
    panel_->readout()->setText(shown_->planned.free
                                   ? (by_hand ? tr("Planned as kept: ") : tr("Planned: "))
                                         + reason_text(shown_->planned.posture, true)
                                   : tr("No posture is free: the point is left to clean-up"));
    panel_->set_ready(true, true);
    panel_->view()->refresh();
    show_kept();
}

QString CSpaceController::reason_text(const PostureValue& posture, bool with_lift) const {
    return posture_reason_text(*studies_->study(), *shown_, posture, with_lift, document_.unit());
}

bool CSpaceController::can_be_kept(const PostureValue& posture) const {
    return studies_->study()->reason(*shown_, posture.lead, posture.yaw).block == PostureBlock::free;
}

void CSpaceController::show_hover(const std::optional<CSpaceDisplay::Hit>& hit) {
    if (!shown_ || !studies_->study()) return;
    if (hit)
        panel_->readout()->setText(reason_text(hit->posture, hit->on != CSpaceDisplay::Hit::On::map));
    else if (tried_)
        panel_->readout()->setText(tr("Tried: ") + reason_text(*tried_, true));
}

void CSpaceController::try_posture(const PostureValue& posture) {
    if (!shown_ || !studies_->study()) return;
    PostureValue p = posture;
    const auto reason = studies_->study()->reason(*shown_, p.lead, p.yaw);
    if (!std::isfinite(reason.bottom)) return; // the cutter cannot touch like this
    // Within the free volume; elsewhere as low as nothing is cut.
    p.delta = reason.block == PostureBlock::free
                  ? std::clamp(p.delta, reason.bottom, std::max(reason.bottom, reason.top))
                  : reason.bottom;
    tried_ = p;
    panel_->view()->scene().set_probe(p);
    panel_->view()->refresh();
    panel_->readout()->setText(tr("Tried: ") + reason_text(p, true));
    show_tool(p, tr("tried"));
    show_kept();
}

void CSpaceController::show_choice(std::size_t choice) {
    if (!shown_) return;
    const ChosenPosture& chosen = choice + 1 < cspace_choices ? shown_->chosen[choice] : shown_->planned;
    tried_.reset();
    show_kept();
    panel_->view()->scene().set_probe(std::nullopt);
    panel_->view()->refresh();
    const QString name = worded(cspace_choice_label(choice));
    if (chosen.free) panel_->readout()->setText(said_of(name, reason_text(chosen.posture, true)));
    show_tool(chosen.free ? std::optional(chosen.posture) : std::nullopt,
              chosen.free ? name : tr("left to clean-up"));
}

std::optional<ManualPosture> CSpaceController::kept() const {
    return at_ ? kept_.at(*at_) : std::nullopt;
}

void CSpaceController::keep() {
    if (!tried_ || !shown_ || !studies_->study()) return;
    if (!record_->has_strips || !can_be_kept(*tried_)) return;
    const Vec3& place = shown_->place.surface;
    const ManualPosture posture{{place.x(), place.y(), place.z()}, tried_->lead, tried_->yaw};
    kept_.keep(*at_, posture);
    tell(tr("Kept lead %1, yaw %2 for the point. Plan again to use it.")
             .arg(posture_angle_text(posture.lead), posture_angle_text(posture.yaw)));
}

void CSpaceController::remove_kept() {
    if (at_ && kept_.remove(*at_))
        tell(tr("The posture kept for the point is forgotten. Plan again to choose one."));
}

void CSpaceController::show_kept() {
    const bool tried = tried_ && shown_ && studies_->study();
    const bool chosen_here = !record_ || record_->has_strips; // else by inclining what was planned upright
    const bool free = tried && chosen_here && can_be_kept(*tried_);
    panel_->keep()->setEnabled(free);
    panel_->keep()->setToolTip(
        !chosen_here ? tr("The tool leans as little as it has to here: postures are kept for operations that "
                          "choose them")
        : !tried     ? tr("Try a posture first: click in the configuration space, or drag a marker")
        : !free      ? tr("The tried posture is not free: it would not be used")
                     : tr("Keep the tried posture for this point; planning again uses it"));
    panel_->remove()->setEnabled(kept().has_value());
    std::vector<CSpacePanel::Kept> all;
    for (const ManualPosture& m : kept_.all()) {
        const std::size_t point = kept_.point_of(m);
        const FiveAxisRecord::Line& line = record_->line_of(point);
        all.push_back({tr("Pass %1, point %2: lead %3, yaw %4")
                           .arg(line.drive + 1)
                           .arg(count_text(point - line.begin + 1), posture_angle_text(m.lead),
                                posture_angle_text(m.yaw)),
                       point});
    }
    panel_->show_kept(all);
}

void CSpaceController::palette_changed(Palette palette) {
    panel_->view()->scene().set_palette(palette);
    panel_->show_legend();
    panel_->view()->refresh();
}

bool CSpaceController::busy() const {
    return studies_->job().running() || (panel_->isVisible() && !panel_->view()->finished());
}

void CSpaceController::save_picture(const QString& path) {
    if (!shown_) return;
    CSpaceScene& scene = panel_->view()->scene();
    const std::string free = free_text(*scene.content());
    scene.set_title(utf8(heading()), free);
    QImage picture = panel_->view()->export_picture(cspace_picture_size);
    scene.set_title({}, free);
    write_file(
        *this, document_, path, [picture = std::move(picture)] { return png_bytes(picture); },
        [this, path](const QString& wrong) { report_written(path, wrong); });
}

void CSpaceController::save_table(const QString& path) {
    if (!shown_ || !studies_->study()) return;
    write_file(
        *this, document_, path,
        [point = shown_, unit = document_.unit()] { return cspace_csv(*point, unit); },
        [this, path](const QString& wrong) { report_written(path, wrong); });
}

QString CSpaceController::export_name() const {
    return QStringLiteral("%1-point-%2")
        .arg(QFileInfo(document_.name()).completeBaseName())
        .arg(at_.value_or(0));
}

} // namespace facetmill::ui
