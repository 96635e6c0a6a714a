#include "ui/start_hint.h"

#include "core/mesh/mesh_format.h"
#include "ui/icons.h"
#include "ui/text.h"
#include "ui/theme.h"

#include <QEvent>
#include <QLabel>
#include <QMenu>
#include <QPushButton>
#include <QVBoxLayout>

namespace facetmill::ui {

StartHint::StartHint(QMenu* samples, QWidget* parent) : QFrame(parent) {
    setObjectName(QStringLiteral("start_hint"));
    setAutoFillBackground(true);
    setFrameShape(QFrame::StyledPanel);
    title_ = new QLabel(tr("Open a mesh or drop one here"), this);
    QFont large = title_->font();
    large.setPointSizeF(large.pointSizeF() * 1.3);
    large.setBold(true);
    title_->setFont(large);
    title_->setAlignment(Qt::AlignCenter);
    text_ = new QLabel(tr("%1, or a Facetmill project").arg(text(mesh_format_names())), this);
    text_->setAlignment(Qt::AlignCenter);
    text_->setForegroundRole(QPalette::PlaceholderText);
    auto* open = new QPushButton(icon(Icon::open), tr("Open…"), this);
    open->setObjectName(QStringLiteral("hint_open"));
    connect(open, &QPushButton::clicked, this, &StartHint::open_requested);
    auto* sample = new QPushButton(icon(Icon::part), tr("New from sample"), this);
    sample->setObjectName(QStringLiteral("hint_sample"));
    sample->setMenu(samples);
    auto* buttons = new QHBoxLayout;
    buttons->addStretch(1);
    buttons->addWidget(open);
    buttons->addWidget(sample);
    buttons->addStretch(1);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(22, 18, 22, 18);
    column->setSpacing(10);
    column->addWidget(title_);
    column->addWidget(text_);
    column->addLayout(buttons);
    parent->installEventFilter(this);
    place();
}

void StartHint::place() {
    if (!parentWidget()) return;
    adjustSize();
    const QSize room = parentWidget()->size();
    move(std::max(0, (room.width() - width()) / 2), std::max(0, (room.height() - height()) / 2));
}

bool StartHint::eventFilter(QObject* object, QEvent* event) {
    if (event->type() == QEvent::Resize || event->type() == QEvent::Show) place();
    return QFrame::eventFilter(object, event);
}

} // namespace facetmill::ui
