// The unrolled view of a turning part's path: its dock, and how its mark and the tool go together.
#include "ui/main_window.h"

#include "ui/playback_controller.h"
#include "ui/settings.h"
#include "ui/unrolled_controller.h"
#include "ui/verification_controller.h"

#include <QDockWidget>
#include <QFileDialog>

#include <algorithm>
#include <utility>

namespace facetmill::ui {

void MainWindow::build_unrolled() {
    unrolled_ = new UnrolledController(document_, this);
    unrolled_dock_ = new QDockWidget(tr("Unrolled"), this);
    unrolled_dock_->setObjectName(QStringLiteral("unrolled_dock"));
    unrolled_dock_->setWidget(unrolled_->panel());
    addDockWidget(Qt::RightDockWidgetArea, unrolled_dock_);
    tabifyDockWidget(verification_dock_, unrolled_dock_);
    unrolled_dock_->hide();
    connect(unrolled_dock_, &QDockWidget::visibilityChanged, this, [this](bool seen) {
        if (seen) unrolled_->look();
    });
    connect(unrolled_dock_->toggleViewAction(), &QAction::triggered, this, [this](bool on) {
        if (on) unrolled_dock_->raise();
    });
    connect(unrolled_, &UnrolledController::place_wanted, this, &MainWindow::show_motion);
    connect(unrolled_, &UnrolledController::step_wanted, this, &MainWindow::step_tool);
    connect(unrolled_, &UnrolledController::failed, this, &MainWindow::fail);
    connect(unrolled_, &UnrolledController::told, this,
            [this](const QString& what) { tell(MessageBar::Kind::information, what, false); });
    connect(unrolled_, &UnrolledController::settled, this, &MainWindow::check_settled);
    connect(unrolled_, &UnrolledController::picture_requested, this, &MainWindow::export_unrolled);
    const PlaybackController* playback = &controller_->playback();
    connect(playback, &PlaybackController::moved, this, [this, playback] {
        if (!controller_->engaged() || !playback->loaded()) return;
        const PlaybackTrack& track = playback->track();
        const MotionPlace at = track.place(playback->position());
        if (const auto source = source_of(track.operation(at.program).result))
            unrolled_->set_place(*source, at.motion);
    });
}

/// A newly planned path of a turning part brings its unrolled view to light, once.
void MainWindow::offer_unrolled() {
    if (!unrolled_->any() || std::exchange(unrolled_offered_, true)) return;
    unrolled_dock_->show();
    arrange_report(); // a narrow window has no room for it beside the view
    if (dockWidgetArea(unrolled_dock_) == Qt::RightDockWidgetArea && !unrolled_dock_->isFloating()) {
        unrolled_dock_->raise();
        resizeDocks({unrolled_dock_}, {std::max(280, width() * 3 / 10)}, Qt::Horizontal);
    }
}

void MainWindow::export_unrolled() {
    QFileDialog dialog(this, tr("Export the unrolled path"), settings::last_folder(), tr("Pictures (*.png)"));
    dialog.setAcceptMode(QFileDialog::AcceptSave);
    dialog.setDefaultSuffix(QStringLiteral("png"));
    QString name = unrolled_->export_name();
    name.replace(QChar('/'), QChar('-'));
    dialog.selectFile(name + QStringLiteral(".png"));
    if (dialog.exec() != QDialog::Accepted || dialog.selectedFiles().isEmpty()) return;
    if (unrolled_->save_picture(dialog.selectedFiles().front())) last_failure_.clear();
}

} // namespace facetmill::ui
