// The stock's surface as triangles: marching cubes over the lattice's cells, with corners on the rays' own
// ends. Closed and, but for places where the stock touches itself, two-manifold. What is thinner than the
// lattice's spacing may be missing; sharp edges between lattice nodes are cut off by less than the spacing.
#pragma once

#include "core/base/progress.h"
#include "core/verify/stock_model.h"

#include <array>
#include <functional>
#include <memory>
#include <vector>

namespace facetmill {

struct CellRange; // stock_patch.h

/// Blocks of the lattice, each with its part of the surface.
class StockSurface {
public:
    explicit StockSurface(const StockLattice& lattice);
    std::size_t patch_count() const;
    /// A number that changes whenever the material that a patch is made from does.
    std::uint64_t stamp(const StockModel& stock, std::size_t patch) const;
    /// The part of the surface within a block; null where it has none, which is soon known. Thread safe;
    /// about 5 ms.
    std::shared_ptr<const StockPatch> patch(const StockModel& stock, std::size_t patch) const;

private:
    CellRange range(std::size_t patch) const;
    StockLattice lattice_;
    std::array<int, 3> blocks_{1, 1, 1};
};

/// Makes few triangles of a flat sheet, which is most of an uncut stock: the points on its rim stay, so that
/// it fits its neighbours, and all but one within go. Any other patch, null too, comes back as it is.
std::shared_ptr<const StockPatch> sparse_patch(std::shared_ptr<const StockPatch> patch);

/// Puts neighbouring patches together to larger ones: to draw a patch takes about as long however small it
/// is.
class PatchGroups {
public:
    /// A group has up to about `triangles`, until the stock has changed by as many.
    explicit PatchGroups(std::size_t triangles) : triangles_(triangles) {}
    /// A group of the same patches as at the last call is the same object; one without surface is null.
    const std::vector<std::shared_ptr<const StockPatch>>&
    of(const std::vector<std::shared_ptr<const StockPatch>>& patches);

private:
    std::size_t triangles_;
    std::vector<std::size_t> ends_; ///< of the groups, in `patches_`
    std::vector<std::shared_ptr<const StockPatch>> patches_, groups_;
};

/// Goes through the whole surface, block by block: take(a, b, c) for each triangle, counter-clockwise seen
/// from outside, in a fixed order on the calling thread. Points that blocks have in common are the same
/// numbers in both. Flat sheets come in few triangles; no more than some hundred blocks are in memory at a
/// time.
void stock_triangles(const StockModel& stock,
                     const std::function<void(const Vec3& a, const Vec3& b, const Vec3& c)>& take,
                     const Progress& progress);

/// The whole surface as one closed mesh. Throws Error(limit_exceeded) where it has too many facets for one.
Mesh stock_mesh(const StockModel& stock, const Progress& progress);

} // namespace facetmill
