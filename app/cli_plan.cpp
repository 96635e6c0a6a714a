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
    const Project project = asked_project(arguments);
    check_all_posting(project);
    const std::string folder = arguments.value("-o");
    check_folder(folder);
    for (const auto& name : program_file_names(project))
        keep_inputs(project, std::filesystem::path(folder) / name);
    const Progress progress = session.progress();
    SetupPlanners planners;
    const std::vector<SetupPlan> setups =
        plan_all(planners, project, arguments.value("--op"), arguments, session, progress.part(0.0, 0.9));
    std::vector<std::vector<double>> air(setups.size());
    for (std::size_t i = 0; i < setups.size(); ++i) {
        if (!setups[i].asked) continue;
        try {
            setups[i].plan->check_reach();
        } catch (const Error& e) {
            throw e.within(printable(file, 400));
        }
        const double n = double(setups.size()), at = double(i);
        air[i] =
            feed_in_air(setups[i].project, setups[i].plan,
                        progress.part(0.9 + 0.07 * at / n, 0.9 + 0.07 * (at + 1) / n, "Looking for air"));
    }
    write_setups(setups, folder, progress.part(0.97, 1.0, "Writing"), air,
                 [&] { session.print(setups_report_json(setups, air)); });
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
