// What programs leave of a stock may be several pieces: a part that is cut free of the block round it,
// corners that fall off. Which pieces there are is known to the spacing of the stock's rays: what is thinner
// may hold two together unseen. Millimetres.
#pragma once

#include "core/base/progress.h"
#include "core/verify/program.h"
#include "core/verify/stock_model.h"

#include <optional>
#include <span>
#include <vector>

namespace facetmill {

struct StockPiece {
    double volume = 0; ///< mm^3
    Box3 box;
};

/// The stretches of material on a stock's rays, those that touch put together.
class StockPieces {
public:
    /// Stretches of neighbouring rays touch where they have heights in common, and rays of different families
    /// where they cross in material.
    StockPieces(const StockModel& stock, const Progress& progress);

    /// The largest first; pieces that hold no ray along Z are left out.
    const std::vector<StockPiece>& pieces() const { return pieces_; }
    /// The number of the piece that a place lies in, by the ray along Z nearest to it; none where nothing is.
    std::optional<std::size_t> at(const Vec3& place) const;

private:
    StockLattice lattice_;
    struct Stretch {
        double lo, hi;
        std::size_t piece;
    };
    std::vector<std::size_t> first_; ///< of each ray along Z: its first stretch; one more at the end
    std::vector<Stretch> along_z_;
    std::vector<StockPiece> pieces_;
};

/// What came loose, and when.
struct LoosePieces {
    /// Whether what came off is a frame that the part hung in rather than chips of the stock.
    bool part_is_free = false;
    std::size_t count = 0; ///< of pieces without the part, crumbs left out
    StockPiece largest;    ///< of those
    MotionPlace
        at; ///< the first motion after which there is more than one piece; unknown: seen by closer rays alone
};

/// Nothing where `left`, which is what the programs leave of its solid, is one piece, but for crumbs. `part`:
/// any orientation. What is thin in one direction the rays see, a rod that falls between them they do not.
/// Where `left` has a great many rays or very few, the programs are cut once more with some hundred on a
/// side.
std::optional<LoosePieces> loose_pieces(const Mesh& part, const StockModel& left,
                                        std::span<const VerifyProgram> programs, const Progress& progress);

} // namespace facetmill
