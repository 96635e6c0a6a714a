// Undo and redo by keys from every field. A line takes the keys for what was typed into it; where nothing was
// typed since its value was shown they are the project's.
#pragma once

#include <QObject>

class QWidget;

namespace facetmill::ui {

class UndoKeys : public QObject {
    Q_OBJECT
public:
    explicit UndoKeys(QWidget* window);

    bool eventFilter(QObject* object, QEvent* event) override;

private:
    QWidget* window_;
};

} // namespace facetmill::ui
