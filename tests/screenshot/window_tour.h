// Every page of a window in turn: what must hold of all of them is asked here.
#pragma once

#include "tests/screenshot/window_support.h"

#include <QSet>

#include <functional>

namespace facetmill::test {

/// What is looked at, and what it is called.
using Look = std::function<void(QWidget& top, const QString& page)>;

/// The window with a planned part: every kind of line of the tree, every kind of operation, every dock, every
/// workspace.
void tour_window(ui::MainWindow& window, const Look& look);
/// Every dialog, and every tab of it. The names of the classes that were seen.
QSet<QString> tour_dialogs(ui::MainWindow& window, const Look& look);
/// All classes of dialogs that ui has, by its headers.
QSet<QString> dialog_classes();

} // namespace facetmill::test
