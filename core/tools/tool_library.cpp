#include "core/tools/tool_library.h"

#include <algorithm>
#include <cmath>

namespace facetmill {

namespace {

/// How far steps may stand out of a cone, and how many sections a whole holder may have.
constexpr double largest_step = 1;
/// What units of files take from a length, mm.
constexpr double rounding = 1e-9;
constexpr std::size_t max_sections = 12;

/// Steps of one cone, each as wide as the cone is at its wider end.
void add_steps(const HolderCone& cone, std::size_t count, std::vector<HolderSection>& steps) {
    const double grow = cone.upper_diameter - cone.lower_diameter;
    for (std::size_t k = 0; k < count; ++k) {
        const double end = double(grow > 0 ? k + 1 : k) / double(count);
        const double diameter = cone.lower_diameter + end * grow, length = cone.length / double(count);
        if (!steps.empty() && std::abs(steps.back().diameter - diameter) <= rounding) {
            steps.back().length += length;
            steps.back().diameter = std::max(steps.back().diameter, diameter);
        } else {
            steps.push_back({diameter, length});
        }
    }
}

} // namespace

std::vector<HolderSection> holder_steps(const std::vector<HolderCone>& outline) {
    for (double allowed = largest_step;; allowed *= 2) {
        std::vector<HolderSection> steps;
        for (const HolderCone& cone : outline) {
            if (!(cone.length > 0)) continue;
            const double out = 0.5 * std::abs(cone.upper_diameter - cone.lower_diameter);
            add_steps(cone, std::size_t(std::max(1.0, std::ceil((out - rounding) / allowed))), steps);
        }
        const bool coarsest = std::all_of(outline.begin(), outline.end(), [&](const HolderCone& cone) {
            return std::abs(cone.upper_diameter - cone.lower_diameter) <= 2 * (allowed + rounding);
        });
        if (steps.size() <= max_sections || coarsest) return steps;
    }
}

std::vector<HolderCone> holder_outline(const std::vector<HolderSection>& sections) {
    std::vector<HolderCone> outline;
    for (const HolderSection& s : sections)
        outline.push_back({s.length, s.diameter, s.diameter});
    return outline;
}

void put_into_holder(LibraryTool& tool, ToolHolder holder) {
    tool.holder = std::move(holder);
    tool.tool.holder = holder_steps(tool.holder.outline);
}

ToolLibrary library_of(const std::vector<Tool>& tools, LengthUnit unit, std::string name) {
    ToolLibrary library;
    library.name = std::move(name);
    library.unit = unit;
    for (const Tool& tool : tools) {
        LibraryTool t;
        t.tool = tool;
        t.holder.outline = holder_outline(tool.holder);
        library.tools.push_back(std::move(t));
    }
    return library;
}

Tool numbered_for(const LibraryTool& tool, const std::vector<Tool>& others) {
    Tool numbered = tool.tool;
    if (find_tool(others, numbered.number)) numbered.number = free_tool_number(others);
    return numbered;
}

} // namespace facetmill
