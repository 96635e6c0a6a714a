// What of the part an operation is asked to cut, where that is told by curves seen from above. Millimetres,
// part coordinates.
#pragma once

#include "core/strategy/curves/plan_curve.h"

namespace facetmill {

PlanCurve circle_about(const Vec2& center, double radius);

/// The same context with what of its part lies within one closed curve and outside another, either of which
/// may be missing, as the part. Throws Error(empty_result), the place of which is `where`, where nothing
/// does.
PlanContext cut_to_curves(const PlanContext& context, const std::string& where,
                          const std::optional<PlanCurve>& within, const std::optional<PlanCurve>& outside,
                          double radius, const Progress& progress);

} // namespace facetmill
