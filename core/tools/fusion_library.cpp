// Fusion's tool libraries: the .json that it exports, and what a .tools archive holds.
#include "core/base/tolerances.h"
#include "core/base/vec.h"
#include "core/tools/formats.h"

#include <array>
#include <cmath>
#include <cstdio>

namespace facetmill {

namespace {

struct FusionKind {
    const char* type;
    CutterKind kind;
};
/// The first of a kind is what it is written as.
constexpr std::array<FusionKind, 13> kinds{{{"flat end mill", CutterKind::flat},
                                            {"ball end mill", CutterKind::ball},
                                            {"bull nose end mill", CutterKind::bull},
                                            {"tapered mill", CutterKind::tapered},
                                            {"drill", CutterKind::drill},
                                            {"chamfer mill", CutterKind::chamfer},
                                            {"slot mill", CutterKind::flat},
                                            {"face mill", CutterKind::bull},
                                            {"spot drill", CutterKind::drill},
                                            {"center drill", CutterKind::drill},
                                            {"counter sink", CutterKind::chamfer},
                                            {"counter bore", CutterKind::flat},
                                            {"reamer", CutterKind::flat}}};

LengthUnit unit_of(LooseObject& object) {
    const std::string unit = object.text("unit");
    return unit == "inches" || unit == "in" ? LengthUnit::inch : LengthUnit::mm;
}

ToolHolder read_holder(LooseObject object, LengthUnit unit, ToolRemarks& remarks) {
    if (object.has("unit")) unit = unit_of(object);
    ToolHolder holder{object.text("description"), object.text("vendor"), object.text("product-id"), {}};
    for (LooseObject s : object.objects("segments")) {
        holder.outline.push_back({s.length("height", unit).value_or(0),
                                  s.length("lower-diameter", unit).value_or(0),
                                  s.length("upper-diameter", unit).value_or(0)});
        remarks.not_carried(s);
    }
    // The gauge length follows from the segments; identifiers name the same holder elsewhere.
    object.drop({"gaugeLength", "guid", "type", "last_modified", "reference_guid", "expressions"});
    remarks.not_carried(object);
    return holder;
}

CuttingData read_preset(LooseObject preset, LengthUnit unit, ToolRemarks& remarks) {
    CuttingData c{preset.text("name"), {}, preset.number("n").value_or(0)};
    c.feed = preset.length("v_f", unit).value_or(0);
    c.plunge_feed = preset.length("v_f_plunge", unit).value_or(0);
    c.chip_load = preset.length("f_z", unit).value_or(0);
    // A number that is switched off is none.
    const double stepover = preset.length("stepover", unit).value_or(0),
                 depth = preset.length("stepdown", unit).value_or(0);
    if (preset.text("use-stepover") != "false") c.stepover = stepover;
    if (preset.text("use-stepdown") != "false") c.depth = depth;
    LooseObject material = preset.object("material");
    c.material = material.text("query");
    material.drop({"category", "use-hardness"});
    remarks.not_carried(material);
    // The speed of an edge and the feed of a turn follow from what is carried.
    preset.drop({"guid", "v_c", "f_n", "description", "use-feed-per-revolution"});
    remarks.not_carried(preset);
    return c;
}

/// The shank as wide as all that stands between flutes and holder.
std::optional<double> widest_of_shank(LooseObject tool, LooseObject& geometry, LengthUnit unit,
                                      ToolRemarks& remarks) {
    std::optional<double> widest = geometry.length("SFDM", unit);
    const auto see = [&](std::optional<double> diameter) {
        if (diameter && *diameter > 0) widest = std::max(widest.value_or(0), *diameter);
    };
    const std::optional<double> shoulder = geometry.length("shoulder-diameter", unit);
    geometry.length("shoulder-length", unit);
    LooseObject shaft = tool.object("shaft");
    bool steps = shoulder && widest && std::abs(*shoulder - *widest) > tolerance::same_shape * *widest;
    for (LooseObject s : shaft.objects("segments")) {
        see(s.length("upper-diameter", unit));
        see(s.length("lower-diameter", unit));
        steps = true;
    }
    see(shoulder);
    if (steps) remarks.add("its neck is taken as wide as the widest of the shank");
    return widest;
}

std::optional<CutterSizes> read_sizes(CutterKind kind, LooseObject& geometry, LengthUnit unit) {
    CutterSizes s;
    s.kind = kind;
    s.diameter = geometry.length("DC", unit).value_or(0);
    s.flute_length = geometry.length("LCF", unit).value_or(0);
    s.corner_radius = geometry.length("RE", unit).value_or(0);
    s.tip_diameter = geometry.length("tip-diameter", unit).value_or(0);
    const double taper = geometry.angle("TA").value_or(0), point = geometry.angle("SIG").value_or(0);
    if (kind == CutterKind::bull && s.corner_radius == 0) s.kind = CutterKind::flat;
    if (kind == CutterKind::bull && 2 * s.corner_radius >= s.diameter * (1 - tolerance::same_shape))
        s.kind = CutterKind::ball;
    if (kind == CutterKind::tapered) {
        s.angle = taper;
        if (2 * s.corner_radius >= s.diameter * (1 - tolerance::same_shape))
            s.kind = CutterKind::tapered_ball;
        if (!(taper > 0)) s.kind = s.corner_radius > 0 ? CutterKind::bull : CutterKind::flat;
    }
    if (kind == CutterKind::drill) s.angle = 0.5 * point;
    if (kind == CutterKind::chamfer) s.angle = taper > 0 ? taper : 0.5 * point;
    const bool pointed = kind == CutterKind::drill || kind == CutterKind::chamfer;
    if (!(s.diameter > 0) || (pointed && !(s.angle > 0 && s.angle < 0.5 * pi))) return std::nullopt;
    return s;
}

void read_numbers(LooseObject object, LibraryTool& t, ToolRemarks& remarks) {
    t.tool.number = object.tool_number("number", 1);
    t.comment = object.text("comment");
    // Offsets are numbered as the tool, unless told otherwise.
    for (const char* key : {"diameter-offset", "length-offset"})
        if (const auto offset = object.number(key);
            offset && *offset != 0 && *offset != double(t.tool.number))
            remarks.add(object.place_of(key) + " is not carried: offsets have the tool's number");
    object.drop({"live", "turret"});
    remarks.not_carried(object);
}

void read_one(LooseObject object, ReadLibrary& read) {
    ToolRemarks remarks(read.remarks);
    LibraryTool t;
    t.tool.name = object.text("description");
    const std::string type = object.text("type");
    const LengthUnit unit = unit_of(object);
    t.material = object.text("BMC");
    t.vendor = object.text("vendor");
    t.product_id = object.text("product-id");
    read_numbers(object.object("post-process"), t, remarks);
    remarks.about(t);
    if (type == "holder") {
        read.library.holders.push_back(read_holder(std::move(object), unit, remarks));
        return;
    }
    const auto known =
        std::find_if(kinds.begin(), kinds.end(), [&](const FusionKind& k) { return type == k.type; });
    LooseObject geometry = object.object("geometry");
    const auto sizes = known == kinds.end() ? std::nullopt : read_sizes(known->kind, geometry, unit);
    if (!sizes) {
        remarks.add(known == kinds.end()
                        ? "left out: '" + printable(type) + "' is no cutter that this program knows"
                        : "left out: its geometry makes no cutter");
        return;
    }
    try {
        set_cutter(t.tool, *sizes);
        set_shank(t.tool, widest_of_shank(object, geometry, unit, remarks), geometry.length("LB", unit));
    } catch (const Error& e) {
        remarks.add(std::string("left out: ") + e.what());
        return;
    }
    t.tool.flutes = geometry.count("NOF");
    t.overall_length = geometry.length("OAL", unit).value_or(0);
    if (geometry.has("HAND") && geometry.text("HAND") == "false")
        remarks.add("it turns the other way, which is not carried");
    geometry.drop({"CSP", "HAND", "assemblyGaugeLength", "tip-length", "tip-offset", "thread-profile-angle",
                   "TP", "NT"});
    remarks.not_carried(geometry);
    if (object.has("holder")) t.holder = read_holder(object.object("holder"), unit, remarks);
    for (const LooseObject& preset : object.object("start-values").objects("presets"))
        t.tool.cutting.push_back(read_preset(preset, unit, remarks));
    object.drop({"guid", "reference_guid", "last_modified", "shaft", "expressions", "product-link"});
    remarks.not_carried(object);
    add_checked(read, std::move(t), remarks);
}

/// The same tool has the same identifier whenever it is written.
std::string identifier(const std::string& of) {
    std::uint64_t a = 14695981039346656037u, b = 1099511628211u;
    for (const char c : of) {
        a = (a ^ std::uint8_t(c)) * 1099511628211u;
        b = (b ^ a) * 14695981039346656037u;
    }
    char text[40];
    std::snprintf(text, sizeof text, "%08x-%04x-4%03x-8%03x-%012llx", unsigned(a >> 32),
                  unsigned(a >> 16) & 0xffffu, unsigned(a) & 0xfffu, unsigned(b >> 52) & 0xfffu,
                  static_cast<unsigned long long>(b & 0xffffffffffffu));
    return text;
}

Json holder_json(const ToolHolder& holder, LengthUnit unit) {
    const double per = mm_per(unit);
    Json segments = Json::array();
    double gauge = 0;
    for (const HolderCone& c : holder.outline) {
        segments.push_back({{"height", json_number(c.length / per, "height")},
                            {"lower-diameter", json_number(c.lower_diameter / per, "lower-diameter")},
                            {"upper-diameter", json_number(c.upper_diameter / per, "upper-diameter")}});
        gauge += c.length / per;
    }
    return {{"description", holder.name},
            {"gaugeLength", json_number(gauge, "gaugeLength")},
            {"guid", identifier("holder " + holder.name + holder.product_id)},
            {"product-id", holder.product_id},
            {"segments", segments},
            {"type", "holder"},
            {"unit", unit == LengthUnit::inch ? "inches" : "millimeters"},
            {"vendor", holder.vendor}};
}

Json preset_json(const CuttingData& c, double per) {
    return {{"f_z", json_number(c.chip_load / per, "f_z")},
            {"guid", identifier("preset " + c.name + c.material)},
            {"material", {{"category", "all"}, {"query", c.material}, {"use-hardness", false}}},
            {"n", json_number(c.spindle, "n")},
            {"name", c.name},
            {"stepdown", json_number(c.depth / per, "stepdown")},
            {"stepover", json_number(c.stepover / per, "stepover")},
            {"use-stepdown", c.depth > 0},
            {"use-stepover", c.stepover > 0},
            {"v_f", json_number(c.feed / per, "v_f")},
            {"v_f_plunge", json_number(c.plunge_feed / per, "v_f_plunge")}};
}

Json geometry_json(const LibraryTool& t, const CutterSizes& s, double per) {
    const auto length = [&](double mm) { return json_number(mm / per, "geometry"); };
    const double below = s.flute_length + t.tool.shank_length;
    Json g = {{"DC", length(s.diameter)},
              {"HAND", true},
              {"LB", length(below)},
              {"LCF", length(s.flute_length)},
              {"NOF", t.tool.flutes},
              {"OAL", length(std::max(t.overall_length, below))},
              {"SFDM", length(t.tool.shank_diameter)},
              {"shoulder-length", length(s.flute_length)}};
    if (s.kind == CutterKind::ball) g["RE"] = length(0.5 * s.diameter);
    if (s.kind == CutterKind::bull || s.kind == CutterKind::tapered) g["RE"] = length(s.corner_radius);
    if (s.kind == CutterKind::tapered_ball) {
        g["DC"] = length(2 * s.corner_radius);
        g["RE"] = length(s.corner_radius);
    }
    if (s.kind == CutterKind::tapered || s.kind == CutterKind::tapered_ball || s.kind == CutterKind::chamfer)
        g["TA"] = json_number(degrees(s.angle), "TA");
    if (s.kind == CutterKind::drill) g["SIG"] = json_number(degrees(2 * s.angle), "SIG");
    if (s.kind == CutterKind::chamfer) g["tip-diameter"] = 0;
    return g;
}

} // namespace

ReadLibrary read_fusion(const Json& json) {
    ReadLibrary read;
    LooseObject file(json);
    bool first = true;
    for (LooseObject one : file.objects("data")) {
        if (first) read.library.unit = unit_of(one);
        first = false;
        read_one(std::move(one), read);
    }
    return read;
}

std::string write_fusion(const ToolLibrary& library, std::vector<std::string>& remarks) {
    const double per = mm_per(library.unit);
    Json data = Json::array();
    ToolRemarks told(remarks);
    for (const LibraryTool& t : library.tools) {
        told.about(t);
        const auto sizes = sizes_of(t.tool);
        if (!sizes) {
            told.add("left out: this format has no '" + t.tool.shape_name() + "'");
            continue;
        }
        const CutterKind kind = sizes->kind == CutterKind::tapered_ball ? CutterKind::tapered : sizes->kind;
        const auto type =
            std::find_if(kinds.begin(), kinds.end(), [&](const FusionKind& k) { return k.kind == kind; });
        Json one = {
            {"BMC", t.material},
            {"description", t.tool.name},
            {"geometry", geometry_json(t, *sizes, per)},
            {"guid", identifier("tool " + std::to_string(t.tool.number) + t.tool.name + t.product_id)},
            {"post-process",
             {{"comment", t.comment},
              {"diameter-offset", t.tool.number},
              {"length-offset", t.tool.number},
              {"number", t.tool.number}}},
            {"product-id", t.product_id},
            {"start-values", {{"presets", Json::array()}}},
            {"type", type->type},
            {"unit", library.unit == LengthUnit::inch ? "inches" : "millimeters"},
            {"vendor", t.vendor}};
        for (const CuttingData& c : t.tool.cutting)
            one["start-values"]["presets"].push_back(preset_json(c, per));
        if (!t.holder.outline.empty()) one["holder"] = holder_json(t.holder, library.unit);
        data.push_back(std::move(one));
    }
    for (const ToolHolder& h : library.holders)
        data.push_back(holder_json(h, library.unit));
    return data.empty() ? std::string() : json_file({{"data", data}, {"version", 2}});
}

} // namespace facetmill
