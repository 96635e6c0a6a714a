#include "ui/main_window.h"

#include "ui/all_setups.h"
#include "ui/controllers.h"
#include "ui/cspace_controller.h"
#include "ui/cspace_panel.h"
#include "ui/dropped_files.h"
#include "ui/graphics_role.h"
#include "ui/inspection_controller.h"
#include "ui/inspection_panel.h"
#include "ui/layer_bar.h"
#include "ui/log_view.h"
#include "ui/measure_controller.h"
#include "ui/messages.h"
#include "ui/operation_actions.h"
#include "ui/parameter_form.h"
#include "ui/place_controller.h"
#include "ui/plan_runner.h"
#include "ui/playback_bar.h"
#include "ui/program_export.h"
#include "ui/project_files.h"
#include "ui/properties_panel.h"
#include "ui/recent_pictures.h"
#include "ui/region_controller.h"
#include "ui/region_dialog.h"
#include "ui/report_view.h"
#include "ui/rough_bar.h"
#include "ui/rough_controller.h"
#include "ui/scan_controller.h"
#include "ui/settings.h"
#include "ui/start_hint.h"
#include "ui/status_line.h"
#include "ui/strip_controller.h"
#include "ui/strip_panel.h"
#include "ui/templates.h"
#include "ui/text.h"
#include "ui/tool_dialog.h"
#include "ui/unrolled_controller.h"
#include "ui/unrolled_panel.h"
#include "ui/verification_controller.h"
#include "ui/verification_panel.h"
#include "ui/view_cube.h"
#include "ui/view_menu.h"
#include "ui/viewport.h"
#include "ui/window_commands.h"
#include "ui/window_docks.h"
#include "ui/window_menus.h"
#include "ui/work_follower.h"
#include "ui/workspaces.h"

#include <QAction>
#include <QApplication>
#include <QCloseEvent>
#include <QDragEnterEvent>
#include <QMenu>
#include <QMimeData>
#include <QScreen>
#include <QStatusBar>
#include <QTimer>
#include <QVBoxLayout>

#include <utility>

