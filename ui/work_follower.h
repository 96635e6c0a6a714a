// The workspaces follow the work: what was just done is to be seen.
#pragma once

namespace facetmill::ui {

class MainWindow;
class WindowDocks;

/// Connects the window's workspaces with what its other parts tell, for as long as they live.
void follow_work(MainWindow& window, WindowDocks& docks);

} // namespace facetmill::ui
