// Values at the vertices of a piece of the surface that change as evenly as they can, and how they are
// stretched to lengths: what the maps of passes are made of (flow_map.h, ring_map.h). Millimetres.
#pragma once

#include "core/base/progress.h"
#include "core/mesh/mesh.h"

#include <limits>
#include <vector>

namespace facetmill {

/// How an edge pulls the values of its ends together, by the cotangents of the angles across: that of `a` is
/// to be `jump` more than that of `b`.
struct Pull {
    Index a, b;
    double weight;
    double jump = 0;
};

struct PieceEdges {
    std::vector<Pull> pulls;              ///< one for each edge, by the lower end `a`, then by `b`
    std::vector<std::vector<Index>> next; ///< per vertex: where sides of one facet alone go from it
};
PieceEdges piece_edges(const Mesh& mesh, const Progress& progress);

/// Closed ways of vertices along the border, each in the direction of the facets' winding.
std::vector<std::vector<Index>> border_of(const PieceEdges& edges);

/// Not fixed (solve_harmonic).
constexpr double free_value = std::numeric_limits<double>::quiet_NaN();

/// The value of every vertex that is the mean of its neighbours', jumps counted in; `value` begins as a
/// guess, and stays where `fixed` is a number. Conjugate gradients.
void solve_harmonic(const std::vector<Pull>& pulls, const std::vector<double>& fixed,
                    std::vector<double>& value, const Progress& progress);

/// What a value changes by over a facet, mm per mm. `period`: what it has grown by after a round, by which
/// values of neighbours may differ; 0: there are no rounds.
Vec3 value_gradient(const Mesh& mesh, std::size_t facet, const std::vector<double>& value, double period = 0);

/// How steep a value is over some facets: what a share of their area lies below.
double steepness_at(const Mesh& mesh, const std::vector<Index>& facets, const std::vector<double>& value,
                    double share, double period = 0);

/// What is left out of account where it is said how much a value changes: at corners it changes ever faster.
constexpr double left_out_share = 0.02;

/// Makes the value of some vertices change by as much everywhere along its own course, and hardly anywhere
/// by more than a length does. `facets`: those between them.
void stretch_value(const Mesh& mesh, const std::vector<Index>& facets, std::vector<double>& value,
                   const std::vector<Index>& vertices);

} // namespace facetmill
