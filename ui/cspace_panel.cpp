#include "ui/cspace_panel.h"

#include "ui/cspace_view.h"
#include "ui/elided_label.h"
#include "ui/flow_layout.h"
#include "ui/icon_button.h"
#include "ui/language.h"
#include "ui/text.h"
#include "ui/theme.h"
#include "ui/worded.h"
#include "viz/cspace_scene.h"
#include "viz/overlay.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QMenu>
#include <QPainter>
#include <QProgressBar>
#include <QScrollArea>
#include <QTimer>
#include <QToolButton>
#include <QVBoxLayout>

#include <cmath>

namespace facetmill::ui {

namespace {

/// A dark line on a dark panel is not seen.
bool stands_out(const QColor& color, const QColor& ground) {
    constexpr int least = 60; // of 255
    return std::abs(qGray(color.rgb()) - qGray(ground.rgb())) >= least;
}

/// As the legend of a picture draws it.
QPixmap sample_of(const LegendEntry& entry, double ratio, const QPalette& palette) {
    constexpr int width = 16, height = 12;
    QPixmap pixmap(int(std::ceil(width * ratio)), int(std::ceil(height * ratio)));
    pixmap.setDevicePixelRatio(ratio);
    pixmap.fill(Qt::transparent);
    QPainter p(&pixmap);
    p.setRenderHint(QPainter::Antialiasing);
    QColor color = to_qt(entry.color);
    switch (entry.sample) {
    case LegendEntry::Sample::spot:
        p.setPen(QPen(to_qt(fixed_colors().outline_ring), 1.5));
        p.setBrush(color);
        p.drawEllipse(QPointF(width / 2.0, height / 2.0), 5.0, 5.0);
        break;
    case LegendEntry::Sample::line:
        if (!stands_out(color, palette.color(QPalette::Window)))
            p.fillRect(QRectF(0, 0, width, height), palette.color(QPalette::PlaceholderText));
        p.fillRect(QRectF(0, height / 2.0 - 1, width, 2), color);
        break;
    case LegendEntry::Sample::box: {
        QColor pale = color;
        pale.setAlphaF(0.3f);
        p.setPen(color);
        p.setBrush(pale);
        p.drawRect(QRectF(0.5, 0.5, width - 1, height - 1));
        break;
    }
    default:
        p.fillRect(QRectF(0, 0, width, height), color);
    }
    return pixmap;
}

/// A small window has no room for view, legend and words at once.
QWidget* scrolled_body(QWidget& panel) {
    auto* whole = new QVBoxLayout(&panel);
    whole->setContentsMargins(0, 0, 0, 0);
    auto* scroll = new QScrollArea(&panel);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setWidgetResizable(true);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    scroll->setFocusPolicy(Qt::NoFocus);
    scroll->setWidget(new QWidget(scroll));
    whole->addWidget(scroll);
    return scroll->widget();
}

} // namespace

CSpacePanel::CSpacePanel(QWidget* parent) : QWidget(parent) {
    setObjectName(QStringLiteral("cspace"));
    auto* column = new QVBoxLayout(scrolled_body(*this));
    column->setContentsMargins(6, 6, 6, 6);
    column->setSpacing(4);
    auto* row = new QHBoxLayout;
    row->setSpacing(2);
    heading_ = new ElidedLabel(this);
    heading_->setObjectName(QStringLiteral("cspace_heading"));
    heading_->setMinimumWidth(40);
    heading_->set_elide_mode(Qt::ElideRight); // the point first, the operation's name after it
    row->addWidget(heading_, 1);
    const auto add = [&](Icon which, const QString& tip, const char* name) {
        auto* b = icon_button(this, which, tip, name);
        row->addWidget(b);
        return b;
    };
    auto* previous = add(Icon::step_back, tr("Point before on the pass (←; Shift: ten)"), "cspace_previous");
    auto* next = add(Icon::step_forward, tr("Next point on the pass (→; Shift: ten)"), "cspace_next");
    auto* up = add(Icon::up, tr("Pass before (↑)"), "cspace_pass_before");
    auto* down = add(Icon::down, tr("Next pass (↓)"), "cspace_pass_next");
    steps_ = {previous, next, up, down};
    connect(previous, &QToolButton::clicked, this, [this] { emit stepped(-1, 0); });
    connect(next, &QToolButton::clicked, this, [this] { emit stepped(1, 0); });
    connect(up, &QToolButton::clicked, this, [this] { emit stepped(0, -1); });
    connect(down, &QToolButton::clicked, this, [this] { emit stepped(0, 1); });
    back_ = add(Icon::reset, tr("Tool back to the planned posture"), "cspace_back");
    picture_ = add(Icon::picture, tr("Export the configuration space as a picture (PNG)"), "cspace_picture");
    table_ = add(Icon::export_program, tr("Export the postures as a table (CSV)"), "cspace_table");
    connect(back_, &QToolButton::clicked, this, &CSpacePanel::back_requested);
    connect(picture_, &QToolButton::clicked, this, &CSpacePanel::picture_requested);
    connect(table_, &QToolButton::clicked, this, &CSpacePanel::table_requested);
    column->addLayout(row);

    view_ = new CSpaceView(this);
    view_->setObjectName(QStringLiteral("cspace_view"));
    view_->setAccessibleName(tr("Configuration space"));
    view_->scene().set_legend_visible(false); // it stands below
    auto* busy = new QHBoxLayout;
    progress_ = new QProgressBar(view_);
    progress_->setObjectName(QStringLiteral("cspace_progress"));
    progress_->setRange(0, 1000);
    progress_->setTextVisible(false);
    progress_->setFixedHeight(6);
    cancel_ = icon_button(this, Icon::cancel, tr("Cancel"), "cspace_cancel", 12);
    connect(cancel_, &QToolButton::clicked, this, &CSpacePanel::cancel_requested);
    busy->addWidget(progress_, 1);
    busy->addWidget(cancel_);
    auto* over = new QVBoxLayout(view_); // it takes no room from the picture
    over->setContentsMargins(8, 4, 4, 4);
    over->addLayout(busy);
    over->addStretch(1);
    column->addWidget(view_, 1);
    view_->installEventFilter(this);
    legend_ = new QWidget(this);
    legend_->setObjectName(QStringLiteral("cspace_legend"));
    auto* flow = new FlowLayout(legend_, 10);
    flow->setContentsMargins(0, 0, 0, 0);
    column->addWidget(legend_);
    readout_ = new QLabel(this);
    readout_->setObjectName(QStringLiteral("cspace_readout"));
    readout_->setWordWrap(true);
    readout_->setTextFormat(Qt::PlainText);
    readout_->setAlignment(Qt::AlignLeft | Qt::AlignTop);
    readout_->setFixedHeight(3 * fontMetrics().lineSpacing() + 2); // the view does not jump
    readout_->setMinimumWidth(40);
    readout_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    column->addWidget(readout_);
    auto* by_hand = new QWidget(this);
    auto* keeping = new FlowLayout(by_hand, 4);
    keeping->setContentsMargins(0, 0, 0, 0);
    const auto worded = [&](const QString& label, const QString& tip, const char* name) {
        auto* b = new QToolButton(by_hand);
        b->setObjectName(QLatin1String(name));
        b->setText(label);
        b->setToolTip(tip);
        b->setToolButtonStyle(Qt::ToolButtonTextOnly);
        b->setFocusPolicy(Qt::TabFocus);
        keeping->addWidget(b);
        return b;
    };
    keep_ = worded(tr("Keep for this point"), {}, "cspace_keep");
    remove_ = worded(tr("Remove"), tr("Forget the posture kept for this point"), "cspace_remove");
    kept_ = worded(tr("Kept"), tr("Points with a posture kept by hand"), "cspace_kept");
    kept_->setPopupMode(QToolButton::MenuButtonPopup);
    connect(kept_, &QToolButton::clicked, kept_, &QToolButton::showMenu);
    connect(keep_, &QToolButton::clicked, this, &CSpacePanel::keep_requested);
    connect(remove_, &QToolButton::clicked, this, &CSpacePanel::remove_requested);
    column->addWidget(by_hand);
    connect(view_, &CSpaceView::stepped, this, &CSpacePanel::stepped);
    set_busy(false);
    set_ready(false, false);
}

void CSpacePanel::set_busy(bool busy, double fraction) {
    progress_->setVisible(busy);
    cancel_->setVisible(busy);
    progress_->setValue(int(1000 * fraction));
}

void CSpacePanel::set_ready(bool point, bool study) {
    for (QToolButton* b : steps_)
        b->setEnabled(point);
    for (QToolButton* b : {back_, picture_, table_})
        b->setEnabled(study);
}

bool CSpacePanel::names_in_legend() const {
    return view_->height() < CSpaceScene::min_height_of_names;
}

bool CSpacePanel::eventFilter(QObject* object, QEvent* event) {
    if (object == view_ && event->type() == QEvent::Resize && names_in_legend() != legend_names_)
        QTimer::singleShot(0, this, &CSpacePanel::show_legend);
    return QWidget::eventFilter(object, event);
}

void CSpacePanel::show_legend() {
    qDeleteAll(legend_->findChildren<QWidget*>(Qt::FindDirectChildrenOnly));
    legend_names_ = names_in_legend();
    for (const LegendEntry& entry : view_->scene().legend()) {
        if (entry.sample == LegendEntry::Sample::spot && !legend_names_) continue; // named in the view
        auto* item = new QWidget(legend_);
        auto* row = new QHBoxLayout(item);
        row->setContentsMargins(0, 0, 0, 0);
        row->setSpacing(5);
        auto* sample = new QLabel(item);
        sample->setPixmap(sample_of(entry, devicePixelRatioF(), palette()));
        row->addWidget(sample);
        row->addWidget(new QLabel(text(said_in_view(entry.label)), item));
        legend_->layout()->addWidget(item);
        item->show();
    }
    legend_->updateGeometry();
}

void CSpacePanel::show_kept(const std::vector<Kept>& all) {
    kept_->setText(tr("Kept: %1").arg(all.size()));
    kept_->setVisible(!all.empty());
    if (QMenu* old = kept_->menu()) { // which may be what led here
        kept_->setMenu(nullptr);
        old->deleteLater();
    }
    if (all.empty()) return;
    auto* menu = new QMenu(kept_);
    for (const Kept& k : all)
        menu->addAction(k.label, this, [this, point = k.point] { emit kept_chosen(point); });
    kept_->setMenu(menu);
}

} // namespace facetmill::ui
