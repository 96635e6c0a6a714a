// FreeCAD's tools (.fctb), libraries of them (.fctl) and holders (.fcholder).
#include "core/base/text.h"
#include "core/base/vec.h"
#include "core/tools/formats.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace facetmill {

namespace {

struct FreecadShape {
    const char* name; ///< file name of the shape without its end, small letters
    CutterKind kind;
};
/// The first of a kind is what it is written as.
constexpr std::array<FreecadShape, 10> shapes{{{"endmill", CutterKind::flat},
                                               {"ballend", CutterKind::ball},
                                               {"bullnose", CutterKind::bull},
                                               {"drill", CutterKind::drill},
                                               {"v-bit", CutterKind::chamfer},
                                               {"taperedballnose", CutterKind::tapered_ball},
                                               {"vbit", CutterKind::chamfer},
                                               {"chamfer", CutterKind::chamfer},
                                               {"torus", CutterKind::bull},
                                               {"reamer", CutterKind::flat}}};

/// "ballend" of "Ballend.fcstd", "ballend" of "Ballend".
std::string shape_word(std::string text) {
    text = in_small_letters(std::move(text));
    const std::size_t slash = text.find_last_of("/\\");
    if (slash != std::string::npos) text.erase(0, slash + 1);
    if (const std::size_t dot = text.find('.'); dot != std::string::npos) text.erase(dot);
    return text;
}

/// Point of a drill that tells none, degrees.
constexpr double usual_point = 119;
/// Figures of a number that come back the same.
constexpr int file_digits = 15;

std::string quantity(double mm, LengthUnit unit) {
    return format_number(mm / mm_per(unit), file_digits) + (unit == LengthUnit::inch ? " in" : " mm");
}

/// What every FreeCAD tool says of itself beside its shape. Attributes have no fixed names: these are in use.
void read_common(LooseObject& p, LooseObject& attributes, LibraryTool& t, LengthUnit unit) {
    t.tool.flutes = p.count("Flutes");
    t.material = p.text("Material");
    t.overall_length = p.length("Length", unit).value_or(0);
    t.vendor = attributes.text("Vendor");
    t.product_id = attributes.text("ProductId");
    t.comment = attributes.text("Comment");
    CuttingData c;
    c.name = attributes.text("Preset");
    c.material = attributes.text("StockMaterial");
    c.chip_load = p.length("Chipload", unit).value_or(0);
    c.spindle = attributes.number("spindleSpeed").value_or(0);
    c.feed = attributes.length("cutting_feedrate", unit).value_or(0);
    c.plunge_feed = attributes.length("plunge_feedrate", unit).value_or(0);
    c.stepover = attributes.length("stepover", unit).value_or(0);
    c.depth = attributes.length("stepdown", unit).value_or(0);
    if (c != CuttingData{c.name, {}}) t.tool.cutting.push_back(c);
}

CutterSizes read_sizes(CutterKind kind, LooseObject& p, LengthUnit unit, ToolRemarks& remarks) {
    CutterSizes s;
    s.kind = kind;
    s.diameter = p.length("Diameter", unit).value_or(0);
    s.tip_diameter = kind == CutterKind::chamfer ? p.length("TipDiameter", unit).value_or(0) : 0;
    s.corner_radius = p.length("CornerRadius", unit).value_or(p.length("TorusRadius", unit).value_or(0));
    // Bull noses of older files have the width of their flat.
    if (kind == CutterKind::bull && s.corner_radius == 0)
        if (const double flat = p.length("FlatRadius", unit).value_or(0); flat > 0)
            s.corner_radius = std::max(0.0, 0.5 * s.diameter - flat);
    const auto edge = p.length("CuttingEdgeHeight", unit);
    s.flute_length = edge.value_or(p.length("Length", unit).value_or(0));
    if (!edge) remarks.add("CuttingEdgeHeight is not said: all of its length is taken for flutes");
    const auto edge_angle = p.angle("CuttingEdgeAngle"), tip_angle = p.angle("TipAngle"),
               taper = p.angle("TaperAngle");
    if (kind == CutterKind::chamfer) s.angle = 0.5 * edge_angle.value_or(tip_angle.value_or(0.5 * pi));
    if (kind == CutterKind::drill) {
        const auto said = tip_angle ? tip_angle : edge_angle;
        s.angle = 0.5 * (said && *said > 0 && *said < pi ? *said : radians(usual_point));
        if (!said || s.angle != 0.5 * *said) remarks.add("its point is taken for one of 119°");
    }
    if (kind == CutterKind::tapered_ball) {
        s.angle = taper.value_or(0);
        s.corner_radius = 0.5 * s.diameter;
        p.length("TaperDiameter", unit); // follows from flutes and angle
        if (!(s.angle > 0)) s.kind = CutterKind::ball;
    }
    if (kind == CutterKind::bull && s.corner_radius == 0) s.kind = CutterKind::flat;
    return s;
}

void read_one(const Json& json, LengthUnit unit, long number, ReadLibrary& read) {
    ToolRemarks remarks(read.remarks);
    LooseObject file(json);
    LibraryTool t;
    t.tool.number = number;
    t.tool.name = file.text("name");
    remarks.about(t);
    file.drop({"version", "id"});
    const std::string type = shape_word(file.text("shape-type")), shape = shape_word(file.text("shape"));
    const auto known = std::find_if(shapes.begin(), shapes.end(), [&](const FreecadShape& s) {
        return shape == s.name || (shape.empty() && type == s.name);
    });
    if (known == shapes.end()) {
        remarks.add("left out: '" + printable(shape.empty() ? type : shape)
                    + "' is no cutter that this program knows");
        return;
    }
    LooseObject p = file.object("parameter"), attributes = file.object("attribute");
    try {
        set_cutter(t.tool, read_sizes(known->kind, p, unit, remarks));
        read_common(p, attributes, t, unit);
        set_shank(t.tool, p.length("ShankDiameter", unit), t.overall_length);
    } catch (const Error& e) {
        remarks.add(std::string("left out: ") + e.what());
        return;
    }
    // The edge is as long as it is high, or follows from that.
    p.drop({"SpindleDirection", "CuttingEdgeLength"});
    attributes.drop({"ToolType", "Description"});
    remarks.not_carried(attributes);
    remarks.not_carried(p);
    remarks.not_carried(file);
    add_checked(read, std::move(t), remarks);
}

Json attributes_of(const LibraryTool& t, LengthUnit unit) {
    Json attributes = Json::object();
    const auto say = [&](const char* key, const std::string& text) {
        if (!text.empty()) attributes[key] = text;
    };
    const auto measure = [&](const char* key, double mm) {
        if (mm > 0) attributes[key] = format_number(mm / mm_per(unit), file_digits);
    };
    say("Vendor", t.vendor);
    say("ProductId", t.product_id);
    say("Comment", t.comment);
    if (t.tool.cutting.empty()) return attributes;
    const CuttingData& c = t.tool.cutting[0];
    say("Preset", c.name);
    say("StockMaterial", c.material);
    if (c.spindle > 0) attributes["spindleSpeed"] = format_number(c.spindle, file_digits);
    measure("cutting_feedrate", c.feed);
    measure("plunge_feedrate", c.plunge_feed);
    measure("stepover", c.stepover);
    measure("stepdown", c.depth);
    return attributes;
}

} // namespace

