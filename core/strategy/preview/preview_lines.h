// Where on a coarse ground an operation cuts, and lines of passes laid over it. Millimetres, coordinates of
// the view.
#pragma once

#include "core/strategy/curves/plan_curve.h"
#include "core/strategy/preview/coarse_tips.h"
#include "core/strategy/preview/pass_preview.h"
#include "core/strategy/surface/contact_domain.h"
#include "core/strategy/surface/cutter_cover.h"
#include "core/strategy/surface/drive_frame.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace facetmill {

/// Step-overs of an upright cutter, and the cusp that they come from.
struct PreviewStep {
    double cusp = 0;    ///< that may stay
    double level = 0;   ///< between passes on a level plane
    double corner = 0;  ///< on a slope that the corner's rounding cuts, along the surface; 0: it is sharp
    bool fixed = false; ///< `level` is kept on any slope

    /// Seen from above, on a surface that rises by so much across the passes, over what it goes on: what the
    /// rounding leaves, or the steps of a side that stands upright.
    double on_slope(double rise) const;
    /// The same as a step down of levels.
    double down(double rise) const;
};
/// Throws what cusp_budget does. `asked`: a length, or what the tolerance allows.
PreviewStep preview_step(const OperationCommon& common, const NumberOrWord& asked, const NumberOrWord& chord,
                         const PlanContext& context);

/// Tips over the ground, and which of them cut.
class PreviewField {
public:
    /// `slopes`: of the surface that is cut, radians from level.
    PreviewField(const PreviewRequest& request, const OperationCommon& common, const CutterProfile& cutter,
                 double allowance, const Interval& slopes, const Progress& progress);

    const CoarseTips& tips() const { return tips_; }
    const CoarseGrid& grid() const { return tips_.grid(); }
    bool kept(std::size_t tip) const { return kept_[tip] != 0; }
    bool kept(const Vec2& p) const;
    bool any_kept() const { return any_; }
    /// The tip over pieces of a line where it cuts, `rise` higher; `low`: no lower than this.
    void lay(const PlanLine& line, double rise, double low, std::vector<std::vector<Vec3>>& lines) const;
    /// How far apart passes may lie that have `across` between them, a unit vector, on the slopes that all
    /// but a quarter of a line has; none of it cuts: nothing.
    std::optional<double> step_over(const PlanLine& line, const Vec2& across, const PreviewStep& step) const;
    /// The same of all that cuts, whichever way it slopes.
    double step_everywhere(const PreviewStep& step) const;
    /// From the first to the last place that cuts, along a direction.
    Interval extent(const Vec2& along) const;

private:
    template <class Height>
    void lay_by(const PlanLine& line, const Height& height, std::vector<std::vector<Vec3>>& lines) const;

    CoarseTips tips_;
    std::vector<char> kept_;
    bool any_ = false;
};

/// use(place) for places along a line, its corners among them, no farther apart than `apart`.
template <class Use>
void along_line(const PlanLine& line, double apart, const Use& use) {
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
        const Vec2 d = line[i + 1] - line[i];
        const int steps = std::max(1, int(std::ceil(d.norm() / apart)));
        for (int k = i == 0 ? 0 : 1; k <= steps; ++k)
            use(Vec2(line[i] + double(k) / steps * d));
    }
}

/// The value that this share of some does not exceed; reorders them, which are not none.
double share_below(std::vector<double>& values, double share);

/// Lays lines, as many of them as may be drawn, and counts all.
void lay_lines(const std::vector<PlanLine>& lines,
               const std::function<void(const PlanLine&, std::vector<std::vector<Vec3>>&)>& lay,
               PassPreview& preview, const Progress& progress);

/// Straight lines along a direction, as far apart as the slopes across them allow.
std::vector<PlanLine> parallel_lines(const PreviewField& field, double direction, const PreviewStep& step,
                                     const Progress& progress);

/// Cells of one grid as those of another that lies over it.
std::vector<char> cells_on(const std::vector<char>& cells, const CoarseGrid& from, const CoarseGrid& to);

} // namespace facetmill
