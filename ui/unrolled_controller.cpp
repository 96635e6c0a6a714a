#include "ui/unrolled_controller.h"

#include "ui/export.h"
#include "ui/file_writing.h"
#include "ui/shown_paths.h"
#include "ui/text.h"
#include "ui/unrolled_panel.h"
#include "ui/unrolled_view.h"

#include <QComboBox>
#include <QSignalBlocker>

#include <algorithm>
#include <functional>

namespace facetmill::ui {

namespace {
constexpr QSize unrolled_picture_size(1400, 1000);
}

UnrolledController::UnrolledController(Document& document, QWidget* window)
    : Controller(window), document_(document), panel_(new UnrolledPanel(window)), unit_(document.unit()) {
    view_ = panel_->view();
    operation_ = panel_->operation_box();
    connect(operation_, &QComboBox::currentIndexChanged, this, &UnrolledController::update);
    connect(panel_, &UnrolledPanel::picture_requested, this, [this] {
        export_file(panel_, tr("Export the unrolled path"), ExportFormat::picture, export_name(),
                    std::bind_front(&UnrolledController::save_picture, this));
    });
    connect(view_, &UnrolledView::motion_wanted, this, [this](std::size_t motion) {
        if (const auto at = source()) emit place_wanted(*at, motion);
    });
    connect(view_, &UnrolledView::stepped, this, &UnrolledController::step_wanted);
    connect(&job_, &BackgroundJob::ended, this, [this](const JobEnd& end) {
        if (end.how == JobEnd::How::failed) emit failed(end.message);
        emit settled();
    });
    list_paths();
}

UnrolledController::~UnrolledController() = default;

void UnrolledController::project_changed() {
    if (unit_ != document_.unit()) update();
}

void UnrolledController::paths_shown(const ShownPaths& paths) {
    job_.cancel();
    results_ = paths.programs();
    list_paths();
    if (!sources_.empty()) offer();
}

void UnrolledController::list_paths() {
    sources_.clear();
    place_.reset();
    {
        const QSignalBlocker quiet(operation_);
        const QString was = operation_->currentText();
        operation_->clear();
        for (std::size_t i = 0; i < results_.size(); ++i) {
            if (!results_[i]->path.as<TurnedPath>()) continue;
            sources_.push_back(i);
            operation_->addItem(elided(text(results_[i]->name), 40));
        }
        operation_->setCurrentIndex(std::max(sources_.empty() ? -1 : 0, operation_->findText(was)));
        operation_->setVisible(sources_.size() > 1);
    }
    view_->clear(results_.empty() ? tr("Plan an operation to see it here")
                                  : tr("No operation turns the part: there is nothing to unroll"));
    update();
}

std::optional<std::size_t> UnrolledController::source() const {
    const auto at = std::size_t(std::max(0, operation_->currentIndex()));
    if (at >= sources_.size()) return std::nullopt;
    return sources_[at];
}

void UnrolledController::panel_seen(bool seen) {
    if (seen) update();
}

/// Makes what is missing for what is wanted, once it is seen.
void UnrolledController::update() {
    panel_->set_ready(view_->path() != nullptr);
    const auto at = source();
    if (!at || !panel_->isVisible()) return;
    const auto result = results_[*at];
    const LengthUnit unit = document_.unit();
    if (view_->path() && view_->path()->operation == result && unit == unit_) {
        show_place();
        return;
    }
    auto path = std::make_shared<UnrolledPathPtr>();
    job_.start(
        tr("Unrolling the path"),
        [path, result, unit](const Progress& p) { *path = prepare_unrolled(result, unit, p); },
        [this, path, result, unit](const JobEnd& end) {
            const auto now = source();
            if (!end.done() || !now || results_[*now] != result || unit != document_.unit()) return;
            unit_ = unit;
            if (*path)
                view_->set_path(*path);
            else
                view_->clear(tr("Nothing is cut"));
            panel_->set_ready(view_->path() != nullptr);
            show_place();
        });
}

void UnrolledController::place_shown(std::size_t source, std::size_t motion, double) {
    place_ = {source, motion};
    const auto at = std::find(sources_.begin(), sources_.end(), source);
    if (at != sources_.end()) operation_->setCurrentIndex(int(at - sources_.begin()));
    show_place();
}

void UnrolledController::tool_removed() {
    place_.reset();
    view_->set_motion(std::nullopt);
}

void UnrolledController::show_place() {
    const auto at = source();
    view_->set_motion(place_ && at && place_->first == *at ? std::optional(place_->second) : std::nullopt);
}

QString UnrolledController::export_name() const {
    const auto at = source();
    return (at ? text(results_[*at]->name) : QString()) + QStringLiteral("-unrolled");
}

void UnrolledController::save_picture(const QString& path) {
    write_file(
        *this, document_, path,
        [picture = view_->picture(unrolled_picture_size)] { return png_bytes(picture); },
        [this, path](const QString& wrong) { report_written(path, wrong); });
}

} // namespace facetmill::ui
