// Parameters that several kinds of operation have and that mean the same in all of them. Each says its own
// default.
#pragma once

#include "core/base/parameter.h"

namespace facetmill {

/// `what` may be off by the tolerance, for the help: "How far motions may run beside the exact path". What is
/// made of the value is chord_budget's (budget.h).
ParameterInfo chord_tolerance_parameter(const std::string& what);
/// Kept between shank or holder and the part.
ParameterInfo holder_clearance_parameter();

} // namespace facetmill
