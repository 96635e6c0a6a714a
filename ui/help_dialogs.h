// The two dialogs of the help menu.
#pragma once

class QWidget;

namespace facetmill::ui {

/// Keys and mouse, in a table.
void show_shortcuts(QWidget* window);
void show_about(QWidget* window);

} // namespace facetmill::ui
