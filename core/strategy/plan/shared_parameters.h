// Parameters that several kinds of operation have and that mean the same in all of them, and kinds of them
// that only differ in their words. Each says its own default.
#pragma once

#include "core/base/parameter.h"

namespace facetmill {

/// `what` may be off by the tolerance, for the help: "How far motions may run beside the exact path". What is
/// made of the value is chord_budget's (budget.h).
ParameterInfo chord_tolerance_parameter(const std::string& what);
/// Kept between shank or holder and the part.
ParameterInfo holder_clearance_parameter();
/// How far the tool may lean where shank or holder would touch.
ParameterInfo tilt_limit_parameter();
/// zigzag or oneway; `help` says what they are here.
ParameterInfo pattern_parameter(const std::string& help);
/// How far the normal turns between points of a pass; `more` ends the sentence of the help.
ParameterInfo normal_limit_parameter(const std::string& more = {});
/// Between levels of constant height, and the most that it adapts to; between drive planes.
ParameterInfo stepdown_parameter();
ParameterInfo max_stepdown_parameter();
ParameterInfo stepover_parameter();
/// Whether only what other operations left is cut.
ParameterInfo rest_only_parameter();

// These complete a description that has key, label and help, and what else is its own.

/// A length above 0 and at most `largest` (mm), or one of the description's words in its place.
ParameterInfo length_or_word_parameter(ParameterInfo info, double largest = 1000);
/// A feed above 0, or "auto".
ParameterInfo feed_or_auto_parameter(ParameterInfo info);
/// A direction of travel: "auto", "x", "y", or an angle from X.
ParameterInfo travel_parameter(ParameterInfo info);
/// The number of a tool beside the operation's own; `smallest` 0: there may be none.
ParameterInfo further_tool_parameter(ParameterInfo info, long smallest);
/// A place on the part.
ParameterInfo place_parameter(ParameterInfo info);

} // namespace facetmill
