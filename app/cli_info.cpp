// facetmill-cli info: the honest account of a mesh file.
#include "app/cli_commands.h"
#include "app/cli_mesh.h"
#include "app/cli_session.h"
#include "core/base/strict_json.h"
#include "core/job/repaired_mesh.h"
#include "core/mesh/mesh_io.h"

namespace facetmill::cli {

namespace {

constexpr std::string_view project_extension = ".facetmill";

/// Measured, not read: printed as it is. Whole numbers without a point.
Json plain(double v) {
    return json_number(v, "info");
}

/// Lengths in the file's unit, as everything else.
Json surfaces_json(const SurfaceReport& s, double mm) {
    Json out;
    out["unit"] = s.unit;
    out["chord_tolerance"] = plain(s.chord / mm);
    out["angle_tolerance"] = plain(degrees(s.chord_angle));
    out["deviation_out"] = plain(s.out / mm);
    out["deviation_in"] = plain(s.in / mm);
    out["faces"] = s.faces;
    out["solids"] = s.solids;
    out["loose_faces"] = s.loose_faces;
    out["missing_faces"] = s.missing_faces;
    out["part_count"] = s.part_count;
    out["parts"] = s.parts;
    return out;
}

/// The mesh itself, or the part of a project as its recipe leaves it.
RepairedMesh read_part(const Arguments& arguments, const std::string& path, const Progress& progress) {
    if (!path.ends_with(project_extension))
        return load_repaired(path, asked_reading(arguments), {}, progress);
    if (arguments.has("--units"))
        throw Error(ErrorCode::usage, "--units", "a project says the unit of its part", "leave it out");
    refuse_reading_options(arguments);
    const Project project = load_project(path);
    check_recipe(project.part.repair, "part.repair");
    return load_repaired(project.part_path(), project.part_reading(), project.part_recipe(), progress);
}

void run_info(const Arguments& arguments, Session& session) {
    const std::string path = arguments.operand(0);
    const RepairedMesh loaded = read_part(arguments, path, session.progress());
    const MeshReport& r = loaded.report;
    const LengthUnit unit = r.assumed_unit; // of everything that is told

    Json box = Json::array(), size = Json::array();
    for (double v : {r.file_box.lo.x(), r.file_box.lo.y(), r.file_box.lo.z(), r.file_box.hi.x(),
                     r.file_box.hi.y(), r.file_box.hi.z()})
        box.push_back(v);
    for (int k = 0; k < 3; ++k)
        size.push_back(plain(r.file_box.size()[k] * mm_per(unit)));
    Json explanations = Json::object();
    for (const auto& word : r.warnings)
        explanations[word] = explain_warning(word);

    Json out;
    out["file"] = printable(path, 400);
    out["format"] = r.format;
    out["name"] = r.name;
    out["units"] = std::string(unit_name(unit));
    out["units_stated"] = arguments.has("--units") || r.unit_known;
    out["units_guess"] = units_guess_name(r);
    out["facets"] = r.facets;
    out["facets_used"] = loaded.mesh->facet_count();
    out["vertices"] = loaded.mesh->vertices.size();
    out["welded_vertices"] = r.welded_vertices;
    out["shells"] = r.shells;
    out["bbox"] = box;
    out["size_mm"] = size;
    out["area"] = plain(r.file_area);
    out["volume"] = plain(r.file_volume);
    out["watertight"] = r.watertight;
    out["degenerate"] = r.degenerate;
    out["duplicate"] = r.duplicate;
    out["open_edges"] = r.open_edges;
    out["non_manifold_edges"] = r.non_manifold_edges;
    out["non_manifold_vertices"] = r.non_manifold_vertices;
    out["inconsistent_edges"] = r.inconsistent_edges;
    if (!r.objects.empty()) {
        out["objects"] = Json::array();
        for (const MeshObject& o : r.objects)
            out["objects"].push_back(
                Json{{"number", o.number}, {"name", o.name}, {"facets", o.facets}, {"read", o.read}});
    }
    if (r.surfaces) out["surfaces"] = surfaces_json(*r.surfaces, mm_per(unit));
    if (!loaded.repairs.empty()) out["repair"] = repairs_json(loaded.repairs, unit);
    out["warnings"] = r.warnings;
    out["explanations"] = explanations;
    session.print(pretty_json(out));
}

} // namespace

Command info_command() {
    return {.name = "info",
            .operands = {"PART"},
            .summary = "Prints what a mesh file holds and what is wrong with it, as JSON.",
            .help =
                "bbox, area and volume are in the file's own numbers; size_mm takes them as units "
                "says, which is\n"
                "what the file states where it does, else --units. A picture (PNG, TIFF) is read as a "
                "relief, black its\n"
                "ground; objects lists those of a 3MF or glTF file, surfaces what a STEP or IGES file holds "
                "and how far its\n"
                "surfaces lie outside and inside the facets. Degenerate\n"
                "facets are left out of planning (facets_used), everything else is machined as it is; "
                "each word in\n"
                "warnings is explained in explanations. PART may be a project: its part as its recipe "
                "leaves it, and what the\n"
                "recipe did.",
            .options = with_reading_options(
                {{.name = "--units",
                  .value = "UNIT",
                  .help = "unit of the file's numbers, and of options: mm, cm, m, in, ft (default: mm)"}}),
            .run = run_info};
}

} // namespace facetmill::cli
