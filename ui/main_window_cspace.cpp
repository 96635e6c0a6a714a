// The configuration-space room in the window: its dock, and the tool in the part view at its postures.
#include "ui/main_window.h"

#include "ui/cspace_controller.h"
#include "ui/elided_label.h"
#include "ui/inspection_controller.h"
#include "ui/settings.h"
#include "ui/text.h"
#include "ui/verification_controller.h"
#include "ui/viewport.h"

#include <QDockWidget>
#include <QFileDialog>
#include <QFileInfo>

#include <algorithm>
#include <utility>

namespace facetmill::ui {

void MainWindow::build_cspace() {
    cspace_ = new CSpaceController(document_, this);
    cspace_dock_ = new QDockWidget(tr("Configuration space"), this);
    cspace_dock_->setObjectName(QStringLiteral("cspace_dock"));
    cspace_dock_->setWidget(cspace_->panel());
    addDockWidget(Qt::RightDockWidgetArea, cspace_dock_);
    tabifyDockWidget(verification_dock_, cspace_dock_);
    connect(cspace_dock_, &QDockWidget::visibilityChanged, this, [this](bool seen) {
        if (seen) cspace_->look();
    });
    connect(cspace_, &CSpaceController::tool_wanted, this, &MainWindow::show_cspace_tool);
    connect(cspace_, &CSpaceController::failed, this, &MainWindow::fail);
    connect(cspace_, &CSpaceController::told, this,
            [this](const QString& what) { tell(MessageBar::Kind::information, what, false); });
    connect(cspace_, &CSpaceController::settled, this, &MainWindow::check_settled);
    connect(cspace_->panel(), &CSpacePanel::picture_requested, this, [this] { export_cspace(false); });
    connect(cspace_->panel(), &CSpacePanel::table_requested, this, [this] { export_cspace(true); });
}

void MainWindow::follow_cspace(const PathPick& pick) {
    const auto& result = shown_results_[pick.source];
    const StrategyResult& path = result->path;
    Vec3 place = pick.location.tip;
    if (pick.pass < path.passes.size() && pick.point < path.passes[pick.pass].cc.size())
        place = path.passes[pick.pass].cc[pick.point].point;
    const bool first = !cspace_->point();
    if (!cspace_->go_near(shown_ids_[pick.source], result, place)) {
        cspace_->leave();
        return;
    }
    // A newly planned 5-axis operation brings the room to light, once; in a narrow window only its tab.
    if (first && !std::exchange(cspace_offered_, true)) {
        cspace_dock_->show();
        if (dockWidgetArea(cspace_dock_) == Qt::RightDockWidgetArea && !cspace_dock_->isFloating()) {
            cspace_dock_->raise();
            resizeDocks({cspace_dock_}, {std::max(250, width() * 3 / 10)}, Qt::Horizontal);
        }
    }
}

void MainWindow::show_cspace_tool(int operation, const std::optional<CutterLocation>& pose,
                                  const Marker& contact, const QString& readout) {
    const auto source = source_of(cspace_->program());
    if (!document_.index_of(operation) || !source) return;
    Scene& scene = viewport_->scene();
    hide_touch();
    try {
        scene.set_tool(tool_of(*source));
    } catch (const Error&) {
        hide_tool(); // the operation's tool was changed into none since it was planned
        return;
    }
    scene.set_tool_pose(pose);
    scene.set_marker(contact);
    readout_text_ = readout;
    readout_->set_text(readout);
    if (pose) {
        // Steps along the path go on from the motion that is nearest.
        PathPick pick;
        pick.source = *source;
        const auto& motions = shown_results_[pick.source]->program.motions.motions;
        double nearest = infinity;
        for (std::size_t m = 0; m < motions.size(); ++m) {
            const double away = (motions[m].to.tip - pose->tip).squaredNorm();
            if (motions[m].kind == MotionKind::cut && away < nearest) {
                nearest = away;
                pick.motion = m;
                pick.pass = motions[m].pass;
                pick.point = motions[m].point;
            }
        }
        pick.position = pose->tip;
        pick.location = *pose;
        if (pick.motion < motions.size()) {
            tool_at_ = pick;
            inspection_->set_place(pick.source, pick.motion);
        }
    }
    viewport_->refresh();
}

void MainWindow::export_cspace(bool table) {
    QFileDialog dialog(this, table ? tr("Export postures") : tr("Export configuration space"),
                       settings::last_folder(), table ? tr("Tables (*.csv)") : tr("Pictures (*.png)"));
    dialog.setAcceptMode(QFileDialog::AcceptSave);
    dialog.setDefaultSuffix(table ? QStringLiteral("csv") : QStringLiteral("png"));
    dialog.selectFile(QStringLiteral("%1-point-%2.%3")
                          .arg(QFileInfo(document_.name()).completeBaseName())
                          .arg(cspace_->point().value_or(0))
                          .arg(dialog.defaultSuffix()));
    if (dialog.exec() != QDialog::Accepted || dialog.selectedFiles().isEmpty()) return;
    const QString path = dialog.selectedFiles().front();
    if (table ? cspace_->save_table(path) : cspace_->save_picture(path)) last_failure_.clear();
}

} // namespace facetmill::ui
