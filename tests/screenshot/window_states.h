// What a window shows in the states that a planned part is not: empty, wrong, failed, missing, long names, a
// scan, several setups, five axes, turning, questions, the manual.
#pragma once

#include "tests/screenshot/window_tour.h"

namespace facetmill::test {

/// All of them in turn, in a window that was just opened. Leaves another project behind.
void tour_states(ui::MainWindow& window, const Look& look);

} // namespace facetmill::test
