// The report of a plan: what was planned, how far it goes and how long it takes.
#pragma once

#include "core/job/planner.h"

#include <string>

namespace facetmill {

/// The text of report.json, in the project's units: lengths in `units`, angles in degrees, times in seconds.
/// An operation with several programs has one entry. `air`: feed_in_air of the plan (verification.h); empty:
/// not known.
std::string report_json(const Project& project, const PlanResult& result,
                        const std::vector<double>& air = {});

} // namespace facetmill
