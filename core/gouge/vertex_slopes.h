// Where the surface around a vertex has which slopes: what a cutter that comes down along Z can touch there.
#pragma once

#include "core/base/progress.h"
#include "core/mesh/mesh.h"

#include <cstdint>
#include <vector>

namespace facetmill {

/// Slopes (dz/dx, dz/dy) of a piece of the surface: a rectangle that holds them.
struct SlopeRange {
    float lo_x, hi_x, lo_y, hi_y;

    static SlopeRange none(); ///< holds nothing
    static SlopeRange all();  ///< holds every slope there is
    void add(const SlopeRange& other);
};

/// The slopes, for every vertex, of the facets that have it, widened by `tolerance::slope_slack`. Every slope
/// there is where `is_open` (see facet_duties.h), and where a facet is upright, steeper than
/// `tolerance::steepest_trusted`, or a needle.
///
/// Why: let q be a highest contact, on the cutter at x from its axis, and the facets that have q lie around
/// it as seen along Z. Over them the lift z - g is highest at q, so 0 is among its generalized gradients
/// (Clarke): there is a slope in the convex hull of the facets' slopes that a plane would need to touch the
/// cutter at x. Facets that have q are a facet that q is on and others that share a vertex with it.
std::vector<SlopeRange> vertex_slopes(const Mesh& mesh, const std::vector<std::uint8_t>& is_open,
                                      const Progress& progress);

} // namespace facetmill
