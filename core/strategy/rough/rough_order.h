// The order of roughing's passes. They are planned layer by layer over the whole part; cut in that order the
// tool would travel between all hollows of the part on every layer. What one pass takes away matters only to
// those that come near it, so passes that do not may change places: one hollow is cut down before the next.
#pragma once

#include "core/base/progress.h"
#include "core/strategy/plan/path.h"

namespace facetmill {

/// Puts passes in an order that travels less: always next is one whose start is nearest, of those before
/// which nothing within `near` of them (level, in mm) has to be cut. Passes nearer to each other than that
/// keep their order, so each meets the stock that it was planned for.
void order_passes(std::vector<Pass>& passes, double near, const Progress& progress);

} // namespace facetmill
