// Levels: contours of the tip over a coarse ground, for waterlines and the layers of roughing. Millimetres,
// coordinates of the view.
#pragma once

#include "core/strategy/preview/preview_lines.h"

#include <array>

namespace facetmill {

/// All slopes that there are.
inline constexpr Interval every_slope{0, 0.5 * pi};

struct PreviewLevels {
    PreviewStep step;              ///< of the cusps on the slopes
    std::optional<double> fixed;   ///< step down, mm; none: nearer where it is less steep
    double deepest = infinity;     ///< step down, mm
    Interval slopes = every_slope; ///< of the surface that is cut, radians from level
};

/// Contours of the tip at any height, where the surface is so steep, and round the walls of the part.
class LevelSlicer {
public:
    /// `field` must outlive it.
    LevelSlicer(const PreviewField& field, const Interval& slopes);
    std::vector<std::vector<Vec3>> lines(double z) const;
    /// From the lowest to the highest; lo above hi where nothing is so steep.
    const Interval& heights() const { return heights_; }

private:
    double height(int x, int y) const;
    bool cuts(int x, int y) const;
    double wall_below(int x, int y) const;

    const PreviewField& field_;
    Interval slopes_;
    double low_;
    Interval heights_{infinity, -infinity};
    std::vector<std::array<float, 2>> ranges_; ///< of heights in the square behind each cell
};
/// Heights from above down, so far apart as the slopes at each ask for. `field` keeps tips of the slopes.
std::vector<double> level_heights(const PreviewField& field, const LevelSlicer& slicer,
                                  const PreviewLevels& levels);
/// Adds levels to a preview; none where nothing is so steep.
void lay_levels(const PreviewField& field, const PreviewLevels& levels, PassPreview& preview,
                const Progress& progress);

/// Layers at `heights` within a stock: lines along `travel` where the tip is free, and round what it is not.
/// `field` keeps every tip that touches the part.
void lay_layers(const PreviewField& field, const Box3& stock, const std::vector<double>& heights,
                double travel, double stepover, PassPreview& preview, const Progress& progress);

/// The outlines of cells of a grid, as curves round them.
std::vector<PlanCurve> cell_outlines(const std::vector<char>& cells, const CoarseGrid& grid);

} // namespace facetmill
