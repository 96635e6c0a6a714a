#include "ui/scan_study.h"

#include "core/job/placed_mesh.h"
#include "core/mesh/mesh_io.h"
#include "ui/text.h"

#include <algorithm>
#include <chrono>
#include <numeric>

namespace facetmill::ui {

namespace {

using StepKind = RepairStep::Kind;

/// Others make surface that was not there.
bool only_changes(StepKind kind) {
    return kind == StepKind::pieces || kind == StepKind::turn || kind == StepKind::needles
           || kind == StepKind::smooth || kind == StepKind::decimate || kind == StepKind::fins;
}

ScannedMeshPtr surveyed(MeshPtr mesh, MeshReport report, const Progress& progress) {
    auto scan = std::make_shared<ScannedMesh>();
    scan->survey = survey_mesh(*mesh, progress);
    scan->report = std::move(report);
    scan->box = mesh->box();
    const auto& shells = scan->survey.shells.all;
    scan->pieces.resize(shells.size());
    std::iota(scan->pieces.begin(), scan->pieces.end(), std::size_t(0));
    std::stable_sort(scan->pieces.begin(), scan->pieces.end(), [&](std::size_t a, std::size_t b) {
        return shells[a].box.diagonal() > shells[b].box.diagonal();
    });
    scan->mesh = std::move(mesh);
    return scan;
}

/// Step `i` of a recipe, on what those before it have made.
TriedStepPtr carry_out(const std::vector<RepairStep>& recipe, std::size_t i, const MeshReading& reading,
                       const MeshPtr& mesh, const std::vector<char>& added, const Progress& progress) {
    const RepairStep& step = recipe[i];
    const auto start = std::chrono::steady_clock::now();
    auto tried = std::make_shared<TriedStep>();
    tried->step = step;
    tried->key = recipe_key({step}); // before: a file that changes meanwhile is read again
    const std::vector<RepairStep> up_to(recipe.begin(), recipe.begin() + std::ptrdiff_t(i) + 1);
    Repaired done = run_recipe(mesh, up_to, progress.part(0, 0.8), reading, i);
    tried->seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    tried->report = std::move(done.steps.front());
    tried->mesh = std::move(done.mesh);
    tried->added = tried->mesh == mesh ? added
                                       : new_surface(*mesh, added, *tried->mesh, !only_changes(step.kind),
                                                     progress.part(0.8, 1));
    return tried;
}

} // namespace

std::string scan_key(const Project& project) {
    return file_stamp(project.part_path()) + "|" + reading_key(project.part_reading());
}

std::string scan_place_key(const Project& project) {
    return mesh_key({}, MeshPlace::of(project.placed_part()));
}

ScannedMeshPtr read_scan(const Project& project, KnownMeshes& meshes, const Progress& progress) {
    RepairedMesh loaded = load_repaired(project.part_path(), project.part_reading(), {},
                                        progress.part(0, 0.4, "Reading the part"), &meshes);
    return surveyed(loaded.mesh, std::move(loaded.report), progress.part(0.4, 1));
}

TriedStepPtr ScanTrial::step(std::size_t i) const {
    if (i >= recipe.size() || recipe[i].off) return nullptr;
    const auto at = std::size_t(std::count_if(recipe.begin(), recipe.begin() + std::ptrdiff_t(i),
                                              [](const RepairStep& s) { return !s.off; }));
    return at < steps.size() ? steps[at] : nullptr;
}

bool ScanTrial::is_current() const {
    return std::all_of(steps.begin(), steps.end(), [](const TriedStepPtr& tried) {
        return tried->step.file.empty() || tried->key == recipe_key({tried->step});
    });
}

std::shared_ptr<ScanTrial> new_trial(const Project& project, const std::vector<RepairStep>& recipe,
                                     const ScannedMeshPtr& before) {
    Project asked = project;
    asked.part.repair = recipe;
    auto trial = std::make_shared<ScanTrial>();
    trial->recipe = recipe;
    trial->located = asked.part_recipe();
    trial->reading = asked.part_reading();
    trial->key = repaired_key(asked.part_path(), trial->reading, trial->located);
    trial->reading.objects.clear(); // all of each
    trial->before = before;
    return trial;
}

RepairedMesh repaired(const ScanTrial& trial) {
    RepairedMesh result{trial.after->mesh, nullptr, trial.after->report, {}};
    for (const TriedStepPtr& tried : trial.steps)
        result.repairs.push_back(tried->report);
    return result;
}

void try_recipe(ScanTrial& trial, const ScanTrialPtr& known, const PlaceMesh& place, LengthUnit unit,
                const Progress& progress) {
    const auto count = std::size_t(
        std::count_if(trial.recipe.begin(), trial.recipe.end(), [](const RepairStep& s) { return !s.off; }));
    const bool same_mesh = known && known->before == trial.before;
    bool as_before = same_mesh;
    MeshPtr mesh = trial.before->mesh;
    std::vector<char> added;
    double moved = 0;
    const Progress running = progress.part(0, 0.7);
    for (std::size_t i = 0; i < trial.recipe.size(); ++i) {
        const RepairStep& step = trial.located[i];
        if (step.off) continue;
        const std::size_t at = trial.steps.size();
        as_before = as_before && at < known->steps.size() && known->steps[at]->key == recipe_key({step});
        const double share = 1 / double(count);
        try {
            trial.steps.push_back(as_before
                                      ? known->steps[at]
                                      : carry_out(trial.located, i, trial.reading, mesh, added,
                                                  running.part(double(at) * share, double(at + 1) * share)));
        } catch (const Error& e) {
            trial.failed = i;
            trial.failure = failure_text(e);
            throw;
        }
        mesh = trial.steps.back()->mesh;
        added = trial.steps.back()->added;
        moved += trial.steps.back()->report.displacement;
    }
    if (mesh == trial.before->mesh) {
        trial.after = trial.before;
    } else if (as_before && known->after && known->after->mesh == mesh) {
        trial.after = known->after;
    } else {
        MeshReport report = report_of_repaired(trial.before->report, *mesh, progress.part(0.7, 0.73));
        trial.after = surveyed(mesh, std::move(report), progress.part(0.73, 0.85));
    }
    trial.display = prepare_repair_display({trial.before->mesh, mesh, added, moved}, place, unit,
                                           progress.part(0.85, 1, "Preparing the view"));
}

} // namespace facetmill::ui