ReadLibrary read_freecad_tool(const Json& json, LengthUnit unit) {
    ReadLibrary read;
    read.library.unit = unit;
    read_one(json, unit, 1, read);
    return read;
}

ReadLibrary read_freecad_library(const Json& json, LengthUnit unit, const NamedFiles& files) {
    ReadLibrary read;
    read.library.unit = unit;
    LooseObject file(json);
    read.library.name = file.text("label");
    for (LooseObject entry : file.objects("tools")) {
        const long number = entry.tool_number("nr", 1);
        const std::string path = entry.text("path");
        const std::optional<std::string> bytes = files ? files(path) : std::nullopt;
        if (!bytes) {
            read.remarks.push_back("T" + std::to_string(number) + ": left out: there is no '"
                                   + printable(path) + "' beside the library or in its Bit folder");
            continue;
        }
        read_one(parse_strict_json(*bytes, path), unit, number, read);
    }
    return read;
}

ReadLibrary read_freecad_holder(const Json& json) {
    ReadLibrary read;
    LooseObject file(json);
    ToolRemarks remarks(read.remarks);
    ToolHolder holder;
    holder.name = file.text("name");
    remarks.about("holder '" + holder.name + "'");
    const std::string units = file.text("units");
    read.library.unit = units.empty() ? LengthUnit::mm : parse_length_unit(units, "units");
    const double per = mm_per(read.library.unit);
    const Json& profile =
        strict::expect_list(strict::require(json, "", "profile", "give the holder's profile"), "profile");
    std::vector<Vec2> points;
    for (std::size_t i = 0; i < profile.size(); ++i) {
        const Json& p = profile[i];
        if (!p.is_array() || p.size() != 2 || !p[0].is_number() || !p[1].is_number())
            strict::wrong_type(strict::element("profile", i), p, "a radius and a height");
        points.emplace_back(std::abs(p[0].get<double>()) * per, p[1].get<double>() * per);
    }
    file.text("profile");
    // From the shank upward; level pieces of the outline are steps.
    if (points.size() > 1 && points.front().y() > points.back().y())
        std::reverse(points.begin(), points.end());
    for (std::size_t i = 1; i < points.size(); ++i)
        if (const double length = points[i].y() - points[i - 1].y(); length > 0)
            holder.outline.push_back({length, 2 * points[i - 1].x(), 2 * points[i].x()});
    file.drop({"version"});
    remarks.not_carried(file);
    if (holder.outline.empty())
        throw Error(ErrorCode::empty_result, "profile", "is no outline of a holder",
                    "give radii and heights that rise");
    read.library.holders.push_back(std::move(holder));
    return read;
}

