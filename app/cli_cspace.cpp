// facetmill-cli cspace: one contact point's configuration space.
#include "app/cli_commands.h"
#include "app/cli_project.h"
#include "app/cli_session.h"
#include "core/base/file.h"
#include "core/job/cspace_json.h"

namespace facetmill::cli {

namespace {

void run_cspace(const Arguments& arguments, Session& session) {
    use_threads(arguments);
    const std::size_t number = point_number(arguments.value("--point"));
    Project project = asked_project(arguments);
    const std::string output = arguments.value("-o"), name = arguments.value("--op");
    keep_inputs(project, output);
    OutputFile out(output); // first, so that a place that cannot be written is told at once
    const Progress progress = session.progress();
    choose_setup(project, setup_of_operation(project, name));
    SetupPlanners planners;
    Planner& planner = ready_planner(planners, project, arguments, session, progress.part(0.0, 0.2));
    const auto result = plan_project(planner, project, name, arguments, session, progress.part(0.2, 0.7));
    const auto record = result->operations.front()->path.five_axis();
    if (!record)
        throw Error(ErrorCode::out_of_range, "operation '" + printable(name) + "'",
                    "has no configuration spaces: its tool axes do not turn",
                    "name an operation of kind finish5");
    const FiveAxisStudy study(record, progress.part(0.7, 0.8, "Configuration space"));
    const FiveAxisStudy::Point point = study.point(number, progress.part(0.8, 1.0));
    const std::string json = cspace_json(study, point, project.unit);
    out.write(json);
    out.close_stream();
    session.print(json);
    out.commit();
}

} // namespace

Command cspace_command() {
    return {.name = "cspace",
            .operands = {"PROJECT"},
            .summary = "Writes the configuration space of one contact point of a 5-axis operation.",
            .help = "Plans the operation first. Contact points are numbered from 0 in machining order.\n"
                    "delta_bottom and delta_top have a row per lambda and a column per omega; blocked says\n"
                    "why each posture is not free: local, global, shank, holder, lift or machine.",
            .options =
                {{.name = "--op", .value = "NAME", .help = "the operation", .required = true},
                 {.name = "--point", .value = "I", .help = "number of the contact point", .required = true},
                 set_option(),
                 threads_option(),
                 large_option(),
                 {.name = "-o", .value = "FILE.json", .help = "the file to write", .required = true}},
            .run = run_cspace};
}

} // namespace facetmill::cli
