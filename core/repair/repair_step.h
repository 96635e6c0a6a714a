// The steps of a recipe, one function each. Internal to the room.
#pragma once

#include "core/repair/repair.h"

#include <optional>
#include <vector>

namespace facetmill::detail {

/// `mesh` is none where the step changed nothing.
struct StepResult {
    MeshPtr mesh;
    double displacement = 0; ///< mm
    std::vector<RepairCount> counts;

    void tell(const char* what, std::size_t count) { counts.push_back({what, count}); }
    /// Only what there is.
    void tell_any(const char* what, std::size_t count) {
        if (count > 0) tell(what, count);
    }
};

StepResult remove_pieces(const Mesh& mesh, const RepairStep& step, const Progress& progress);
StepResult remove_fins(const Mesh& mesh, const RepairStep& step, const Progress& progress);
StepResult turn_facets(const Mesh& mesh, const RepairStep& step, const Progress& progress);
StepResult remove_needles(const Mesh& mesh, const RepairStep& step, const Progress& progress);
/// `left`: holes with their middles there (hole_near) stay open.
StepResult fill_holes(const Mesh& mesh, const RepairStep& step, const std::vector<Vec3>& left,
                      const Progress& progress);
StepResult fill_hole(const Mesh& mesh, const RepairStep& step, const Progress& progress);
StepResult smooth_noise(const Mesh& mesh, const RepairStep& step, const Progress& progress);
StepResult decimate(const Mesh& mesh, const RepairStep& step, const Progress& progress);
StepResult cut_by_plane(const Mesh& mesh, const RepairStep& step, const Progress& progress);
StepResult thicken_sheet(const Mesh& mesh, const RepairStep& step, const Progress& progress);
StepResult remake_crossings(const Mesh& mesh, const RepairStep& step, const Progress& progress);

/// The facets that stay, in their order, with the vertices that they name, in theirs.
MeshPtr with_facets(const Mesh& mesh, const std::vector<char>& stays, const Progress& progress);

} // namespace facetmill::detail
