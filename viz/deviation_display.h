// The deviations of a part ready to be drawn: its surface with a colour at every sample, and what a histogram
// takes.
#pragma once

#include "core/base/progress.h"
#include "core/verify/verify.h"
#include "viz/deviation_colors.h"
#include "viz/part_display.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace facetmill {

struct DeviationDisplay {
    std::shared_ptr<const DeviationSurface> surface;
    Vec3 center = Vec3::Zero();
    Box3 box;
    std::vector<float> points, normals;  ///< 3 per sample; points relative to `centre`
    std::vector<std::int32_t> triangles; ///< 3 per triangle
    std::vector<float> areas;            ///< mm^2 each sample stands for: a third of its triangles
    DeviationScale scale;                ///< what `colors` were made with
    std::vector<std::uint8_t> colors;    ///< RGBA per sample
    std::vector<float> shown; ///< per sample; where less than 1 the part's own colour shows through; or none
    PartPreview preview;      ///< for large surfaces only
    std::vector<float>
        preview_deviation; ///< mean of what each vertex stands for; NaN where nothing is judged
    std::vector<std::uint8_t> preview_colors;
    bool has_unjudged = false;      ///< some samples are grey
    double lowest = 0, highest = 0; ///< among the judged samples
};

using DeviationDisplayPtr = std::shared_ptr<const DeviationDisplay>;

/// Throws Error(out_of_range) where the surface's arrays do not fit each other.
DeviationDisplayPtr prepare_deviation_display(std::shared_ptr<const DeviationSurface> surface,
                                              const DeviationScale& scale, const Progress& progress);

/// The same surface elsewhere: every place p at turn * p + move.
DeviationDisplayPtr moved_display(const DeviationDisplay& display, const Mat3& turn, const Vec3& move);

/// Area per stretch of deviation.
struct DeviationHistogram {
    DeviationScale scale;
    std::vector<double> bins;               ///< mm^2, of equal stretches from scale.low to scale.high
    double below = 0, above = 0, total = 0; ///< mm^2
};
/// Counts of the judged samples. About 5 ms per million.
DeviationHistogram deviation_histogram(const DeviationDisplay& display, const DeviationScale& scale,
                                       std::size_t bins);

} // namespace facetmill
