// What a right click in the view offers for what lies under the pointer: a face of the part, a path, or
// nothing.
#pragma once

#include "viz/scene_part.h"

#include <QObject>
#include <QPoint>

#include <optional>

class QMenu;

namespace facetmill::ui {

class MainWindow;

class ViewMenu : public QObject {
    Q_OBJECT
public:
    /// `views`: what the menu of views has stands behind everything else.
    ViewMenu(MainWindow& window, QMenu& views);

    /// For a place of the screen. The caller shows it; it is gone when it closes.
    QMenu* make(const QPoint& global);

private:
    void add_part(QMenu& menu, const PartPick& pick);
    void add_layers(QMenu& menu, bool on_part, bool on_path);
    void bound_face(const PartPick& pick);

    MainWindow& window_;
    QMenu& views_;
};

} // namespace facetmill::ui
