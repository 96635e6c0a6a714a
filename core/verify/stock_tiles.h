// How a StockModel keeps its rays. Internal to this room.
#pragma once

#include "core/verify/stock_model.h"
#include "core/verify/sweep.h"

#include <algorithm>
#include <atomic>
#include <cmath>

namespace facetmill {

/// A tile: 16 x 16 rays of one family. Coordinates along the rays are from the middle of the stock's box, mm.
struct RayTile {
    static constexpr int side = 16;
    static constexpr std::uint32_t none = 0xFFFFFFFFu;
    /// A stretch of material on a ray, linked to the next one above.
    struct Piece {
        float lo = 1, hi = -1;
        std::uint32_t next = none; ///< in `more`
        bool empty() const { return lo > hi; }
    };
    std::array<Piece, side * side> first; ///< ray (i, j) of the tile at i + side * j
    std::vector<Piece> more;
    std::uint32_t spare = none; ///< chain of unused places in `more`
    float lo = 1, hi = -1;      ///< bounds of all material of the tile
    std::uint64_t stamp = 0;    ///< changes with the content

    /// Appends a stretch above all that the ray has.
    void append(int ray, float from, float to);
    /// Takes [from, to] out of a ray: the length of what it had of it, mm.
    double remove(int ray, float from, float to);
    void find_bounds();
    static std::uint64_t next_stamp();

private:
    std::uint32_t take();
    void give_back(std::uint32_t place);
};

/// The two axes across the rays of a family: x, y for those along z; y, z for x; z, x for y.
inline int first_across(int axis) {
    return (axis + 1) % 3;
}
inline int second_across(int axis) {
    return (axis + 2) % 3;
}
/// How many tiles so many rays in a row need.
inline int tiles_of(int nodes) {
    return (nodes + RayTile::side - 1) / RayTile::side;
}

/// Tiles of a family: from .. to, both included, along the two axes across its rays.
struct TileRange {
    std::array<int, 2> from, to;
};

/// The tiles of a family that a box reaches.
inline TileRange tiles_in(const Box3& box, const StockLattice& lattice, int axis) {
    TileRange r{};
    for (const std::size_t n : {0u, 1u}) {
        const int k = n == 0 ? first_across(axis) : second_across(axis);
        const auto at = [&](double x) { return (x - lattice.origin[k]) / lattice.spacing[k]; };
        const double most = lattice.nodes[std::size_t(k)] - 1;
        r.from[n] = int(std::clamp(std::ceil(at(box.lo[k])), 0.0, most)) / RayTile::side;
        r.to[n] = int(std::clamp(std::floor(at(box.hi[k])), 0.0, most)) / RayTile::side;
    }
    return r;
}

/// The tile of a family as the solid is before any cut. For mesh stock use fill_from_mesh once.
std::shared_ptr<RayTile> solid_tile(const StockSolid& solid, const StockLattice& lattice, int axis,
                                    int tile_i, int tile_j);
/// The tiles of the rays along x, y, z, those of a family at i + tiles in a row * j; null where a tile is as
/// the solid is.
using TileFamilies = std::array<std::vector<std::shared_ptr<RayTile>>, 3>;
/// Fills all tiles from a solid that is a mesh. Throws Error(out_of_range) where the mesh is not closed.
void fill_from_mesh(const StockSolid& solid, const StockLattice& lattice, TileFamilies& families,
                    const Progress& progress);

} // namespace facetmill
