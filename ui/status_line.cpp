#include "ui/status_line.h"

#include "core/job/work_zero.h"
#include "ui/elided_label.h"
#include "ui/text.h"

#include <QAction>
#include <QComboBox>
#include <QLabel>
#include <QProgressBar>
#include <QStatusBar>
#include <QToolButton>

#include <cmath>

namespace facetmill::ui {

constexpr int min_progress_width = 170;

QString time_left_text(double seconds) {
    // As coarse as it is known.
    if (seconds < 10) return StatusLine::tr("a few s left");
    if (seconds < 55) return StatusLine::tr("%1 s left").arg(10 * std::lround(seconds / 10));
    if (seconds < 3300) return StatusLine::tr("%1 min left").arg(std::max(1L, std::lround(seconds / 60)));
    const double hours = seconds / 3600;
    return StatusLine::tr("%1 h left")
        .arg(hours < 10 ? in_user_numbers(QString::number(hours, 'f', 1))
                        : QString::number(std::lround(hours)));
}

void say_in_bar(QProgressBar& bar, const QString& format) {
    constexpr int beside_words = 12;
    bar.setFormat(format);
    const int need = bar.fontMetrics().horizontalAdvance(bar.text()) + beside_words;
    if (need > bar.width()) bar.setFixedWidth(need);
}

StatusLine::StatusLine(const Document& document, QStatusBar* bar)
    : QObject(bar), document_(document), bar_(bar) {
    activity_ = new QLabel(tr("Ready"), bar);
    activity_->setObjectName(QStringLiteral("activity"));
    activity_->setMinimumWidth(90);
    progress_ = new QProgressBar(bar);
    progress_->setObjectName(QStringLiteral("progress"));
    progress_->setRange(0, 1000);
    progress_->setTextVisible(true);
    progress_->setFixedWidth(min_progress_width);
    progress_->setMaximumHeight(16);
    cancel_button_ = new QToolButton(bar);
    cancel_button_->setObjectName(QStringLiteral("cancel_button"));
    cancel_button_->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    cancel_button_->setIconSize(QSize(14, 14));
    readout_ = new ElidedLabel(bar);
    readout_->setObjectName(QStringLiteral("readout"));
    readout_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    unit_box_ = new QComboBox(bar);
    unit_box_->setObjectName(QStringLiteral("unit"));
    unit_box_->addItems({QStringLiteral("mm"), QStringLiteral("in")});
    unit_box_->setToolTip(tr("Unit of the project: of all fields, reports and written programs"));
    unit_box_->setFocusPolicy(Qt::TabFocus);
    connect(unit_box_, &QComboBox::activated, this,
            [this](int i) { emit unit_chosen(i == 1 ? LengthUnit::inch : LengthUnit::mm); });
    bar->addWidget(activity_);
    bar->addWidget(progress_);
    bar->addWidget(cancel_button_);
    bar->addWidget(readout_, 1);
    bar->addPermanentWidget(unit_box_);
    progress_->hide();
    cancel_button_->hide();
}

void StatusLine::follow(const BackgroundJob& job, QAction* cancel) {
    cancel_button_->setDefaultAction(cancel);
    connect(&job, &BackgroundJob::started, this, [this](const QString& title) {
        activity_->setText(title);
        since_.start();
        progress_->setValue(0);
        progress_->setFixedWidth(min_progress_width);
        progress_->setFormat(QStringLiteral("%p %"));
        progress_->show();
        cancel_button_->show();
    });
    connect(&job, &BackgroundJob::progressed, this, [this, &job](double fraction, const QString& label) {
        progress_->setValue(int(fraction * 1000));
        show_time_left(fraction);
        if (job.cancelling())
            show_cancelling();
        else if (!label.isEmpty())
            activity_->setText(elided(label, 60));
    });
    connect(&job, &BackgroundJob::ended, this, [this] {
        progress_->hide();
        cancel_button_->hide();
        activity_->setText(tr("Ready"));
    });
}

void StatusLine::show_time_left(double fraction) {
    // Before that a guess would jump about.
    constexpr double min_seconds = 3, min_fraction = 0.03;
    const double gone = 1e-3 * double(since_.elapsed());
    if (gone < min_seconds || fraction < min_fraction) return;
    say_in_bar(*progress_, QStringLiteral("%p % · ") + time_left_text(gone * (1 - fraction) / fraction));
}

void StatusLine::show_cancelling() {
    activity_->setText(tr("Cancelling…"));
}

void StatusLine::set_readout(const QStringList& parts) {
    readout_parts_ = parts;
    show_readout();
}

void StatusLine::show_readout() {
    const auto from = [&](qsizetype first) { return readout_parts_.mid(first).join(QStringLiteral("   ")); };
    QStringList shorter;
    for (qsizetype first = 1; first < readout_parts_.size(); ++first)
        shorter << from(first);
    readout_->set_text(from(0), shorter);
}

void StatusLine::set_hovered(const std::optional<PartPick>& pick) {
    if (!pick) {
        show_readout();
        return;
    }
    Vec3 zero = Vec3::Zero(); // places are told as the control tells them
    try {
        if (document_.part()) zero = work_zero(document_.project(), *document_.part());
    } catch (const Error&) {
        // There is no stock for it to be on: told where it is set.
    }
    const Vec3 at = pick->point - zero;
    const double mm = mm_per(document_.unit());
    const auto number = [&](double v) {
        return in_user_numbers(QString::number(v / mm, 'f', document_.unit() == LengthUnit::inch ? 4 : 3));
    };
    readout_->set_text(
        QStringLiteral("x %1   y %2   z %3 %4")
            .arg(number(at.x()), number(at.y()), number(at.z()), text(unit_name(document_.unit()))));
}

void StatusLine::refresh() {
    unit_box_->setCurrentIndex(document_.unit() == LengthUnit::inch ? 1 : 0);
    unit_box_->setEnabled(document_.has_part());
}

} // namespace facetmill::ui
