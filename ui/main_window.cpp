#include "ui/main_window.h"

#include "ui/cspace_controller.h"
#include "ui/elided_label.h"
#include "ui/icons.h"
#include "ui/inspection_controller.h"
#include "ui/layer_bar.h"
#include "ui/log_view.h"
#include "ui/parameter_form.h"
#include "ui/playback_bar.h"
#include "ui/project_tree.h"
#include "ui/properties_panel.h"
#include "ui/region_controller.h"
#include "ui/region_dialog.h"
#include "ui/report_view.h"
#include "ui/rough_controller.h"
#include "ui/settings.h"
#include "ui/start_hint.h"
#include "ui/strip_controller.h"
#include "ui/text.h"
#include "ui/unrolled_controller.h"
#include "ui/verification_controller.h"
#include "ui/verification_panel.h"
#include "ui/view_cube.h"
#include "ui/viewport.h"

#include <QAction>
#include <QApplication>
#include <QCloseEvent>
#include <QComboBox>
#include <QDockWidget>
#include <QDragEnterEvent>
#include <QFileInfo>
#include <QLabel>
#include <QMenu>
#include <QMimeData>
#include <QProgressBar>
#include <QScreen>
#include <QStandardPaths>
#include <QStatusBar>
#include <QTabBar>
#include <QTimer>
#include <QToolButton>
#include <QVBoxLayout>

#include <utility>

namespace facetmill::ui {

namespace {

/// Of the docks on the right: their tabs can be read whole.
constexpr int right_width = 306;

} // namespace

MainWindow::MainWindow(QWidget* parent) : QMainWindow(parent) {
    setObjectName(QStringLiteral("main_window"));
    setWindowIcon(application_icon());
    setAcceptDrops(true);
    setDockOptions(QMainWindow::AnimatedDocks | QMainWindow::AllowTabbedDocks
                   | QMainWindow::AllowNestedDocks);
    sample_folder_ =
        QStandardPaths::writableLocation(QStandardPaths::CacheLocation) + QStringLiteral("/samples");

    auto* center = new QWidget(this);
    auto* column = new QVBoxLayout(center);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    message_ = new MessageBar(center);
    viewport_ = new Viewport(center);
    viewport_->setObjectName(QStringLiteral("viewport"));
    layers_ = new LayerBar(center);
    controller_ = new VerificationController(document_, *viewport_, *layers_, job_, this);
    column->addWidget(message_);
    column->addWidget(viewport_, 1);
    rough_ = new RoughController(document_, *viewport_, this);
    column->addWidget(rough_->bar());
    regions_ = new RegionController(document_, *viewport_, this);
    column->addWidget(controller_->bar());
    column->addWidget(layers_);
    setCentralWidget(center);

    build_docks();
    build_actions();
    build_menus();
    regions_->dialog()->addActions({undo_, redo_, save_, plan_});
    build_status_bar();
    hint_ = new StartHint(sample_menu_, viewport_);
    connect(hint_, &StartHint::open_requested, this, &MainWindow::open_with_dialog);
    connect_parts();
    build_pick();

    Scene& scene = viewport_->scene();
    scene.set_visible(Layer::title, false); // the window has one
    if (const auto names = settings::shown_layers()) layers_->set_shown_names(*names);
    layers_->apply(scene);
    set_theme(settings::theme());
    restore_window();
    update_title();
    update_actions();
}

MainWindow::~MainWindow() {
    // The children go while the document they show is still there. An entry that was not finished goes with
    // its field.
    properties_->form()->disconnect();
    for (QDockWidget* dock : {project_dock_, properties_dock_, report_dock_, verification_dock_, cspace_dock_,
                              log_dock_, chart_dock_, unrolled_dock_, strips_dock_})
        delete dock;
    delete inspection_;
    delete unrolled_;
    delete strips_;
    delete rough_;
    delete regions_;
    delete cspace_;
    delete controller_;
    delete takeCentralWidget();
}

void MainWindow::build_docks() {
    const auto dock = [this](const QString& title, const char* name, QWidget* content,
                             Qt::DockWidgetArea area) {
        auto* d = new QDockWidget(title, this);
        d->setObjectName(QLatin1String(name));
        d->setWidget(content);
        addDockWidget(area, d);
        return d;
    };
    setCorner(Qt::BottomLeftCorner, Qt::LeftDockWidgetArea);
    setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea);
    tree_ = new ProjectTree(document_, this);
    properties_ = new PropertiesPanel(document_, this);
    report_ = new ReportView(document_, this);
    log_ = new LogView(this);
    project_dock_ = dock(tr("Project"), "project_dock", tree_, Qt::LeftDockWidgetArea);
    properties_dock_ = dock(tr("Parameters"), "properties_dock", properties_, Qt::LeftDockWidgetArea);
    report_dock_ = dock(tr("Report"), "report_dock", report_, Qt::RightDockWidgetArea);
    verification_dock_ =
        dock(tr("Verification"), "verification_dock", controller_->panel(), Qt::RightDockWidgetArea);
    tabifyDockWidget(report_dock_, verification_dock_);
    build_cspace();
    build_unrolled();
    build_strips();
    report_dock_->raise();
    tree_->set_verification(controller_->model());
    tree_->tree()->installEventFilter(controller_);
    controller_->panel()->findings()->installEventFilter(controller_);
    log_dock_ = dock(tr("Log"), "log_dock", log_, Qt::BottomDockWidgetArea);
    build_inspection();
}

