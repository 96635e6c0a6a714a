// Which files a plan becomes and what they are called.
#pragma once

#include "core/base/progress.h"
#include "core/job/planner.h"
#include "core/job/setup_plan.h"

#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace facetmill {

/// The APT file of a program, "01-Finish" and its extension: the operation's place in the project and its
/// name, in which '-' stands for what file systems or shells might stumble over.
std::string program_file_name(std::size_t place, const std::string& operation_name);
/// The same for a program of a plan.
std::string program_file_name(const Project& project, const PlanResult& result, std::size_t program);

/// The posted program of one program of a plan.
std::string posted_file_name(const Project& project, const PlanResult& result, std::size_t program,
                             const std::string& extension);

/// What write_plan writes for certain: the posted programs, the APT file of each program, the report. Throws
/// what project_post does.
std::vector<std::string> plan_file_names(const Project& project, const PlanResult& result);

/// A name in which '-' stands for what file systems or shells might stumble over, and "operation" for none.
std::string program_stem(const std::string& name);

/// The posted program that holds all operations of a project; of several setups those of the chosen one, with
/// its number and name.
std::string joined_program_name(const Project& project, const std::string& extension);

/// The names of the files that a plan of all setups writes for certain: one program an operation, the posted
/// programs, and the report. Throws Error(out_of_range) where two would have one name.
std::vector<std::string> program_file_names(const Project& project);

/// The operation that a program of a plan belongs to; the project is the one that was planned.
const Operation& operation_of(const Project& project, const PlanResult& result, std::size_t program);

/// Writes what every program writer has to say about each program ("NN-NAME" with the writer's extension,
/// "NN-NAME-rework" for the program of a rework tool), the posted programs (post_plan) and report.json, into
/// `folder` (made if missing): all of them or none, and never over a file that the project reads. `before`
/// runs when they are complete and none has appeared; none does when it throws. Returns the paths. Throws
/// Error(limit_exceeded of PlanResult::check_reach, unwritable, what ProgramWriter::write and post_plan
/// throw) or Cancelled; nothing is left then, not even a new folder. `air`: for the report.
std::vector<std::filesystem::path> write_plan(const Project& project, const PlanResult& result,
                                              const std::filesystem::path& folder, const Progress& progress,
                                              const std::vector<double>& air = {},
                                              const std::function<void()>& before = {});

/// The same for the setups that were asked for; the report is that of them all. `air`: for each setup.
std::vector<std::filesystem::path> write_setups(std::span<const SetupPlan> setups,
                                                const std::filesystem::path& folder, const Progress& progress,
                                                const std::vector<std::vector<double>>& air,
                                                const std::function<void()>& before = {});

} // namespace facetmill
