// What the workbench tells its user: every message goes to the log, the important ones to the bar above the
// view too.
#pragma once

#include "ui/message_bar.h"

namespace facetmill::ui {

class LogView;

class Messages {
public:
    Messages(MessageBar& bar, LogView& log) : bar_(bar), log_(log) {}

    void tell(MessageBar::Kind kind, const QString& message, bool in_bar = true);
    void information(const QString& message, bool in_bar = true);
    void warning(const QString& message, bool in_bar = true);
    void fail(const QString& message);
    /// Something succeeded: the last failure is forgotten.
    void succeeded() { last_failure_.clear(); }
    /// The last thing that failed, until something succeeds.
    const QString& last_failure() const { return last_failure_; }
    /// Shows a message in the bar alone.
    void show(const QString& message) { bar_.show_message(MessageBar::Kind::information, message); }
    /// A button beside the message in the bar, until another one is there.
    void offer(MessageAction action) { bar_.offer(std::move(action)); }
    const MessageBar& bar() const { return bar_; }
    /// Empties the bar.
    void dismiss() { bar_.dismiss(); }

private:
    MessageBar& bar_;
    LogView& log_;
    QString last_failure_;
};

} // namespace facetmill::ui
