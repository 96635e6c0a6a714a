// Tools as catalogues and other programs keep them: more than a job needs to know of one. Millimetres,
// radians, mm/min, 1/min.
#pragma once

#include "core/setup/tool.h"

#include <string>
#include <vector>

namespace facetmill {

/// One piece of a holder's outline, from the shank upward: a cone, or a cylinder where both are the same.
struct HolderCone {
    double length = 0, lower_diameter = 0, upper_diameter = 0;
    bool operator==(const HolderCone&) const = default;
};

struct ToolHolder {
    std::string name, vendor, product_id;
    std::vector<HolderCone> outline;
    bool operator==(const ToolHolder&) const = default;
};

struct LibraryTool {
    /// Its holder has the outline below as cylinders.
    Tool tool;
    ToolHolder holder;
    double overall_length = 0; ///< with what is in the holder; 0: unsaid
    std::string material;      ///< it is made of
    std::string vendor, product_id, comment;
};

struct ToolLibrary {
    std::string name;
    LengthUnit unit = LengthUnit::mm; ///< that its files have
    std::vector<LibraryTool> tools;
    std::vector<ToolHolder> holders; ///< that no tool is in
};

/// Steps of an outline as cylinders: none lies anywhere inside it, and none stands out of it by more than a
/// millimetre, unless a holder of more sections than tools may have (ToolLift::max_bodies) would come of it.
std::vector<HolderSection> holder_steps(const std::vector<HolderCone>& outline);
/// The outline of cylinders.
std::vector<HolderCone> holder_outline(const std::vector<HolderSection>& sections);

/// A tool with an outline for its holder; what it was held by before is forgotten.
void put_into_holder(LibraryTool& tool, ToolHolder holder);

/// The tools of a job, with all that it knows of them.
ToolLibrary library_of(const std::vector<Tool>& tools, LengthUnit unit, std::string name);

/// The tool for a list of others: with the number that it has, if that is free, or the next free one.
Tool numbered_for(const LibraryTool& tool, const std::vector<Tool>& others);

} // namespace facetmill