void MainWindow::build_status_bar() {
    auto* bar = statusBar();
    activity_ = new QLabel(tr("Ready"), this);
    activity_->setObjectName(QStringLiteral("activity"));
    activity_->setMinimumWidth(90);
    progress_ = new QProgressBar(this);
    progress_->setObjectName(QStringLiteral("progress"));
    progress_->setRange(0, 1000);
    progress_->setTextVisible(true);
    progress_->setFixedWidth(150);
    progress_->setMaximumHeight(16);
    cancel_button_ = new QToolButton(this);
    cancel_button_->setObjectName(QStringLiteral("cancel_button"));
    cancel_button_->setDefaultAction(cancel_);
    cancel_button_->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    cancel_button_->setIconSize(QSize(14, 14));
    readout_ = new ElidedLabel(this);
    readout_->setObjectName(QStringLiteral("readout"));
    readout_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    unit_box_ = new QComboBox(this);
    unit_box_->setObjectName(QStringLiteral("unit"));
    unit_box_->addItems({QStringLiteral("mm"), QStringLiteral("in")});
    unit_box_->setToolTip(tr("Unit of the project: of all fields, reports and written programs"));
    unit_box_->setFocusPolicy(Qt::TabFocus);
    connect(unit_box_, &QComboBox::activated, this,
            [this](int i) { set_unit(i == 1 ? LengthUnit::inch : LengthUnit::mm); });
    bar->addWidget(activity_);
    bar->addWidget(progress_);
    bar->addWidget(cancel_button_);
    bar->addWidget(readout_, 1);
    bar->addPermanentWidget(unit_box_);
    progress_->hide();
    cancel_button_->hide();
}

