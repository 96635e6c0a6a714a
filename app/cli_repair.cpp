// facetmill-cli repair: the scan room without a display.
#include "app/cli_commands.h"
#include "app/cli_session.h"
#include "core/base/file.h"
#include "core/base/strict_json.h"
#include "core/job/repaired_mesh.h"
#include "core/mesh/mesh_io.h"
#include "core/mesh/mesh_writer.h"
#include "core/repair/repair.h"
#include "core/repair/survey.h"

#include <algorithm>
#include <cmath>

namespace facetmill::cli {

namespace {

using Kind = RepairStep::Kind;

Json measured(double v) {
    return json_number(v, "repair");
}

[[noreturn]] void wrong_value(const std::string& option, const std::string& text, const std::string& remedy) {
    throw Error(ErrorCode::usage, option, "'" + printable(text) + "' cannot be read", remedy);
}

double read_number(const std::string& option, const std::string& text, const std::string& remedy) {
    double v = 0;
    if (!parse_number(text, v)) wrong_value(option, text, remedy);
    return v;
}

long read_count(const std::string& option, const std::string& text, const std::string& remedy) {
    const double v = read_number(option, text, remedy);
    if (v < 0 || v != std::floor(v) || v > 4e9) wrong_value(option, text, remedy);
    return long(v);
}

/// "5:flat" is "5" and "flat"; without a colon the second is empty.
struct Value {
    std::string first, second;
    explicit Value(const std::string& text) : first(text.substr(0, text.find(':'))) {
        if (first.size() < text.size()) second = text.substr(first.size() + 1);
    }
};

RepairStep pieces_step(const std::string& text, double per) {
    const std::string remedy = "write a size, as in 5, or 200:facets, 3:area, 1:keep";
    const Value value(text);
    RepairStep step{.kind = Kind::pieces};
    if (value.second.empty() && value.first == text)
        step.size = per * read_number("--pieces", text, remedy);
    else if (value.second == "facets")
        step.facets = read_count("--pieces", value.first, remedy);
    else if (value.second == "area")
        step.area = per * per * read_number("--pieces", value.first, remedy);
    else if (value.second == "keep")
        step.keep = read_count("--pieces", value.first, remedy);
    else
        wrong_value("--pieces", text, remedy);
    return step;
}

RepairStep fill_step(Kind kind, const std::string& option, const std::string& text, double per) {
    const std::string remedy = "write a size, as in 5 or 5:flat";
    const Value value(text);
    RepairStep step{.kind = kind};
    step.size = per * read_number(option, value.first, remedy);
    if (value.second == "flat")
        step.fill = RepairStep::Fill::flat;
    else if (value.second != "smooth" && value.first != text)
        wrong_value(option, text, remedy);
    return step;
}

RepairStep bound_step(Kind kind, const std::string& option, const std::string& text, double per) {
    const std::string remedy = kind == Kind::smooth     ? "write a bound, as in 0.02 or 0.02:40 (degrees)"
                               : kind == Kind::decimate ? "write a bound, as in 0.01 or 0.01:0.25"
                                                        : "write a bound, as in 0.01";
    const Value value(text);
    RepairStep step{.kind = kind};
    step.bound = per * read_number(option, value.first, remedy);
    if (value.first == text) return step;
    const double second = read_number(option, value.second, remedy);
    if (kind == Kind::smooth)
        step.angle = radians(second);
    else if (kind == Kind::decimate)
        step.share = second;
    else
        wrong_value(option, text, remedy);
    return step;
}

/// The file's name may hold colons: numbers are taken from its end.
RepairStep join_step(const std::string& text, double per) {
    std::vector<double> numbers;
    std::string file = text;
    constexpr std::size_t most = 2;
    while (numbers.size() < most) {
        const std::size_t colon = file.rfind(':');
        double v = 0;
        if (colon == std::string::npos || !parse_number(file.substr(colon + 1), v)) break;
        numbers.insert(numbers.begin(), v);
        file.resize(colon);
    }
    RepairStep step{.kind = Kind::join, .file = file};
    if (!numbers.empty()) step.size = per * numbers[0];
    if (numbers.size() > 1) step.bound = per * numbers[1];
    return step;
}

/// "0,0,1,12.5"
std::vector<double> read_numbers(const std::string& option, const std::string& text,
                                 const std::string& remedy) {
    std::vector<double> numbers;
    for (std::size_t at = 0; at <= text.size();) {
        const std::size_t end = std::min(text.find(',', at), text.size());
        numbers.push_back(read_number(option, text.substr(at, end - at), remedy));
        at = end + 1;
    }
    return numbers;
}

RepairStep cut_step(const std::string& text, double per) {
    const std::string remedy =
        "write the normal and how far off the origin, as in 0,0,1,12.5 or 0,0,1,12.5:open";
    const Value value(text);
    RepairStep step{.kind = Kind::cut};
    if (value.second == "open")
        step.close = false;
    else if (value.first != text)
        wrong_value("--cut", text, remedy);
    const std::vector<double> numbers = read_numbers("--cut", value.first, remedy);
    if (numbers.size() != 4) wrong_value("--cut", text, remedy);
    step.normal = {numbers[0], numbers[1], numbers[2]};
    step.offset = per * numbers[3];
    return step;
}

RepairStep hole_step(const std::string& text, double per) {
    const std::string remedy =
        "write where the hole's middle is, as in 10,20,5 or 10,20,5:flat or 10,20,5:left";
    const Value value(text);
    RepairStep step{.kind = Kind::hole};
    const auto& words = repair_step_parameters().find("fill")->info.words;
    const auto word = std::find(words.begin(), words.end(), value.second);
    if (word != words.end())
        step.fill = RepairStep::Fill(word - words.begin());
    else if (value.first != text)
        wrong_value("--hole", text, remedy);
    const std::vector<double> at = read_numbers("--hole", value.first, remedy);
    if (at.size() != step.at.size()) wrong_value("--hole", text, remedy);
    for (std::size_t k = 0; k < at.size(); ++k)
        step.at[k] = per * at[k];
    return step;
}

/// The steps in the order in which their options are given.
std::vector<RepairStep> recipe_of(const Arguments& arguments, double per) {
    std::vector<RepairStep> recipe;
    for (const auto& [option, text] : arguments.given()) {
        if (option == "--pieces") recipe.push_back(pieces_step(text, per));
        if (option == "--turn" || option == "--orient") recipe.push_back({.kind = Kind::turn});
        if (option == "--needles") recipe.push_back(bound_step(Kind::needles, option, text, per));
        if (option == "--holes") recipe.push_back(fill_step(Kind::holes, option, text, per));
        if (option == "--hole") recipe.push_back(hole_step(text, per));
        if (option == "--smooth") recipe.push_back(bound_step(Kind::smooth, option, text, per));
        if (option == "--decimate") recipe.push_back(bound_step(Kind::decimate, option, text, per));
        if (option == "--cut") recipe.push_back(cut_step(text, per));
        if (option == "--crossings") recipe.push_back(fill_step(Kind::crossings, option, text, per));
        if (option == "--fins") {
            RepairStep step{.kind = Kind::fins};
            step.size = per * read_number(option, text, "write a size, as in 5");
            recipe.push_back(step);
        }
        if (option == "--join") recipe.push_back(join_step(text, per));
        if (option == "--thicken") {
            RepairStep step{.kind = Kind::thicken};
            step.thickness = per * read_number(option, text, "write a thickness, as in 2");
            recipe.push_back(step);
        }
        if (option == "--recipe") {
            const auto read = load_recipe(text);
            recipe.insert(recipe.end(), read.begin(), read.end());
        }
    }
    check_recipe(recipe, "repair");
    return recipe;
}

Json mesh_json(const Mesh& mesh, const MeshReport& r) {
    Json out;
    out["facets"] = mesh.facet_count();
    out["vertices"] = mesh.vertices.size();
    out["shells"] = r.shells;
    out["watertight"] = r.watertight;
    out["open_edges"] = r.open_edges;
    out["non_manifold_edges"] = r.non_manifold_edges;
    out["inconsistent_edges"] = r.inconsistent_edges;
    out["area"] = measured(r.file_area);
    out["volume"] = measured(r.file_volume);
    return out;
}

Json hole_json(const Hole& hole, double per) {
    Json out;
    out["diameter"] = measured(hole.diameter / per);
    out["perimeter"] = measured(hole.perimeter / per);
    out["edges"] = hole.loop.size();
    out["center"] = Json::array();
    for (int k = 0; k < 3; ++k)
        out["center"].push_back(measured(hole.center[k] / per));
    return out;
}

Json survey_json(const Survey& survey, double per) {
    Json out;
    out["holes"] = Json::array();
    for (const Hole& hole : survey.holes.holes)
        out["holes"].push_back(hole_json(hole, per));
    std::vector<Shell> shells = survey.shells.all;
    std::stable_sort(shells.begin(), shells.end(),
                     [](const Shell& a, const Shell& b) { return a.area > b.area; });
    out["pieces"] = Json::array();
    for (const Shell& shell : shells)
        out["pieces"].push_back({{"facets", shell.facets},
                                 {"area", measured(shell.area / (per * per))},
                                 {"size", measured(shell.box.diagonal() / per)}});
    out["doubles"] = survey.doubles;
    out["needles"] = survey.needles;
    out["crossings"] = survey.crossings;
    out["crossing_facets"] = survey.crossing_facets;
    out["edges_against"] = survey.against;
    out["non_manifold_edges"] = survey.non_manifold;
    out["sheet_ends"] = survey.holes.sheet_ends;
    out["facets_in_no_sheet"] = survey.holes.left_out;
    return out;
}

void list_faults(const LoadedMesh& loaded, Json& out, double per, Session& session,
                 const Progress& progress) {
    const Survey survey = survey_mesh(*loaded.mesh, progress);
    out.update(survey_json(survey, per));
    session.print(pretty_json(out));
}

void run_repair(const Arguments& arguments, Session& session) {
    const LengthUnit unit = arguments.unit("--units", LengthUnit::mm);
    const double per = mm_per(unit);
    const bool lists = arguments.has("--list");
    const std::vector<RepairStep> recipe = recipe_of(arguments, per);
    if (lists && (!recipe.empty() || arguments.has("-o")))
        throw Error(ErrorCode::usage, "--list", "it changes nothing", "leave out the steps and -o");
    if (!lists && recipe.empty())
        throw Error(ErrorCode::usage, "repair", "no step is given", "give one, or --list");
    if (!lists && !arguments.has("-o"))
        throw Error(ErrorCode::usage, "repair", "-o is missing", "write -o FILE");
    if (!lists) mesh_file_kind(arguments.value("-o")); // told before a long job
    use_threads(arguments);
    const Progress progress = session.progress();
    const LoadedMesh loaded =
        load_mesh(arguments.operand(0), unit, progress.part(0, 0.15, "Reading the part"));
    Json out;
    out["part"] = printable(arguments.operand(0), 400);
    out["units"] = std::string(unit_name(unit));
    out["before"] = mesh_json(*loaded.mesh, loaded.report);
    if (lists) return list_faults(loaded, out, per, session, progress.part(0.15, 1));

    const Repaired repaired = run_recipe(loaded.mesh, recipe, progress.part(0.15, 0.9), unit);
    MeshReport report;
    report.assumed_unit = unit;
    analyse_mesh(*repaired.mesh, report, progress.part(0.9, 0.95));
    const std::string file = arguments.value("-o");
    OutputFile output(file);
    write_mesh(*repaired.mesh, output, {.unit = unit, .name = loaded.report.name},
               progress.part(0.95, 1, "Writing"));
    output.close_stream();
    out["after"] = mesh_json(*repaired.mesh, report);
    out["steps"] = repairs_json(repaired.steps, unit);
    double sum = 0;
    for (const StepReport& step : repaired.steps)
        sum += step.displacement;
    out["displacement"] = measured(sum / per);
    out["file"] = printable(file, 400);
    session.print(pretty_json(out));
    output.commit();
}

} // namespace

Command repair_command() {
    return {
        .name = "repair",
        .operands = {"PART"},
        .summary = "Makes a scan worth machining, step by step, and writes it as STL, 3MF or PLY.",
        .help =
            "Steps are carried out in the order in which they are given; each may be given several times. "
            "Each tells its\n"
            "largest displacement, how far the surface lies from where it was, both ways, and what it did; "
            "what a step does\n"
            "not need stays as it is, to the last bit. `displacement` is the sum over the steps. All lengths "
            "are in --units.\n"
            "A recipe file has the steps as a project has them: {\"units\": \"mm\", \"repair\": [{\"kind\": "
            "\"holes\", \"size\": 5}]}.",
        .options =
            {{.name = "--list",
              .value = "",
              .help = "changes nothing: lists holes, pieces, doubles, needles, crossings"},
             {.name = "--pieces",
              .value = "SIZE",
              .help = "removes pieces whose box has a smaller diagonal; N:facets, A:area: with less; N:keep: "
                      "all but the N largest",
              .repeated = true},
             {.name = "--turn",
              .value = "",
              .help = "turns facets to agree and shells outward; of doubled facets one stays",
              .repeated = true},
             {.name = "--orient", .value = "", .help = "the same as --turn", .repeated = true},
             {.name = "--needles",
              .value = "BOUND",
              .help = "removes doubled facets and facets without height, within the bound",
              .repeated = true},
             {.name = "--holes",
              .value = "SIZE[:flat]",
              .help = "fills holes of at most this diameter (0: all) as the surface bends, or flat",
              .repeated = true},
             {.name = "--hole",
              .value = "X,Y,Z[:HOW]",
              .help = "fills the one hole with its middle there smooth or flat, or leaves it open: HOW is "
                      "smooth, flat or left",
              .repeated = true},
             {.name = "--smooth",
              .value = "BOUND[:ANGLE]",
              .help = "smooths noise; edges that bend by more than ANGLE degrees (default: 60) stay sharp",
              .repeated = true},
             {.name = "--decimate",
              .value = "BOUND[:SHARE]",
              .help = "takes facets away within the bound, until SHARE of them is left (default: all it can)",
              .repeated = true},
             {.name = "--cut",
              .value = "X,Y,Z,D[:open]",
              .help = "removes what lies beyond the plane with this normal, D off the origin; closes the "
                      "section, or leaves it open",
              .repeated = true},
             {.name = "--thicken",
              .value = "T",
              .help = "makes a sheet a solid: its back lies T behind it, before it below 0",
              .repeated = true},
             {.name = "--crossings",
              .value = "SIZE[:flat]",
              .help = "makes places of at most this size anew where the surface runs through itself",
              .repeated = true},
             {.name = "--fins",
              .value = "SIZE",
              .help = "removes sheets up to this size that hang on edges of more than two facets and end in "
                      "the open",
              .repeated = true},
             {.name = "--join",
              .value = "FILE[:APART[:MOVE]]",
              .help =
                  "joins a scan on that overlaps; they lie up to APART from each other (default: three mean "
                  "edges); it is laid on the part, and moves by no more than MOVE (default: not at all)",
              .repeated = true},
             {.name = "--recipe", .value = "FILE", .help = "the steps of a file", .repeated = true},
             {.name = "--units",
              .value = "UNIT",
              .help = "unit of all lengths: mm, cm, m, in, ft (default: mm)"},
             threads_option(),
             {.name = "-o", .value = "FILE", .help = "the file to write: .stl, .3mf or .ply"}},
        .run = run_repair};
}

} // namespace facetmill::cli
