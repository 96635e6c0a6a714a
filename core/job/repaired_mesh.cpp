#include "core/job/repaired_mesh.h"

#include "core/job/cache_key.h"

#include <algorithm>

namespace facetmill {

namespace {

/// Words that say what the mesh is like, not what the file is like.
bool is_of_mesh(const std::string& word) {
    for (const char* of_mesh : {"degenerate_facets", "duplicate_facets", "inconsistent_winding", "inside_out",
                                "multiple_shells", "non_manifold_edges", "open_edges", "unit_suspect"})
        if (word == of_mesh) return true;
    return false;
}

MeshReport report_after(const MeshReport& before, const Mesh& mesh, const Progress& progress) {
    MeshReport report;
    report.format = before.format;
    report.name = before.name;
    report.assumed_unit = before.assumed_unit;
    report.unit_known = before.unit_known;
    report.is_relief = before.is_relief;
    report.objects = before.objects;
    report.surfaces = before.surfaces;
    analyse_mesh(mesh, report, progress);
    for (const std::string& word : before.warnings)
        if (!is_of_mesh(word)) report.warnings.push_back(word);
    std::sort(report.warnings.begin(), report.warnings.end());
    return report;
}

} // namespace

RepairedMesh load_repaired(const std::filesystem::path& path, const MeshReading& reading,
                           const std::vector<RepairStep>& recipe, const Progress& progress) {
    const bool repairs =
        std::any_of(recipe.begin(), recipe.end(), [](const RepairStep& step) { return !step.off; });
    LoadedMesh loaded = load_mesh(path, reading, progress.part(0, repairs ? 0.3 : 1, "Reading the part"));
    if (!repairs) return {loaded.mesh, loaded.faces, std::move(loaded.report), {}};
    MeshReading scans = reading; // all of each
    scans.objects.clear();
    Repaired repaired = run_recipe(loaded.mesh, recipe, progress.part(0.3, 0.95), scans);
    MeshReport report = report_after(loaded.report, *repaired.mesh, progress.part(0.95, 1));
    return {repaired.mesh, nullptr, std::move(report), std::move(repaired.steps)};
}

std::string recipe_key(const std::vector<RepairStep>& recipe) {
    if (recipe.empty()) return {};
    Key key;
    key.add_value(ParameterValue(repair_list.values(recipe)));
    for (const RepairStep& step : recipe)
        if (!step.file.empty()) key.add(std::string_view(file_stamp(step.file)));
    return "repair" + key.text();
}

Json repairs_json(const std::vector<StepReport>& steps, LengthUnit unit) {
    Json out = Json::array();
    for (const StepReport& step : steps) {
        Json one;
        one["kind"] = repair_kind_name(step.kind);
        one["displacement"] = json_number(step.displacement / mm_per(unit), "repair");
        for (const RepairCount& c : step.counts)
            one[c.what] = c.count;
        one["facets"] = step.facets;
        out.push_back(one);
    }
    return out;
}

} // namespace facetmill
