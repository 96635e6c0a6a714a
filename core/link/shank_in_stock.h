// Whether shank and holder come into stock that nobody has cut. Millimetres, part
// coordinates.
#pragma once

#include "core/base/progress.h"
#include "core/setup/motion.h"
#include "core/strategy/lathe/lathe.h"
#include "core/strategy/plan/operation.h"

#include <string>

namespace facetmill {

struct ShankInStock {
    double length = 0; ///< of the cutting motions on which they do
    double whole = 0;  ///< of all cutting motions
};

/// Raw material less what operations with the upright tool cut before: what this operation's own passes have
/// cleared by then counts as standing. Cells of a quarter of the radius, of which a body has to hold the
/// middle well. Motions are looked at no closer than a diameter.
ShankInStock shank_in_stock(const ToolMotions& motions, const PlanContext& context, const Progress& progress);
/// The same of a part that turns, all raw material standing.
ShankInStock shank_in_stock(const ToolMotions& motions, const LatheCommon& settings,
                            const PlanContext& context, const Progress& progress);
/// What is said about it; empty where there is nothing to say.
std::string shank_in_stock_warning(const ShankInStock& touched, const PlanContext& context);

} // namespace facetmill
