#include "ui/unrolled_controller.h"

#include "ui/export.h"
#include "ui/icons.h"
#include "ui/text.h"
#include "ui/unrolled_view.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QSignalBlocker>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>

namespace facetmill::ui {

namespace {
constexpr QSize picture_size(1400, 1000);
}

UnrolledController::UnrolledController(Document& document, QWidget* window)
    : QObject(window), document_(document), panel_(new QWidget(window)), unit_(document.unit()) {
    panel_->setObjectName(QStringLiteral("unrolled"));
    auto* column = new QVBoxLayout(panel_);
    column->setContentsMargins(6, 4, 6, 6);
    column->setSpacing(4);
    auto* row = new QHBoxLayout;
    operation_ = new QComboBox(panel_);
    operation_->setObjectName(QStringLiteral("unrolled_operation"));
    operation_->setToolTip(tr("Of which operation"));
    operation_->setFocusPolicy(Qt::TabFocus);
    operation_->setMinimumContentsLength(8);
    row->addWidget(operation_);
    row->addStretch(1);
    const auto add = [&](Icon which, const QString& tip, const char* name) {
        auto* button = new QToolButton(panel_);
        button->setObjectName(QLatin1String(name));
        button->setIcon(icon(which));
        button->setIconSize(QSize(16, 16));
        button->setAutoRaise(true);
        button->setToolTip(tip);
        button->setFocusPolicy(Qt::TabFocus);
        row->addWidget(button);
        return button;
    };
    all_ = add(Icon::fit, tr("Show all of it (double click, Home)"), "unrolled_all");
    picture_ = add(Icon::picture, tr("Export the unrolled path as a picture (PNG)"), "unrolled_picture");
    column->addLayout(row);
    view_ = new UnrolledView(panel_);
    column->addWidget(view_, 1);
    connect(operation_, &QComboBox::currentIndexChanged, this, &UnrolledController::update);
    connect(all_, &QToolButton::clicked, view_, &UnrolledView::reset_view);
    connect(picture_, &QToolButton::clicked, this, &UnrolledController::picture_requested);
    connect(view_, &UnrolledView::motion_wanted, this, [this](std::size_t motion) {
        if (const auto at = source()) emit place_wanted(*at, motion);
    });
    connect(view_, &UnrolledView::stepped, this, &UnrolledController::step_wanted);
    connect(&job_, &BackgroundJob::ended, this, [this](const JobEnd& end) {
        if (end.how == JobEnd::How::failed) emit failed(end.message);
        emit settled();
    });
    connect(&document_, &Document::changed, this, [this] {
        if (unit_ != document_.unit()) update();
    });
    set_paths({});
}

UnrolledController::~UnrolledController() = default;

void UnrolledController::set_paths(std::vector<std::shared_ptr<const OperationResult>> results) {
    job_.cancel();
    results_ = std::move(results);
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

void UnrolledController::look() {
    update();
}

/// Makes what is missing for what is wanted, once it is seen.
void UnrolledController::update() {
    enable_buttons();
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
            enable_buttons();
            show_place();
        });
}

void UnrolledController::enable_buttons() {
    for (QToolButton* button : {all_, picture_})
        button->setEnabled(view_->path() != nullptr);
}

void UnrolledController::set_place(std::size_t source, std::size_t motion) {
    place_ = {source, motion};
    const auto at = std::find(sources_.begin(), sources_.end(), source);
    if (at != sources_.end()) operation_->setCurrentIndex(int(at - sources_.begin()));
    show_place();
}

void UnrolledController::clear_place() {
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

bool UnrolledController::save_picture(const QString& path) {
    const QString wrong = write_picture(path, view_->picture(picture_size));
    if (wrong.isEmpty())
        emit told(tr("Wrote %1.").arg(path));
    else
        emit failed(wrong);
    return wrong.isEmpty();
}

} // namespace facetmill::ui
