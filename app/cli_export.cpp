// facetmill-cli export: part, stock and deviation as mesh files.
#include "app/cli_commands.h"
#include "app/cli_judge.h"
#include "app/cli_mesh.h"
#include "app/cli_project.h"
#include "app/cli_session.h"
#include "core/base/strict_json.h"
#include "core/job/chain_verification.h"
#include "core/job/mesh_export.h"
#include "core/job/project_inputs.h"
#include "core/job/repaired_mesh.h"
#include "core/mesh/mesh_writer.h"
#include "core/verify/stock_surface.h"
#include "viz/deviation_colors.h"

#include <algorithm>
#include <filesystem>

namespace facetmill::cli {

namespace {

namespace fs = std::filesystem;

const std::vector<std::string> things{"part", "stock", "deviation"};

std::string asked_thing(const Arguments& arguments) {
    const std::string what = arguments.value("--what", things.front());
    if (std::find(things.begin(), things.end(), what) == things.end())
        throw Error(ErrorCode::usage, "--what", "'" + printable(what) + "' is nothing to export",
                    "name part, stock or deviation");
    return what;
}

/// What is written, and what is told of it.
struct Exported {
    MeshPtr mesh;
    LengthUnit unit = LengthUnit::mm;
    std::string name;
    std::vector<float> values;
    std::vector<VertexColor> colors;
};

LengthUnit asked_unit(const Arguments& arguments, LengthUnit own) {
    return arguments.has("--to") ? arguments.unit("--to", own) : own;
}

Exported export_file_mesh(const Arguments& arguments, const Progress& progress) {
    const RepairedMesh loaded = load_repaired(arguments.operand(0), asked_reading(arguments), {}, progress);
    return {.mesh = loaded.mesh,
            .unit = asked_unit(arguments, loaded.report.assumed_unit),
            .name = fs::path(arguments.operand(0)).stem().string()};
}

/// The chain of setups that --setup is in, or the only one.
std::span<const SetupPlan> asked_chain(const Arguments& arguments, const std::vector<SetupPlan>& setups) {
    const auto chains = stock_chains(setups);
    const std::string name = arguments.value("--setup");
    for (const std::span<const SetupPlan> chain : chains)
        for (const SetupPlan& setup : chain)
            if (setup.project.name == name) return chain;
    if (arguments.has("--setup"))
        throw Error(ErrorCode::missing_reference, "--setup",
                    "no setup '" + printable(name) + "' with operations", "name one that cuts");
    if (chains.size() != 1)
        throw Error(ErrorCode::usage, "--setup", "the project has several stocks",
                    "name the setup whose stock is meant");
    return chains.front();
}

void add_deviation(Exported& out, const Verification& result) {
    const DeviationSurface& surface = *result.surface;
    out.mesh = std::make_shared<Mesh>(deviation_mesh(surface));
    out.values = surface.deviation;
    out.colors = deviation_vertex_colors(surface.deviation, surface.flags, default_scale(result, out.unit));
}

Exported export_cut(const Arguments& arguments, const Project& project, const std::string& what,
                    Session& session, const Progress& progress) {
    const AskedSettings asked(arguments, project.unit);
    SetupPlanners planners;
    const std::vector<SetupPlan> setups =
        plan_all(planners, project, arguments.value("--op"), arguments, session, progress.part(0, 0.4));
    const std::span<const SetupPlan> chain = asked_chain(arguments, setups);
    VerifySettings settings = chain_settings(chain);
    asked.apply(settings, *chain.front().plan->part);
    tell_work(settings, arguments, session);
    Exported out{.unit = asked_unit(arguments, project.unit)};
    out.name = fs::path(arguments.operand(0)).stem().string() + " " + what;
    const auto programs = planned_programs(chain);
    if (what == "stock") {
        const ChainPrograms all = chain_programs(chain, programs);
        const auto stock =
            stock_after(chain.front().plan->stock, all.programs, settings, progress.part(0.4, 0.8));
        out.mesh = std::make_shared<Mesh>(stock_mesh(*stock, progress.part(0.8, 1)));
    } else {
        add_deviation(out, *judge_chain(chain, programs, settings, progress.part(0.4, 1)).result);
    }
    return out;
}

Exported export_project(const Arguments& arguments, const std::string& what, Session& session,
                        const Progress& progress) {
    if (arguments.has("--units"))
        throw Error(ErrorCode::usage, "--units", "a project says the unit of its part", "write --to UNIT");
    refuse_reading_options(arguments);
    const Project all = asked_project(arguments);
    keep_inputs(all, arguments.value("-o"));
    if (what != "part") return export_cut(arguments, all, what, session, progress);
    const Project project = asked_setup(arguments, all, false);
    check_project(project);
    SetupPlanners planners;
    const auto part = planners.at(chosen_setup(project)).prepare(project, progress);
    return {.mesh = part->mesh,
            .unit = asked_unit(arguments, project.unit),
            .name = fs::path(arguments.operand(0)).stem().string()};
}

void run_export(const Arguments& arguments, Session& session) {
    const std::string what = asked_thing(arguments), file = arguments.value("-o");
    const MeshFileKind& kind = mesh_file_kind(file); // told before a long job
    use_threads(arguments);
    const Progress progress = session.progress();
    const bool is_project = arguments.operand(0).ends_with(".facetmill");
    if (!is_project && what != "part")
        throw Error(ErrorCode::usage, "--what", "a part alone has no " + what, "give a project");
    const Exported out = is_project ? export_project(arguments, what, session, progress.part(0, 0.9))
                                    : export_file_mesh(arguments, progress.part(0, 0.9, "Reading the part"));
    OutputFile output(file);
    write_mesh(*out.mesh, output,
               {.unit = out.unit, .name = out.name, .values = out.values, .colors = out.colors},
               progress.part(0.9, 1, "Writing"));
    output.close_stream();
    Json json;
    json["file"] = printable(file, 400);
    json["format"] = std::string(kind.name);
    json["what"] = what;
    json["units"] = std::string(unit_name(out.unit));
    json["facets"] = out.mesh->facet_count();
    json["vertices"] = out.mesh->vertices.size();
    json["values"] = kind.holds_values && !out.values.empty();
    session.print(pretty_json(json));
    output.commit();
}

} // namespace

Command export_command() {
    return {
        .name = "export",
        .operands = {"PROJECT|PART"},
        .summary = "Writes part, stock or deviation as STL, 3MF or PLY.",
        .help =
            "The part as its placement, and the recipe of repairs, leave it; the stock as the plan leaves "
            "it; the part's\n"
            "surface with how much stands on it or is missing. All but a part are planned first. The "
            "name's ending says the\n"
            "format. A deviation is coloured (PLY, 3MF by vertex, STL by facet); PLY also holds it as the "
            "vertices' property\n"
            "`deviation`. Of a part alone, another format or unit of it. Stock and deviation lie in the "
            "coordinates of the\n"
            "first setup that cuts the stock.",
        .options = with_reading_options(
            {{.name = "--what", .value = "part|stock|deviation", .help = "what is written (default: part)"},
             {.name = "--to",
              .value = "UNIT",
              .help = "unit of the file: mm, cm, m, in, ft (default: as read)"},
             {.name = "--units", .value = "UNIT", .help = "of a part: unit of its numbers"},
             setup_option(),
             set_option(),
             {.name = "--op", .value = "NAME", .help = "plans only this operation, and the setups before it"},
             resolution_option(),
             spacing_option(),
             threads_option(),
             large_option(),
             {.name = "-o", .value = "FILE", .help = "the file to write", .required = true}}),
        .run = run_export};
}

} // namespace facetmill::cli
