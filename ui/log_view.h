// What happened, with the time of day: a line per event, the newest below.
#pragma once

#include "ui/message_bar.h"

#include <QPlainTextEdit>

#include <vector>

namespace facetmill::ui {

class LogView : public QPlainTextEdit {
    Q_OBJECT
public:
    explicit LogView(QWidget* parent = nullptr);
    void add(MessageBar::Kind kind, const QString& line);
    QSize sizeHint() const override { return {400, 80}; }
    QSize minimumSizeHint() const override { return {80, 40}; }

protected:
    void changeEvent(QEvent* event) override;

private:
    struct Entry {
        MessageBar::Kind kind;
        QString time, line;
    };
    void append(const Entry& entry);
    std::vector<Entry> entries_;
};

} // namespace facetmill::ui