void MainWindow::connect_parts() {
    connect(tree_, &ProjectTree::selection_changed, this, [this] {
        properties_->show_node(tree_->selected());
        report_->show_node(tree_->selected());
        rough_->show_node(tree_->selected());
        regions_->show_node(tree_->selected());
        if (const auto node = tree_->selected(); node && node->kind == TreeNode::Kind::stock_after)
            controller_->show_stock_after(node->index);
        if (shown_alone() != drawn_alone_) draw_paths(true);
        update_actions();
    });
    connect(tree_, &ProjectTree::refused, this,
            [this](const QString& why) { tell(MessageBar::Kind::warning, why); });
    connect(tree_, &ProjectTree::edit_tool, this, [this](std::size_t i) { edit_tool(i); });
    connect(tree_, &ProjectTree::new_tool, this, [this] { edit_tool(std::nullopt); });
    connect(tree_, &ProjectTree::edit_parameters, this, [this] {
        properties_dock_->show();
        properties_dock_->raise();
        properties_->form()->focus_first();
    });
    connect(tree_, &ProjectTree::plan_operation, this, [this](std::size_t i) { plan(i); });
    connect(properties_, &PropertiesPanel::edit_tool, this, [this](std::size_t i) { edit_tool(i); });
    connect(properties_, &PropertiesPanel::choose_stock, this, &MainWindow::choose_stock);
    connect(properties_, &PropertiesPanel::edit_regions, regions_, &RegionController::open);
    connect(regions_, &RegionController::wanted, this,
            [this] { layers_->set_shown(ViewLayer::regions, true); });
    connect(regions_, &RegionController::failed, this, &MainWindow::fail);
    connect(regions_, &RegionController::settled, this, &MainWindow::check_settled);
    connect(rough_, &RoughController::layer_changed, this, [this] { draw_paths(); });
    connect(rough_, &RoughController::settled, this, &MainWindow::check_settled);
    connect(controller_, &VerificationController::said, this, &MainWindow::tell);
    connect(controller_, &VerificationController::verify_requested, this, &MainWindow::verify);
    connect(controller_, &VerificationController::verified, this, [this] {
        last_failure_.clear();
        verification_dock_->show();
        verification_dock_->raise();
    });
    connect(controller_, &VerificationController::tool_moved, this, [this](const QString& readout) {
        readout_text_ = readout;
        readout_->set_text(readout);
        hide_touch();
        check_settled();
    });
    // What a finding is by is to be seen beside it.
    connect(controller_->panel(), &VerificationPanel::finding_chosen, this, [this](const Finding& finding) {
        if (!drawn_alone_ || !finding.by.known() || !controller_->model().any()) return;
        const VerificationOutcome& judged = controller_->model().outcome();
        if (finding.by.program < judged.program_operations.size()
            && judged.ids[judged.program_operations[finding.by.program]] != *drawn_alone_)
            layers_->set_shown(ViewLayer::others, true);
    });
    connect(layers_, &LayerBar::toggled, this, [this] {
        layers_->apply(viewport_->scene());
        controller_->layers_changed();
        if (shown_alone() != drawn_alone_) draw_paths(true);
        viewport_->refresh();
    });

    connect(&document_, &Document::opened, this, [this] {
        hide_tool();
        viewport_->scene().set_part(PartDisplayPtr());
        viewport_->scene().set_stock(Box3());
        viewport_->scene().set_unit(document_.unit());
        hint_->setVisible(!document_.has_part());
        message_->dismiss();
        refresh_paths();
        viewport_->refresh();
        update_title();
    });
    connect(&document_, &Document::changed, this, [this] {
        viewport_->scene().set_unit(document_.unit());
        show_stock();
        refresh_paths();
        viewport_->refresh();
        update_actions();
        update_title();
    });
    connect(&document_, &Document::part_changed, this, [this] {
        if (document_.has_part() && document_.part() && !document_.part_is_current()) reload_part();
        update_actions();
    });
    connect(&document_, &Document::states_changed, this, [this] {
        refresh_paths();
        update_actions();
    });
    connect(&document_, &Document::modified_changed, this, &MainWindow::update_title);

    connect(&job_, &BackgroundJob::started, this, [this](const QString& title) {
        activity_->setText(title);
        progress_->setValue(0);
        progress_->show();
        cancel_button_->show();
        update_actions();
    });
    connect(&job_, &BackgroundJob::progressed, this, [this](double fraction, const QString& label) {
        progress_->setValue(int(fraction * 1000));
        if (job_.cancelling())
            activity_->setText(tr("Cancelling…"));
        else if (!label.isEmpty())
            activity_->setText(elided(label, 40));
    });
    connect(&job_, &BackgroundJob::ended, this, &MainWindow::ended);
    connect(&display_job_, &BackgroundJob::ended, this, [this](const JobEnd& end) {
        if (end.how == JobEnd::How::failed) fail(end.message);
        check_settled();
    });

    connect(viewport_, &Viewport::drawn, this, &MainWindow::check_settled);
    connect(viewport_, &Viewport::path_picked, this, [this](const PathPick& pick) {
        if (!pick_strip(pick)) show_tool_at(pick);
    });
    connect(viewport_, &Viewport::part_picked, this, [this](const PartPick& pick) {
        if (strips_->pick(pick.point)) return;
        viewport_->scene().set_marker(Marker{pick.point, pick.normal});
        viewport_->refresh();
    });
    connect(viewport_, &Viewport::nothing_picked, this, [this] {
        viewport_->scene().set_marker(std::nullopt);
        viewport_->refresh();
    });
    connect(viewport_, &Viewport::hovered, this, [this](const std::optional<PartPick>& pick) {
        if (!pick) {
            readout_->set_text(readout_text_);
            return;
        }
        const double mm = mm_per(document_.unit());
        const auto number = [&](double v) {
            return QString::number(v / mm, 'f', document_.unit() == LengthUnit::inch ? 4 : 3);
        };
        readout_->set_text(QStringLiteral("x %1   y %2   z %3 %4")
                               .arg(number(pick->point.x()), number(pick->point.y()), number(pick->point.z()),
                                    text(unit_name(document_.unit()))));
    });
    connect(viewport_, &Viewport::menu_requested, this, [this](const QPoint& at) { view_menu_->popup(at); });
}

