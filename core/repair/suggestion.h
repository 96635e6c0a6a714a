// What a recipe may begin with: steps for what a survey found, to be looked at and changed by whoever knows
// the scan. Millimetres.
#pragma once

#include "core/base/units.h"
#include "core/repair/recipe.h"
#include "core/repair/survey.h"

#include <vector>

namespace facetmill {

/// A step of this kind with amounts that fit a mesh of the box's size: round numbers in `unit`. A scan that
/// is joined on lacks its file.
RepairStep starting_step(RepairStep::Kind kind, const Box3& box, LengthUnit unit);

/// Steps for what the survey of the mesh found, in the order pieces, turn, needles, holes; those that would
/// do nothing are not in it. Pieces go that are smaller than a tenth of the largest. A hole that is wider
/// than three tenths of its piece is taken for the rim of an open sheet and left. `inside_out`: shells of the
/// mesh face inward (MeshReport::warnings).
std::vector<RepairStep> suggested_recipe(const Mesh& mesh, const Survey& survey, bool inside_out,
                                         LengthUnit unit);

enum class HoleFate {
    left,
    filled,
    goes, ///< with the piece that it is in
};

/// What becomes of the survey's holes, in their order, as far as their diameters and pieces say: whether a
/// patch fits shows when the recipe is carried out.
std::vector<HoleFate> hole_fates(const Mesh& mesh, const Survey& survey,
                                 const std::vector<RepairStep>& recipe);

} // namespace facetmill
