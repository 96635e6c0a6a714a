// The part's mesh as its project's recipe leaves it.
#pragma once

#include "core/base/strict_json.h"
#include "core/job/project.h"
#include "core/mesh/mesh_io.h"
#include "core/repair/repair.h"

#include <filesystem>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

namespace facetmill {

struct RepairedMesh {
    MeshPtr mesh;                                    ///< in the place of the file
    std::shared_ptr<const std::vector<Index>> faces; ///< as LoadedMesh; null once a step has run
    MeshReport report; ///< of the mesh as it is now; format, name and what was odd in the file are the file's
    std::vector<StepReport> repairs;
};

/// Meshes that were read and repaired, by the text of what they come from; each as long as somebody holds it.
/// Several threads may ask at once.
class KnownMeshes {
public:
    std::optional<RepairedMesh> find(const std::string& key) const;
    void keep(const std::string& key, const RepairedMesh& known);

private:
    struct Entry {
        std::weak_ptr<const Mesh> mesh;
        RepairedMesh rest; ///< without the mesh
    };
    mutable std::mutex mutex_;
    std::map<std::string, Entry> all_;
};

/// Another text for another file, way of reading and recipe, and once one of their files was written anew.
std::string repaired_key(const std::filesystem::path& path, const MeshReading& reading,
                         const std::vector<RepairStep>& recipe);

/// What is told of a file's mesh once a recipe has made another one of it.
MeshReport report_of_repaired(const MeshReport& of_file, const Mesh& mesh, const Progress& progress);

/// Reads the file and carries the recipe out, whose files are where they are looked for
/// (Project::part_recipe); scans that are joined on are read as the part is. What `known` has is
/// not done again. Throws what load_mesh and run_recipe throw.
RepairedMesh load_repaired(const std::filesystem::path& path, const MeshReading& reading,
                           const std::vector<RepairStep>& recipe, const Progress& progress,
                           KnownMeshes* known = nullptr);

/// Another text for another recipe, or once a file of it was written anew; empty for none.
std::string recipe_key(const std::vector<RepairStep>& recipe);

/// What the steps did, as reports and `info` tell it: kind, displacement in `unit`, counts, facets.
Json repairs_json(const std::vector<StepReport>& steps, LengthUnit unit);

} // namespace facetmill
