// The table of the window's commands: what each is called, its icon and keys, when it is enabled, what it
// does.
#pragma once

#include "core/base/units.h"

namespace facetmill::ui {

class Commands;
class MainWindow;

void add_commands(Commands& commands, MainWindow& window);
/// The window takes over what the settings say: colours, navigation, how often work is kept, threads.
void take_preferences(MainWindow& window);
/// The project gets another unit, as a step of its history. Where a field holds no value that is told
/// instead.
void set_unit(MainWindow& window, LengthUnit unit);

} // namespace facetmill::ui