namespace facetmill::ui {

namespace {

QString title_of(const Document& document) {
    if (document.name().isEmpty()) return QStringLiteral("Facetmill");
    return QStringLiteral("%1%2 – Facetmill")
        .arg(elided(document.name(), 60), document.modified() ? QStringLiteral("*") : QString());
}

QSize usual_size() {
    const QSize screen = QApplication::primaryScreen()->availableSize();
    return {std::min(1280, screen.width()), std::min(800, screen.height())};
}

} // namespace

MainWindow::MainWindow(QWidget* parent) : QMainWindow(parent) {
    setObjectName(QStringLiteral("main_window"));
    setWindowIcon(application_icon());
    setAcceptDrops(true);
    setDockOptions(QMainWindow::AnimatedDocks | QMainWindow::AllowTabbedDocks
                   | QMainWindow::AllowNestedDocks);
    build_parts();
    build_docks();
    build_commands();
    connect_document();
    connect_panels();
    connect_jobs();
    follow_work(*this, *docks_);

    Scene& scene = viewport_->scene();
    scene.set_visible(Layer::title, false); // the window has one
    layers_->apply(scene);
    take_preferences(*this);
    restore_window();
    update_title();
    update_commands();
}

MainWindow::~MainWindow() {
    // The children go while the document they show is still there. An entry that was not finished goes with
    // its field.
    properties_->form()->disconnect();
    docks_->clear();
    delete controllers_;
    delete takeCentralWidget();
}

void MainWindow::build_parts() {
    tell_graphics();
    auto* center = new QWidget(this);
    setCentralWidget(center);
    viewport_ = new Viewport(center);
    message_bar_ = new MessageBar(viewport_);
    viewport_->setObjectName(QStringLiteral("viewport"));
    viewport_->setAccessibleName(tr("View"));
    layers_ = new LayerBar(center);
    log_ = new LogView(this);
    messages_ = std::make_unique<Messages>(*message_bar_, *log_);
    status_ = new StatusLine(document_, statusBar());
    tree_ = new ProjectTree(document_, this);
    properties_ = new PropertiesPanel(document_, this);
    report_ = new ReportView(document_, this);
    const auto planners = std::make_shared<SetupPlanners>(planner_->meshes());
    controllers_ = new Controllers({document_, job_, planner_, planners, *viewport_, *layers_, *tree_,
                                    *properties_, *status_, *messages_},
                                   this);
    planning_ = new PlanRunner(document_, planner_, planners, job_, *messages_, controllers_->part(),
                               *properties_, verification(), this);
    files_ = std::make_unique<ProjectFiles>(document_, planner_, job_, *messages_, controllers_->part(),
                                            *properties_, *tree_, this);
    templates_ = new Templates(document_, *messages_, this);
    exports_ = new ProgramExport(document_, job_, *messages_, *properties_, *viewport_, verification(), this);

    auto* column = new QVBoxLayout(center);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(viewport_, 1);
    workspaces_ = new Workspaces(*layers_, controllers_->operation_bars(), *verification().bar(), center);
    column->addWidget(workspaces_);
}

void MainWindow::build_docks() {
    setCorner(Qt::BottomLeftCorner, Qt::LeftDockWidgetArea);
    setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea);
    constexpr auto left = Qt::LeftDockWidgetArea, right = Qt::RightDockWidgetArea,
                   bottom = Qt::BottomDockWidgetArea;
    const QString report = QStringLiteral("report_dock"), beside = QStringLiteral("verification_dock");
    PlaceController& place = controllers_->place();
    docks_ = new WindowDocks(this);
    docks_->add({"project_dock", tr("Project"), tree_, left});
    docks_->add({"properties_dock", tr("Parameters"), properties_, left});
    docks_->add({report, tr("Report"), report_, right});
    docks_->add({beside, tr("Verification"), verification().panel(), right, report});
    docks_->add({"cspace_dock", tr("Configuration space"), cspace().panel(), right, beside, &cspace()});
    docks_->add({"unrolled_dock", tr("Unrolled"), unrolled().panel(), right, beside, &unrolled(), true});
    docks_->add({"strips_dock", tr("Strips"), controllers_->strips().panel(), right, beside,
                 &controllers_->strips(), true});
    docks_->add({"place_dock", tr("Place part"), place.panel(), right, beside, &place, true});
    docks_->add({"log_dock", tr("Log"), log_, bottom});
    docks_->add({"chart_dock", tr("Charts"), inspection().panel(), bottom, "log_dock", &inspection(), true});
    ScanController& scan = controllers_->scan();
    docks_->add({"scan_dock", tr("Scan room"), scan.panel(), right, beside, &scan, true});
    docks_->show(report);
    tree_->set_verification(verification().model());
    tree_->tree()->installEventFilter(&verification());
    verification().panel()->findings()->installEventFilter(&verification());
}

void MainWindow::build_commands() {
    commands_ = std::make_unique<Commands>(this);
    add_commands(*commands_, *this);
    QMenu* samples = make_sample_menu(this, [this](const std::string& name) { new_from_sample(name); });
    QMenu* recent = make_recent_menu(this, [this](const QString& path) { open_file(path); });
    commands_->adopt("samples", samples->menuAction());
    commands_->adopt("recent", recent->menuAction());
    commands_->adopt("apply_template", templates_->menu()->menuAction());
    for (const auto& [name, action] : tree_commands(*tree_))
        commands_->adopt(name, action);
    build_menus(this, *commands_, *docks_);
    view_menu_ = new ViewMenu(*this, *commands_->action("view_menu")->menu());
    for (const char* name : {"undo", "redo", "save", "plan"})
        regions().dialog()->addAction(commands_->action(name));
    status_->follow(job_, commands_->action("cancel"));
    hint_ = new StartHint(samples, viewport_);
    connect(hint_, &StartHint::open_requested, files_.get(), &ProjectFiles::open_with_dialog);
    connect(hint_, &StartHint::file_chosen, this, [this](const QString& path) { open_file(path); });
    connect(hint_, &StartHint::sample_chosen, this, &MainWindow::new_from_sample);
    new RecentPictures(document_, *viewport_, *this);
}

