#include "ui/tool_controller.h"

#include "ui/path_controller.h"
#include "ui/status_line.h"
#include "ui/text.h"
#include "ui/verification_controller.h"
#include "ui/viewport.h"

#include <QKeyEvent>

#include <algorithm>

namespace facetmill::ui {

namespace {

constexpr int shown_operation = 32; ///< characters of an operation's name: what follows is what one looks for

} // namespace

ToolController::ToolController(Document& document, Viewport& viewport, const PathController& paths,
                               VerificationController& verification, StatusLine& status, QObject* window)
    : Controller(window), document_(document), viewport_(viewport), paths_(paths),
      verification_(verification), status_(status) {
    connect(&paths_, &PathController::replaced, this, &ToolController::hide);
    connect(&verification_, &VerificationController::tool_moved, this, [this](const QStringList& readout) {
        status_.set_readout(readout);
        leave_touch();
        emit settled();
    });
    connect(&verification_.playback(), &PlaybackController::moved, this, &ToolController::follow_playback);
}

const ShownPaths& ToolController::shown() const {
    return paths_.paths();
}

void ToolController::follow_playback() {
    const PlaybackController& playback = verification_.playback();
    if (!verification_.engaged() || !playback.loaded()) return;
    const PlaybackTrack& track = playback.track();
    const double position = playback.position();
    const MotionPlace at = track.place(position);
    if (const auto source = shown().source_of(track.operation(at.program).result))
        emit at_place(*source, at.motion, std::clamp(position - (track.position_of(at) - 1), 0.0, 1.0));
}

void ToolController::show_at(const PathPick& pick) {
    if (pick.source >= shown().size()) return;
    if (!shown().place_of(pick.source)) return;
    Scene& scene = viewport_.scene();
    leave_touch();
    try {
        scene.tool().set(shown().tool_of(pick.source));
        scene.tool().set_pose(pick.location);
    } catch (const Error&) {
        hide(); // the operation's tool was changed into none since it was planned
        return;
    }
    at_ = pick;
    const CutterContact* cc = shown().contact_of(pick);
    scene.marks().set_marker(cc ? std::optional(Marker{cc->point, cc->normal}) : std::nullopt);
    status_.set_readout(readout_of(pick));
    viewport_.refresh();
    emit placed(pick);
    emit at_place(pick.source, shown().motion_of(pick), 1);
}

QStringList ToolController::readout_of(const PathPick& pick) const {
    const double mm = mm_per(document_.unit());
    const int digits = document_.unit() == LengthUnit::inch ? 4 : 3;
    const auto number = [&](double v) { return in_user_numbers(QString::number(v / mm, 'f', digits)); };
    const auto place = [&](const Vec3& v) {
        return number_list({number(v.x()), number(v.y()), number(v.z())});
    };
    const QString unit = text(unit_name(document_.unit())), tip = place(pick.location.tip);
    const auto& program = shown().programs()[pick.source];
    QString name = text(program->name);
    if (const auto operation = document_.index_of(shown().ids()[pick.source]);
        operation
        && program == document_.result(*operation)) // else a further program of it, or an opened one
        name = text(document_.operation(*operation).common().name);
    QStringList parts{elided(name, shown_operation)};
    if (const CutterContact* cc = shown().contact_of(pick))
        parts << tr("pass %1, point %2").arg(pick.pass + 1).arg(pick.point + 1)
              << QStringLiteral("CC %1").arg(place(cc->point));
    return parts << QStringLiteral("CL %1 %2").arg(tip, unit);
}

void ToolController::show_motion(std::size_t source, std::size_t motion) {
    if (const auto pick = shown().pick_at(source, motion)) show_at(*pick);
}

void ToolController::step(int by) {
    if (!at_ || at_->source >= shown().size()) return;
    const auto& motions = shown().programs()[at_->source]->program.motions.motions;
    if (motions.empty()) return;
    const auto last = std::ptrdiff_t(motions.size()) - 1;
    const auto at = std::ptrdiff_t(shown().motion_of(*at_));
    show_motion(at_->source, std::size_t(std::clamp<std::ptrdiff_t>(at + by, 0, last)));
}

void ToolController::show_start() {
    if (const auto pick = paths_.start()) show_at(*pick);
}

void ToolController::paths_shown(const ShownPaths&) {
    show_start();
}

void ToolController::paths_redrawn(const std::vector<PathSource>& sources, bool keep_tool) {
    const bool stays =
        keep_tool
        && (verification_.engaged() || (at_ && sources[at_->source].shows_motion(shown().motion_of(*at_))));
    if (!stays) show_start();
}

void ToolController::show_pose(const std::shared_ptr<const OperationResult>& program,
                               const std::optional<CutterLocation>& pose, const Marker& contact,
                               const QStringList& readout) {
    const auto source = shown().source_of(program);
    if (!source || !shown().place_of(*source)) return;
    Scene& scene = viewport_.scene();
    leave_touch();
    try {
        scene.tool().set(shown().tool_of(*source));
    } catch (const Error&) {
        hide(); // the operation's tool was changed into none since it was planned
        return;
    }
    scene.tool().set_pose(pose);
    scene.marks().set_marker(contact);
    status_.set_readout(readout);
    if (pose)
        if (auto pick = shown().nearest_cut(*source, pose->tip)) {
            // Steps along the path go on from the motion that is nearest.
            pick->position = pose->tip;
            pick->location = *pose;
            at_ = pick;
            emit at_place(pick->source, pick->motion, 1);
        }
    viewport_.refresh();
}

void ToolController::show_touch(const Tool& tool, const CleanupRecord::Touch& touch) {
    Scene& scene = viewport_.scene();
    try {
        scene.tool().set(tool);
    } catch (const Error&) {
        return; // it was planned with: it makes a cutter
    }
    scene.tool().set_pose(CutterLocation{touch.tip, Vec3::UnitZ()});
    scene.marks().set_marker(Marker{touch.center, Vec3::Zero()});
    scene.marks().set_touches({touch.touch[0], touch.touch[1]});
    verification_.tool_taken();
    status_.set_readout({});
    viewport_.refresh();
}

void ToolController::end_touch() {
    leave_touch();
    if (verification_.engaged()) return;
    if (const auto pick = at_)
        show_at(*pick);
    else
        hide();
    viewport_.refresh();
}

void ToolController::leave_touch() {
    emit touch_left();
    viewport_.scene().marks().set_touches({});
}

void ToolController::hide() {
    at_.reset();
    leave_touch();
    emit removed();
    status_.set_readout({});
    viewport_.scene().tool().set(std::nullopt);
    viewport_.scene().tool().set_pose(std::nullopt);
    viewport_.scene().marks().set_marker(std::nullopt);
}

bool ToolController::take_key(const QKeyEvent& event) {
    if (!at_ || (event.key() != Qt::Key_Left && event.key() != Qt::Key_Right)) return false;
    const int by = event.modifiers() & Qt::ShiftModifier ? 10 : 1;
    step(event.key() == Qt::Key_Left ? -by : by);
    return true;
}

} // namespace facetmill::ui
