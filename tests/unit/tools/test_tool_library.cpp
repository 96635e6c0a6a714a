// Tool libraries: what each format carries comes back, what it does not is named, and holders only grow.
#include "core/base/file.h"
#include "core/base/vec.h"
#include "core/setup/tool_edit.h"
#include "core/tools/library_file.h"
#include "tests/support/error_code.h"
#include "tests/support/random_meshes.h"
#include "tests/support/test_runner.h"

#include <QTemporaryDir>
#include <QTest>

#include <fstream>
#include <map>
#include <set>

using namespace facetmill;
using namespace facetmill::test;

namespace {

bool near(double a, double b) {
    return std::abs(a - b) <= 1e-9 * std::max({1.0, std::abs(a), std::abs(b)});
}

LibraryTool made(CutterShape shape, long number, double diameter, LengthUnit unit) {
    LibraryTool t;
    ToolEdit edit(t.tool, unit);
    edit.set("diameter", diameter);
    edit.set_shape(shape);
    t.tool = edit.tool();
    t.tool.number = number;
    t.tool.shank_diameter = 2 * CutterProfile(t.tool.cutter()).max_radius();
    t.tool.shank_length = 17.5;
    t.tool.flutes = 3;
    t.material = "carbide";
    t.vendor = "Nobody & Sons";
    t.product_id = "X-" + std::to_string(number);
    t.comment = "sharp";
    t.overall_length = t.tool.flute_length + t.tool.shank_length + 20;
    t.tool.cutting = {{"Roughing", "Wood", 12000, 1800, 600, 0.05, 0.4 * diameter, 2}};
    put_into_holder(t, {"Collet", "Nobody", "C-1", {{10, 20, 30}, {25, 30, 30}, {12, 40, 28}}});
    return t;
}

/// One of every shape that has a name.
ToolLibrary every_shape(LengthUnit unit) {
    ToolLibrary library;
    library.name = "Shop";
    library.unit = unit;
    long number = 0;
    for (const CutterShape shape :
         {CutterShape::flat, CutterShape::ball, CutterShape::bull, CutterShape::tapered_flat,
          CutterShape::tapered_ball, CutterShape::drill_point, CutterShape::cone}) {
        ++number;
        library.tools.push_back(made(shape, number, 0.7 + double(number), unit));
    }
    library.holders = {{"Chuck", "", "", {{30, 40, 50}}}};
    return library;
}

bool same_cutter(const Tool& a, const Tool& b) {
    return near(a.diameter, b.diameter) && near(a.corner_radius, b.corner_radius)
           && near(a.bottom_angle, b.bottom_angle) && near(a.taper_angle, b.taper_angle)
           && near(a.flute_length, b.flute_length);
}
bool same_tool(const Tool& a, const Tool& b) {
    if (a.holder.size() != b.holder.size()) return false;
    for (std::size_t i = 0; i < a.holder.size(); ++i)
        if (!near(a.holder[i].diameter, b.holder[i].diameter)
            || !near(a.holder[i].length, b.holder[i].length))
            return false;
    return a.number == b.number && a.name == b.name && same_cutter(a, b)
           && near(a.shank_diameter, b.shank_diameter) && near(a.shank_length, b.shank_length);
}
bool same_cutting(const CuttingData& a, const CuttingData& b) {
    return a.name == b.name && a.material == b.material && near(a.spindle, b.spindle) && near(a.feed, b.feed)
           && near(a.plunge_feed, b.plunge_feed) && near(a.chip_load, b.chip_load)
           && near(a.stepover, b.stepover) && near(a.depth, b.depth);
}
bool same_holder(const ToolHolder& a, const ToolHolder& b) {
    if (a.name != b.name || a.vendor != b.vendor || a.product_id != b.product_id
        || a.outline.size() != b.outline.size())
        return false;
    for (std::size_t i = 0; i < a.outline.size(); ++i)
        if (!near(a.outline[i].length, b.outline[i].length)
            || !near(a.outline[i].lower_diameter, b.outline[i].lower_diameter)
            || !near(a.outline[i].upper_diameter, b.outline[i].upper_diameter))
            return false;
    return true;
}

/// Written, read again, and everything compared: a format that carries all.
void comes_back_whole(LibraryFormat format, const char* file, LengthUnit unit) {
    const ToolLibrary library = every_shape(unit);
    const WrittenLibrary written = write_library(library, format, file);
    QVERIFY2(written.remarks.empty(), written.remarks.empty() ? "" : written.remarks[0].c_str());
    const ReadLibrary read = read_library(written.files[0].bytes, file, LengthUnit::mm);
    QVERIFY2(read.remarks.empty(), read.remarks.empty() ? "" : read.remarks[0].c_str());
    QVERIFY(read.format == format && read.library.unit == unit);
    QCOMPARE(read.library.tools.size(), library.tools.size());
    for (std::size_t i = 0; i < library.tools.size(); ++i) {
        const LibraryTool &a = library.tools[i], &b = read.library.tools[i];
        QVERIFY2(same_tool(a.tool, b.tool), a.tool.name.c_str());
        QVERIFY2(same_holder(a.holder, b.holder), a.tool.name.c_str());
        QVERIFY(a.tool.flutes == b.tool.flutes && a.material == b.material && a.vendor == b.vendor
                && a.product_id == b.product_id && a.comment == b.comment);
        QVERIFY(near(a.overall_length, b.overall_length));
        QCOMPARE(a.tool.cutting.size(), b.tool.cutting.size());
        QVERIFY(same_cutting(a.tool.cutting[0], b.tool.cutting[0]));
    }
    QCOMPARE(read.library.holders.size(), std::size_t(1));
    QVERIFY(same_holder(read.library.holders[0], library.holders[0]));
}

/// Written and read again, cutters compared; what is lost is named for every tool.
void cutters_come_back(LibraryFormat format, const char* file, std::size_t fit, bool numbers = true) {
    const ToolLibrary library = every_shape(LengthUnit::inch);
    const WrittenLibrary written = write_library(library, format, file);
    std::map<std::string, std::string> others;
    for (const WrittenLibrary::File& f : written.files)
        others[f.name] = f.bytes;
    const ReadLibrary read = read_library(written.files[0].bytes, file, LengthUnit::inch,
                                          [&](const std::string& name) -> std::optional<std::string> {
                                              if (!others.contains(name)) return std::nullopt;
                                              return others[name];
                                          });
    QVERIFY(read.format == format);
    QCOMPARE(read.library.tools.size(), fit);
    for (const LibraryTool& b : read.library.tools) {
        const auto a = std::find_if(library.tools.begin(), library.tools.end(),
                                    [&](const LibraryTool& t) { return t.tool.name == b.tool.name; });
        QVERIFY2(a != library.tools.end(), b.tool.name.c_str());
        // Drills of Kiri:Moto have no angle.
        if (format == LibraryFormat::kiri && shape_of(a->tool) == CutterShape::drill_point) continue;
        QVERIFY2(same_cutter(a->tool, b.tool), b.tool.name.c_str());
        QVERIFY(!numbers || a->tool.number == b.tool.number);
    }
    for (const LibraryTool& t : library.tools)
        QVERIFY2(std::any_of(written.remarks.begin(), written.remarks.end(),
                             [&](const std::string& r) { return r.find(t.tool.name) != std::string::npos; }),
                 t.tool.name.c_str());
}

/// Tools of all shapes that say of themselves what chance has it.
ToolLibrary chance_library(Random& rng) {
    ToolLibrary library = every_shape(uniform(rng, 0, 1) < 0.5 ? LengthUnit::mm : LengthUnit::inch);
    library.holders.clear();
    for (LibraryTool& t : library.tools) {
        const auto maybe = [&](auto& value) {
            if (uniform(rng, 0, 1) < 0.4) value = {};
        };
        for (std::string* text : {&t.material, &t.vendor, &t.product_id, &t.comment})
            maybe(*text);
        maybe(t.overall_length);
        maybe(t.tool.flutes);
        maybe(t.tool.cutting);
        t.tool.shank_length = uniform(rng, 5, 40);
        if (t.overall_length > 0) t.overall_length = t.tool.flute_length + t.tool.shank_length + 20;
        if (t.tool.cutting.empty()) {
            maybe(t.tool.holder);
            if (t.tool.holder.empty()) t.holder = {};
            continue;
        }
        CuttingData& c = t.tool.cutting.front();
        for (double* value : {&c.spindle, &c.feed, &c.plunge_feed, &c.chip_load, &c.stepover, &c.depth})
            maybe(*value);
        maybe(c.material);
        if (uniform(rng, 0, 1) < 0.5)
            t.tool.cutting.push_back({"Finishing", "Steel", 6000, 700, 200, 0.02, 1, 0.5});
    }
    return library;
}

/// What a round trip has changed of a tool, each with the words of which one is to be said of it.
std::vector<std::vector<const char*>> changes(const LibraryTool& a, const LibraryTool& b, bool has_numbers) {
    std::vector<std::vector<const char*>> all;
    const auto changed = [&](bool same, std::vector<const char*> words) {
        if (!same) all.push_back(std::move(words));
    };
    changed(a.tool.number == b.tool.number || !has_numbers, {"number"});
    changed(near(a.tool.flute_length, b.tool.flute_length), {"flute_length", "lengths"});
    changed(near(a.tool.corner_radius, b.tool.corner_radius) && near(a.tool.taper_angle, b.tool.taper_angle)
                && near(a.tool.bottom_angle, b.tool.bottom_angle),
            {"shape", "angle"});
    changed(near(a.tool.diameter, b.tool.diameter), {"diameter", "shape"});
    changed(near(a.tool.shank_diameter, b.tool.shank_diameter)
                && near(a.tool.shank_length, b.tool.shank_length),
            {"shank", "lengths"});
    changed(same_holder(a.holder, b.holder), {"holder"});
    changed(a.tool.flutes == b.tool.flutes, {"flutes"});
    changed(a.material == b.material, {"material"});
    changed(a.vendor == b.vendor, {"vendor"});
    changed(a.product_id == b.product_id, {"product_id"});
    changed(a.comment == b.comment, {"comment"});
    // Where nobody said it, a format that needs one has what flutes and shank come to.
    changed(a.overall_length == 0 || near(a.overall_length, b.overall_length), {"overall_length"});
    changed(a.tool.cutting.size() == b.tool.cutting.size(), {"cutting"});
    if (a.tool.cutting.empty() || b.tool.cutting.empty()) return all;
    const CuttingData &c = a.tool.cutting.front(), &d = b.tool.cutting.front();
    changed(c.name == d.name, {"cutting[0].name"});
    changed(c.material == d.material, {"cutting[0].material"});
    changed(near(c.spindle, d.spindle), {"cutting[0].spindle"});
    changed(near(c.feed, d.feed), {"cutting[0].feed"});
    changed(near(c.plunge_feed, d.plunge_feed), {"cutting[0].plunge_feed"});
    changed(near(c.chip_load, d.chip_load), {"cutting[0].chip_load"});
    changed(near(c.stepover, d.stepover), {"cutting[0].stepover"});
    changed(near(c.depth, d.depth), {"cutting[0].depth"});
    return all;
}

/// What writing and reading again has made another without a word, field by field.
void add_losses(const ToolLibrary& library, LibraryFormat format, const char* file,
                std::set<std::string>& losses) {
    const WrittenLibrary written = write_library(library, format, file);
    const ReadLibrary read = read_library(written.files[0].bytes, file, library.unit,
                                          [&](const std::string& name) -> std::optional<std::string> {
                                              for (const WrittenLibrary::File& f : written.files)
                                                  if (f.name == name) return f.bytes;
                                              return std::nullopt;
                                          });
    const auto said = [&](const LibraryTool& t, const char* word) {
        return std::any_of(written.remarks.begin(), written.remarks.end(), [&](const std::string& r) {
            return r.find("'" + t.tool.name + "'") != std::string::npos && r.find(word) != std::string::npos;
        });
    };
    for (const LibraryTool& a : library.tools) {
        const auto b = std::find_if(read.library.tools.begin(), read.library.tools.end(),
                                    [&](const LibraryTool& t) { return t.tool.name == a.tool.name; });
        const std::string who = std::string(file) + ": " + a.tool.name;
        if (b == read.library.tools.end()) {
            if (!said(a, "left out")) losses.insert(who);
            continue;
        }
        for (const auto& words : changes(a, *b, format != LibraryFormat::freecad_tool))
            if (std::none_of(words.begin(), words.end(), [&](const char* w) { return said(a, w); }))
                losses.insert(who + ": " + words.front());
    }
}

bool tells(const ReadLibrary& read, const char* of) {
    return std::any_of(read.remarks.begin(), read.remarks.end(),
                       [&](const std::string& r) { return r.find(of) != std::string::npos; });
}

std::string error_of(const std::string& bytes, const std::string& name) {
    return code_of([&] { read_library(bytes, name, LengthUnit::mm); });
}

} // namespace

