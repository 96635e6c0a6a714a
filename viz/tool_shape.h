// A tool as triangles: the cutter's profile, the shank and the holder turned about the axis. Tip at the
// origin, axis +Z.
#pragma once

#include "core/setup/tool.h"

#include <cstdint>
#include <vector>

namespace facetmill {

/// One body of revolution, closed at both ends; every facet faces outward.
struct RevolvedShape {
    std::vector<float> points, normals;  ///< 3 per vertex
    std::vector<std::int32_t> triangles; ///< 3 per facet
    std::vector<std::int32_t> rings;     ///< 2 per segment: the circles where the outline has a corner
};

struct ToolShape {
    RevolvedShape cutter, shank, holder; ///< shank and holder may be empty
    double length = 0, radius = 0;       ///< size of the whole tool
};

/// A piece of a holder as it is drawn, from the shank upward; diameters below and above, mm.
struct HolderPiece {
    double lower = 0, upper = 0, length = 0;
};
/// Sections that are the steps of a cone (holder_steps of core/tools), which stand out of it by up to a
/// millimetre, are that cone again; others are cylinders. Empty sections are left out.
std::vector<HolderPiece> holder_pieces(const std::vector<HolderSection>& sections);

/// Throws Error(out_of_range) where the tool's values make no cutter.
ToolShape make_tool_shape(const Tool& tool);

/// An arrow from the origin along +Z: a shaft and a cone of the given radii, the cone `head` long.
RevolvedShape make_arrow(double shaft_radius, double head_radius, double head, double length);

} // namespace facetmill
