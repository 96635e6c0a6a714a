// What the commands that plan a project have in common.
#pragma once

#include "core/job/planner.h"

#include <filesystem>
#include <memory>
#include <string>

namespace facetmill::cli {

/// Throws Error(unwritable) where something that is no folder stands at `folder`: told before a long job, not
/// after it.
void check_folder(const std::filesystem::path& folder);

/// Refuses to write over the project's file, its part and its stock (refuse_to_overwrite).
void keep_inputs(const Project& project, const std::string& file, const std::filesystem::path& output);

/// planner.plan, with errors that name the project's file unless they name the part's or the stock's. Throws
/// as that does.
std::shared_ptr<const PlanResult> plan_project(Planner& planner, const Project& project,
                                               const std::string& file, const std::string& only_operation,
                                               const Progress& progress);

/// Number of a contact point, as --point has it. Throws Error(usage).
std::size_t point_number(const std::string& text);

} // namespace facetmill::cli
