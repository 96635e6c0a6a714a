// The stock that an operation meets: raw material less what the operations before it cut. Millimetres, part
// coordinates.
#pragma once

#include "core/strategy/plan/operation.h"
#include "core/strategy/surface/stock_field.h"

namespace facetmill {

/// The stock as it stands before an operation, in cells of `cell` mm; cells without anything above `from` are
/// forgotten (StockField::forget_below). Outside `within`, seen along Z, more may stand than does: whoever
/// asks about a small piece of a part does not wait for all that was cut. Throws what StockField does.
StockField stock_before(const PlanContext& context, double cell, const Progress& progress,
                        double from = -infinity, const Box3& within = StockField::everywhere());

} // namespace facetmill
