// What happened, with the time of day: a line per event, the newest below.
#pragma once

#include "ui/message_bar.h"

#include <QPlainTextEdit>

namespace facetmill::ui {

class LogView : public QPlainTextEdit {
    Q_OBJECT
public:
    explicit LogView(QWidget* parent = nullptr);
    void add(MessageBar::Kind kind, const QString& line);
    QSize sizeHint() const override { return {400, 80}; }
    QSize minimumSizeHint() const override { return {80, 40}; }
};

} // namespace facetmill::ui
