// What an empty window says: how to begin.
#pragma once

#include <QFrame>

class QLabel;
class QMenu;
class QPushButton;

namespace facetmill::ui {

class StartHint : public QFrame {
    Q_OBJECT
public:
    StartHint(QMenu* samples, QWidget* parent);
    /// Keeps itself in the middle of its parent.
    void place();

signals:
    void open_requested();

protected:
    bool eventFilter(QObject* object, QEvent* event) override;

private:
    QLabel *title_ = nullptr, *text_ = nullptr;
};

} // namespace facetmill::ui
