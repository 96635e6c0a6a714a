// The surface of the stock within one block of the lattice's cells. Internal to this room.
#pragma once

#include "core/verify/stock_tiles.h"

#include <memory>

namespace facetmill {

/// Cells from `from` up to, but not including, `to`. Cell (i, j, k) lies between the nodes (i, j, k) and (i +
/// 1, j + 1, k + 1); cells -1 lie half outside the lattice.
struct CellRange {
    std::array<int, 3> from, to;
};

/// The surface within the cells `own`, in part coordinates; null where there is none, which is soon known.
/// `tiles` are those of a stock that was `solid` before any cut. Thread safe.
std::shared_ptr<const StockPatch> make_patch(const StockSolid& solid, const StockLattice& lattice,
                                             const TileFamilies& tiles, const CellRange& own);

} // namespace facetmill