class TestToolLibrary : public QObject {
    Q_OBJECT
private slots:
    /// At every height a holder's steps are as wide as its outline or wider, by no more than a millimetre
    /// while there are few of them.
    void steps_of_a_holder_lie_outside() {
        Random rng(5);
        for (int trial = 0; trial < 300; ++trial) {
            std::vector<HolderCone> outline;
            for (int k = whole(rng, 1, 5); k > 0; --k)
                outline.push_back({uniform(rng, 0.1, 40), uniform(rng, 5, 60), uniform(rng, 5, 60)});
            const auto steps = holder_steps(outline);
            QVERIFY(!steps.empty() && steps.size() <= 12);
            double all = 0, of_steps = 0;
            for (const HolderCone& c : outline)
                all += c.length;
            for (const HolderSection& s : steps)
                of_steps += s.length;
            QVERIFY(near(all, of_steps));
            double low = 0;
            for (const HolderCone& c : outline) {
                for (const double t : {0.001, 0.3, 0.62, 0.999}) {
                    const double z = low + t * c.length,
                                 d = c.lower_diameter + t * (c.upper_diameter - c.lower_diameter);
                    double base = 0;
                    for (const HolderSection& s : steps) {
                        if (z > base + 1e-9 && z < base + s.length - 1e-9) QVERIFY(s.diameter >= d - 1e-9);
                        base += s.length;
                    }
                }
                low += c.length;
            }
        }
        const auto slim = holder_steps({{10, 20, 24}});
        QCOMPARE(slim.size(), std::size_t(2));
        QCOMPARE(slim[0].diameter, 22.0);
        QCOMPARE(holder_steps(holder_outline(slim)), slim);
    }

