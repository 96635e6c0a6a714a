// How far apart two passes may lie on a plane so that the cusp between them is the one allowed, down the
// slope and along the level. Millimetres, radians.
#pragma once

#include "core/base/progress.h"
#include "core/strategy/surface/cutter_cover.h"

#include <array>

namespace facetmill {

class ScallopSteps {
public:
    ScallopSteps(const CutterCover& cover, double cusp, const Progress& progress);

    struct Step {
        double apart = 0; ///< distance of tips on the plane
        double power = 0; ///< of the cusp in it: a half for what is round, 1 for corners, 0 for flat bottoms
    };
    /// Neighbouring passes that run along the level, one below the other.
    Step down(double slope) const { return at(down_, slope); }
    /// Those that run down the slope, side by side.
    Step across(double slope) const { return at(across_, slope); }
    /// On level surface the bottom leaves nothing, or a gap.
    bool flat_bottom() const { return down_.front().power < 0.2; }
    double smallest() const { return smallest_; } ///< of slopes up to `steepest`
    static const double steepest;                 ///< slopes beyond are as this one

private:
    static constexpr std::size_t slopes = 31;
    using Table = std::array<Step, slopes>;
    static Step at(const Table& table, double slope);

    Table down_{}, across_{};
    double smallest_ = 0;
};

} // namespace facetmill
