// What the commands that plan a project have in common.
#pragma once

#include "app/cli_arguments.h"
#include "app/cli_session.h"
#include "core/job/planner.h"

#include <filesystem>
#include <memory>
#include <string>

namespace facetmill::cli {

/// Throws Error(unwritable) where something that is no folder stands at `folder`: told before a long job, not
/// after it.
void check_folder(const std::filesystem::path& folder);

/// The option that lets a job of more than usual size begin.
OptionInfo large_option();

/// planner.plan, with errors that name the project's file unless they name the part's or the stock's. Says on
/// stderr how much work it will be where that is much. Throws as that does; Error(limit_exceeded) where it is
/// more than usual and --yes-large is not given.
std::shared_ptr<const PlanResult> plan_project(Planner& planner, const Project& project,
                                               const std::string& only_operation, const Arguments& arguments,
                                               Session& session, const Progress& progress);

/// Number of a contact point, as --point has it. Throws Error(usage).
std::size_t point_number(const std::string& text);

} // namespace facetmill::cli
