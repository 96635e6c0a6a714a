// Charts and colours of the path in the window: their dock, and how cursor and tool go together.
#include "ui/main_window.h"

#include "ui/inspection_controller.h"
#include "ui/playback_controller.h"
#include "ui/settings.h"
#include "ui/verification_controller.h"

#include <QDockWidget>
#include <QFileDialog>

#include <algorithm>
#include <utility>

namespace facetmill::ui {

void MainWindow::build_inspection() {
    inspection_ = new InspectionController(document_, *viewport_, *layers_, this);
    chart_dock_ = new QDockWidget(tr("Charts"), this);
    chart_dock_->setObjectName(QStringLiteral("chart_dock"));
    chart_dock_->setWidget(inspection_->panel());
    addDockWidget(Qt::BottomDockWidgetArea, chart_dock_);
    tabifyDockWidget(log_dock_, chart_dock_);
    chart_dock_->hide();
    connect(chart_dock_, &QDockWidget::visibilityChanged, this, [this](bool seen) {
        if (!seen) return;
        // The log beside it is content with a few lines.
        if (!chart_dock_->isFloating() && !std::exchange(chart_sized_, true))
            resizeDocks({chart_dock_}, {std::clamp(height() * 3 / 10, 150, 300)}, Qt::Vertical);
        inspection_->look();
    });
    connect(chart_dock_->toggleViewAction(), &QAction::triggered, this, [this](bool on) {
        if (on) chart_dock_->raise();
    });
    connect(inspection_, &InspectionController::place_wanted, this, &MainWindow::show_motion);
    connect(inspection_, &InspectionController::step_wanted, this, &MainWindow::step_tool);
    connect(inspection_, &InspectionController::failed, this, &MainWindow::fail);
    connect(inspection_, &InspectionController::told, this,
            [this](const QString& what) { tell(MessageBar::Kind::information, what, false); });
    connect(inspection_, &InspectionController::settled, this, &MainWindow::check_settled);
    connect(inspection_->panel(), &InspectionPanel::picture_requested, this, [this] { export_chart(false); });
    connect(inspection_->panel(), &InspectionPanel::table_requested, this, [this] { export_chart(true); });
    const PlaybackController* playback = &controller_->playback();
    connect(playback, &PlaybackController::moved, this, [this, playback] {
        if (!controller_->engaged() || !playback->loaded()) return;
        const PlaybackTrack& track = playback->track();
        const double position = playback->position();
        const MotionPlace at = track.place(position);
        const auto source = source_of(track.operation(at.program).result);
        if (!source) return;
        inspection_->set_place(*source, at.motion,
                               std::clamp(position - (track.position_of(at) - 1), 0.0, 1.0));
    });
}

void MainWindow::export_chart(bool table) {
    QFileDialog dialog(this, table ? tr("Export the chart's values") : tr("Export the chart"),
                       settings::last_folder(), table ? tr("Tables (*.csv)") : tr("Pictures (*.png)"));
    dialog.setAcceptMode(QFileDialog::AcceptSave);
    dialog.setDefaultSuffix(table ? QStringLiteral("csv") : QStringLiteral("png"));
    QString name = inspection_->export_name();
    name.replace(QChar('/'), QChar('-'));
    dialog.selectFile(name + QChar('.') + dialog.defaultSuffix());
    if (dialog.exec() != QDialog::Accepted || dialog.selectedFiles().isEmpty()) return;
    const QString path = dialog.selectedFiles().front();
    if (table ? inspection_->save_table(path) : inspection_->save_picture(path)) last_failure_.clear();
}

} // namespace facetmill::ui