void MainWindow::restore_window() {
    const QSize screen = QApplication::primaryScreen()->availableSize();
    resize(std::min(1280, screen.width()), std::min(800, screen.height()));
    resizeDocks({project_dock_, properties_dock_}, {230, 420}, Qt::Vertical);
    resizeDocks({project_dock_, report_dock_}, {280, right_width}, Qt::Horizontal);
    resizeDocks({log_dock_}, {96}, Qt::Vertical);
    restoreGeometry(settings::window_geometry());
    restoreState(settings::window_state());
}

void MainWindow::arrange_report() {
    // In a narrow window report and verification stand behind the parameters, so that the view keeps room; in
    // a wide one they go back.
    constexpr int narrow = 1000;
    bool moved = false;
    if (width() < narrow) {
        if (properties_dock_->isFloating() || dockWidgetArea(properties_dock_) != Qt::LeftDockWidgetArea)
            return;
        for (QDockWidget* dock :
             {report_dock_, verification_dock_, cspace_dock_, strips_dock_, unrolled_dock_}) {
            if (dock->isFloating() || dock->isHidden() || dockWidgetArea(dock) != Qt::RightDockWidgetArea)
                continue;
            tabifyDockWidget(properties_dock_, dock);
            properties_dock_->raise();
            made_way_.push_back(dock);
            moved = true;
        }
    } else if (!made_way_.empty()) {
        moved = true;
        for (QDockWidget* dock : std::exchange(made_way_, {}))
            if (!dock->isFloating()) addDockWidget(Qt::RightDockWidgetArea, dock);
        if (dockWidgetArea(report_dock_) == dockWidgetArea(verification_dock_)) {
            tabifyDockWidget(report_dock_, verification_dock_);
            if (dockWidgetArea(report_dock_) == dockWidgetArea(cspace_dock_))
                tabifyDockWidget(verification_dock_, cspace_dock_);
            if (dockWidgetArea(report_dock_) == dockWidgetArea(strips_dock_) && !strips_dock_->isHidden())
                tabifyDockWidget(verification_dock_, strips_dock_);
            if (dockWidgetArea(report_dock_) == dockWidgetArea(unrolled_dock_))
                tabifyDockWidget(verification_dock_, unrolled_dock_);
            report_dock_->raise();
        }
        resizeDocks({report_dock_}, {right_width}, Qt::Horizontal);
    }
    if (!moved) return;
    // Qt leaves the bar of tabs that are gone standing, as a line; also after it has laid out the docks.
    const auto hide_empty_bars = [this] {
        for (QTabBar* bar : findChildren<QTabBar*>(Qt::FindDirectChildrenOnly))
            if (bar->count() == 0) bar->hide();
    };
    hide_empty_bars();
    QTimer::singleShot(0, this, hide_empty_bars);
}

void MainWindow::resizeEvent(QResizeEvent* event) {
    QMainWindow::resizeEvent(event);
    if (report_dock_) arrange_report();
}

void MainWindow::update_title() {
    const QString name = document_.name();
    setWindowTitle(name.isEmpty()
                       ? QStringLiteral("Facetmill")
                       : QStringLiteral("%1%2 – Facetmill")
                             .arg(elided(name, 60), document_.modified() ? QStringLiteral("*") : QString()));
}

void MainWindow::update_actions() {
    const bool idle = !job_.running(), has_part = document_.has_part();
    new_->setEnabled(has_part);
    save_->setEnabled(has_part);
    save_as_->setEnabled(has_part);
    plan_->setEnabled(idle && has_part && document_.operation_count() > 0);
    verify_->setEnabled(plan_->isEnabled());
    controller_->panel()->set_ready(verify_->isEnabled());
    export_->setEnabled(idle && has_part);
    sheet_->setEnabled(idle && has_part);
    picture_->setEnabled(has_part);
    cancel_->setEnabled(!idle && !job_.cancelling());
    for (QAction* a : view_actions_)
        a->setEnabled(has_part);
    unit_box_->setCurrentIndex(document_.unit() == LengthUnit::inch ? 1 : 0);
    unit_box_->setEnabled(has_part);
    for (std::size_t i = 0; i < unit_actions_.size(); ++i) {
        unit_actions_[i]->setChecked((i == 1) == (document_.unit() == LengthUnit::inch));
        unit_actions_[i]->setEnabled(has_part);
    }
}

