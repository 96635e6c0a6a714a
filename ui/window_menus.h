// Menus and tool bar of the window, built from a table of command names.
#pragma once

#include <functional>
#include <string>

class QMainWindow;
class QMenu;
class QString;

namespace facetmill::ui {

class Commands;
class WindowDocks;

/// The samples that a project can begin with.
QMenu* make_sample_menu(QMainWindow* window, const std::function<void(const std::string&)>& take);
/// The files that were open before, newest first.
QMenu* make_recent_menu(QMainWindow* window, const std::function<void(const QString&)>& open);

/// Builds menus and tool bar. `commands` has all that the table names: the samples as "samples", the recent
/// files as "recent", and the entries of the project tree.
void build_menus(QMainWindow* window, Commands& commands, const WindowDocks& docks);

} // namespace facetmill::ui
