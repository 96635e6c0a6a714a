// Strips of clean-up in the window: their dock, picking them in the view, and the previous tool's touch
// there.
#include "ui/main_window.h"

#include "ui/elided_label.h"
#include "ui/region_controller.h"
#include "ui/strip_controller.h"
#include "ui/verification_controller.h"
#include "ui/viewport.h"

#include <QAction>
#include <QDockWidget>

#include <algorithm>
#include <utility>

namespace facetmill::ui {

void MainWindow::build_strips() {
    strips_ = new StripController(document_, *viewport_, this);
    strips_dock_ = new QDockWidget(tr("Strips"), this);
    strips_dock_->setObjectName(QStringLiteral("strips_dock"));
    strips_dock_->setWidget(strips_->panel());
    addDockWidget(Qt::RightDockWidgetArea, strips_dock_);
    tabifyDockWidget(verification_dock_, strips_dock_);
    strips_dock_->hide();
    // Queued: a dock says that it is hidden before what is in it is.
    connect(strips_dock_, &QDockWidget::visibilityChanged, strips_, &StripController::look,
            Qt::QueuedConnection);
    connect(strips_dock_->toggleViewAction(), &QAction::triggered, this, [this](bool on) {
        if (on) strips_dock_->raise();
    });
    connect(strips_, &StripController::touch_wanted, this, &MainWindow::show_touch);
    connect(strips_, &StripController::touch_gone, this, [this] {
        hide_touch();
        if (controller_->engaged()) return;
        if (const auto pick = tool_at_)
            show_tool_at(*pick);
        else
            hide_tool();
        viewport_->refresh();
    });
    connect(strips_, &StripController::strips_shown, regions_, &RegionController::give_way);
    connect(regions_, &RegionController::ended, strips_, &StripController::show_again);
    connect(strips_, &StripController::failed, this, &MainWindow::fail);
    connect(strips_, &StripController::settled, this, &MainWindow::check_settled);
}

/// A newly planned clean-up brings the list to light, once; in a narrow window only its tab.
void MainWindow::offer_strips() {
    if (!strips_->any() || std::exchange(strips_offered_, true)) return;
    strips_dock_->show();
    arrange_report();
    if (dockWidgetArea(strips_dock_) == Qt::RightDockWidgetArea && !strips_dock_->isFloating()) {
        strips_dock_->raise();
        resizeDocks({strips_dock_}, {std::max(280, width() * 3 / 10)}, Qt::Horizontal);
    }
}

bool MainWindow::pick_strip(const PathPick& pick) {
    if (!strips_->takes_path_clicks() || pick.source >= shown_results_.size()) return false;
    const StrategyResult& path = shown_results_[pick.source]->path;
    if (pick.pass >= path.passes.size() || pick.point >= path.passes[pick.pass].cc.size()) return false;
    return strips_->pick(path.passes[pick.pass].cc[pick.point].point);
}

void MainWindow::show_touch(const Tool& tool, const CleanupRecord::Touch& touch) {
    Scene& scene = viewport_->scene();
    try {
        scene.set_tool(tool);
    } catch (const Error&) {
        return; // it was planned with: it makes a cutter
    }
    scene.set_tool_pose(CutterLocation{touch.tip, Vec3::UnitZ()});
    scene.set_marker(Marker{touch.center, Vec3::Zero()});
    scene.set_touches({touch.touch[0], touch.touch[1]});
    controller_->tool_taken();
    readout_text_.clear();
    readout_->set_text({});
    viewport_->refresh();
}

void MainWindow::hide_touch() {
    strips_->leave_tool();
    viewport_->scene().set_touches({});
}

} // namespace facetmill::ui
