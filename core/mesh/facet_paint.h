// Selections of facets as they are painted on a mesh: what a brush touches, what hangs together at flat
// angles, and the rings round what is selected. Millimetres, radians. Any mesh: open, non-manifold, wound
// differently.
#pragma once

#include "core/base/progress.h"
#include "core/mesh/mesh.h"

#include <cstdint>
#include <span>
#include <vector>

namespace facetmill {

/// Facets beside each other across an edge.
class FacetNeighbours {
public:
    FacetNeighbours(const Mesh& mesh, const Progress& progress);

    std::span<const Index> of(std::size_t facet) const {
        return {neighbours_.data() + start_[facet], neighbours_.data() + start_[facet + 1]};
    }

private:
    std::vector<Index> start_; ///< one more than facets
    std::vector<Index> neighbours_;
};

/// Finds facets from a place on the mesh. What it finds depends on nothing that was found before; it keeps
/// room for its searches, so that each takes as long as what it finds is large.
class FacetPainter {
public:
    /// Linear in the mesh.
    FacetPainter(MeshPtr mesh, const Progress& progress);

    const MeshPtr& mesh() const { return mesh_; }
    /// Facets that a ball of `radius` about `at`, a place on `facet`, touches and that hang together with it
    /// across edges of such facets: none on the other side of a wall unless the way round it lies in the
    /// ball. `facet` itself in any case, first.
    std::vector<Index> brush(Index facet, const Vec3& at, double radius);
    /// Facets that are reached from `facet` across edges at which the surface turns by `angle` at most;
    /// `facet` first. Facets without area are crossed as if they lay level with where one comes from.
    std::vector<Index> flood(Index facet, double angle);

private:
    /// Calls take(from, to) for each facet beside one that was taken, the first excepted, until it says
    /// false of all of them; returns those of which it said true.
    template <class Take>
    std::vector<Index> spread(Index facet, Take&& take);

    MeshPtr mesh_;
    FacetNeighbours neighbours_;
    std::vector<std::uint32_t> seen_; ///< the search that took a facet last
    std::uint32_t search_ = 0;
};

/// Facets whose mark is not `of` that have a corner within `distance`, measured along edges, of a facet whose
/// mark is: with distance 0 one ring round those. `marks` has one for each facet. Growing a selection takes
/// the rings round its facets in, shrinking it those round all others out. Ascending.
std::vector<Index> ring_round(const Mesh& mesh, const std::vector<char>& marks, bool of, double distance,
                              const Progress& progress);

} // namespace facetmill
