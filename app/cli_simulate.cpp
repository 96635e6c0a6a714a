// facetmill-cli simulate: removes material by a project's plan, or by CL files, and compares what is left
// with the part.
#include "app/cli_commands.h"
#include "app/cli_judge.h"
#include "app/cli_project.h"
#include "app/cli_session.h"
#include "core/base/file.h"
#include "core/base/parameter.h"
#include "core/job/chain_verification.h"
#include "core/job/posting.h"
#include "core/job/stock_solid.h"
#include "core/job/verification.h"
#include "core/job/work_estimate.h"
#include "core/output/apt.h"

#include <cmath>
#include <filesystem>
#include <iterator>
#include <system_error>

namespace facetmill::cli {

namespace {

namespace fs = std::filesystem;

/// Never over what is read.
void keep_read(const Arguments& arguments, const Project& project, const fs::path& folder,
               const std::vector<std::string>& names) {
    for (const std::string& name : names) {
        keep_inputs(project, folder / name);
        for (const std::string& one : arguments.values("--cl"))
            refuse_to_overwrite(one, folder / name);
        for (const fs::path& one : posted_files(arguments))
            refuse_to_overwrite(one, folder / name);
    }
}

/// The first program that the machine cannot make.
std::string out_of_reach(const PlanResult& plan) {
    for (const auto& o : plan.operations)
        if (!o->out_of_reach.empty()) return "'" + printable(o->name) + "': " + o->out_of_reach;
    return {};
}

void tell(std::string findings, const std::string& out_of_reach, Session& session) {
    if (!out_of_reach.empty()) findings += (findings.empty() ? "" : "; ") + out_of_reach;
    if (findings.empty()) return;
    session.say("not verified: " + findings);
    session.fail();
}

/// The plan of all setups, each on what those before it leave, judged as one.
void simulate_plan(const Arguments& arguments, const Project& project, const AskedSettings& asked,
                   Session& session) {
    const Progress progress = session.progress();
    SetupPlanners planners;
    const std::vector<SetupPlan> setups =
        plan_all(planners, project, arguments.value("--op"), arguments, session, progress.part(0.0, 0.3));
    const fs::path folder = arguments.value("-o");
    keep_read(arguments, project, folder, chain_file_names(stock_chains(setups).size()));
    const auto ask = [&](VerifySettings& settings, std::span<const SetupPlan> chain,
                         std::span<const std::vector<VerifyProgram>>) {
        asked.apply(settings, *chain.front().plan->part);
        tell_work(settings, arguments, session);
    };
    const JudgedJob judged = judge_job(setups, ask, progress.part(0.3, 0.95));
    std::string beyond;
    for (const SetupPlan& setup : setups)
        if (beyond.empty()) beyond = out_of_reach(*setup.plan);
    judged.write(folder, progress.part(0.95, 1.0), [&] { session.print(judged.json()); });
    tell(judged.findings(), beyond, session);
}

void run_simulate(const Arguments& arguments, Session& session) {
    use_threads(arguments);
    const Project all = asked_project(arguments);
    const AskedSettings asked(arguments, all.unit);
    const std::vector<std::string> cl_files = arguments.values("--cl");
    if (!cl_files.empty() && arguments.has("--op"))
        throw Error(ErrorCode::usage, "--op", "CL files are simulated instead of a plan",
                    "give --cl or --op");
    const std::vector<fs::path> nc_files = posted_files(arguments);
    const fs::path folder = arguments.value("-o");
    check_folder(folder);
    const bool planned = nc_files.empty() && cl_files.empty();
    if (planned && arguments.has("--setup"))
        throw Error(ErrorCode::usage, "--setup", "a plan is simulated with all setups, one after the other",
                    "give it with --cl or --nc");
    if (planned) return simulate_plan(arguments, all, asked, session);
    const Project project = asked_setup(arguments, all, true);
    keep_read(arguments, project, folder, chain_file_names(1));

    const Progress progress = session.progress();
    SetupPlanners planners;
    Planner& planner = ready_planner(planners, project, arguments, session, progress.part(0.0, 0.1));
    std::shared_ptr<const PreparedPart> part;
    std::vector<VerifyProgram> programs;
    VerifySettings settings;
    std::vector<std::string> ignored, remarks;
    if (!nc_files.empty()) {
        check_project(project);
        const Post post = asked_post(arguments, project);
        part = planner.prepare(project, progress.part(0.0, 0.1));
        NcFilePrograms read = read_posted(project, *part, post, nc_files, progress.part(0.1, 0.3));
        programs = std::move(read.programs);
        remarks.push_back(posted_remark(post, read.blocks, read.seconds));
        settings = verify_settings(project, nullptr);
    } else {
        check_project(project);
        const double n = double(cl_files.size());
        for (std::size_t i = 0; i < cl_files.size(); ++i) {
            ClFilePrograms cl = read_verify_programs(
                project, cl_files[i],
                progress.part(0.2 * double(i) / n, 0.2 * double(i + 1) / n, "Reading CL"));
            std::move(cl.programs.begin(), cl.programs.end(), std::back_inserter(programs));
            for (const std::string& line : cl.ignored)
                ignored.push_back(printable(cl_files[i], 400) + ": " + line);
            std::move(cl.remarks.begin(), cl.remarks.end(), std::back_inserter(remarks));
        }
        part = planner.prepare(project, progress.part(0.2, 0.3));
        stand_fixtures(programs, *part);
        settings = verify_settings(project, nullptr);
    }
    asked.apply(settings, *part);
    tell_work(settings, arguments, session);
    const StockSolid stock = stock_solid(project.stock, *part);
    Verification result = verify(*part->mesh, stock, programs, settings, progress.part(0.3, 0.95));
    for (std::string& warning : stock_warnings(project.stock, *part, project.unit))
        remarks.push_back(std::move(warning));
    result.remarks.insert(result.remarks.begin(), remarks.begin(), remarks.end());
    write_verification(project, programs, result, folder, progress.part(0.95, 1.0),
                       [&] { session.print(verify_json(project, programs, result)); });
    for (const std::string& line : ignored)
        session.say("read over: " + line);
    tell(findings_line(project, programs, result), {}, session);
}

} // namespace

Command simulate_command() {
    return {
        .name = "simulate",
        .operands = {"PROJECT"},
        .summary =
            "Removes material and compares with the part: writes stock.stl, deviation.vtp, verify.json.",
        .help =
            "Plans the project first, or takes CL files (" + apt_writer().label
            + ") instead. Prints verify.json. Either all files "
              "appear or none.\n"
              "Exit status 1 also when a gouge or collision is found, more stays uncut than may, the machine "
              "cannot make a planned motion, or nothing can "
              "be said of\n"
              "the whole: the files are written then, and the figures are on stderr. Shank and holder "
              "are those of the project's tool with the CL file's tool number; of a "
              "file without\n"
              "LOADTL those of tool 1 where it has the same cutter. Setups are simulated in order, each on "
              "what "
              "those before it\n"
              "leave, and judged as one; a setup with a stock of its own begins files of its own "
              "(stock-2.stl).",
        .options = {{.name = "--cl",
                     .value = "FILE" + apt_writer().extension,
                     .help = "simulates this file instead of a plan; more than one run in order",
                     .repeated = true},
                    nc_option(),
                    post_option(),
                    setup_option(),
                    set_option(),
                    {.name = "--op",
                     .value = "NAME",
                     .help =
                         "plans and simulates only this operation, after the setups whose stock it goes on "
                         "with"},
                    resolution_option(),
                    spacing_option(),
                    {.name = "--gouge-limit",
                     .value = "G",
                     .help = "what is a gouge, in the project's units (default: the project's)"},
                    {.name = "--uncut-limit",
                     .value = "U",
                     .help =
                         "the share of the surface to be cut that may stay uncut (default: the project's)"},
                    threads_option(),
                    large_option(),
                    {.name = "-o",
                     .value = "DIR",
                     .help = "the folder to write to; made if missing",
                     .required = true}},
        .run = run_simulate};
}

} // namespace facetmill::cli
