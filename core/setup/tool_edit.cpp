#include "core/setup/tool_edit.h"

#include "core/base/tolerances.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace facetmill {

namespace {

constexpr double usual_taper = 5.0 * (pi / 180.0);
/// A bull nose has this share of its diameter for a corner, unless told otherwise.
constexpr double bull_share = 1.0 / 8;
/// Flutes of a drill, in lengths of its point.
constexpr double drill_points = 3;

struct ShapeName {
    const char* name; ///< Tool::shape_name
    const char* word; ///< in a tool's name
    CutterShape shape;
};
constexpr std::array<ShapeName, 7> shape_names{{
    {"Ball end", "Ball", CutterShape::ball},
    {"Flat end", "Flat", CutterShape::flat},
    {"Bull nose", "Bull", CutterShape::bull},
    {"Tapered flat", "Tapered flat", CutterShape::tapered_flat},
    {"Tapered ball", "Tapered ball", CutterShape::tapered_ball},
    {"Drill point", "Drill", CutterShape::drill_point},
    {"Cone", "Cone", CutterShape::cone},
}};

bool same(double a, double b) {
    return std::abs(a - b) <= tolerance::same_shape * std::max(std::abs(a), std::abs(b));
}

/// The diameter of a tapered ball is where side and bottom would meet, so that the ball which touches the
/// side is a little larger than half of it.
double ball_radius(const Tool& tool) {
    return tool.diameter / 2 * std::tan(pi / 4 + tool.taper_angle / 2);
}

double point_height(const Tool& tool) {
    return tool.diameter / 2 * std::tan(tool.bottom_angle);
}

/// "Tool 3": what a tool is called before it has a name.
bool is_placeholder(const std::string& name) {
    constexpr std::string_view word = "Tool";
    if (!name.starts_with(word)) return name.empty();
    return std::all_of(name.begin() + word.size(), name.end(),
                       [](char c) { return c == ' ' || (c >= '0' && c <= '9'); });
}

} // namespace

CutterShape shape_of(const Tool& tool) {
    const std::string name = tool.shape_name();
    for (const ShapeName& s : shape_names)
        if (name == s.name) return s.shape;
    return CutterShape::special;
}

std::string usual_tool_name(const Tool& tool, LengthUnit unit, const ToolNameStyle& style) {
    const auto number = [&](double value, int digits) {
        std::string shown = format_number(value, digits);
        if (const auto point = shown.find('.'); point != std::string::npos)
            shown.replace(point, 1, style.decimal_mark);
        return shown;
    };
    const auto length = [&](double mm) { return number(mm / mm_per(unit), 4); };
    const auto angle = [&](double a) { return " " + number(degrees(a), 3) + "°"; };
    const CutterShape shape = shape_of(tool);
    std::string name = "Special";
    for (const ShapeName& s : shape_names)
        if (s.shape == shape) name = s.word;
    if (style.shape) name = style.shape(name);
    name += " " + length(tool.diameter);
    switch (shape) {
    case CutterShape::ball:
    case CutterShape::flat:
        return name;
    case CutterShape::bull:
        return name + " R" + length(tool.corner_radius);
    case CutterShape::tapered_flat:
    case CutterShape::tapered_ball:
        return name + angle(tool.taper_angle);
    case CutterShape::drill_point:
    case CutterShape::cone: // the whole angle of the point, as such tools are sold
        return name + angle(pi - 2 * tool.bottom_angle);
    case CutterShape::special:
        break;
    }
    if (tool.corner_radius > 0) name += " R" + length(tool.corner_radius);
    if (tool.taper_angle != 0) name += angle(tool.taper_angle);
    return name;
}

