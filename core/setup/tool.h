// A tool: the cutting part, the shank above it and the holder stack above that, all on one axis, tip at z = 0.
#pragma once

#include "core/base/parameter.h"
#include "core/cutter/cutter.h"

#include <string>
#include <vector>

namespace facetmill {

/// One cylinder of the holder, from the shank upward. Millimetres.
struct HolderSection {
    double diameter = 0, length = 0;
    bool operator==(const HolderSection&) const = default;
};

/// Plain values as the project file has them; millimetres and radians.
struct Tool {
    long number = 1;
    std::string name = "Tool";
    double diameter = 6, corner_radius = 0;
    double bottom_angle = 0, taper_angle = 0; ///< APT alpha and beta
    double flute_length = 20;
    double shank_diameter = 6, shank_length = 30;
    std::vector<HolderSection> holder; ///< beside the parameters: key "holder" in files

    /// The cutting part; throws Error(out_of_range) naming the parameter when the values make no convex cutter.
    AptCutter cutter() const;
    /// "Ball end", "Flat end", "Bull nose", "Cone", "Tapered ball", ...
    std::string shape_name() const;
};

const ParameterTable<Tool>& tool_parameters();

/// Checks all values together (corner radius against diameter, shank against holder, ...). Throws Error(out_of_range).
void check_tool(const Tool& tool);

} // namespace facetmill
