// What is wrong with a scan, before anything is done to it.
#pragma once

#include "core/base/progress.h"
#include "core/mesh/mesh.h"
#include "core/repair/holes.h"
#include "core/repair/shells.h"

namespace facetmill {

struct Survey {
    Shells shells;
    HoleList holes;
    std::size_t doubles = 0;         ///< facets with the vertices of another one before them
    std::size_t needles = 0;         ///< facets whose direction is noise
    std::size_t crossings = 0;       ///< pairs of facets that run through each other
    std::size_t crossing_facets = 0; ///< facets in such pairs
    std::size_t against = 0;         ///< edges along which two facets run in the same direction
    std::size_t non_manifold = 0;    ///< edges of more than two facets
};

/// Linear but for the crossings. Throws Error(limit_exceeded) as build_topology, Cancelled.
Survey survey_mesh(const Mesh& mesh, const Progress& progress);

} // namespace facetmill
