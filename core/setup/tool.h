// A tool: the cutting part, the shank above it and the holder stack above that, all on one axis, tip at z =
// 0.
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

/// How the tool is run in a material, as its maker or its user says; 0 where nobody did. Operations may take
/// it over (cutting_choice.h); it is no part of a plan.
struct CuttingData {
    std::string name, material;
    double spindle = 0, feed = 0, plunge_feed = 0; ///< rpm, mm/min
    double chip_load = 0;                          ///< mm a turn and edge
    double stepover = 0, depth = 0;                ///< mm
    bool operator==(const CuttingData&) const = default;
};

/// Tools are numbered from 1 to this.
inline constexpr long largest_tool_number = 99999;

/// Plain values as the project file has them; millimetres and radians. `diameter` is APT's d (cutter.h): the
/// diameter of a cylindrical cutter, and of a tapered one that where bottom and side line meet, below the
/// corner rounding. (Lu's R is the radius at the top, which would change with the flute length.)
struct Tool {
    long number = 1;
    std::string name = "Tool";
    double diameter = 6, corner_radius = 0;
    double bottom_angle = 0, taper_angle = 0; ///< APT alpha and beta
    double flute_length = 20;
    double shank_diameter = 6, shank_length = 30;
    std::vector<HolderSection> holder;
    long flutes = 0; ///< cutting edges; 0: unsaid
    std::vector<CuttingData> cutting;

    /// The cutting part; throws Error(out_of_range) naming the parameter when the values make no convex
    /// cutter.
    AptCutter cutter() const;
    /// "Ball end", "Flat end", "Bull nose", "Cone", "Tapered ball", ...; "Invalid" when the values make no
    /// cutter.
    std::string shape_name() const;
};

/// The tool of a list with this number; null where there is none.
const Tool* find_tool(const std::vector<Tool>& tools, long number);
/// The smallest number that no tool of a list has.
long free_tool_number(const std::vector<Tool>& tools);

const ParameterTable<HolderSection>& holder_parameters();
inline constexpr RecordList<HolderSection> holder_list{"holder", holder_parameters};
const ParameterTable<CuttingData>& cutting_parameters();
inline constexpr RecordList<CuttingData> cutting_list{"cutting", cutting_parameters};
const ParameterTable<Tool>& tool_parameters();

/// Checks every value by itself and all together (corner radius against diameter, taper against flute length,
/// shank against holder). Throws Error(out_of_range) whose place is the key, "holder[1].diameter" for a
/// section.
void check_tool(const Tool& tool);

} // namespace facetmill
