// Adaptive triangles over a parametric surface, for the sample parts.
#pragma once

#include "core/base/progress.h"
#include "core/mesh/mesh.h"

#include <functional>
#include <string>
#include <vector>

namespace facetmill {

/// Point at parameters (a, b); must be callable from several threads at once and smooth inside every cell of
/// the grid.
using PatchFunction = std::function<Vec3(double, double)>;

/// Coarse grid of a patch: triangles start as its cells, halved along a diagonal, and its lines stay edges,
/// so put lines on creases. Facets are counter-clockwise seen from d/da x d/db.
struct PatchGrid {
    std::vector<double> a, b; ///< increasing, at least two each
    /// The last column is the first one again: patch(a.back(), b) == patch(a.front(), b).
    bool closed_a = false;
};

/// Mesh of the patch whose surface points are all within `tolerance` (mm) of it, edges and border included:
/// facets are halved across their longest edge, together with the facet on the other side (Rivara's longest-
/// edge bisection), so that there are never T-junctions and angles stay near those of the coarse grid. Facets
/// are judged at the points of a fine lattice, not only at their middles. The same mesh for every thread
/// count. Throws Error(out_of_range) naming `what` when the tolerance needs more than `sample_facet_limit`
/// facets.
Mesh tessellate_patch(const PatchFunction& patch, const PatchGrid& grid, double tolerance,
                      const std::string& what, const Progress& progress);

inline constexpr std::size_t sample_facet_limit = 20'000'000;
[[noreturn]] void throw_too_many_facets(const std::string& what);

/// `cells` + 1 parameters from `from` to `to` at about equal distances along the curve, for coarse grids.
std::vector<double> even_stations(const std::function<Vec3(double)>& curve, double from, double to,
                                  int cells);

} // namespace facetmill
