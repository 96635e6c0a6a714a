#include "ui/undo_keys.h"

#include <QComboBox>
#include <QCoreApplication>
#include <QKeyEvent>
#include <QLineEdit>

namespace facetmill::ui {

UndoKeys::UndoKeys(QWidget* window) : QObject(window), window_(window) {
    QCoreApplication::instance()->installEventFilter(this);
}

/// A line asks for every key that it could use before shortcuts get it (ShortcutOverride).
bool UndoKeys::eventFilter(QObject* object, QEvent* event) {
    if (event->type() != QEvent::ShortcutOverride) return false;
    const auto* line = qobject_cast<QLineEdit*>(object);
    // A box gives what its line has ignored to the line once more.
    if (const auto* box = qobject_cast<QComboBox*>(object)) line = box->lineEdit();
    if (!line || line->window() != window_) return false;
    const auto* key = static_cast<QKeyEvent*>(event);
    const bool undo = key->matches(QKeySequence::Undo), redo = key->matches(QKeySequence::Redo);
    if (!undo && !redo) return false;
    const bool typed = line->isModified() && (undo ? line->isUndoAvailable() : line->isRedoAvailable());
    if (typed) return false;
    event->ignore();
    return true;
}

} // namespace facetmill::ui
