// The holes of a mesh: closed curves along edges that only one facet has. The rim of an open sheet is one of
// them. Millimetres.
#pragma once

#include "core/base/progress.h"
#include "core/mesh/mesh.h"

#include <vector>

namespace facetmill {

struct Hole {
    std::vector<Index> loop; ///< vertices, in the order in which facets that fill it run along it
    double perimeter = 0;
    double diameter = 0;        ///< largest distance of two corners; from 4000 on the diagonal of their box
    Vec3 center = Vec3::Zero(); ///< middle of the corners
};

struct HoleList {
    std::vector<Hole> holes; ///< the largest diameter first
    /// Curves along edges of more than two facets, or of two that are wound against each other: ends of
    /// sheets, nothing to fill.
    std::size_t sheet_ends = 0;
    std::size_t left_out = 0; ///< facets that are in no manifold sheet
};

/// The hole whose middle is nearest to a place, no farther from it than half its diameter; none: their
/// number.
std::size_t hole_near(const std::vector<Hole>& holes, const Vec3& at);

/// Linear in the facets. Throws Error(limit_exceeded) as build_topology.
HoleList holes_of(const Mesh& mesh, const Progress& progress);

} // namespace facetmill
