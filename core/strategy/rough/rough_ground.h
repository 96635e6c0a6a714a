// Where the tool may stand in and around the stock, looked at once for all layers: lifts on a grid, along
// drive lines, and floors of valleys between them. Millimetres.
#pragma once

#include "core/strategy/rough/rough_reach.h"
#include "core/strategy/rough/rough_setup.h"
#include "core/strategy/rough/rough_valley.h"

namespace facetmill {

class RoughGround {
public:
    /// Everything passed must outlive this. Throws Error(limit_exceeded) for more than 100 000 lines, and
    /// what ReachGrid throws.
    RoughGround(const RoughReach& reach, const DriveFrame& frame, const RoughMeasures& measures,
                const RoughHeights& heights, const StockField& field, const Progress& progress);

    const ReachGrid& grid() const { return *grid_; }
    const std::vector<ReachValley>& valleys() const { return valleys_; }
    const std::vector<ReachLine>& lines() const { return lines_; }
    /// Lines a step-over apart, those inside the stock; the others stand between them, or outside on either
    /// side.
    bool is_usual(std::size_t line) const {
        return line >= divisions_ && line < lines_.size() - divisions_ && line % divisions_ == 0;
    }
    /// Number of a line among the usual ones.
    std::size_t usual_number(std::size_t line) const { return line / divisions_; }
    /// Corner of the ground at which the tool begins.
    Vec2 start() const { return start_; }

private:
    std::optional<ReachGrid> grid_;
    std::vector<ReachValley> valleys_;
    std::vector<ReachLine> lines_;
    std::size_t divisions_;
    Vec2 start_ = Vec2::Zero();
};

} // namespace facetmill
