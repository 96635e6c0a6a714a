// What some hundred straight moves of tools cut from the stock, and what they touch there. Internal to this
// room.
#pragma once

#include "core/verify/removal.h"
#include "core/verify/stock_tiles.h"
#include "core/verify/sweep.h"

#include <atomic>
#include <optional>
#include <tuple>
#include <vector>

namespace facetmill {

/// One body of a tool on a straight move.
struct RemovalItem {
    const TurnedBody* body;
    StraightMove move;
    Box3 box; ///< of what the body sweeps
    std::size_t program, motion;
    bool cuts;            ///< takes stock away; else what it touches is a collision
    Collision::Kind kind; ///< of that collision
    double length = 0;    ///< above 0: it is asked whether it takes away more than `air_depth`; mm
};

/// The longest overlap of a body that must not touch with the stock, as the rays of each family saw it.
struct RemovalTouch {
    std::size_t program = 0, motion = 0;
    Collision::Kind kind = Collision::Kind::rapid;
    std::array<double, 3> overlap{0, 0, 0}; ///< mm, per family; 0 where its rays saw none
    std::array<Vec3, 3> place{Vec3::Zero(), Vec3::Zero(), Vec3::Zero()}; ///< middle of that overlap

    auto key() const { return std::tuple(program, motion, kind); }
    void join(const RemovalTouch& other) {
        for (std::size_t k = 0; k < 3; ++k)
            if (other.overlap[k] > overlap[k]) {
                overlap[k] = other.overlap[k];
                place[k] = other.place[k];
            }
    }
};

/// Items in the order in which they happen, applied tile by tile: tiles do not know of each other, so they
/// are spread over threads.
class RemovalBatch {
public:
    /// `tiles` are those of a stock that was `solid` before any cut. All must outlive this.
    /// Only rays of the family `only` are cut; -1: all.
    RemovalBatch(const StockSolid& solid, const StockLattice& lattice, TileFamilies& tiles,
                 const std::vector<RemovalItem>& items, int only = -1);
    /// A cancelled call leaves some tiles cut and others not.
    void run(const Progress& progress);

    /// Whether an item with a length has taken something away.
    bool has_cut(std::size_t item) const { return cut_[item].load(std::memory_order_relaxed); }
    /// The volume that each item has taken away, mm^3: by the family of rays of which most have lost
    /// something. Those that cross a thin cut know how thick it is; of those along it some or none meet it.
    std::vector<double> volumes() const;
    /// Bytes by which the tiles have grown; less than 0 where they have shrunk.
    std::ptrdiff_t grown() const;
    /// A list for each tile that was reached; within it in the order of items.
    const std::vector<std::vector<RemovalTouch>>& touches() const { return touches_; }

private:
    struct RemovedHere {
        float volume = 0;       ///< mm^3
        std::uint32_t rays = 0; ///< that have lost something
    };
    /// A tile with the items that may change it.
    struct Work {
        int axis, tile_i, tile_j;
        std::vector<std::uint32_t> items;
        std::vector<RemovedHere> removed; ///< by each of them
    };
    std::shared_ptr<RayTile>& place_of(const Work& work) const;
    void find_work(int axis);
    void apply(std::size_t w, const Progress& progress);

    const StockSolid& solid_;
    const StockLattice& lattice_;
    TileFamilies& tiles_;
    const std::vector<RemovalItem>& items_;
    std::vector<Work> work_;
    std::vector<std::atomic<bool>> cut_;    ///< per item
    std::vector<std::array<bool, 3>> used_; ///< per item and family: some tile wants its rays
    std::vector<std::array<std::optional<SweepRays>, 3>> rays_;
    std::vector<std::vector<RemovalTouch>> touches_; ///< per work, as `grown_`
    std::vector<std::ptrdiff_t> grown_;
};

} // namespace facetmill
