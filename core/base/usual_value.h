// What something new begins with: defaults are round in millimetres, and should be so in inches as well.
#pragma once

#include "core/base/parameter.h"

namespace facetmill {

/// The nearest number that has one digit other than 0; 0 for 0.
double round_to_digit(double v);

/// The default as something new has it: in inches its lengths and feeds have one digit, 0.04 in for 1 mm,
/// where the range allows that.
ParameterValue usual_value(const ParameterInfo& info, LengthUnit unit);

/// Gives what still has a default the usual value of the unit.
void take_usual_values(Parameterized& values, LengthUnit unit);

} // namespace facetmill
