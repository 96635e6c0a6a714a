// The report of a plan: what was planned, how far it goes and how long it takes.
#pragma once

#include "core/job/planner.h"
#include "core/job/setup_plan.h"

#include <string>

namespace facetmill {

/// The text of report.json, in the project's units: lengths in `units`, angles in degrees, times in seconds.
/// An operation with several programs has one entry. `air`: feed_in_air of the plan (verification.h); empty:
/// not known.
std::string report_json(const Project& project, const PlanResult& result,
                        const std::vector<double>& air = {});

/// The report of a project: that of its setup, or of several `setups[]`, those that were asked for, each with
/// its `name`, `place` and all that the report of a single one has. `air`: for each setup.
std::string setups_report_json(std::span<const SetupPlan> setups,
                               const std::vector<std::vector<double>>& air);

} // namespace facetmill
