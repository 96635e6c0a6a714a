#include "core/job/usual_tools.h"

#include "core/base/tolerances.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <vector>

namespace facetmill {

namespace {

/// Of the narrower side that lies flat, what the first tool is wide.
constexpr double width_share = 1.0 / 8;
/// What is smaller than this share of the smallest tool that is sold is no part for a workshop's tools.
constexpr double smallest_share = 0.5;
/// Flutes, in diameters.
constexpr double usual_flutes = 3;
/// Finishing leaves less than these shares of the part's diagonal and of the tool.
constexpr double part_share = 1.0 / 4000, tool_share = 1.0 / 100;

double in_mm(double mm, double inches, LengthUnit unit) {
    return unit == LengthUnit::inch ? inches * mm_per(unit) : mm;
}

bool is_as(double value, double usual) {
    return std::abs(value - usual) <= tolerance::figure_rounding * usual;
}

/// In round numbers of the unit.
double rounded_down(double mm, LengthUnit unit) {
    return round_down(mm / mm_per(unit)) * mm_per(unit);
}

bool is_same_cutter(const Tool& a, const Tool& b) {
    return is_as(a.diameter, b.diameter) && is_as(a.corner_radius, b.corner_radius)
           && is_as(a.flute_length, b.flute_length) && is_as(a.shank_diameter, b.shank_diameter)
           && a.bottom_angle == b.bottom_angle && a.taper_angle == b.taper_angle;
}

} // namespace

double usual_diameter(double target, LengthUnit unit) {
    static const std::vector<double> mm = {0.5, 1, 1.5, 2, 3, 4, 5, 6, 8, 10, 12, 16, 20, 25};
    static const std::vector<double> inch = {1.0 / 32, 1.0 / 16, 3.0 / 32, 1.0 / 8, 3.0 / 16, 1.0 / 4,
                                             3.0 / 8,  1.0 / 2,  5.0 / 8,  3.0 / 4, 1};
    const auto& sizes = unit == LengthUnit::inch ? inch : mm;
    const double wanted = target / mm_per(unit);
    if (wanted < smallest_share * sizes.front()) return rounded_down(target, unit);
    const auto above = std::upper_bound(sizes.begin(), sizes.end(), wanted * (1 + 1e-9));
    return (above == sizes.begin() ? sizes.front() : *std::prev(above)) * mm_per(unit);
}

double usual_shank_length(const Tool& tool, double part_height, LengthUnit unit) {
    const double step = (unit == LengthUnit::inch ? 0.05 : 1) * mm_per(unit);
    const ParameterInfo& info = tool_parameters().find("shank_length")->info;
    return std::clamp(std::max(4 * tool.diameter, std::ceil(part_height / step - 1e-9) * step), info.minimum,
                      info.maximum);
}

Tool usual_finishing_tool(const Vec3& part_size, LengthUnit unit) {
    // A flat part of no width still gets a tool.
    const double diagonal = std::max(part_size.norm(), 1e-3 * mm_per(unit));
    const double width = std::max(std::min(part_size.x(), part_size.y()), diagonal / 20);
    Tool tool;
    tool.number = 1;
    tool.diameter = tool.shank_diameter = usual_diameter(width * width_share, unit);
    tool.corner_radius = tool.diameter / 2;
    tool.flute_length = usual_flutes * tool.diameter;
    tool.shank_length = usual_shank_length(tool, part_size.z(), unit);
    tool.name = usual_tool_name(tool, unit);
    return tool;
}

double usual_tolerance(const Tool& tool, const Vec3& part_size, LengthUnit unit) {
    const double least = in_mm(0.01, 0.0005, unit), diagonal = part_size.norm();
    return rounded_down(std::min(std::max(diagonal * part_share, least), tool.diameter * tool_share), unit);
}

Tool usual_roughing_tool(const Project& project) {
    const LengthUnit unit = project.unit;
    double largest = 0, shank = 0;
    for (const Tool& t : project.tools) {
        largest = std::max(largest, t.diameter);
        shank = std::max(shank, t.shank_length);
    }
    Tool tool;
    tool.number = free_tool_number(project.tools);
    tool.diameter = std::max(std::min(usual_diameter(2 * largest, unit), in_mm(20, 0.75, unit)), largest);
    tool.shank_diameter = tool.diameter;
    tool.corner_radius = 0;
    tool.flute_length = usual_flutes * tool.diameter;
    tool.shank_length = std::max(shank, usual_shank_length(tool, 0, unit));
    tool.name = usual_tool_name(tool, unit);
    return tool;
}

void follow_part_height(Project& project, double before, double after) {
    for (Tool& tool : project.tools)
        if (is_as(tool.shank_length, usual_shank_length(tool, before, project.unit)))
            tool.shank_length = usual_shank_length(tool, after, project.unit);
}

void follow_part_size(Project& project, const Vec3& before, const Vec3& after, const ToolNameStyle& style) {
    const LengthUnit unit = project.unit;
    follow_part_height(project, before.z(), after.z());
    if (project.tools.size() != 1) return;
    Tool& tool = project.tools.front();
    const Tool was = usual_finishing_tool(before, unit), now = usual_finishing_tool(after, unit);
    // Depths of roughing and reworking tools come from it.
    const auto finishes = [](const Operation* o) { return o->purpose() == Purpose::finishing; };
    if (!is_same_cutter(tool, was) || !std::ranges::all_of(all_operations(project), finishes)) return;
    const double left = usual_tolerance(was, before, unit);
    const bool named = tool.name == was.name || tool.name == usual_tool_name(was, unit, style);
    tool.diameter = now.diameter;
    tool.corner_radius = now.corner_radius;
    tool.flute_length = now.flute_length;
    tool.shank_diameter = now.shank_diameter;
    if (is_as(tool.shank_length, usual_shank_length(was, after.z(), unit)))
        tool.shank_length = now.shank_length;
    if (named) tool.name = usual_tool_name(tool, unit, style);
    for (Operation* o : all_operations(project))
        if (is_as(o->common().tolerance, left)) o->common().tolerance = usual_tolerance(tool, after, unit);
}

} // namespace facetmill
