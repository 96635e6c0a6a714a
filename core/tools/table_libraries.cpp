// LinuxCNC's tool table, and the lists of CAMotics and Kiri:Moto: a few sizes of every tool.
#include "core/base/text.h"
#include "core/base/vec.h"
#include "core/tools/formats.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <sstream>

namespace facetmill {

namespace {

/// What formats that have only sizes leave out.
void tell_lost(const LibraryTool& t, ToolRemarks& told) {
    const auto lost = [&](const char* what, bool said) {
        if (said) told.add(std::string(what) + " is not carried");
    };
    lost("the holder", !t.tool.holder.empty());
    lost("flutes", t.tool.flutes != 0);
    lost("material", !t.material.empty());
    lost("vendor", !t.vendor.empty());
    lost("product_id", !t.product_id.empty());
    lost("comment", !t.comment.empty());
    lost("overall_length", t.overall_length > 0);
    lost("cutting", !t.tool.cutting.empty());
}
void tell_lost(const ToolLibrary& library, std::vector<std::string>& remarks) {
    for (const ToolHolder& h : library.holders)
        remarks.push_back("holder '" + printable(h.name) + "' is left out: this format has none");
}

/// Flutes and shank of files that say neither: as long as usual ones.
constexpr double usual_flutes = 3, usual_shank = 4;
/// Drills there have a point of 118 degrees.
constexpr double kiri_point = 59;

LibraryTool sized(double number, std::string name) {
    LibraryTool t;
    t.tool.number = as_tool_number(number);
    t.tool.name = std::move(name);
    return t;
}

/// A number behind a letter of the table: "T1", "D+6.000".
std::optional<double> after(const std::string& word, char letter) {
    double value = 0;
    if (word.size() < 2 || std::toupper(static_cast<unsigned char>(word[0])) != letter) return std::nullopt;
    const std::size_t sign = word[1] == '+' ? 2 : 1;
    if (!parse_number(word.substr(sign), value)) return std::nullopt;
    return value;
}

} // namespace

ReadLibrary read_linuxcnc(std::string_view text, const std::string& name, LengthUnit unit) {
    ReadLibrary read;
    read.library.unit = unit;
    std::istringstream lines{std::string(text)};
    std::size_t count = 0;
    for (std::string line; std::getline(lines, line);) {
        ++count;
        const std::size_t remark = line.find(';');
        const std::string said = remark == std::string::npos ? std::string() : line.substr(remark + 1);
        std::istringstream words(line.substr(0, remark));
        std::optional<double> number, diameter;
        std::vector<std::string> left;
        for (std::string word; words >> word;) {
            if (const auto t = after(word, 'T'))
                number = t;
            else if (const auto d = after(word, 'D'))
                diameter = d;
            else if (const auto offset = std::isalpha(static_cast<unsigned char>(word[0])) ? after(
                                             word, char(std::toupper(static_cast<unsigned char>(word[0]))))
                                                                                           : std::nullopt)
                (std::toupper(static_cast<unsigned char>(word[0])) != 'P' && *offset != 0)
                    ? left.push_back(word)
                    : void();
            else
                throw Error(ErrorCode::syntax, name + ":" + std::to_string(count),
                            "'" + printable(word) + "' is no letter and number", "correct the table");
        }
        if (!number) continue;
        std::string called = printable(said, 200);
        while (!called.empty() && std::isspace(static_cast<unsigned char>(called.front())))
            called.erase(0, 1);
        LibraryTool t = sized(*number, called);
        if (t.tool.name.empty()) t.tool.name = "Tool " + std::to_string(t.tool.number);
        ToolRemarks remarks(read.remarks);
        remarks.about(t);
        for (const std::string& word : left)
            remarks.add(printable(word) + " is not carried");
        if (!diameter || !(*diameter > 0)) {
            remarks.add("left out: the table has no diameter");
            continue;
        }
        CutterSizes s;
        s.diameter = *diameter * mm_per(unit);
        s.flute_length = usual_flutes * s.diameter;
        const std::string words_of = in_small_letters(t.tool.name);
        if (words_of.find("ball") != std::string::npos) s.kind = CutterKind::ball;
        remarks.add(std::string("a table tells no shape and no lengths: taken for a ")
                    + (s.kind == CutterKind::ball ? "ball" : "flat") + " end with usual flutes and shank");
        set_cutter(t.tool, s);
        set_shank(t.tool, s.diameter, (usual_flutes + usual_shank) * s.diameter);
        add_checked(read, std::move(t), remarks);
    }
    return read;
}

std::string write_linuxcnc(const ToolLibrary& library, std::vector<std::string>& remarks) {
    std::string table;
    ToolRemarks told(remarks);
    for (const LibraryTool& t : library.tools) {
        told.about(t);
        told.add("shape and lengths are not carried");
        tell_lost(t, told);
        const std::string number = std::to_string(t.tool.number);
        table += "T" + number + " P" + number + " D"
                 + format_number(2 * CutterProfile(t.tool.cutter()).max_radius() / mm_per(library.unit), 9)
                 + " ;" + printable(t.tool.name, 200) + "\n";
    }
    tell_lost(library, remarks);
    return table;
}

ReadLibrary read_camotics(const Json& json) {
    ReadLibrary read;
    const Json* table = &json;
    if (json.is_object() && json.contains("tools")) table = &json["tools"];
    strict::expect_object(*table, "tools");
    bool first = true;
    for (auto it = table->begin(); it != table->end(); ++it) {
        double number = 0;
        if (!parse_number(it.key(), number)) continue;
        LooseObject object(*it, "tools." + printable(it.key()));
        const LengthUnit unit =
            in_small_letters(object.text("units")) == "imperial" ? LengthUnit::inch : LengthUnit::mm;
        if (first) read.library.unit = unit;
        first = false;
        LibraryTool t = sized(number, object.text("description"));
        if (t.tool.name.empty()) t.tool.name = "Tool " + std::to_string(t.tool.number);
        ToolRemarks remarks(read.remarks);
        remarks.about(t);
        const std::string shape = in_small_letters(object.text("shape"));
        CutterSizes s;
        s.diameter = object.length("diameter", unit).value_or(0);
        const double snub = object.length("snub_diameter", unit).value_or(0);
        s.flute_length = object.length("length", unit).value_or(0);
        if (shape == "ballnose") s.kind = CutterKind::ball;
        if (shape == "conical" || shape == "snubnose") {
            s.kind = CutterKind::chamfer;
            s.tip_diameter = shape == "snubnose" ? snub : 0;
            s.angle = std::atan2(0.5 * (s.diameter - s.tip_diameter), s.flute_length);
        }
        if (shape != "cylindrical" && shape != "ballnose" && shape != "conical" && shape != "snubnose") {
            remarks.add("left out: '" + printable(shape) + "' is no cutter that this program knows");
            continue;
        }
        object.drop({"number"});
        remarks.not_carried(object);
        try {
            set_cutter(t.tool, s);
            set_shank(t.tool, s.diameter, 0);
        } catch (const Error& e) {
            remarks.add(std::string("left out: ") + e.what());
            continue;
        }
        add_checked(read, std::move(t), remarks);
    }
    return read;
}

std::string write_camotics(const ToolLibrary& library, std::vector<std::string>& remarks) {
    const double per = mm_per(library.unit);
    Json table = Json::object();
    ToolRemarks told(remarks);
    for (const LibraryTool& t : library.tools) {
        told.about(t);
        const auto s = sizes_of(t.tool);
        const char* shape = nullptr;
        double diameter = s ? s->diameter : 0, snub = 0;
        if (s && s->kind == CutterKind::flat) shape = "CYLINDRICAL";
        if (s && s->kind == CutterKind::ball) shape = "BALLNOSE";
        if (s && s->kind == CutterKind::chamfer) shape = "CONICAL";
        if (s && s->kind == CutterKind::tapered && s->corner_radius == 0) {
            shape = "SNUBNOSE";
            snub = s->diameter;
            diameter = 2 * CutterProfile(t.tool.cutter()).max_radius();
        }
        if (!shape) {
            told.add("left out: this format has no '" + t.tool.shape_name() + "'");
            continue;
        }
        tell_lost(t, told);
        if (t.tool.shank_length > 0) told.add("the shank is not carried");
        table[std::to_string(t.tool.number)] = {
            {"units", library.unit == LengthUnit::inch ? "IMPERIAL" : "METRIC"},
            {"shape", shape},
            {"length", json_number(s->flute_length / per, "length")},
            {"diameter", json_number(diameter / per, "diameter")},
            {"snub_diameter", json_number(snub / per, "snub_diameter")},
            {"description", t.tool.name}};
    }
    tell_lost(library, remarks);
    return table.empty() ? std::string() : json_file(table);
}

ReadLibrary read_kiri(const Json& json) {
    ReadLibrary read;
    const Json* list = &json;
    if (json.is_object() && json.contains("tools")) list = &json["tools"];
    strict::expect_list(*list, "tools");
    for (std::size_t i = 0; i < list->size(); ++i) {
        LooseObject object((*list)[i], strict::element("tools", i));
        const std::string metric = object.text("metric");
        const LengthUnit unit = metric == "true" || metric == "1" ? LengthUnit::mm : LengthUnit::inch;
        if (i == 0) read.library.unit = unit;
        LibraryTool t = sized(object.number("number").value_or(double(i + 1)), object.text("name"));
        ToolRemarks remarks(read.remarks);
        remarks.about(t);
        const std::string type = in_small_letters(object.text("type"));
        CutterSizes s;
        s.diameter = object.length("flute_diam", unit).value_or(0);
        s.flute_length = object.length("flute_len", unit).value_or(0);
        const double tip = object.length("taper_tip", unit).value_or(0);
        const auto shaft = object.length("shaft_diam", unit), shaft_length = object.length("shaft_len", unit);
        const double slope = s.flute_length > 0 ? std::atan2(0.5 * (s.diameter - tip), s.flute_length) : 0;
        if (type == "ballmill") s.kind = CutterKind::ball;
        if (type == "drill") s.kind = CutterKind::drill, s.angle = radians(kiri_point);
        if (type == "tapermill") {
            s.kind = CutterKind::chamfer;
            s.tip_diameter = tip;
            s.angle = slope;
        }
        if (type == "taperball") {
            s.kind = CutterKind::tapered_ball;
            s.corner_radius = 0.5 * tip;
            // The side touches the ball, and is as wide as said where the flutes end.
            for (int k = 0; k < 60; ++k)
                s.angle = std::atan2(0.5 * s.diameter - s.corner_radius * std::cos(s.angle),
                                     s.flute_length - s.corner_radius * (1 - std::sin(s.angle)));
        }
        if (type != "endmill" && type != "ballmill" && type != "drill" && type != "tapermill"
            && type != "taperball") {
            remarks.add("left out: '" + printable(type) + "' is no cutter that this program knows");
            continue;
        }
        object.drop({"id", "order"});
        remarks.not_carried(object);
        try {
            set_cutter(t.tool, s);
            set_shank(t.tool, shaft, t.tool.flute_length + shaft_length.value_or(0));
        } catch (const Error& e) {
            remarks.add(std::string("left out: ") + e.what());
            continue;
        }
        add_checked(read, std::move(t), remarks);
    }
    return read;
}

std::string write_kiri(const ToolLibrary& library, std::vector<std::string>& remarks) {
    const double per = mm_per(library.unit);
    Json list = Json::array();
    ToolRemarks told(remarks);
    for (const LibraryTool& t : library.tools) {
        told.about(t);
        const auto s = sizes_of(t.tool);
        const char* type = nullptr;
        double diameter = s ? s->diameter : 0, tip = 0;
        if (s && s->kind == CutterKind::flat) type = "endmill";
        if (s && s->kind == CutterKind::ball) type = "ballmill";
        if (s && s->kind == CutterKind::chamfer) type = "tapermill";
        if (s && s->kind == CutterKind::drill) {
            type = "drill";
            if (std::abs(s->angle - radians(kiri_point)) > radians(0.01))
                told.add("the angle of its point is not carried");
        }
        const bool tapered = s && s->kind == CutterKind::tapered && s->corner_radius == 0;
        if (tapered) type = "tapermill", tip = s->diameter;
        if (s && s->kind == CutterKind::tapered_ball) type = "taperball", tip = 2 * s->corner_radius;
        if (tip > 0) diameter = 2 * CutterProfile(t.tool.cutter()).max_radius();
        if (!type) {
            told.add("left out: this format has no '" + t.tool.shape_name() + "'");
            continue;
        }
        tell_lost(t, told);
        list.push_back({{"id", t.tool.number},
                        {"number", t.tool.number},
                        {"type", type},
                        {"name", t.tool.name},
                        {"metric", library.unit != LengthUnit::inch},
                        {"shaft_diam", json_number(t.tool.shank_diameter / per, "shaft_diam")},
                        {"shaft_len", json_number(t.tool.shank_length / per, "shaft_len")},
                        {"flute_diam", json_number(diameter / per, "flute_diam")},
                        {"flute_len", json_number(s->flute_length / per, "flute_len")},
                        {"taper_tip", json_number(tip / per, "taper_tip")}});
    }
    tell_lost(library, remarks);
    return list.empty() ? std::string() : json_file(list);
}

} // namespace facetmill
