// The order of the passes of a waterline path: down from level to level as long as the next pass is near,
// then on from the highest that is left. Millimetres.
#pragma once

#include "core/base/progress.h"
#include "core/strategy/plan/path.h"

#include <vector>

namespace facetmill {

/// Closed passes are turned so that they begin near the end of the pass before; others are turned round where
/// `either_way`. Passes nearer than `near` (seen from above) follow one another down. The same order for the
/// same passes.
void order_by_level(std::vector<Pass>& passes, double near, bool either_way, const Progress& progress);

/// True for a pass that ends where it begins.
bool is_closed(const Pass& pass);

/// Turns a closed pass so that it begins, and ends, at a point of it: any but the last, which is the first.
void begin_at(Pass& closed, std::size_t point);

} // namespace facetmill
