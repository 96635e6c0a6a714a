// The stock's surface as triangles: marching cubes over the lattice's cells, with corners on the rays' own
// ends. Closed and, but for places where the stock touches itself, two-manifold. What is thinner than the
// lattice's spacing may be missing; sharp edges between lattice nodes are cut off by less than the spacing.
#pragma once

#include "core/base/progress.h"
#include "core/mesh/mesh.h"
#include "core/verify/stock_model.h"

#include <memory>
#include <vector>

namespace facetmill {

/// Blocks of the lattice, each with its part of the surface.
class StockSurface {
public:
    explicit StockSurface(const StockLattice& lattice);
    std::size_t patch_count() const;
    /// Changes whenever what a patch is made from does.
    std::uint64_t stamp(const StockModel& stock, std::size_t patch) const;
    /// Null where the block has no surface. Thread safe; about 5 ms.
    std::shared_ptr<const StockPatch> patch(const StockModel& stock, std::size_t patch) const;

private:
    struct Range {
        std::array<int, 3> from, to; ///< cells, from -1 (half outside the lattice) on
    };
    Range range(std::size_t patch) const;
    StockLattice lattice_;
    std::array<int, 3> blocks_{1, 1, 1};
};

/// The whole surface, corners welded where blocks meet. Throws Error(limit_exceeded) beyond 2^31 corners;
/// Cancelled.
Mesh stock_mesh(const StockModel& stock, const Progress& progress);

} // namespace facetmill
