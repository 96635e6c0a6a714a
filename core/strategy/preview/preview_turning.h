// Passes over a part that turns, on a coarse grid of angles and places along the axis. Millimetres, radians;
// coordinates of the setup.
#pragma once

#include "core/strategy/lathe/lathe.h"
#include "core/strategy/preview/pass_preview.h"
#include "core/strategy/surface/contact_domain.h"

#include <vector>

namespace facetmill {

/// The outermost place of the part by angle and place along the axis: what heights are to a part that lies.
struct TurnedGround {
    Interval along{infinity, -infinity}; ///< of the part, mm along the axis
    double outer = 0, cell = 1;          ///< its largest distance from the axis; cells along it; mm
    int rows = 1, columns = 1;           ///< along the axis, and in a turn
    std::vector<float> away;             ///< distance from the axis; below -1e30 where nothing is

    /// `cells` along the axis, or along the radius of what is wider than long. Throws what LatheFrame does,
    /// Error(empty_result) for a part without extent.
    TurnedGround(const LatheCommon& settings, const PlanContext& context, int cells,
                 const Progress& progress);
    TurnedGround halved() const;
    std::size_t index(int x, int y) const {
        const int around = (x % columns + columns) % columns;
        return std::size_t(y) * std::size_t(columns) + std::size_t(around);
    }
};

/// Finishing (`depth_of_cut` 0), or roughing that comes down from the stock in passes so deep and
/// leaves `allowance`. Throws Error(empty_result) where nothing is left between the ends, and what LatheFrame
/// does.
PassPreview preview_turning(const LatheCommon& settings, double allowance, double depth_of_cut,
                            const PlanContext& context, const TurnedGround& ground, const Progress& progress);

} // namespace facetmill