/// Comes after what the controllers do for the same signals.
void MainWindow::connect_document() {
    connect(&document_, &Document::opened, this, [this] {
        hint_->setVisible(!document_.has_part());
        messages_->dismiss();
        viewport_->content_changed(); // the page stands over it, or does no more
        update_title();
    });
    connect(&document_, &Document::changed, this, [this] {
        viewport_->refresh();
        update_commands();
        update_title();
    });
    connect(&document_, &Document::part_changed, this, &MainWindow::update_commands);
    connect(&document_, &Document::states_changed, this, &MainWindow::update_commands);
    connect(&document_, &Document::modified_changed, this, &MainWindow::update_title);
}

void MainWindow::connect_panels() {
    connect(tree_, &ProjectTree::selection_changed, this, [this] {
        properties_->show_node(tree_->selected());
        report_->show_node(tree_->selected());
        controllers_->tell(&Controller::node_chosen, tree_->selected());
        update_commands();
    });
    connect(tree_, &ProjectTree::refused, this, [this](const QString& why) { messages_->warning(why); });
    connect(tree_, &ProjectTree::edit_tool, this, [this](std::size_t i) { edit_tool(i); });
    connect(tree_, &ProjectTree::new_tool, this, [this] { edit_tool(std::nullopt); });
    connect(tree_, &ProjectTree::edit_parameters, this, [this] {
        docks_->show(QStringLiteral("properties_dock"));
        properties_->form()->focus_first();
    });
    OperationActions& one = tree_->operations();
    connect(&one, &OperationActions::plan_wanted, this, [this](std::size_t i) { plan(i); });
    connect(&one, &OperationActions::verify_wanted, this, [this](std::size_t i) { planning_->verify(i); });
    connect(&one, &OperationActions::export_wanted, exports_, &ProgramExport::program_with_dialog);
    connect(properties_, &PropertiesPanel::edit_tool, this, [this](std::size_t i) { edit_tool(i); });
    connect(properties_, &PropertiesPanel::choose_stock, files_.get(), &ProjectFiles::choose_stock);
    connect(properties_, &PropertiesPanel::choose_fixture, files_.get(), &ProjectFiles::choose_fixture);
    connect(tree_, &ProjectTree::new_mesh_fixture, files_.get(), &ProjectFiles::choose_fixture);
    connect(properties_, &PropertiesPanel::edit_regions, &regions(), &RegionController::open);
    connect(layers_, &LayerBar::toggled, this, [this] {
        layers_->apply(viewport_->scene());
        controllers_->tell(&Controller::layers_toggled);
        viewport_->refresh();
    });
    connect(&controllers_->measure(), &MeasureController::switched, this, &MainWindow::update_commands);
    connect(viewport_, &Viewport::hovered, status_, &StatusLine::set_hovered);
    connect(viewport_, &Viewport::menu_requested, this,
            [this](const QPoint& at) { view_menu_->make(at)->popup(at); });
    connect(status_, &StatusLine::unit_chosen, this, [this](LengthUnit unit) { set_unit(*this, unit); });
}

void MainWindow::connect_jobs() {
    connect(viewport_, &Viewport::drawn, this, &MainWindow::check_settled);
    connect(controllers_, &Controllers::settled, this, &MainWindow::check_settled);
    connect(controllers_, &Controllers::verified, this,
            [this] { docks_->show(QStringLiteral("verification_dock")); });
    connect(&verification(), &VerificationController::verify_requested, this, &MainWindow::verify);
    connect(&verification(), &VerificationController::verify_all_requested, &planning_->all_setups(),
            &AllSetups::verify);
    connect(planning_, &PlanRunner::about_to_plan, &regions(), &RegionController::commit);
    connect(planning_, &PlanRunner::planned, this, [this](std::size_t first) {
        // The report of what was planned is what one wants to see now.
        const auto node = tree_->selected();
        if (!node || node->kind != TreeNode::Kind::operation)
            tree_->select({TreeNode::Kind::operation, first});
    });
    connect(files_.get(), &ProjectFiles::renamed, this, &MainWindow::update_title);
    connect(files_.get(), &ProjectFiles::settled, this, &MainWindow::check_settled);
    connect(exports_, &ProgramExport::verify_wanted, this, &MainWindow::verify);
    connect(&job_, &BackgroundJob::started, this, &MainWindow::update_commands);
    connect(&job_, &BackgroundJob::ended, this, [this](const JobEnd& end) {
        if (end.how == JobEnd::How::failed)
            messages_->fail(end.message);
        else if (end.how == JobEnd::How::cancelled)
            messages_->information(tr("Cancelled."), false);
        update_commands();
        check_settled();
    });
}

