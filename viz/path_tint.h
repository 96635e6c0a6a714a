// Paths in the colours of what happens along them: posture, cusp, feed, time, joint rates.
#pragma once

#include "core/base/units.h"
#include "viz/path_display.h"
#include "viz/path_figures.h"

#include <optional>
#include <string>
#include <string_view>

namespace facetmill {

struct ColorBar; // overlay.h
struct Rgb;      // palette.h

/// What the colours of a path can mean.
enum class PathQuantity {
    kind,        ///< the kind of motion
    lead,        ///< angle between the tool axis and the surface normal at the contact point
    tilt,        ///< angle between the tool axis and Z
    cusp,        ///< to expect beside the contact point
    feed,        ///< that the machine reaches
    motion_time, ///< time of the single motion
    elapsed,     ///< since the beginning of the operation
    joint_rate,  ///< share of its largest speed at which the joint nearest to it goes
};
inline constexpr std::size_t path_quantities = 8;
/// "Kind of motion", "Lead", ...
std::string_view path_quantity_label(PathQuantity quantity);
/// Empty where the quantity exists for the operation; otherwise why not, as a sentence.
std::string path_quantity_missing(PathQuantity quantity, const OperationResult& operation);

/// From the low end of a scale (0) to its high end (1); lightness grows all along (after Viridis).
Rgb path_tint_color(double t);

/// Motions at feed as separate segments with a value at either end; rapids keep their kind's colour.
struct TintedPath {
    struct Lines {
        std::vector<float> points;          ///< 6 per segment, relative to the centre
        std::vector<std::int32_t> segments; ///< 2 per segment
        std::vector<float> values;          ///< 2 per segment, in `unit`; NaN where there is none
        std::vector<std::uint8_t> rgba;     ///< 8 per segment
        bool empty() const { return values.empty(); }
    };
    PathQuantity quantity = PathQuantity::kind;
    Vec3 center = Vec3::Zero();
    std::array<Lines, motion_kinds> lines;   ///< one per MotionKind; empty: no motion of it has a value
    std::array<Lines, motion_kinds> preview; ///< fewer segments, of long paths only
    std::string unit;                        ///< "°", "mm", "in/min", "s", "min", "%"
    double low = 0, high = 1;                ///< ends of the scale, low < high
    bool below = false, above = false;       ///< single values lie beyond the ends
    bool unknown = false;                    ///< segments without a value, which are grey
    ColorBar bar() const;
};
using TintedPathPtr = std::shared_ptr<const TintedPath>;

/// The scale goes from the least to the largest value, without the outermost hundredth on either side where
/// the values within lie much closer together. Null for the quantity `kind`, and where no motion has a value.
/// `shown`, where not empty, says for each operation which of its motions are drawn.
TintedPathPtr prepare_tinted_path(const std::vector<PathFiguresPtr>& operations, PathQuantity quantity,
                                  LengthUnit unit, const Progress& progress,
                                  const std::vector<PathSource>& shown = {});

} // namespace facetmill
