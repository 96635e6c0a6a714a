// The table of the window's commands: what each is called, its icon and keys, when it is enabled, what it
// does.
#pragma once

namespace facetmill::ui {

class Commands;
class MainWindow;

void add_commands(Commands& commands, MainWindow& window);

} // namespace facetmill::ui