    void our_own_format_and_fusions_carry_everything() {
        for (const LengthUnit unit : {LengthUnit::mm, LengthUnit::inch}) {
            comes_back_whole(LibraryFormat::facetmill, "a.fmtools", unit);
            comes_back_whole(LibraryFormat::fusion, "a.json", unit);
            comes_back_whole(LibraryFormat::fusion_archive, "a.tools", unit);
        }
    }

    void other_formats_carry_cutters_and_name_the_rest() {
        cutters_come_back(LibraryFormat::freecad_library, "a.fctl", 6); // no tapered flat
        cutters_come_back(LibraryFormat::camotics, "a.json", 4);
        cutters_come_back(LibraryFormat::kiri, "a.json", 6);
        // A table has diameters, and what the name tells.
        const ToolLibrary library = every_shape(LengthUnit::mm);
        const WrittenLibrary table = write_library(library, LibraryFormat::linuxcnc, "a.tbl");
        const ReadLibrary read = read_library(table.files[0].bytes, "a.tbl", LengthUnit::mm);
        QCOMPARE(read.library.tools.size(), library.tools.size());
        QVERIFY(same_cutter(read.library.tools[1].tool, [&] {
            Tool ball = library.tools[1].tool;
            ball.flute_length = 3 * ball.diameter;
            return ball;
        }()));
        QVERIFY(tells(read, "tells no shape"));
    }

