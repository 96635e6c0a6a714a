// The stock as three families of parallel rays (a tri-dexel model): along x, y and z through one lattice,
// each ray with the stretches of it that are material. Along its ray an end of a stretch is where the swept
// tool enters, not a lattice place; between rays, features thinner than the lattice's spacing may be missed.
//
// Material is removed by the exact solid that a tool sweeps on a straight line with fixed axis (sweep.h).
// Rays are kept in tiles of 16 x 16; a tile that no tool has reached costs nothing, and copies of a model
// share what is the same. Ends are floats from the middle of the stock: exact to 6e-8 of its size.
#pragma once

#include "core/base/progress.h"
#include "core/base/units.h"
#include "core/verify/program.h"

#include <array>
#include <memory>
#include <span>
#include <vector>

namespace facetmill {

struct RayTile; // stock_tiles.h

/// A lattice of nodes: (i, j, k) is at origin + (i, j, k) * spacing, mm, part coordinates. The outermost
/// nodes lie within the stock's box, a thousandth of the spacing from its sides.
struct StockLattice {
    Vec3 origin = Vec3::Zero(), spacing = Vec3::Ones();
    std::array<int, 3> nodes{2, 2, 2};

    Vec3 node(int i, int j, int k) const { return origin + Vec3(i, j, k).cwiseProduct(spacing); }
    /// A lattice whose nodes are about `resolution` (mm) apart in all directions, never farther. Throws
    /// Error(empty_result) for a box without volume, Error(limit_exceeded) where the rays would be more than
    /// 10^9, naming a resolution that serves in `unit`.
    static StockLattice over(const Box3& box, double resolution, LengthUnit unit = LengthUnit::mm);
    /// How many rays `over` would make, if it had no limit.
    static double rays_over(const Box3& box, double resolution);
    std::size_t rays() const;
};

/// Part of the stock's surface, for pictures: the cells of one block of the lattice.
struct StockPatch {
    std::vector<std::array<float, 3>> points, normals;   ///< mm; unit, outward
    std::vector<std::array<std::uint32_t, 3>> triangles; ///< counter-clockwise seen from outside
    Box3 box;
};

/// A stock, whole or cut. Copies share the tiles that are the same in both.
class StockModel {
public:
    StockModel() = default;
    StockModel(const StockSolid& solid, const StockLattice& lattice, const Progress& progress);

    const StockLattice& lattice() const { return lattice_; }
    const StockSolid& solid() const { return solid_; }
    /// The stretches of material on the ray of family `axis` (0: along x) through node (i, j) across it: i
    /// and j count along (y, z) for x, (z, x) for y, (x, y) for z. Part coordinates along the axis, mm,
    /// ascending; no two touch.
    std::vector<std::array<double, 2>> stretches(int axis, int i, int j) const;
    double volume() const;     ///< mm^3, the mean of the three families
    std::size_t bytes() const; ///< memory of the rays

private:
    friend class MaterialRemoval;
    friend class StockSurface;
    StockSolid solid_;
    StockLattice lattice_;
    std::array<std::vector<std::shared_ptr<RayTile>>, 3> tiles_; ///< null: not yet made, as the solid is
};

} // namespace facetmill
