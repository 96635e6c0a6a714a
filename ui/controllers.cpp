#include "ui/controllers.h"

#include "core/setup/tool.h"
#include "ui/boundary_controller.h"
#include "ui/cspace_controller.h"
#include "ui/divide_bar.h"
#include "ui/divide_controller.h"
#include "ui/fixture_controller.h"
#include "ui/inputs_controller.h"
#include "ui/inspection_controller.h"
#include "ui/kept_plans.h"
#include "ui/layer_bar.h"
#include "ui/measure_controller.h"
#include "ui/messages.h"
#include "ui/part_controller.h"
#include "ui/path_controller.h"
#include "ui/place_controller.h"
#include "ui/point_picker.h"
#include "ui/preview_controller.h"
#include "ui/properties_panel.h"
#include "ui/region_controller.h"
#include "ui/repair_button.h"
#include "ui/rough_bar.h"
#include "ui/rough_controller.h"
#include "ui/same_place.h"
#include "ui/scan_controller.h"
#include "ui/strategy_pictures.h"
#include "ui/strip_controller.h"
#include "ui/study_controller.h"
#include "ui/suggest_controller.h"
#include "ui/text.h"
#include "ui/tool_controller.h"
#include "ui/unrolled_controller.h"
#include "ui/verification_controller.h"
#include "ui/verification_panel.h"
#include "ui/viewport.h"

#include <QMenu>
#include <QToolButton>

#include <algorithm>

