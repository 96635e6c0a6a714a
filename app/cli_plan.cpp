// facetmill-cli plan: a project to program files and a report.
#include "app/cli_commands.h"
#include "app/cli_project.h"
#include "app/cli_session.h"
#include "core/job/posting.h"
#include "core/job/program_files.h"
#include "core/job/report.h"
#include "core/job/verification.h"
#include "core/output/apt.h"

namespace facetmill::cli {

namespace {

void run_plan(const Arguments& arguments, Session& session) {
    use_threads(arguments);
    const std::string file = arguments.operand(0);
    Project project = load_project(file);
    for (const std::string& setting : arguments.values("--set"))
        apply_setting(project, setting);
    check_posting(project);
    const std::string folder = arguments.value("-o");
    check_folder(folder);
    for (const auto& name : program_file_names(project))
        keep_inputs(project, std::filesystem::path(folder) / name);
    const Progress progress = session.progress();
    Planner planner;
    const auto result =
        plan_project(planner, project, arguments.value("--op"), arguments, session, progress.part(0.0, 0.9));
    try {
        result->check_reach();
    } catch (const Error& e) {
        throw e.within(printable(file, 400));
    }
    const std::vector<double> air = feed_in_air(project, result, progress.part(0.9, 0.97, "Looking for air"));
    write_plan(project, *result, folder, progress.part(0.97, 1.0, "Writing"), air,
               [&] { session.print(report_json(project, *result, air)); });
}

} // namespace

Command plan_command() {
    return {.name = "plan",
            .operands = {"PROJECT"},
            .summary = "Plans a project: writes NN-NAME" + apt_writer().extension
                       + " per operation and report.json, and prints the report.",
            .help = "Either all files appear or none; none where the machine cannot make a motion. Keys and "
                    "ranges of --set: facetmill-cli reference.",
            .options = {{.name = "--op", .value = "NAME", .help = "plans only this operation"},
                        {.name = "--set",
                         .value = "NAME.key=value",
                         .help = "sets a parameter of an operation for this run, in the project's units",
                         .repeated = true},
                        threads_option(),
                        large_option(),
                        {.name = "-o",
                         .value = "DIR",
                         .help = "the folder to write to; made if missing",
                         .required = true}},
            .run = run_plan};
}

} // namespace facetmill::cli
