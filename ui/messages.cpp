#include "ui/messages.h"

#include "ui/log_view.h"
#include "ui/text.h"

namespace facetmill::ui {

void Messages::tell(MessageBar::Kind kind, const QString& message, bool in_bar) {
    log_.add(kind, message);
    if (in_bar) bar_.show_message(kind, message);
}

void Messages::information(const QString& message, bool in_bar) {
    tell(MessageBar::Kind::information, message, in_bar);
}

void Messages::warning(const QString& message, bool in_bar) {
    tell(MessageBar::Kind::warning, message, in_bar);
}

void Messages::fail(const QString& message) {
    last_failure_ = message;
    tell(MessageBar::Kind::error, sentence(message));
}

} // namespace facetmill::ui
