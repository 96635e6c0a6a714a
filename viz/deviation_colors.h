// Colours for deviations: green within the tolerance, through yellow to red where material is missing,
// through cyan to blue where it stands. Equal steps of deviation look about equally far apart (steps in the
// OKLab space, Ottosson 2020), and both ways it gets darker all along, so that the order shows without hue
// too.
#pragma once

#include "core/base/units.h"
#include "core/mesh/mesh_writer.h"

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace facetmill {

struct Verification;
struct Rgb;

/// All in mm. Deviations beyond `low` and `high` have the colours of the ends.
struct DeviationScale {
    double low = -0.1, high = 0.1;         ///< low < 0 < high
    double gouge_limit = 0, tolerance = 0; ///< >= 0; from -gouge_limit to tolerance all is the same green
    bool operator==(const DeviationScale&) const = default;
};

/// Blue where twice the tolerance stands, red where the tolerance is missing. Where no tolerance was given,
/// from the largest deviations found. Ends are round numbers of `unit` (1, 2, 5 times a power of ten) there.
DeviationScale default_scale(const Verification& verification, LengthUnit unit);

Rgb deviation_color(const DeviationScale& scale, double deviation);
/// Colour of what is not judged.
Rgb unjudged_color();
/// -1 is red, 0 green, 1 blue.
Rgb deviation_color_at(double t);

/// Samples near borders and on faces that no tool axis sees count with gouges only, bare ones not at all:
/// what does not count is grey. `gouge_limit` tells what is a gouge.
bool judged(std::uint8_t flags, float deviation, double gouge_limit);

/// Colours of samples (`flags` may be empty: all judged unless NaN). About 10 ms per million.
std::vector<std::uint8_t> deviation_colors(std::span<const float> deviation,
                                           std::span<const std::uint8_t> flags, const DeviationScale& scale);
/// The same as meshes are written with them (core/mesh/mesh_writer.h).
std::vector<VertexColor> deviation_vertex_colors(std::span<const float> deviation,
                                                 std::span<const std::uint8_t> flags,
                                                 const DeviationScale& scale);

/// Marks beside a bar or under a histogram of the scale: value and text, ascending; ends, zero and the limits
/// where they stand apart by at least `min_gap` of the scale's width.
struct ScaleMark {
    double value = 0; ///< mm
    std::string label;
};
std::vector<ScaleMark> scale_marks(const DeviationScale& scale, LengthUnit unit, double min_gap);

} // namespace facetmill
