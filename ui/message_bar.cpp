#include "ui/message_bar.h"

#include "ui/icons.h"
#include "ui/text.h"
#include "ui/theme.h"

#include <QApplication>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QRegularExpression>
#include <QToolButton>
#include <QWheelEvent>

#include <algorithm>
#include <utility>

namespace facetmill::ui {

namespace {

/// Lines are broken at spaces and after slashes: what is longer than this without them, a name, would be cut
/// off at the bar's end.
constexpr int longest_word = 40;

QString with_short_words(const QString& message) {
    static const QRegularExpression word(QStringLiteral("[^\\s/]{%1,}").arg(longest_word + 1));
    QString result;
    qsizetype from = 0;
    for (auto it = word.globalMatch(message); it.hasNext();) {
        const auto match = it.next();
        result += message.mid(from, match.capturedStart() - from) + elided(match.captured(), longest_word);
        from = match.capturedEnd();
    }
    return result + message.mid(from);
}

} // namespace

MessageBar::MessageBar(QWidget* parent) : QFrame(parent) {
    setObjectName(QStringLiteral("message_bar"));
    setAttribute(Qt::WA_NoMousePropagation); // what is clicked here is not meant for the view below
    setAutoFillBackground(true);
    icon_ = new QLabel(this);
    text_ = new QLabel(this);
    text_->setObjectName(QStringLiteral("message_text"));
    text_->setWordWrap(true);
    text_->setTextFormat(Qt::PlainText);
    text_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    text_->setMinimumWidth(60);
    text_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    button_ = new QPushButton(this);
    button_->setObjectName(QStringLiteral("message_button"));
    button_->hide();
    // What it does may show another message.
    connect(button_, &QPushButton::clicked, this, [this] {
        if (const auto run = action_.run) run();
    });
    close_ = new QToolButton(this);
    close_->setIcon(icon(Icon::close));
    close_->setAutoRaise(true);
    close_->setToolTip(tr("Dismiss"));
    close_->setAccessibleName(close_->toolTip());
    connect(close_, &QToolButton::clicked, this, &MessageBar::dismiss);
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(10, 5, 5, 5);
    row->addWidget(icon_, 0, Qt::AlignTop);
    row->addWidget(text_, 1);
    row->addWidget(button_, 0, Qt::AlignTop);
    row->addWidget(close_, 0, Qt::AlignTop);
    parent->installEventFilter(this);
    hide();
}

void MessageBar::show_message(Kind kind, const QString& message) {
    kind_ = kind;
    message_ = message;
    const QString shown = with_short_words(message);
    text_->setText(kept_together(shown));
    text_->setToolTip(shown == message ? QString() : message);
    offer({});
    color();
    show();
    place();
    raise();
}

void MessageBar::place() {
    const QSize room = parentWidget()->size();
    const int height = layout()->totalHeightForWidth(room.width());
    setGeometry(0, std::max(0, room.height() - height), room.width(), height);
}

void MessageBar::wheelEvent(QWheelEvent* event) {
    event->accept();
}

bool MessageBar::eventFilter(QObject* object, QEvent* event) {
    if (event->type() == QEvent::Resize && isVisible()) place();
    return QFrame::eventFilter(object, event);
}

void MessageBar::offer(MessageAction action) {
    action_ = std::move(action);
    button_->setText(action_.text);
    button_->setVisible(!action_.text.isEmpty());
    if (isVisible()) place();
}

void MessageBar::dismiss() {
    hide();
    text_->clear();
    message_.clear();
    offer({});
    emit dismissed();
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