namespace facetmill::ui {

Controllers::Controllers(const Parts& parts, QWidget* window) : QObject(window) {
    build(parts, window);
    connect_document(parts.document);
    connect_messages(parts.document, parts.messages);
    connect_tool();
    connect_each_other(parts.layers);
    connect_view(parts.viewport);
}

Controllers::~Controllers() {
    while (!all_.empty()) {
        delete all_.back();
        all_.pop_back();
    }
}

void Controllers::build(const Parts& p, QWidget* window) {
    auto* picker = new PointPicker(p.document, p.viewport, p.properties, p.messages, window);
    verification_ = new VerificationController(p.document, p.viewport, p.layers, p.job, window);
    rough_ = new RoughController(p.document, p.viewport, window);
    divide_ = new DivideController(p.document, p.viewport, window);
    preview_ = new PreviewController(p.document, p.viewport, p.layers, window);
    regions_ = new RegionController(p.document, p.viewport, window);
    inspection_ = new InspectionController(p.document, p.viewport, p.layers, window);
    unrolled_ = new UnrolledController(p.document, window);
    cspace_ = new CSpaceController(p.document, window);
    strips_ = new StripController(p.document, p.viewport, window);
    paths_ = new PathController(p.document, p.viewport, p.layers, p.tree, *rough_, window);
    tool_ = new ToolController(p.document, p.viewport, *paths_, *verification_, p.status, window);
    part_ = new PartController(p.document, p.viewport, p.planner, p.planners, p.job, p.messages,
                               verification_->model(), window);
    inputs_ = new InputsController(p.document, p.planner, p.job, p.messages, *part_, window);
    place_ = new PlaceController(p.document, p.viewport, p.messages, window);
    connect(&p.job, &BackgroundJob::ended, place_, [place = place_](const JobEnd& end) {
        if (!end.done()) place->forget_waiting();
    });
    kept_ = new KeptPlans(p.document, p.planner, p.planners, p.job, *verification_, window);
    auto* same_place = new SamePlace(*paths_, *verification_, *cspace_, window);
    auto* fixtures = new FixtureController(p.document, p.viewport, p.tree, window);
    auto* boundaries =
        new BoundaryController(p.document, p.viewport, *p.properties.boundary_box(), p.messages, window);
    // A click in the view is for one of them.
    connect(picker, &PointPicker::picking_begun, place_, &PlaceController::leave);
    connect(place_, &PlaceController::picking_begun, picker, &PointPicker::leave);
    connect(picker, &PointPicker::picking_begun, boundaries, &BoundaryController::leave);
    connect(place_, &PlaceController::picking_begun, boundaries, &BoundaryController::leave);
    connect(boundaries, &BoundaryController::painting_begun, picker, &PointPicker::leave);
    connect(boundaries, &BoundaryController::painting_begun, place_, &PlaceController::leave);
    measure_ = new MeasureController(p.document, p.viewport, p.messages, window);
    connect(measure_, &MeasureController::measuring_begun, picker, &PointPicker::leave);
    connect(measure_, &MeasureController::measuring_begun, place_, &PlaceController::leave);
    connect(measure_, &MeasureController::measuring_begun, boundaries, &BoundaryController::leave);
    connect(picker, &PointPicker::picking_begun, measure_, &MeasureController::leave);
    connect(place_, &PlaceController::picking_begun, measure_, &MeasureController::leave);
    connect(boundaries, &BoundaryController::painting_begun, measure_, &MeasureController::leave);
    scan_ = new ScanController(p.document, p.planner->meshes(), p.viewport, window);
    p.tree.tree()->addAction(scan_->open_action());
    connect(p.properties.repair_button(), &RepairButton::clicked, scan_, &ScanController::open);
    study_ = new StudyController(p.document, verification_->model(), window);
    auto* pictures = new StrategyPictures(
        p.document,
        {p.tree.add_operation_menu(), p.tree.findChild<QToolButton*>(QStringLiteral("add"))->menu()}, window);
    suggest_ = new SuggestController(p.document, window);
    connect(suggest_, &SuggestController::added, this, [&tree = p.tree](std::size_t operation) {
        tree.select({TreeNode::Kind::operation, operation});
    });
    connect(verification_->panel(), &VerificationPanel::add_wanted, this,
            [&document = p.document, &tree = p.tree](const VerdictAdvice& advice) {
                tree.select({TreeNode::Kind::operation, document.add_operation(advice.add, advice.wish)});
            });
    // The charts hear of other paths first, then the tool goes to the paths' start, then a chosen strip may
    // take it. Keys: a playback goes before the configuration space, that before steps along the path. New
    // results are drawn last, when everybody knows of them.
    all_ = {measure_,    picker,    boundaries, verification_, rough_,   divide_, preview_, regions_,
            inspection_, unrolled_, cspace_,    tool_,         strips_,  part_,   fixtures, inputs_,
            place_,      scan_,     study_,     suggest_,      pictures, paths_,  kept_,    same_place};
}

void Controllers::connect_document(const Document& document) {
    connect(&document, &Document::opened, this, [this] { tell(&Controller::project_opened); });
    connect(&document, &Document::changed, this, [this] { tell(&Controller::project_changed); });
    connect(&document, &Document::part_changed, this, [this] { tell(&Controller::part_changed); });
    connect(&document, &Document::states_changed, this, [this] { tell(&Controller::plan_changed); });
}

void Controllers::connect_messages(const Document& document, Messages& messages) {
    connect(&document, &Document::tool_added, this, [this, &messages](const Tool& tool) {
        added_tool_ = tool.number;
        tool_said_ =
            tr("The list had no tool for this operation: T%1 %2 was added to it. Change it to one that "
               "you have.")
                .arg(tool.number)
                .arg(text(tool.name));
        messages.information(tool_said_);
    });
    const auto take_back = [this, &messages] {
        if (!tool_said_.isEmpty() && messages.bar().message() == tool_said_) messages.dismiss();
        tool_said_.clear();
    };
    connect(&document, &Document::opened, this, take_back);
    connect(&document, &Document::changed, this, [this, &document, take_back] { // undone
        if (!find_tool(document.project().tools, added_tool_)) take_back();
    });
    for (Controller* controller : all_) {
        connect(controller, &Controller::said, this,
                [&messages](MessageBar::Kind kind, const QString& message, bool in_bar) {
                    messages.tell(kind, message, in_bar);
                });
        connect(controller, &Controller::failed, this,
                [&messages](const QString& why) { messages.fail(why); });
        connect(controller, &Controller::wrote, this, [&messages](const QString& path) {
            messages.succeeded();
            messages.information(tr("Wrote %1.").arg(path), false);
        });
        connect(controller, &Controller::settled, this, &Controllers::settled);
    }
    // A verdict in the bar goes with its worth.
    connect(verification_, &Controller::said, this,
            [this, &messages](MessageBar::Kind, const QString& message, bool in_bar) {
                if (!in_bar) return;
                verdict_said_ = message;
                const VerdictAdvice advice = verification_->panel()->advice();
                if (!advice.add.empty() && message.endsWith(advice.text))
                    messages.offer({advised_button(advice),
                                    [this, advice] { emit verification_->panel()->add_wanted(advice); }});
            });
    connect(&verification_->model(), &VerificationModel::changed, this, [this, &messages] {
        if (!verification_->model().current() && !verdict_said_.isEmpty()
            && messages.bar().message() == verdict_said_)
            messages.dismiss();
    });
    connect(&messages.bar(), &MessageBar::dismissed, part_, &PartController::forget_former);
    connect(part_, &PartController::remarked, this, [this, &messages](const QString& remark) {
        remark_ = remark;
        messages.information(remark);
        messages.offer({tr("Scan room"), [this] { scan_->open(); }});
    });
    // Whoever is there need not be told the way.
    connect(scan_, &ScanController::opened, this, [this, &messages] {
        if (!remark_.isEmpty() && messages.bar().message() == remark_) messages.dismiss();
    });
    connect(verification_, &VerificationController::not_begun, this,
            [this, &messages](const QString& message, std::optional<std::size_t> up_to) {
                messages.succeeded(); // what was planned before it
                messages.warning(message);
                messages.offer({tr("Verify anyway"), [this, up_to] { verification_->verify(up_to, true); }});
            });
    connect(verification_, &VerificationController::verified, this, [this, &messages] {
        messages.succeeded();
        emit verified();
    });
}

/// The tool goes where a panel wants it, and all hear where it is.
void Controllers::connect_tool() {
    connect(paths_, &PathController::shown, this,
            [this] { tell(&Controller::paths_shown, paths_->paths()); });
    connect(paths_, &PathController::parts_shown, this,
            [this](const std::vector<PathSource>& sources) { tell(&Controller::path_parts_shown, sources); });
    connect(paths_, &PathController::redrawn, tool_, &ToolController::paths_redrawn);
    connect(tool_, &ToolController::placed, this,
            [this](const PathPick& pick) { tell(&Controller::tool_placed, paths_->paths(), pick); });
    connect(tool_, &ToolController::at_place, this,
            [this](std::size_t source, std::size_t motion, double share) {
                tell(&Controller::place_shown, source, motion, share);
            });
    connect(tool_, &ToolController::removed, this, [this] { tell(&Controller::tool_removed); });

    connect(inspection_, &InspectionController::place_wanted, tool_, &ToolController::show_motion);
    connect(inspection_, &InspectionController::step_wanted, tool_, &ToolController::step);
    connect(unrolled_, &UnrolledController::place_wanted, tool_, &ToolController::show_motion);
    connect(unrolled_, &UnrolledController::step_wanted, tool_, &ToolController::step);
    connect(cspace_, &CSpaceController::tool_wanted, tool_, &ToolController::show_pose);
    connect(strips_, &StripController::touch_wanted, tool_, &ToolController::show_touch);
    connect(strips_, &StripController::touch_gone, tool_, &ToolController::end_touch);
    connect(tool_, &ToolController::touch_left, strips_, &StripController::leave_tool);
}

void Controllers::connect_each_other(LayerBar& layers) {
    connect(strips_, &StripController::strips_shown, regions_, &RegionController::give_way);
    connect(regions_, &RegionController::ended, strips_, &StripController::show_again);
    connect(regions_, &RegionController::wanted, this,
            [&layers] { layers.set_shown(ViewLayer::regions, true); });
    connect(verification_, &VerificationController::operation_meant, paths_, &PathController::uncover);
}

void Controllers::connect_view(Viewport& viewport) {
    connect(&viewport, &Viewport::path_picked, this, [this](const PathPick& pick) {
        for (Controller* controller : all_)
            if (controller->take_path_pick(paths_->paths(), pick)) return;
        tool_->show_at(pick);
    });
    connect(&viewport, &Viewport::part_picked, this, [this, &viewport](const PartPick& pick) {
        for (Controller* controller : all_)
            if (controller->take_part_pick(pick)) return;
        viewport.scene().marks().set_marker(Marker{pick.point, pick.normal});
        viewport.refresh();
    });
    connect(&viewport, &Viewport::nothing_picked, this, [&viewport] {
        viewport.scene().marks().set_marker(std::nullopt);
        viewport.refresh();
    });
}

bool Controllers::take_key(const QKeyEvent& event) {
    return std::any_of(all_.begin(), all_.end(),
                       [&](Controller* controller) { return controller->take_key(event); });
}

std::vector<QWidget*> Controllers::operation_bars() {
    return {rough_->bar(), divide_->bar()};
}

bool Controllers::busy() const {
    return std::any_of(all_.begin(), all_.end(),
                       [](const Controller* controller) { return controller->busy(); });
}

} // namespace facetmill::ui
