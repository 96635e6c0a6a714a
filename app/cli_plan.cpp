// facetmill-cli plan: a project to program files and a report.
#include "app/cli_commands.h"
#include "app/cli_project.h"
#include "app/cli_session.h"
#include "core/job/posting.h"
#include "core/job/program_files.h"
#include "core/output/apt.h"

namespace facetmill::cli {

namespace {

void run_plan(const Arguments& arguments, Session& session) {
    use_threads(arguments);
    const Project project = asked_project(arguments);
    check_all_posting(project);
    const std::string folder = arguments.value("-o");
    check_folder(folder);
    for (const auto& name : program_file_names(project))
        keep_inputs(project, std::filesystem::path(folder) / name);
    const Progress progress = session.progress();
    SetupPlanners planners;
    const PlannedJob job =
        plan_whole(planners, project, arguments.value("--op"), arguments, session, progress.part(0.0, 0.97));
    job.write(folder, progress.part(0.97, 1.0, "Writing"), [&] { session.print(job.report()); });
}

} // namespace

Command plan_command() {
    return {.name = "plan",
            .operands = {"PROJECT"},
            .summary = "Plans a project: writes NN-NAME" + apt_writer().extension
                       + " per operation and report.json, and prints the report.",
            .help =
                "Either all files appear or none; none where the machine cannot make a motion. Setups are\n"
                "planned in order, each on what those before it leave. Keys and ranges of --set:\n"
                "facetmill-cli reference.",
            .options = {{.name = "--op", .value = "NAME", .help = "plans only this operation"},
                        set_option(),
                        threads_option(),
                        large_option(),
                        {.name = "-o",
                         .value = "DIR",
                         .help = "the folder to write to; made if missing",
                         .required = true}},
            .run = run_plan};
}

} // namespace facetmill::cli
