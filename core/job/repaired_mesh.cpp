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

} // namespace

std::optional<RepairedMesh> KnownMeshes::find(const std::string& key) const {
    const std::lock_guard lock(mutex_);
    const auto it = all_.find(key);
    MeshPtr mesh = it == all_.end() ? nullptr : it->second.mesh.lock();
    if (!mesh) return std::nullopt;
    RepairedMesh found = it->second.rest;
    found.mesh = std::move(mesh);
    return found;
}

void KnownMeshes::keep(const std::string& key, const RepairedMesh& known) {
    const std::lock_guard lock(mutex_);
    std::erase_if(all_, [](const auto& entry) { return entry.second.mesh.expired(); });
    Entry& entry = all_[key];
    entry.mesh = known.mesh;
    entry.rest = known;
    entry.rest.mesh = nullptr;
}

std::string repaired_key(const std::filesystem::path& path, const MeshReading& reading,
                         const std::vector<RepairStep>& recipe) {
    Key key;
    key.add(std::string_view(file_stamp(path)))
        .add(std::string_view(reading_key(reading)))
        .add(std::string_view(recipe_key(recipe)));
    return key.text();
}

MeshReport report_of_repaired(const MeshReport& of_file, const Mesh& mesh, const Progress& progress) {
    MeshReport report;
    report.format = of_file.format;
    report.name = of_file.name;
    report.assumed_unit = of_file.assumed_unit;
    report.unit_known = of_file.unit_known;
    report.is_relief = of_file.is_relief;
    report.objects = of_file.objects;
    report.surfaces = of_file.surfaces;
    analyse_mesh(mesh, report, progress);
    for (const std::string& word : of_file.warnings)
        if (!is_of_mesh(word)) report.warnings.push_back(word);
    std::sort(report.warnings.begin(), report.warnings.end());
    return report;
}

RepairedMesh load_repaired(const std::filesystem::path& path, const MeshReading& reading,
                           const std::vector<RepairStep>& recipe, const Progress& progress,
                           KnownMeshes* known) {
    const bool repairs =
        std::any_of(recipe.begin(), recipe.end(), [](const RepairStep& step) { return !step.off; });
    // What a file is called before it is read: one that changes meanwhile has another text afterwards.
    const std::string file_key = repaired_key(path, reading, {}), key = repaired_key(path, reading, recipe);
    const auto find = [&](const std::string& k) { return known ? known->find(k) : std::nullopt; };
    if (auto found = find(key)) return *std::move(found);
    auto file = find(file_key);
    if (!file) {
        LoadedMesh loaded = load_mesh(path, reading, progress.part(0, repairs ? 0.3 : 1, "Reading the part"));
        file = {loaded.mesh, loaded.faces, std::move(loaded.report), {}};
        if (known) known->keep(file_key, *file);
    }
    if (!repairs) return *std::move(file);
    MeshReading scans = reading; // all of each
    scans.objects.clear();
    Repaired repaired = run_recipe(file->mesh, recipe, progress.part(0.3, 0.95), scans);
    MeshReport report = report_of_repaired(file->report, *repaired.mesh, progress.part(0.95, 1));
    RepairedMesh result{repaired.mesh, nullptr, std::move(report), std::move(repaired.steps)};
    if (known) known->keep(key, result);
    return result;
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