    void every_field_comes_back_or_is_named() {
        Random rng(11);
        std::set<std::string> losses;
        for (int trial = 0; trial < 60; ++trial) {
            const ToolLibrary library = chance_library(rng);
            for (const auto& [format, file] : {std::pair(LibraryFormat::facetmill, "a.fmtools"),
                                               {LibraryFormat::fusion, "a.json"},
                                               {LibraryFormat::fusion_archive, "a.tools"},
                                               {LibraryFormat::freecad_library, "a.fctl"},
                                               {LibraryFormat::linuxcnc, "a.tbl"},
                                               {LibraryFormat::camotics, "c.json"},
                                               {LibraryFormat::kiri, "k.json"}})
                add_losses(library, format, file, losses);
        }
        for (const std::string& loss : losses)
            qWarning("%s", loss.c_str());
        QVERIFY(losses.empty());
    }

    void holders_of_freecad_come_back() {
        const ToolHolder holder{"BT30", "", "", {{12, 30, 44}, {20, 44, 44}, {3, 50, 50}}};
        ToolLibrary library;
        library.holders = {holder};
        const WrittenLibrary written = write_library(library, LibraryFormat::freecad_holder, "a.fcholder");
        const ReadLibrary read = read_library(written.files[0].bytes, "a.fcholder", LengthUnit::mm);
        QVERIFY(read.library.tools.empty());
        QCOMPARE(read.library.holders.size(), std::size_t(1));
        QVERIFY(same_holder(read.library.holders[0], holder));
    }

