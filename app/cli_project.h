// What the commands that plan a project have in common.
#pragma once

#include "app/cli_arguments.h"
#include "app/cli_session.h"
#include "core/job/planner.h"
#include "core/job/setup_plan.h"
#include "core/job/whole_job.h"
#include "core/output/post/post.h"

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace facetmill::cli {

/// Throws Error(unwritable) where something that is no folder stands at `folder`: told before a long job, not
/// after it.
void check_folder(const std::filesystem::path& folder);

/// The option that changes parameters for a run, and the project with those.
OptionInfo set_option();
Project asked_project(const Arguments& arguments);

/// The option that lets a job of more than usual size begin.
OptionInfo large_option();

/// Has a verification say on stderr how much work it will be, where that is much, and throw
/// Error(limit_exceeded) before it begins where it is more than usual and --yes-large is not given. Both
/// others must outlive the settings.
void tell_work(VerifySettings& settings, const Arguments& arguments, Session& session);

/// planner.plan, with errors that name the project's file unless they name the part's or the stock's. Says on
/// stderr how much work it will be where that is much. Throws as that does; Error(limit_exceeded) where it is
/// more than usual and --yes-large is not given.
std::shared_ptr<const PlanResult> plan_project(Planner& planner, const Project& project,
                                               const std::string& only_operation, const Arguments& arguments,
                                               Session& session, const Progress& progress);

/// All setups of a project, or those that one operation needs; each planned as plan_project does. Throws as
/// that and plan_setups do.
std::vector<SetupPlan> plan_all(SetupPlanners& planners, const Project& project,
                                const std::string& only_operation, const Arguments& arguments,
                                Session& session, const Progress& progress);

/// The same with the air that programs cut, all within the machine's reach (plan_job). Throws as that does.
PlannedJob plan_whole(SetupPlanners& planners, const Project& project, const std::string& only_operation,
                      const Arguments& arguments, Session& session, const Progress& progress);

/// The option that says which setup of several is meant.
OptionInfo setup_option();
/// The view on the setup that --setup names, else on that of --op, else on the first; throws Error(usage)
/// where neither is given and programs are read back (`needed`) that are those of one of several.
Project asked_setup(const Arguments& arguments, const Project& project, bool needed);
/// The planner of the chosen setup, with the stock that this begins with. Throws as plan_all.
Planner& ready_planner(SetupPlanners& planners, const Project& project, const Arguments& arguments,
                       Session& session, const Progress& progress);

/// The options for programs of a control, which are read back.
OptionInfo nc_option();
OptionInfo post_option();
/// The files of --nc, also several in one value with commas between. Throws Error(usage) where --op or --cl
/// stand beside it, and for --post without it.
std::vector<std::filesystem::path> posted_files(const Arguments& arguments);
/// The control they are for: --post, or the project's. Throws Error(usage) without one.
Post asked_post(const Arguments& arguments, const Project& project);

/// Number of a contact point, as --point has it. Throws Error(usage).
std::size_t point_number(const std::string& text);

} // namespace facetmill::cli
