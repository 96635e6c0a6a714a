// The scan room: a recipe carried out. Each step says how far it moved the surface, what it did, and leaves
// everything it did not need as it was: the same bits of vertices, the same facets in the same order.
//
// Half-edges hold no non-manifold mesh. Where a step needs them, edges of more than two facets, and facets
// wound against their neighbours, part the mesh into manifold sheets (topology.h) and the step says how many
// facets it could not take in; these stay as they are.
#pragma once

#include "core/base/progress.h"
#include "core/mesh/mesh.h"
#include "core/mesh/mesh_reading.h"
#include "core/repair/recipe.h"

#include <string>
#include <vector>

namespace facetmill {

/// One thing that a step did or left, and how many of it: "filled", 12.
struct RepairCount {
    std::string what; ///< snake_case
    std::size_t count = 0;
};

/// What a step did to the mesh that the step before left.
struct StepReport {
    RepairStep::Kind kind = RepairStep::Kind::turn;
    /// mm; no place of the surface lies farther from where it was, both ways. Surface that was taken away
    /// (pieces, doubles, what is cut off) or is new (in holes, in a section, backs) is not in it.
    /// Of a joined scan: how far it was moved and how far what went of it lies from what stayed.
    double displacement = 0;
    std::vector<RepairCount> counts;
    std::size_t facets = 0; ///< of the mesh after the step

    /// 0 where it did not say.
    std::size_t count(const std::string& what) const;
};

struct Repaired {
    MeshPtr mesh;                  ///< the one that came in where no step changed it
    std::vector<StepReport> steps; ///< of those that are not off
};

/// New vertices lie where a 32-bit float can say it, so that a binary STL file in mm holds the very mesh that
/// was judged. The mesh must have no facet that names a vertex twice (load_mesh leaves these out). `reading`:
/// how the files of scans that are joined on are read; their places are those of located_recipe. `done`: the
/// mesh is what so many steps at the beginning have made; they are not in the result. Throws
/// Error(out_of_range, missing_key) as check_recipe does, Error(empty_result) when a step leaves no facet,
/// Error(limit_exceeded), what load_mesh throws, Cancelled. The same bits with any number of threads.
Repaired run_recipe(const MeshPtr& mesh, const std::vector<RepairStep>& recipe, const Progress& progress,
                    const MeshReading& reading = {}, std::size_t done = 0);

} // namespace facetmill
