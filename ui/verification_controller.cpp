#include "ui/verification_controller.h"

#include "core/job/stock_solid.h"
#include "core/job/verification.h"
#include "core/setup/machine.h"
#include "ui/camera_flight.h"
#include "ui/layer_bar.h"
#include "ui/playback_bar.h"
#include "ui/setup_list.h"
#include "ui/shown_paths.h"
#include "ui/text.h"
#include "ui/verdict_advice.h"
#include "ui/verification_panel.h"
#include "ui/verification_run.h"
#include "ui/viewport.h"
#include "ui/worded.h"

#include <QKeyEvent>

#include <algorithm>
#include <cmath>
#include <utility>

namespace facetmill::ui {

namespace {

/// Triangles of the stock in motion and at rest: what a graphics card draws many times a second, and what a
/// processor in its place does.
constexpr double card_triangles = 1.5e6, processor_triangles = 3e4, resting_triangles = 1.5e6;
constexpr double cutter_share = 1.0 / 20; ///< share of the smallest cutter's radius: finer shows nothing more

/// The lattice whose surface has about so many triangles, about 2.4 to a square of it.
double resolution_for(const Box3& box, double triangles, double finest) {
    const Vec3 s = box.size();
    const double area = 2 * (s.x() * s.y() + s.y() * s.z() + s.z() * s.x());
    return std::max(finest, std::sqrt(2.4 * area / triangles));
}

struct PlaybackInput {
    std::shared_ptr<const PlanResult> plan;
    std::vector<VerifyProgram> programs;
};

StockPlayer::Source source_of(const std::shared_ptr<const PlaybackInput>& input, double triangles,
                              double finest) {
    return [=](const Progress& progress) {
        const StockSolid& solid = input->plan->stock;
        return std::make_unique<StockPlayback>(solid, input->programs,
                                               resolution_for(solid.box, triangles, finest), progress);
    };
}

} // namespace

VerificationController::VerificationController(Document& document, Viewport& viewport, LayerBar& layers,
                                               BackgroundJob& job, QWidget* window)
    : Controller(window), document_(document), viewport_(viewport), layers_(layers), job_(job),
      model_(document), display_(viewport, playback_) {
    panel_ = new VerificationPanel(document_, model_, window);
    bar_ = new PlaybackBar(playback_, window);
    bar_->hide();
    flight_ = new CameraFlight(viewport_);
    connect(&model_, &VerificationModel::changed, this, &VerificationController::show_results);
    connect(panel_, &VerificationPanel::verify_requested, this, &VerificationController::verify_requested);
    connect(panel_, &VerificationPanel::verify_all_requested, this,
            &VerificationController::verify_all_requested);
    connect(panel_, &VerificationPanel::finding_chosen, this, &VerificationController::go_to_finding);
    connect(panel_, &VerificationPanel::range_edited, this, [this](double low, double high) {
        own_range_ = {low, high};
        DeviationScale scale = viewport_.scene().deviation().scale();
        scale.low = low;
        scale.high = high;
        use_scale(scale);
    });
    connect(panel_, &VerificationPanel::range_reset, this, [this] {
        own_range_.reset();
        if (model_.any()) use_scale(default_scale(model_.verification(), document_.unit()));
    });
    connect(&playback_, &PlaybackController::loaded_changed, this, [this] {
        engaged_ = false;
        display_.forget_tool();
        bar_->setVisible(playback_.loaded());
    });
    connect(&playback_, &PlaybackController::moved, this, &VerificationController::show_playback);
    connect(&playback_, &PlaybackController::playing_changed, this, [this] {
        if (playback_.playing()) emit played();
        show_playback();
    });
    connect(&playback_, &PlaybackController::failed, this,
            [this](const QString& why) { emit said(MessageBar::Kind::error, sentence(why), true); });
}

VerificationController::~VerificationController() = default;

bool VerificationController::can_verify(std::optional<std::size_t> up_to) const {
    return can_judge(document_, up_to);
}

void VerificationController::verify(std::optional<std::size_t> up_to, bool anyway) {
    if (!can_verify(up_to) || job_.running()) return;
    const auto plan = plan_as_it_stands(document_, up_to);
    const std::shared_ptr<VerificationOutcome> outcome = outcome_to_be(document_, *plan, up_to);
    auto project = std::make_shared<Project>(document_.project());
    job_.start(
        tr("Verifying"),
        [outcome, project, plan, programs = programs_as_they_stand(document_, plan),
         anyway](const Progress& progress) { judge(*outcome, *project, plan, programs, anyway, progress); },
        [this, outcome, up_to](const JobEnd& end) {
            if (!end.done()) return;
            if (outcome->not_begun.empty())
                take({outcome});
            else
                emit not_begun(not_begun_message(outcome->not_begun, document_.project()), up_to);
        });
}

void VerificationController::take(const std::vector<std::shared_ptr<const VerificationOutcome>>& outcomes) {
    for (const auto& outcome : outcomes)
        model_.take(outcome);
    for (const auto& outcome : outcomes)
        tell(*outcome, outcomes.size() > 1);
    emit verified();
}

void VerificationController::tell(const VerificationOutcome& outcome, bool one_of_several) {
    const Verification& v = *outcome.verification;
    const QString from = one_of_several && !outcome.chain.empty()
                             ? tr("From setup “%1”: ").arg(text(outcome.chain.front().project.name))
                             : QString();
    const QString advice = verdict_advice(v, document_.project()).text;
    emit said(v.passed() ? MessageBar::Kind::information : MessageBar::Kind::warning,
              from + verdict_message(outcome, document_.unit())
                  + (advice.isEmpty() ? QString() : QChar(' ') + advice),
              true);
    for (const std::string& remark : v.remarks)
        emit said(MessageBar::Kind::information, with_lengths_in(sentence(worded(remark)), document_.unit()),
                  false);
}

QString VerificationController::doubt() const {
    switch (model_.verdict()) {
    case Verdict::verified:
        if (const QString last = model_.last_judged(); !last.isEmpty())
            return tr("Only what is cut up to “%1” has been verified.").arg(last);
        return {};
    case Verdict::failed:
        return tr("The path failed verification: %1.").arg(model_.failure_text());
    case Verdict::not_judged:
        return tr("The path cannot be judged: %1.").arg(model_.failure_text());
    case Verdict::stale:
        return tr("The path has not been verified since the project was changed.");
    case Verdict::none:
        break;
    }
    return tr("The path has not been verified.");
}

bool VerificationController::busy() const {
    return (playback_.follow() && playback_.behind()) || flight_->flying();
}

void VerificationController::follow_plan() {
    std::vector<std::string> key;
    std::vector<std::shared_ptr<const OperationResult>> results;
    std::vector<int> ids;
    const std::shared_ptr<const OpenedProgram>& opened = document_.program();
    if (can_verify() && opened) {
        key.push_back(Document::part_key(document_.project()) + project_to_json(document_.project()));
        results = opened->operations;
    } else if (can_verify())
        for (std::size_t i = 0; i < document_.operation_count(); ++i) {
            if (document_.is_off(i)) continue;
            key.push_back(Document::fingerprint(document_.project(), i));
            results.push_back(document_.result(i));
            ids.push_back(document_.operation_id(i));
        }
    if (key == track_key_ && results == track_results_) return;
    track_key_ = key;
    track_results_ = results;
    if (results.empty()) {
        playback_.load(nullptr, {}, {});
        return;
    }
    auto input = std::make_shared<PlaybackInput>();
    input->plan = plan_as_it_stands(document_);
    input->programs = programs_as_they_stand(document_, input->plan);
    std::vector<PlaybackTrack::Operation> operations;
    double radius = infinity;
    for (std::size_t i = 0; i < results.size(); ++i)
        for (const auto& program : programs_of(results[i])) {
            PlaybackTrack::Operation o{opened ? -1 - int(i) : ids[i],
                                       program->name,
                                       {},
                                       program,
                                       input->programs[operations.size()].turning};
            if (opened)
                o.tool = opened->tools[i];
            else if (const auto at = document_.index_of(ids[i]))
                o.accelerations = document_.operation(*at).accelerations();
            for (const Tool& t : document_.project().tools)
                if (!opened && t.number == program->program.tool_number) o.tool = t;
            if (o.tool) radius = std::min(radius, o.tool->diameter / 2);
            operations.push_back(std::move(o));
        }
    const double finest = std::isfinite(radius) ? cutter_share * radius : 0.0;
    const double live = viewport_.without_card() ? processor_triangles : card_triangles;
    playback_.load(
        std::make_shared<PlaybackTrack>(std::move(operations), project_machine(document_.project())),
        source_of(input, live, finest),
        live < resting_triangles ? source_of(input, resting_triangles, finest) : StockPlayer::Source());
    if (const auto which = std::exchange(wanted_finding_, {});
        which && model_.any() && *which < model_.findings().size())
        go_to_finding(*which);
}

void VerificationController::show_results() {
    Scene& scene = viewport_.scene();
    const JudgedSetup* setup = model_.fits_part() ? model_.shown_setup() : nullptr;
    const DeviationDisplayPtr display = setup ? setup->display : nullptr;
    if (display.get() != shown_deviation_) {
        shown_deviation_ = display.get();
        scene.deviation().set(display);
        std::vector<FindingMark> marks;
        if (display) marks = finding_marks(model_.verification());
        for (FindingMark& mark : marks)
            mark.point = setup->frame(mark.point);
        scene.findings().set(marks);
        viewport_.content_changed();
        if (display) {
            DeviationScale scale = display->scale;
            if (own_range_) std::tie(scale.low, scale.high) = *own_range_;
            use_scale(scale);
        }
    }
    scene.deviation().set_note(setup && !model_.current() ? utf8(tr("out of date")) : std::string());
    viewport_.refresh();
}

void VerificationController::use_scale(const DeviationScale& scale) {
    viewport_.scene().deviation().set_scale(scale);
    panel_->set_scale(scale);
    viewport_.refresh();
}

void VerificationController::plan_changed() {
    follow_plan();
}

void VerificationController::layers_toggled() {
    playback_.set_follow(engaged_ && layers_.shown(ViewLayer::stock));
}

void VerificationController::show_playback() {
    if (!playback_.loaded()) {
        display_.show_stock();
        return;
    }
    const bool moved = (playback_.target() > 0 && !playback_.put_by_others()) || playback_.playing();
    if (moved && !engaged_) {
        engaged_ = true;
        layers_toggled(); // the stock follows from now on
    }
    display_.show_stock();
    if (!engaged_ || playback_.put_by_others()) return; // who put the tool there shows it
    const PlaybackTrack& track = playback_.track();
    const double position = playback_.position();
    const MotionPlace at = track.place(position);
    Scene& scene = viewport_.scene();
    display_.show_tool(bar_->turns_part(), flight_->flying());
    if (!from_finding_ && marked_at_ != playback_.target()) {
        marked_at_.reset();
        scene.marks().set_marker(std::nullopt);
    }
    viewport_.refresh();
    const CutterLocation tool = playback_.tool();
    const double mm = mm_per(document_.unit());
    const int digits = document_.unit() == LengthUnit::inch ? 4 : 3;
    const auto number = [&](double v) { return in_user_numbers(QString::number(v / mm, 'f', digits)); };
    emit tool_moved({text(track.operation(at.program).name), QStringLiteral("GOTO %1").arg(at.motion + 1),
                     QStringLiteral("CL %1 %2")
                         .arg(number_list({number(tool.tip.x()), number(tool.tip.y()), number(tool.tip.z())}),
                              text(unit_name(document_.unit())))});
}

void VerificationController::show_stock_after(std::size_t operation) {
    if (!playback_.loaded() || operation >= document_.operation_count()) return;
    const PlaybackTrack& track = playback_.track();
    std::size_t last = track.operation_count();
    for (std::size_t i = 0; i < track.operation_count(); ++i)
        if (track.operation(i).id == document_.operation_id(operation) && track.motions_of(i) > 0) last = i;
    if (last == track.operation_count()) return;
    playback_.pause();
    display_.forget_tool();
    engaged_ = true;
    playback_.go_to(MotionPlace{last, track.motions_of(last) - 1});
    emit played();
}

void VerificationController::node_chosen(const std::optional<TreeNode>& node) {
    if (node && node->kind == TreeNode::Kind::stock_after) show_stock_after(node->index);
}

void VerificationController::tool_placed(const ShownPaths& paths, const PathPick& pick) {
    const auto& program = paths.programs()[pick.source];
    const std::size_t motion = pick.motion;
    if (!engaged_ || !playback_.loaded()) return;
    const PlaybackTrack& track = playback_.track();
    std::size_t at = 0;
    while (at < track.operation_count() && track.operation(at).result != program)
        ++at;
    if (at == track.operation_count() || motion >= track.motions_of(at)) return;
    display_.forget_tool(); // another one showed the tool
    playback_.pause();
    playback_.go_to(MotionPlace{at, motion});
}

void VerificationController::go_to_finding(std::size_t which) {
    const JudgedProgram* program = nullptr;
    if (const MotionPlace by = model_.findings()[which].by;
        by.known() && by.program < model_.outcome().programs.size())
        program = &model_.outcome().programs[by.program];
    // Where another setup made it, it is seen there, once its part has been read.
    wanted_finding_.reset();
    if (program && model_.current()) {
        const std::size_t place = model_.outcome().setups[program->setup].place;
        if (place != chosen_setup(document_.project())) {
            wanted_finding_ = which;
            choose_setup(document_, place);
            return;
        }
    }
    const Finding finding = model_.findings()[which];
    Scene& scene = viewport_.scene();
    if (model_.current() && program && playback_.loaded()
        && program->index < playback_.track().operation_count()) {
        playback_.pause();
        from_finding_ = true;
        playback_.go_to(MotionPlace{program->index, finding.by.motion});
        layers_.set_shown(ViewLayer::tool, true);
        from_finding_ = false;
        marked_at_ = playback_.target();
    }
    const double across = model_.outcome().across;
    scene.marks().set_marker(Marker{finding.place, finding.normal});
    flight_->fly_to(scene.camera().place_to_see(finding.place, finding.normal, 0.15 * across));
    viewport_.refresh();
    if (program && !model_.outcome().program) emit operation_meant(program->id);
}

bool VerificationController::take_key(const QKeyEvent& event) {
    if (!playback_.loaded()) return false;
    const bool shift = event.modifiers() & Qt::ShiftModifier;
    switch (event.key()) {
    case Qt::Key_Space:
        if (event.isAutoRepeat()) return true;
        playback_.toggle();
        return true;
    case Qt::Key_Comma:
    case Qt::Key_Period:
        playback_.step(event.key() == Qt::Key_Comma ? -1 : 1);
        emit played();
        return true;
    case Qt::Key_Left:
    case Qt::Key_Right:
        if (!engaged_) return false;
        playback_.step((event.key() == Qt::Key_Left ? -1 : 1) * (shift ? 10 : 1));
        return true;
    case Qt::Key_Up:
    case Qt::Key_Down:
        return engaged_; // the arrows are the playback's
    default:
        return false;
    }
}

bool VerificationController::eventFilter(QObject* watched, QEvent* event) {
    // Lists would take these keys for a search among their rows.
    if (event->type() == QEvent::KeyPress) {
        const auto& key = *static_cast<QKeyEvent*>(event);
        const bool ours =
            key.key() == Qt::Key_Space || key.key() == Qt::Key_Comma || key.key() == Qt::Key_Period;
        if (ours && take_key(key)) return true;
    }
    return Controller::eventFilter(watched, event);
}

} // namespace facetmill::ui
