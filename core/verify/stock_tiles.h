// How a StockModel keeps its rays. Internal to this room.
#pragma once

#include "core/verify/stock_model.h"
#include "core/verify/sweep.h"

#include <atomic>

namespace facetmill {

/// 16 x 16 rays of one family. Coordinates along the rays are from the middle of the stock's box.
struct RayTile {
    static constexpr int side = 16;
    static constexpr std::uint32_t none = 0xFFFFFFFFu;
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

    /// Appends a stretch above all the ray has.
    void append(int ray, float from, float to);
    /// Takes [from, to] out of a ray; true when it had some of it.
    bool remove(int ray, float from, float to);
    void find_bounds();
    static std::uint64_t next_stamp();

private:
    std::uint32_t take();
    void give_back(std::uint32_t place);
};

/// Coordinates across the rays of a family: along z they are x, y; along x: y, z; along y: z, x.
inline int first_across(int axis) {
    return (axis + 1) % 3;
}
inline int second_across(int axis) {
    return (axis + 2) % 3;
}
inline int tiles_of(int nodes) {
    return (nodes + RayTile::side - 1) / RayTile::side;
}

/// The tile of a family as the solid is before any cut. For mesh stock use fill_from_mesh once.
std::shared_ptr<RayTile> solid_tile(const StockSolid& solid, const StockLattice& lattice, int axis,
                                    int tile_i, int tile_j);
using TileFamilies = std::array<std::vector<std::shared_ptr<RayTile>>, 3>;
/// Throws Error(out_of_range) where the mesh is not closed. Cancellation per tile.
void fill_from_mesh(const StockSolid& solid, const StockLattice& lattice, TileFamilies& families,
                    const Progress& progress);

} // namespace facetmill
