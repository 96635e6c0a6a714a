// What a recipe of the scan room does to a mesh, ready to be drawn: the surface before, the surface after in
// the colours of how far it was moved, and apart from these what is new and what was taken away.
#pragma once

#include "core/base/progress.h"
#include "core/base/units.h"
#include "core/mesh/mesh.h"
#include "viz/deviation_colors.h"
#include "viz/part_display.h"

#include <functional>
#include <memory>
#include <vector>

namespace facetmill {

/// In the coordinates of the mesh file, mm.
struct RepairedSurfaces {
    MeshPtr before, after;
    std::vector<char> added; ///< of the facets after: new surface; may be empty
    double moved = 0;        ///< no place of what stays lies farther from where it was
};

struct RepairDisplay {
    PartDisplayPtr before;         ///< all of it
    PartDisplayPtr kept;           ///< afterwards, without what is new; null: nothing
    PartDisplayPtr added, removed; ///< null: nothing
    double largest = 0;            ///< mm, of the displacements, without their signs
    DeviationScale scale;
    std::vector<float> displacement;                  ///< mm, of the vertices of `kept`; outward is positive
    std::vector<std::uint8_t> colors, preview_colors; ///< RGBA of the vertices of `kept` and of its preview
};

using RepairDisplayPtr = std::shared_ptr<const RepairDisplay>;

/// Where the part's meshes stand in the view.
using PlaceMesh = std::function<MeshPtr(const MeshPtr& mesh, const Progress& progress)>;

/// Facets of `now` that are new surface, where a step makes such: they are not among those of `then`, and lie
/// off it. What was new then stays so (`added`, of `then`; may be empty).
std::vector<char> new_surface(const Mesh& then, const std::vector<char>& added, const Mesh& now,
                              bool makes_surface, const Progress& progress);

RepairDisplayPtr prepare_repair_display(const RepairedSurfaces& surfaces, const PlaceMesh& place,
                                        LengthUnit unit, const Progress& progress);

} // namespace facetmill
