// The part's mesh as its project's recipe leaves it.
#pragma once

#include "core/base/strict_json.h"
#include "core/job/project.h"
#include "core/mesh/mesh_io.h"
#include "core/repair/repair.h"

#include <filesystem>
#include <string>
#include <vector>

namespace facetmill {

struct RepairedMesh {
    MeshPtr mesh;                                    ///< in the place of the file
    std::shared_ptr<const std::vector<Index>> faces; ///< as LoadedMesh; null once a step has run
    MeshReport report; ///< of the mesh as it is now; format, name and what was odd in the file are the file's
    std::vector<StepReport> repairs;
};

/// Reads the file and carries the recipe out, whose files are where they are looked for
/// (Project::part_recipe); scans that are joined on are read as the part is. Throws what load_mesh and
/// run_recipe throw.
RepairedMesh load_repaired(const std::filesystem::path& path, const MeshReading& reading,
                           const std::vector<RepairStep>& recipe, const Progress& progress);

/// Another text for another recipe, or once a file of it was written anew; empty for none.
std::string recipe_key(const std::vector<RepairStep>& recipe);

/// What the steps did, as reports and `info` tell it: kind, displacement in `unit`, counts, facets.
Json repairs_json(const std::vector<StepReport>& steps, LengthUnit unit);

} // namespace facetmill
