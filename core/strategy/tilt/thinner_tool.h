// A tool whose shank may be as wide as its cutter, as it is asked whether it touches. Millimetres.
#pragma once

#include "core/gouge/tool_lift.h"

namespace facetmill {

/// The whole tool over what must not be cut, with shank and holder a hair thinner, by the chord tolerance: a
/// shank as thick as the cutter runs along what the cutter has cut.
ToolLift thinner_tool(const ContactIndexPtr& contact, Tool tool, const ToolClearance& clearance,
                      double chord);

} // namespace facetmill
