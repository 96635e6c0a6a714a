// Which files a plan becomes and what they are called.
#pragma once

#include "core/base/progress.h"
#include "core/job/planner.h"

#include <filesystem>
#include <string>
#include <vector>

namespace facetmill {

/// "01-Finish.apt": the operation's place in the project and its name, in which '-' stands for what file
/// systems or shells might stumble over.
std::string program_file_name(std::size_t place, const std::string& operation_name);
/// The file of a program of a plan.
std::string program_file_name(const Project& project, const PlanResult& result, std::size_t program);
/// "01-Rough-pass-01.txt", "02-Finish.txt" (pass -1): the table of positions of a turning part.
std::string turning_table_name(std::size_t place, const std::string& operation_name, int pass);

/// The operation that a program of a plan belongs to; the project is the one that was planned.
const Operation& operation_of(const Project& project, const PlanResult& result, std::size_t program);

/// Writes NN-NAME.apt per program (NN-NAME-rework.apt for that of a rework tool), the tables of positions of
/// those that turn the part (turning_table.h), and report.json into `folder` (made if missing): all of them
/// or none. Returns the paths. Throws Error(unwritable, what write_apt throws) or Cancelled; nothing is left
/// then, not even a new folder.
std::vector<std::filesystem::path> write_plan(const Project& project, const PlanResult& result,
                                              const std::filesystem::path& folder, const Progress& progress);

} // namespace facetmill
