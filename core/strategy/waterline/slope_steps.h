// How much lower the next level may lie on a slope, so that between the two no higher cusp stays than is
// allowed. Millimetres, radians.
#pragma once

#include "core/strategy/surface/cutter_cover.h"

#include <array>

namespace facetmill {

class SlopeSteps {
public:
    /// `longest`: no step is larger, whatever the cusp.
    SlopeSteps(const CutterCover& cover, double cusp, double longest);

    /// The step on a surface of this slope (0 level, pi/2 upright). `ratio`: how far the touched point moves
    /// for what the tip moves; 1 on planes, less where the surface bends away from the cutter, 0 where that
    /// rolls over an edge, more in hollows. What a round cutter leaves between two places is, to second
    /// order, this ratio times what it leaves on a plane.
    double step(double slope, double ratio) const;
    /// The cusp that levels so far apart leave.
    double cusp(double slope, double ratio, double step) const;
    double longest() const { return longest_; }

private:
    struct Entry {
        double along = 0; ///< distance of tips, down the slope
        double power = 0; ///< of the ratio: a half for what is round, 1 for corners
    };
    Entry at(double slope) const;
    static constexpr std::size_t slopes = 46;

    double cusp_, longest_;
    std::array<Entry, slopes> entries_{};
};

} // namespace facetmill
