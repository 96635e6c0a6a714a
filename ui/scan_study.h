// The scan room's work, without widgets: a mesh file surveyed as it is, and a recipe tried on it, step after
// step. Steps that stand at the beginning of the recipe that was tried before are not carried out again.
#pragma once

#include "core/job/project.h"
#include "core/job/repaired_mesh.h"
#include "core/mesh/mesh_report.h"
#include "core/repair/repair.h"
#include "core/repair/suggestion.h"
#include "viz/repair_display.h"

#include <QString>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace facetmill::ui {

/// A mesh and what is wrong with it, in the coordinates of its file, mm.
struct ScannedMesh {
    MeshPtr mesh;
    MeshReport report;
    Survey survey;
    Box3 box;
    std::vector<std::size_t> pieces; ///< its shells, the largest first
};

using ScannedMeshPtr = std::shared_ptr<const ScannedMesh>;

/// The part's file as it is on disk and how it is read: another text, and what was surveyed is of another
/// mesh.
std::string scan_key(const Project& project);
/// Where the part lies, likewise.
std::string scan_place_key(const Project& project);

/// Reads the part's file without its recipe, unless that is known. Throws what load_mesh and survey_mesh
/// throw.
ScannedMeshPtr read_scan(const Project& project, KnownMeshes& meshes, const Progress& progress);

/// What one step came to.
struct TriedStep {
    RepairStep step; ///< its file where it is looked for
    std::string key; ///< of the step and its file as they were
    StepReport report;
    MeshPtr mesh;            ///< after it
    std::vector<char> added; ///< of its facets: surface that the scan had not
    double seconds = 0;
};

using TriedStepPtr = std::shared_ptr<const TriedStep>;

/// What a recipe comes to.
struct ScanTrial {
    std::vector<RepairStep> recipe, located; ///< as it is edited; with files where they are looked for
    MeshReading reading;                     ///< of scans that are joined on
    std::string key;                         ///< repaired_key of what comes out
    ScannedMeshPtr before;
    std::vector<TriedStepPtr> steps; ///< of the recipe's steps that are not off, as far as it came
    ScannedMeshPtr after;            ///< null where it did not come to the end
    RepairDisplayPtr display;
    std::optional<std::size_t> failed; ///< the step, counted in the recipe, that could not be carried out
    QString failure;                   ///< why

    /// What a step of the recipe came to; null where it is off or was not reached.
    TriedStepPtr step(std::size_t i) const;
    /// False once a file that a step has read was written anew.
    bool is_current() const;
};

using ScanTrialPtr = std::shared_ptr<const ScanTrial>;

/// A recipe for the part of a project, to be tried on its mesh as it is.
std::shared_ptr<ScanTrial> new_trial(const Project& project, const std::vector<RepairStep>& recipe,
                                     const ScannedMeshPtr& before);

/// What came out at the end, as the part is read.
RepairedMesh repaired(const ScanTrial& trial);

/// Fills a new trial as it goes on: what was done by the time that it is
/// cancelled or fails stays. `known`: a trial of before, of the same mesh; may be null. Throws what
/// run_recipe throws.
void try_recipe(ScanTrial& trial, const ScanTrialPtr& known, const PlaceMesh& place, LengthUnit unit,
                const Progress& progress);

} // namespace facetmill::ui