void MainWindow::restore_window() {
    resize(usual_size());
    docks_->size_as_new();
    restoreGeometry(settings::window_geometry());
    restoreState(settings::window_state());
}

void MainWindow::update_title() {
    setWindowTitle(title_of(document_));
}

void MainWindow::update_commands() {
    commands_->refresh();
    status_->refresh();
    verification().panel()->set_ready(planning_->can_plan() || (document_.program() && !job_.running()));
}

void MainWindow::open_file(const QString& path, std::optional<LengthUnit> unit) {
    files_->open(path, unit);
}

void MainWindow::new_from_sample(const std::string& name) {
    files_->new_from_sample(name);
}

void MainWindow::plan(std::optional<std::size_t> only) {
    planning_->plan(only);
}

void MainWindow::verify() {
    planning_->verify();
}

void MainWindow::cancel() {
    job_.cancel();
    status_->show_cancelling();
    update_commands();
}

void MainWindow::set_theme(Theme theme) {
    theme_ = theme;
    apply_theme(*qApp, theme);
    const auto palette =
        is_dark(QApplication::palette()) ? facetmill::Palette::dark : facetmill::Palette::light;
    viewport_->scene().set_palette(palette);
    viewport_->view_cube()->update();
    viewport_->refresh();
    controllers_->tell(&Controller::palette_changed, palette);
    message_bar_->color();
    commands_->refresh();
}

void MainWindow::edit_tool(std::optional<std::size_t> index) {
    if (const ToolDialog* dialog = ToolDialog::open_for(document_, index, this))
        connect(dialog, &ToolDialog::taken, this, [this](std::size_t at) {
            tree_->select({TreeNode::Kind::tool, at});
        });
}

VerificationController& MainWindow::verification() {
    return controllers_->verification();
}

CSpaceController& MainWindow::cspace() {
    return controllers_->cspace();
}

InspectionController& MainWindow::inspection() {
    return controllers_->inspection();
}

UnrolledController& MainWindow::unrolled() {
    return controllers_->unrolled();
}

RoughController& MainWindow::roughing() {
    return controllers_->rough();
}

RegionController& MainWindow::regions() {
    return controllers_->regions();
}

const QString& MainWindow::last_failure() const {
    return messages_->last_failure();
}

void MainWindow::show_place() {
    docks_->bring(QStringLiteral("place_dock"));
}

bool MainWindow::busy() const {
    return job_.running() || controllers_->busy() || files_->busy() || !viewport_->finished();
}

void MainWindow::check_settled() {
    if (settling_) return;
    settling_ = true;
    // What follows a job may start another one: looked at after all of it.
    QTimer::singleShot(0, this, [this] {
        settling_ = false;
        if (!busy()) emit settled();
    });
}

void MainWindow::closeEvent(QCloseEvent* event) {
    if (!files_->may_close()) {
        event->ignore();
        return;
    }
    job_.cancel();
    settings::set_window(saveGeometry(), saveState());
    workspaces_->keep_layers();
    event->accept();
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
    if (QApplication::activeModalWidget()) return; // a question is open
    if (!local_files(*event->mimeData()).isEmpty()) event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent* event) {
    const QStringList paths = local_files(*event->mimeData());
    if (paths.isEmpty() || QApplication::activeModalWidget()) return;
    event->acceptProposedAction();
    // The source of the drag waits for this event: questions come after it.
    QTimer::singleShot(0, this, [this, paths] { files_->open_dropped(paths); });
}

void MainWindow::keyPressEvent(QKeyEvent* event) {
    if (!controllers_->take_key(*event)) QMainWindow::keyPressEvent(event);
}

void MainWindow::resizeEvent(QResizeEvent* event) {
    QMainWindow::resizeEvent(event);
    if (docks_) docks_->arrange();
}

} // namespace facetmill::ui