void MainWindow::set_theme(Theme theme) {
    apply_theme(*qApp, theme);
    const bool dark = is_dark(QApplication::palette());
    viewport_->scene().set_palette(dark ? facetmill::Palette::dark : facetmill::Palette::light);
    viewport_->view_cube()->update();
    viewport_->refresh();
    cspace_->set_palette(dark ? facetmill::Palette::dark : facetmill::Palette::light);
    strips_->color();
    message_->color();
    for (std::size_t i = 0; i < theme_actions_.size(); ++i)
        theme_actions_[i]->setChecked(i == std::size_t(theme));
}

void MainWindow::set_unit(LengthUnit unit) {
    if (!document_.has_part() || unit == document_.unit()) return;
    if (!properties_->commit()) {
        update_actions(); // the box goes back
        tell(MessageBar::Kind::warning,
             tr("A parameter is not valid: correct it before the unit is changed."));
        return;
    }
    document_.change(tr("Change unit"), [unit](Project& p) { p.unit = unit; });
}

void MainWindow::tell(MessageBar::Kind kind, const QString& message, bool in_bar) {
    log_->add(kind, message);
    if (in_bar) message_->show_message(kind, message);
}

void MainWindow::fail(const QString& message) {
    last_failure_ = message;
    tell(MessageBar::Kind::error, sentence(message));
}

void MainWindow::cancel() {
    job_.cancel();
    activity_->setText(tr("Cancelling…"));
    update_actions();
}

void MainWindow::ended(const JobEnd& end) {
    progress_->hide();
    cancel_button_->hide();
    activity_->setText(tr("Ready"));
    if (end.how == JobEnd::How::failed)
        fail(end.message);
    else if (end.how == JobEnd::How::cancelled)
        tell(MessageBar::Kind::information, tr("Cancelled."), false);
    update_actions();
    check_settled();
}

bool MainWindow::busy() const {
    return job_.running() || display_job_.running() || controller_->busy() || cspace_->busy()
           || inspection_->busy() || rough_->busy() || strips_->busy() || regions_->busy()
           || !viewport_->finished();
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
    if (!may_discard()) {
        event->ignore();
        return;
    }
    job_.cancel();
    settings::set_window(saveGeometry(), saveState());
    settings::set_shown_layers(layers_->shown_names());
    event->accept();
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
    const auto urls = event->mimeData()->urls();
    if (QApplication::activeModalWidget()) return; // a question is open
    if (urls.size() == 1 && urls.front().isLocalFile()) event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent* event) {
    const auto urls = event->mimeData()->urls();
    if (urls.isEmpty() || !urls.front().isLocalFile() || QApplication::activeModalWidget()) return;
    event->acceptProposedAction();
    // The source of the drag waits for this event: questions come after it.
    const QString path = urls.front().toLocalFile();
    QTimer::singleShot(0, this, [this, path] { open_file(path); });
}

void MainWindow::keyPressEvent(QKeyEvent* event) {
    if (!picked_key_.empty() && event->key() == Qt::Key_Escape) return end_pick();
    if (!controller_->engaged() && cspace_->active()) {
        const int by = event->modifiers() & Qt::ShiftModifier ? 10 : 1;
        switch (event->key()) {
        case Qt::Key_Left:
            return cspace_->step(-by, 0);
        case Qt::Key_Right:
            return cspace_->step(by, 0);
        case Qt::Key_Up:
            return cspace_->step(0, -1);
        case Qt::Key_Down:
            return cspace_->step(0, 1);
        default:
            break;
        }
    }
    if (controller_->take_key(*event)) return;
    if (tool_at_ && (event->key() == Qt::Key_Left || event->key() == Qt::Key_Right)) {
        const int by = event->modifiers() & Qt::ShiftModifier ? 10 : 1;
        step_tool(event->key() == Qt::Key_Left ? -by : by);
        return;
    }
    QMainWindow::keyPressEvent(event);
}

} // namespace facetmill::ui
