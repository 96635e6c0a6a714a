// What of a tool moves together when somebody edits it: corner radius and shank with the diameter, as its
// shape says, and the name with all of them until somebody writes one. Millimetres, radians.
#pragma once

#include "core/base/units.h"
#include "core/setup/tool.h"

#include <functional>

namespace facetmill {

/// Shapes that a tool can be told to have; `special` is any other.
enum class CutterShape { special, ball, flat, bull, tapered_flat, tapered_ball, drill_point, cone };
/// By its values, as Tool::shape_name; `special` for values that make no cutter.
CutterShape shape_of(const Tool& tool);
/// How somebody writes the name of a tool.
struct ToolNameStyle {
    /// Says the word for a shape, "Tapered ball", in their language; none: it stays English.
    std::function<std::string(const std::string&)> shape = {};
    std::string decimal_mark = ".";
};
/// "Ball 6", "Flat 0.25", "Bull 6 R1", "Tapered ball 3 5°": shape and sizes in the unit.
std::string usual_tool_name(const Tool& tool, LengthUnit unit, const ToolNameStyle& style = {});

class ToolEdit {
public:
    /// Values follow from the shape that the tool has now; its name if nobody has written one: it is the
    /// usual one, in English or as `style` has it (with its decimal mark or a point), or "Tool" and a number.
    ToolEdit(const Tool& tool, LengthUnit unit, ToolNameStyle style = {});

    const Tool& tool() const { return tool_; }
    CutterShape shape() const { return shape_; }
    bool name_follows() const { return name_follows_; }

    /// One value by its key (tool_parameters()), and what moves with it: the diameter takes along the corner
    /// radius of a ball and a tapered ball, that of a bull nose where it was the usual one or would be too
    /// large, the height of a cone, and a shank that was as wide; the corner radius of a ball takes along its
    /// diameter as far as it cannot be smaller. One key several times in a row is as if it had been set once:
    /// a number that is typed passes others. Throws as ParameterView::set.
    void set(const std::string& key, const ParameterValue& value);
    /// Corner radius, angles and, where the shape asks for it, the flutes; nothing for `special`.
    void set_shape(CutterShape shape);
    void set_holder(std::vector<HolderSection> holder);
    void set_cutting(std::vector<CuttingData> cutting);

private:
    void follow(double old_diameter);
    void rename();

    struct State {
        Tool tool;
        CutterShape shape;
    };
    Tool tool_;
    LengthUnit unit_;
    ToolNameStyle style_;
    CutterShape shape_;
    bool name_follows_;
    std::string key_; ///< that was set last
    State before_;    ///< that
};

} // namespace facetmill
