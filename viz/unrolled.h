// The path on a turning part, unrolled: turning angle upward, length along the axis to the right, coloured by
// how deep the tip is below the stock's outside. Shapes here are plain pixels: the workbench draws axes and
// legend around them. Lengths in the unit shown, angles in degrees.
#pragma once

#include "core/base/units.h"
#include "core/job/planner.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace facetmill {

struct UnrolledPath {
    /// Ends of motions at feed, in their order; `joined` where the tool came there at feed.
    struct Place {
        float along = 0, angle = 0, depth = 0; ///< angle from 0 up to 360
        std::uint32_t motion = 0;
        bool joined = false;
    };
    std::vector<Place> places;
    std::shared_ptr<const OperationResult> operation; ///< keeps it
    std::string unit;                                 ///< "mm", "in"
    double from = 0, to = 1;                          ///< along the axis, to the borders of what is cut
    double low = 0, high = 1;                         ///< depths, low < high
    double feed = 0;         ///< width that a line of the path stands for, along the axis
    bool lengthwise = false; ///< lines run along the axis: they stand for an angle
    double feed_angle = 0;   ///< angle of lengthwise lines, degrees
    /// What the cutter cannot come to (lathe_reach.h), as boxes within one turn.
    struct Unreached {
        double from = 0, to = 0, low = 0, high = 0; ///< along the axis, angles
    };
    std::vector<Unreached> unreached;
};
using UnrolledPathPtr = std::shared_ptr<const UnrolledPath>;

/// Null for an operation whose part does not turn.
UnrolledPathPtr prepare_unrolled(std::shared_ptr<const OperationResult> operation, LengthUnit unit,
                                 const Progress& progress);

/// What is looked at: from < to along the axis, low < high of 0 to 360 degrees.
struct UnrolledWindow {
    double from = 0, to = 1, low = 0, high = 360;
    bool operator==(const UnrolledWindow&) const = default;
};
UnrolledWindow unrolled_whole(const UnrolledPath& path);

/// RGBA, rows from the largest angle down. What no motion passes is transparent. A place cut several times
/// has the colour of its deepest cut.
struct UnrolledImage {
    int width = 0, height = 0;
    std::vector<std::uint8_t> rgba;
};
UnrolledImage unrolled_image(const UnrolledPath& path, const UnrolledWindow& window, int width, int height);

/// Colour of a depth in [low, high] as path_tint_color has it.
double unrolled_share(const UnrolledPath& path, double depth);

/// The motion whose end is nearest to a place, distances counted in pixels of an image of this window and
/// size; nothing where there is no path.
std::optional<std::size_t> unrolled_pick(const UnrolledPath& path, const UnrolledWindow& window, double along,
                                         double angle, int width, int height);
/// Where a motion's end lies; nothing where it is not at feed.
std::optional<UnrolledPath::Place> unrolled_place(const UnrolledPath& path, std::size_t motion);

} // namespace facetmill
