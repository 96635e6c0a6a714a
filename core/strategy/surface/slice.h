// Slices of the mesh by vertical drive planes: the chains of cutter contact points (CC points) of Lu 3.5.2.
//
// The rule that makes slices whole: a vertex with v >= the plane's offset counts as above, any other as
// below, and a facet is cut when it has both. Every cut facet then has exactly two cut edges, whatever lies
// on the plane; the point on an edge is computed from the edge alone, so facets that share it share the point
// bit by bit. Facets in the plane are never cut; the facets around them carry the chain along their border
// once. Hence no gaps and no doubled pieces; points that repeat their predecessor exactly are dropped.
#pragma once

#include "core/mesh/geometry.h"
#include "core/strategy/surface/drive_frame.h"
#include "core/strategy/surface/interval_index.h"
#include "core/strategy/surface/pass_map.h"

#include <utility>
#include <vector>

namespace facetmill {

struct SlicePoint {
    Vec3 point, normal;     ///< the normal is that of the edge there (Lu 3.5)
    double u = 0;           ///< along the direction of travel
    Index facet = no_index; ///< one that the point lies on
};

struct SliceChain {
    std::vector<SlicePoint> points; ///< at least two; a closed chain does not repeat its first point
    bool closed = false;
};

/// Slices one mesh by many parallel planes. Safe from many threads at once.
class MeshSlicer {
public:
    /// `mesh` and `geometry` must outlive the slicer; `map` too, which stands for u and v of the frame where
    /// there is one.
    MeshSlicer(const Mesh& mesh, const MeshGeometry& geometry, const DriveFrame& frame,
               const Progress& progress, const PassMap* map = nullptr);

    /// Chains of the plane v = offset. Open chains run in the direction of growing u between their ends,
    /// closed ones start at their smallest u. Chains come in the order of their smallest u. At a non-manifold
    /// edge chains are joined in the order of facets. Where the map goes round u jumps back by its period
    /// somewhere along a chain, which may run either way.
    std::vector<SliceChain> slice(double offset) const;

    /// Range of v over all facets; lo > hi for a mesh without facets.
    double lo() const { return index_.lo(); }
    double hi() const { return index_.hi(); }

private:
    double v(Index vertex) const { return map_ ? map_->v[vertex] : frame_.v(mesh_.vertices[vertex]); }
    std::pair<double, double> range_of(std::size_t facet) const;
    double mapped_u(Index from, Index to, double share) const;

    const Mesh& mesh_;
    const MeshGeometry& geometry_;
    DriveFrame frame_;
    const PassMap* map_;
    IntervalIndex index_;
};

/// The average change of normals along a slice (Lu 3.12): root mean square of |N_i - N_(i-1)| / d_i over
/// neighbouring points, summed over chains. Adds to `sum` and `count`; points closer than `shortest` to their
/// predecessor are passed over, because their quotient is noise, and so are vertical places, which a
/// three-axis cutter only passes.
void add_normal_change(const SliceChain& chain, double shortest, double& sum, std::size_t& count);

} // namespace facetmill