ToolEdit::ToolEdit(const Tool& tool, LengthUnit unit, ToolNameStyle style)
    : tool_(tool), unit_(unit), style_(std::move(style)), shape_(shape_of(tool)),
      name_follows_(is_placeholder(tool.name) || tool.name == usual_tool_name(tool, unit)
                    || tool.name == usual_tool_name(tool, unit, style_)
                    || tool.name == usual_tool_name(tool, unit, {style_.shape})),
      before_{tool_, shape_} {}

void ToolEdit::set(const std::string& key, const ParameterValue& value) {
    if (key != key_) before_ = {tool_, shape_};
    Tool changed = before_.tool;
    ParameterView<Tool>(changed, tool_parameters()).set(key, value);
    key_ = key;
    tool_ = std::move(changed);
    shape_ = before_.shape;
    const double old_diameter = before_.tool.diameter;
    if (key == "name") {
        name_follows_ = tool_.name.empty();
        return;
    }
    if (key == "diameter") {
        follow(old_diameter);
    } else if (key == "corner_radius" && shape_ == CutterShape::ball
               && 2 * tool_.corner_radius > tool_.diameter) {
        tool_.diameter = 2 * tool_.corner_radius;
        follow(old_diameter);
    } else if (key == "taper_angle" && shape_ == CutterShape::tapered_ball && tool_.taper_angle > 0) {
        tool_.corner_radius = ball_radius(tool_);
    } else if (key == "bottom_angle" && shape_ == CutterShape::cone) {
        tool_.flute_length = point_height(tool_);
    }
    // What is typed may make it another shape; what makes no cutter leaves it the one that it was.
    if (const CutterShape now = shape_of(tool_); tool_.shape_name() != "Invalid") shape_ = now;
    rename();
}

void ToolEdit::follow(double old_diameter) {
    const double scale = tool_.diameter / old_diameter;
    switch (shape_) {
    case CutterShape::ball:
        tool_.corner_radius = tool_.diameter / 2;
        break;
    case CutterShape::bull:
        if (same(tool_.corner_radius, bull_share * old_diameter) || 2 * tool_.corner_radius >= tool_.diameter)
            tool_.corner_radius = bull_share * tool_.diameter;
        break;
    case CutterShape::tapered_ball:
        tool_.corner_radius = ball_radius(tool_);
        break;
    case CutterShape::cone:
        tool_.flute_length = point_height(tool_);
        break;
    case CutterShape::drill_point:
        tool_.flute_length = std::max(tool_.flute_length, drill_points * point_height(tool_));
        break;
    case CutterShape::flat:
    case CutterShape::tapered_flat:
    case CutterShape::special:
        break;
    }
    if (same(tool_.shank_diameter, old_diameter)) tool_.shank_diameter *= scale;
}

void ToolEdit::set_holder(std::vector<HolderSection> holder) {
    tool_.holder = std::move(holder);
    key_.clear();
}

void ToolEdit::set_cutting(std::vector<CuttingData> cutting) {
    tool_.cutting = std::move(cutting);
    key_.clear();
}

void ToolEdit::set_shape(CutterShape shape) {
    if (shape == CutterShape::special) return;
    key_.clear();
    const bool tapered = shape == CutterShape::tapered_flat || shape == CutterShape::tapered_ball,
               pointed = shape == CutterShape::drill_point || shape == CutterShape::cone;
    tool_.bottom_angle = pointed ? pi / 4 : 0;
    tool_.taper_angle = tapered ? usual_taper : 0;
    tool_.corner_radius = shape == CutterShape::ball           ? tool_.diameter / 2
                          : shape == CutterShape::bull         ? bull_share * tool_.diameter
                          : shape == CutterShape::tapered_ball ? ball_radius(tool_)
                                                               : 0;
    if (pointed) tool_.flute_length = point_height(tool_) * (shape == CutterShape::cone ? 1 : drill_points);
    shape_ = shape;
    rename();
}

void ToolEdit::rename() {
    if (name_follows_ && tool_.shape_name() != "Invalid") tool_.name = usual_tool_name(tool_, unit_, style_);
}

} // namespace facetmill