    void what_fusion_says_beyond_is_named() {
        const ReadLibrary read = read_library(R"({"data": [
            {"type": "ball end mill", "unit": "inches", "description": "1/4 ball", "vendor": "V",
             "geometry": {"DC": 0.25, "LCF": 0.75, "LB": 1.5, "SFDM": 0.375, "NOF": 2, "OAL": 2.5,
                          "shoulder-diameter": 0.25, "shoulder-length": 1, "odd": 3},
             "post-process": {"number": 7, "diameter-offset": 9, "break-control": true},
             "start-values": {"presets": [{"name": "P", "n": 8000, "v_f": 40, "tool-coolant": "flood"}]}},
            {"type": "thread mill", "unit": "inches", "description": "1/4-20", "geometry": {"DC": 0.2}},
            {"type": "drill", "unit": "millimeters", "description": "Drill 5",
             "geometry": {"DC": 5, "LCF": 40, "SIG": 118, "LB": 50}, "post-process": {"number": 2}}]})",
                                              "shop.json", LengthUnit::mm);
        QCOMPARE(read.library.tools.size(), std::size_t(2));
        const Tool& ball = read.library.tools[0].tool;
        QVERIFY(near(ball.diameter, 6.35) && near(ball.corner_radius, 3.175) && ball.number == 7);
        QVERIFY(near(ball.shank_diameter, 9.525) && near(ball.shank_length, 0.75 * 25.4));
        QVERIFY(near(read.library.tools[0].tool.cutting[0].feed, 1016));
        const Tool& drill = read.library.tools[1].tool;
        QVERIFY(near(drill.bottom_angle, radians(31)) && near(drill.flute_length, 40));
        for (const char* said : {"geometry.odd", "break-control", "diameter-offset", "tool-coolant", "neck",
                                 "'thread mill' is no cutter"})
            QVERIFY2(tells(read, said), said);
        QCOMPARE(read.library.name, std::string("shop"));
    }

    void texts_with_units_are_read() {
        const ReadLibrary read =
            read_library(R"({"version": 2, "name": "V 60", "shape": "Vbit.fcstd", "attribute": {},
            "parameter": {"Diameter": "1/2 in", "CuttingEdgeAngle": "60.0000 °", "TipDiameter": "0.5 mm",
                          "CuttingEdgeHeight": "9 mm", "Length": "2 in", "ShankDiameter": "6.35", "Flutes": 2,
                          "Chipload": "0.02 mm"}})",
                         "v.fctb", LengthUnit::mm);
        const LibraryTool& t = read.library.tools[0];
        QVERIFY(near(t.tool.diameter, 0.5) && near(t.tool.taper_angle, radians(30)));
        QVERIFY(near(2 * CutterProfile(t.tool.cutter()).max_radius(), 12.7));
        QVERIFY(near(t.tool.shank_diameter, 6.35) && near(t.tool.cutting[0].chip_load, 0.02)
                && t.tool.flutes == 2);
        QCOMPARE(error_of(R"({"shape": "endmill", "parameter": {"Diameter": "wide"}})", "v.fctb"),
                 std::string("empty_result"));
    }

    void numbers_that_are_switched_off_are_none() {
        const ReadLibrary read = read_library(R"({"data": [{"type": "flat end mill", "unit": "millimeters",
            "description": "F6", "geometry": {"DC": 6, "LCF": 20}, "start-values": {"presets": [
            {"name": "P", "n": 8000, "v_f": 400, "use-stepdown": false, "stepdown": 25, "use-stepover": true,
             "stepover": 2}]}}]})",
                                              "shop.json", LengthUnit::mm);
        const CuttingData& data = read.library.tools.at(0).tool.cutting.at(0);
        QCOMPARE(data.depth, 0.0);
        QCOMPARE(data.stepover, 2.0);
    }

    void what_nobody_can_run_by_is_left_out_and_the_tool_kept() {
        const ReadLibrary read = read_library(R"({"data": [{"type": "flat end mill", "unit": "millimeters",
            "description": "F6", "geometry": {"DC": 6, "LCF": 20, "NOF": 5000},
            "start-values": {"presets": [{"name": "P", "n": 8000, "v_f": 400}, {"name": "Q", "n": 8e9}]}}]})",
                                              "shop.json", LengthUnit::mm);
        QCOMPARE(read.library.tools.size(), std::size_t(1));
        const Tool& tool = read.library.tools[0].tool;
        QCOMPARE(tool.flutes, 0L);
        QCOMPARE(tool.cutting.size(), std::size_t(1));
        QVERIFY(tells(read, "flutes") && tells(read, "'Q'"));
    }

    void tables_are_read_line_by_line() {
        const ReadLibrary read =
            read_library("; my tools\nT1 P1 D6.000 Z+12.5 ;flat 6\nT22 P3 D.125;  1/8 ball nose\n"
                         "t3 p3 ;probe\n\n",
                         "t.tbl", LengthUnit::inch);
        QCOMPARE(read.library.tools.size(), std::size_t(2));
        QVERIFY(near(read.library.tools[0].tool.diameter, 152.4));
        QCOMPARE(read.library.tools[1].tool.number, 22L);
        QVERIFY(near(read.library.tools[1].tool.corner_radius, 25.4 / 16));
        QVERIFY(tells(read, "Z+12.5 is not carried") && tells(read, "no diameter"));
        QCOMPARE(error_of("T1 P1 D6 what\n", "t.tbl"), std::string("syntax"));
    }

    void bad_files_are_refused() {
        QCOMPARE(error_of("{}", "a.json"), std::string("unsupported_format"));
        QCOMPARE(error_of("{\"data\": []}", "a.json"), std::string("empty_result"));
        QCOMPARE(error_of("{\"data\": [{\"type\": \"holder\"", "a.json"), std::string("truncated"));
        QCOMPARE(error_of("x", "a.xyz"), std::string("unsupported_format"));
        QCOMPARE(error_of("no zip", "a.tools"), std::string("syntax"));
        QCOMPARE(error_of(R"({"facetmill_tools": 99, "units": "mm", "tools": []})", "a.fmtools"),
                 std::string("unsupported_format"));
        QCOMPARE(error_of(R"({"data": [{"type": "ball end mill", "geometry": {"DC": -3}}]})", "a.json"),
                 std::string("empty_result"));
        ToolLibrary two = every_shape(LengthUnit::mm);
        QCOMPARE(code_of([&] { write_library(two, LibraryFormat::freecad_tool, "a.fctb"); }),
                 std::string("limit_exceeded"));
        two.tools = {two.tools[0]};
        two.tools[0].tool.bottom_angle = 0.2;
        two.tools[0].tool.corner_radius = 0.1;
        two.holders.clear();
        QCOMPARE(code_of([&] { write_library(two, LibraryFormat::fusion, "a.json"); }),
                 std::string("empty_result"));
    }

    /// A library of FreeCAD's names files that lie beside it, or in Bit beside its folder.
    void files_beside_are_found() {
        const QTemporaryDir dir;
        const std::filesystem::path root = dir.path().toStdString();
        const WrittenLibrary written =
            write_library(every_shape(LengthUnit::mm), LibraryFormat::freecad_library, "shop.fctl");
        std::filesystem::create_directories(root / "Library");
        std::filesystem::create_directories(root / "Bit");
        for (std::size_t i = 0; i < written.files.size(); ++i)
            std::ofstream(root / (i == 0 ? "Library" : "Bit") / written.files[i].name)
                << written.files[i].bytes;
        QCOMPARE(load_library(root / "Library" / "shop.fctl", LengthUnit::mm).library.tools.size(),
                 std::size_t(6));
        std::filesystem::remove(root / "Bit" / written.files[1].name);
        const ReadLibrary less = load_library(root / "Library" / "shop.fctl", LengthUnit::mm);
        QCOMPARE(less.library.tools.size(), std::size_t(5));
        QVERIFY(tells(less, "left out: there is no"));
    }
};

FACETMILL_TEST(TestToolLibrary)
#include "test_tool_library.moc"
