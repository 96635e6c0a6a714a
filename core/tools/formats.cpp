#include "core/tools/formats.h"

#include "core/base/tolerances.h"
#include "core/base/vec.h"
#include "core/setup/tool_edit.h"

#include <algorithm>
#include <cmath>

namespace facetmill {

void ToolRemarks::about(const LibraryTool& tool) {
    what_ = "T" + std::to_string(tool.tool.number) + " '" + printable(tool.tool.name) + "'";
}

void ToolRemarks::not_carried(const LooseObject& object) {
    for (const std::string& place : object.left())
        add(printable(place) + " is not carried");
}

std::optional<CutterSizes> sizes_of(const Tool& tool) {
    CutterSizes s;
    s.diameter = tool.diameter;
    s.corner_radius = tool.corner_radius;
    s.flute_length = tool.flute_length;
    const double same = tolerance::same_shape;
    switch (shape_of(tool)) {
    case CutterShape::ball:
        s.kind = CutterKind::ball;
        return s;
    case CutterShape::flat:
        return s;
    case CutterShape::bull:
        s.kind = CutterKind::bull;
        return s;
    case CutterShape::tapered_flat:
    case CutterShape::tapered_ball:
        s.kind = shape_of(tool) == CutterShape::tapered_flat ? CutterKind::tapered : CutterKind::tapered_ball;
        s.angle = tool.taper_angle;
        return s;
    case CutterShape::drill_point:
    case CutterShape::cone:
        s.kind = shape_of(tool) == CutterShape::cone ? CutterKind::chamfer : CutterKind::drill;
        s.angle = 0.5 * pi - tool.bottom_angle;
        return s;
    case CutterShape::special:
        break;
    }
    // A bull nose on a tapered side says all by its corner.
    if (tool.taper_angle > same && tool.bottom_angle <= same && tool.corner_radius > 0) {
        s.kind = CutterKind::tapered;
        s.angle = tool.taper_angle;
        return s;
    }
    return std::nullopt;
}

void set_cutter(Tool& tool, const CutterSizes& s) {
    tool.diameter = s.diameter;
    tool.flute_length = s.flute_length;
    tool.corner_radius = tool.bottom_angle = tool.taper_angle = 0;
    switch (s.kind) {
    case CutterKind::flat:
        break;
    case CutterKind::ball:
        tool.corner_radius = 0.5 * s.diameter;
        break;
    case CutterKind::bull:
        tool.corner_radius = s.corner_radius;
        break;
    case CutterKind::tapered:
        tool.taper_angle = s.angle;
        tool.corner_radius = s.corner_radius;
        break;
    case CutterKind::tapered_ball:
        // Where the ball's sides would go on to its tip (Tool::diameter).
        tool.taper_angle = s.angle;
        tool.corner_radius = s.corner_radius;
        tool.diameter = 2 * s.corner_radius / std::tan(0.25 * pi + 0.5 * s.angle);
        break;
    case CutterKind::drill:
    case CutterKind::chamfer:
        if (s.tip_diameter > 0) { // a blunt tip: a flat end with sloping sides, as high as they are wide
            tool.diameter = s.tip_diameter;
            tool.taper_angle = s.angle;
            tool.flute_length = 0.5 * (s.diameter - s.tip_diameter) / std::tan(s.angle);
        } else {
            tool.bottom_angle = 0.5 * pi - s.angle;
            tool.flute_length = std::max(s.flute_length, 0.5 * s.diameter / std::tan(s.angle));
        }
        break;
    }
    (void)tool.cutter();
}

void set_shank(Tool& tool, std::optional<double> diameter, std::optional<double> below_holder) {
    const double widest = 2 * CutterProfile(tool.cutter()).max_radius();
    tool.shank_diameter = diameter && *diameter > 0 ? *diameter : widest;
    tool.shank_length = std::max(0.0, below_holder.value_or(0) - tool.flute_length);
}

namespace {

/// A tool is good without what nobody can run it by.
void check_cutting(Tool& tool, ToolRemarks& remarks) {
    try {
        tool_parameters().find("flutes")->info.check(tool.flutes);
    } catch (const Error& e) {
        remarks.add(std::string("without its flutes: ") + e.what());
        tool.flutes = 0;
    }
    std::erase_if(tool.cutting, [&](const CuttingData& data) {
        try {
            for (const auto& entry : cutting_parameters().entries())
                entry.info.check(entry.get(data));
            return false;
        } catch (const Error& e) {
            remarks.add("without how it is run ('" + printable(data.name) + "'): " + e.what());
            return true;
        }
    });
}

} // namespace

void add_checked(ReadLibrary& read, LibraryTool tool, ToolRemarks& remarks) {
    const auto too_large = [](const HolderCone& c) {
        return !(c.length >= 0 && c.lower_diameter >= 0 && c.upper_diameter >= 0
                 && std::max({c.length, c.lower_diameter, c.upper_diameter}) <= tolerance::largest_tool);
    };
    if (std::any_of(tool.holder.outline.begin(), tool.holder.outline.end(), too_large)) {
        remarks.add("left out: its holder has sizes that none can have");
        return;
    }
    if (!tool.holder.outline.empty()) {
        // A shank that is wider than its holder is a neck in that: the holder is as wide.
        for (HolderCone& cone : tool.holder.outline)
            if (std::min(cone.lower_diameter, cone.upper_diameter) < tool.tool.shank_diameter) {
                remarks.add("its holder is narrower than its shank, and taken as wide");
                cone.lower_diameter = std::max(cone.lower_diameter, tool.tool.shank_diameter);
                cone.upper_diameter = std::max(cone.upper_diameter, tool.tool.shank_diameter);
            }
        put_into_holder(tool, std::move(tool.holder));
    }
    check_cutting(tool.tool, remarks);
    try {
        check_tool(tool.tool);
        read.library.tools.push_back(std::move(tool));
    } catch (const Error& e) {
        remarks.add(std::string("left out: ") + e.what());
    }
}

std::string json_file(const Json& json) {
    return pretty_json(json) + "\n";
}

} // namespace facetmill