std::string write_freecad_tool(const LibraryTool& t, LengthUnit unit, std::vector<std::string>& remarks) {
    ToolRemarks told(remarks);
    told.about(t);
    const auto sizes = sizes_of(t.tool);
    const auto shape = sizes ? std::find_if(shapes.begin(), shapes.end(),
                                            [&](const FreecadShape& s) { return s.kind == sizes->kind; })
                             : shapes.end();
    if (shape == shapes.end()) {
        told.add("left out: this format has no '" + t.tool.shape_name() + "'");
        return {};
    }
    const auto angle = [](double a) { return format_number(degrees(a), file_digits) + " °"; };
    const CutterSizes& s = *sizes;
    const double below = s.flute_length + t.tool.shank_length;
    Json p = {
        {"CuttingEdgeHeight", quantity(s.flute_length, unit)},
        {"Diameter", quantity(s.kind == CutterKind::tapered_ball ? 2 * s.corner_radius : s.diameter, unit)},
        {"Flutes", t.tool.flutes},
        {"Length", quantity(below, unit)},
        {"Material", t.material},
        {"ShankDiameter", quantity(t.tool.shank_diameter, unit)}};
    if (s.kind == CutterKind::bull) p["CornerRadius"] = quantity(s.corner_radius, unit);
    if (s.kind == CutterKind::drill) p["TipAngle"] = angle(2 * s.angle);
    if (s.kind == CutterKind::tapered_ball) p["TaperAngle"] = angle(s.angle);
    if (s.kind == CutterKind::chamfer) {
        p["CuttingEdgeAngle"] = angle(2 * s.angle);
        p["TipDiameter"] = quantity(0, unit);
    }
    const auto lost = [&](const char* what, bool said) {
        if (said) told.add(std::string(what) + " is not carried");
    };
    lost("the holder", !t.tool.holder.empty());
    lost("overall_length", t.overall_length > 0 && std::abs(t.overall_length - below) > 1e-9);
    lost("all cutting data but the first", t.tool.cutting.size() > 1);
    if (!t.tool.cutting.empty() && t.tool.cutting[0].chip_load > 0)
        p["Chipload"] = quantity(t.tool.cutting[0].chip_load, unit);
    return json_file({{"version", 2},
                      {"name", t.tool.name},
                      {"shape", std::string(shape->name) + ".fcstd"},
                      {"parameter", p},
                      {"attribute", attributes_of(t, unit)}});
}

WrittenLibrary write_freecad_library(const ToolLibrary& library, const std::string& name) {
    WrittenLibrary written;
    Json tools = Json::array();
    written.files.push_back({name, {}});
    for (const LibraryTool& t : library.tools) {
        std::string bytes = write_freecad_tool(t, library.unit, written.remarks);
        if (bytes.empty()) continue;
        const std::string file =
            name.substr(0, name.rfind('.')) + "-T" + std::to_string(t.tool.number) + ".fctb";
        tools.push_back({{"nr", t.tool.number}, {"path", file}});
        written.files.push_back({file, std::move(bytes)});
    }
    for (const ToolHolder& h : library.holders)
        written.remarks.push_back("holder '" + printable(h.name) + "' is left out: write it as .fcholder");
    if (!tools.empty())
        written.files.front().bytes = json_file({{"version", 1}, {"label", library.name}, {"tools", tools}});
    return written;
}

std::string write_freecad_holder(const ToolHolder& holder, LengthUnit unit) {
    const double per = mm_per(unit);
    Json profile = Json::array();
    double z = 0;
    const auto add = [&](double diameter) {
        profile.push_back({json_number(0.5 * diameter / per, "radius"), json_number(z / per, "height")});
    };
    for (const HolderCone& c : holder.outline) {
        add(c.lower_diameter);
        z += c.length;
        add(c.upper_diameter);
    }
    return json_file({{"version", 1},
                      {"name", holder.name},
                      {"units", unit == LengthUnit::inch ? "in" : "mm"},
                      {"type", "holder"},
                      {"profile", profile}});
}

} // namespace facetmill
