#include "ui/message_bar.h"

#include "ui/icons.h"
#include "ui/theme.h"

#include <QApplication>
#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>

namespace facetmill::ui {

MessageBar::MessageBar(QWidget* parent) : QFrame(parent) {
    setObjectName(QStringLiteral("message_bar"));
    setAutoFillBackground(true);
    icon_ = new QLabel(this);
    text_ = new QLabel(this);
    text_->setObjectName(QStringLiteral("message_text"));
    text_->setWordWrap(true);
    text_->setTextFormat(Qt::PlainText);
    text_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    text_->setMinimumWidth(60);
    text_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    close_ = new QToolButton(this);
    close_->setIcon(icon(Icon::close));
    close_->setAutoRaise(true);
    close_->setToolTip(tr("Dismiss"));
    connect(close_, &QToolButton::clicked, this, &MessageBar::dismiss);
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(10, 5, 5, 5);
    row->addWidget(icon_, 0, Qt::AlignTop);
    row->addWidget(text_, 1);
    row->addWidget(close_, 0, Qt::AlignTop);
    hide();
}

void MessageBar::show_message(Kind kind, const QString& message) {
    kind_ = kind;
    text_->setText(message);
    color();
    show();
}

QString MessageBar::message() const {
    return isHidden() ? QString() : text_->text();
}

void MessageBar::dismiss() {
    hide();
    text_->clear();
}

void MessageBar::color() {
    const QPalette window = QApplication::palette();
    const SignalColors signal = signal_colors(window);
    const QColor mark = kind_ == Kind::error     ? signal.bad
                        : kind_ == Kind::warning ? signal.attention
                                                 : signal.busy;
    const QColor ground = window.color(QPalette::Window);
    QPalette own = window;
    own.setColor(QPalette::Window, mixed(ground, 6, mark));
    setPalette(own);
    icon_->setPixmap(icon(kind_ == Kind::error     ? Icon::error
                          : kind_ == Kind::warning ? Icon::warning
                                                   : Icon::information)
                         .pixmap(18, 18));
}

} // namespace facetmill::ui
