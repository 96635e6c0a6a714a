// What is said of a planned operation that its strategy cannot know: what the job before it has left
// standing.
#pragma once

#include "core/job/planner.h"

namespace facetmill {

/// Adds to OperationResult::motion_warnings: how far shank or holder of a finishing tool run in stock, and a
/// clean-up whose previous tool nothing before it cuts with. `result` has its program.
void tell_what_stands(OperationResult& result, const Project& project, const Operation& operation,
                      const PlanContext& context, const Progress& progress);

} // namespace facetmill
