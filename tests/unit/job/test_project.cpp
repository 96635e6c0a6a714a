// The project file: every key checked, every value in its unit, what is saved reads back the same.
#include "core/base/file.h"
#include "core/base/strict_json.h"
#include "core/job/project.h"
#include "core/setup/machine.h"
#include "core/strategy/five_axis/finish5.h"
#include "core/strategy/global_local/global_local.h"
#include "tests/support/error_code.h"
#include "tests/support/test_runner.h"
#include "tests/support/trials.h"

#include <QTemporaryDir>
#include <QTest>

#include <cmath>
#include <fstream>
#include <random>

using namespace facetmill;
using facetmill::test::code_of;
using facetmill::test::trials;

namespace {

const char* const contract_project = R"({ "facetmill": 1, "units": "in",
  "part": { "file": "convex.stl", "units": "in", "rotate": [0, 0, 90], "translate": [1, 0, 0.1], "tessellation_tolerance": [0.001, 0] },
  "stock": { "kind": "box", "margin": [0.5, 0.5, 0.25] },
  "machine": "tarus-tpi-2000",
  "tools": [ { "number": 1, "name": "FEC 0.5", "diameter": 0.5, "corner_radius": 0.125, "bottom_angle": 0, "taper_angle": 0,
               "flute_length": 1.5, "shank_diameter": 0.5, "shank_length": 2, "holder": [ { "diameter": 2, "length": 3 } ] } ],
  "operations": [ { "kind": "finish3", "name": "Finish", "tool": 1, "tolerance": 0.004, "stepover": "adaptive", "direction": 30,
                    "feed": 100, "spindle": 3000, "clearance": 0.5 } ] })";

/// The contract's project with one text in place of another.
std::string changed(const std::string& from, const std::string& to) {
    std::string text = contract_project;
    const std::size_t at = text.find(from);
    if (at == std::string::npos) qFatal("the test's text is not in the project");
    return text.replace(at, from.size(), to);
}

Project parsed(const std::string& text) {
    return parse_project(text, "p.facetmill");
}

struct Failure {
    std::string code, where, line;
};

Failure failure_of(const std::function<void()>& call) {
    try {
        call();
    } catch (const Error& e) {
        return {std::string(code_name(e.code())), e.where(), e.what()};
    }
    return {"none", "", ""};
}

Failure failure_of(const std::string& text) {
    return failure_of([&] { parsed(text); });
}

const ParameterValue value(const Project& p, const char* key) {
    return p.operations.at(0)->get(key);
}

/// The project with one text in place of another is refused, at this place of its operation.
void check_refusal(std::string text, const char* from, const char* to, const char* code, const char* where) {
    text.replace(text.find(from), std::string(from).size(), to);
    const Failure f = failure_of(text);
    if (f.code != code || f.where != std::string("p.facetmill: operations[0]") + where)
        qFatal("%s gives %s at %s", to, f.code.c_str(), f.where.c_str());
}

} // namespace

class TestProject : public QObject {
    Q_OBJECT
private slots:

    void the_contract_reads() {
        const Project p = parsed(contract_project);
        QCOMPARE(p.unit, LengthUnit::inch);
        QCOMPARE(p.part.unit, LengthUnit::inch);
        QVERIFY(std::abs(p.part.rotate[2] - pi / 2) < 1e-15);
        QCOMPARE(p.part.translate[0], 25.4);
        QCOMPARE(p.part.tessellation_tolerance[0], 0.0254);
        QCOMPARE(p.stock.margin[2], 6.35);
        QCOMPARE(p.machine, std::string("tarus-tpi-2000"));
        QCOMPARE(p.tools.size(), std::size_t(1));
        QCOMPARE(p.tools[0].diameter, 12.7);
        QCOMPARE(p.tools[0].holder.size(), std::size_t(1));
        QCOMPARE(p.tools[0].holder[0].length, 3 * 25.4);
        QCOMPARE(p.operations.size(), std::size_t(1));
        const OperationCommon& c = p.operations[0]->common();
        QCOMPARE(c.tolerance, 0.004 * 25.4);
        QCOMPARE(c.feed, 2540.0);
        QCOMPARE(c.spindle, 3000.0);
        QVERIFY(std::abs(c.direction.number - radians(30)) < 1e-15);
        QCOMPARE(std::get<std::string>(value(p, "stepover")), std::string("adaptive"));
    }

    /// A mesh file's numbers may be in units that no project has.
    void units_of_mesh_files() {
        for (const LengthUnit unit : mesh_units) {
            const Project p = parsed(R"({"facetmill":1,"units":"mm","part":{"file":"a.stl","units":")"
                                     + std::string(unit_name(unit)) + R"(","scale":2,"mirror":"y"}})");
            QVERIFY(p.part.unit == unit && p.part.scale == 2 && p.part.mirror == Mirror::y);
            QCOMPARE(project_to_json(parsed(project_to_json(p))), project_to_json(p));
            QVERIFY(parse_mesh_unit(unit_name(unit), "") == unit);
            QVERIFY(default_project("a.stl", unit, Box3{{0, 0, 0}, {50, 50, 50}}).unit == project_unit(unit));
        }
        QCOMPARE(code_of([] { parsed(R"({"facetmill":1,"units":"m","part":{"file":"a.stl"}})"); }),
                 std::string("out_of_range"));
    }

    void what_may_be_left_out() {
        const Project p =
            parsed(R"({"facetmill":1,"units":"in","part":{"file":"a.stl"},)"
                   R"("tools":[{"number":4,"diameter":0.25}],"operations":[{"kind":"finish3","tool":4}]})");
        QCOMPARE(p.part.unit, LengthUnit::inch); // the project's
        QCOMPARE(p.tools[0].shank_diameter, 0.25 * 25.4);
        QCOMPARE(p.machine, Project().machine);
        QCOMPARE(parsed("\xEF\xBB\xBF{\"facetmill\":1,\"units\":\"mm\",\"part\":{\"file\":\"a.stl\"}}")
                     .operations.size(),
                 std::size_t(0));
    }

    void saving_gives_the_same_bytes() {
        const std::string once = project_to_json(parsed(contract_project));
        QCOMPARE(project_to_json(parsed(once)), once);
        // What was written by hand stands in it as it was.
        for (const char* text :
             {"\"tolerance\": 0.004", "\"feed\": 100", "\"direction\": 30", "\"rotate\": [0, 0, 90]",
              "\"diameter\": 0.5", "[0.001, 0]", "{ \"diameter\": 2, \"length\": 3 }"})
            QVERIFY2(once.find(text) != std::string::npos, text);

        QTemporaryDir dir;
        const std::filesystem::path path = std::filesystem::path(dir.path().toStdString()) / "p.facetmill";
        save_project(parsed(contract_project), path);
        QCOMPARE(std::string(InputFile(path).bytes()), once);
        save_project(load_project(path), path);
        QCOMPARE(std::string(InputFile(path).bytes()), once);
        QCOMPARE(load_project(path).path, path);
    }

    void postures_kept_by_hand_are_saved() {
        const std::string list = R"([{ "point": [1, 2.5, -0.1], "lead": 12.5, "yaw": -30 },)"
                                 R"({ "point": [0, 0, 0], "lead": 0, "yaw": 180 }])";
        const std::string text =
            changed("\"kind\": \"finish3\",", "\"kind\": \"finish5\", \"manual_postures\": " + list + ",");
        const Project p = parsed(text);
        const auto by_hand = manual_posture_list.of(*p.operations[0]);
        QCOMPARE(by_hand.size(), std::size_t(2));
        const ManualPosture& first = by_hand[0];
        QCOMPARE(first.point[1], 2.5 * 25.4);
        QCOMPARE(first.lead, radians(12.5));
        QCOMPARE(first.yaw, radians(-30));
        const std::string once = project_to_json(p);
        QVERIFY(once.find("\"point\": [1, 2.5, -0.1], \"lead\": 12.5, \"yaw\": -30") != std::string::npos);
        QCOMPARE(project_to_json(parsed(once)), once);
        QCOMPARE(project_to_json(Project(p)), once);
        // Without any, the file says nothing of them.
        Project none = p;
        manual_posture_list.set(*none.operations[0], {});
        QVERIFY(project_to_json(none).find("manual_postures") == std::string::npos);

        const auto wrong = [&](const char* from, const char* to, const char* code, const char* where) {
            check_refusal(text, from, to, code, where);
        };
        wrong("finish5", "finish3", "unknown_key", ".manual_postures");
        wrong(list.c_str(), "7", "wrong_type", ".manual_postures");
        wrong("\"lead\": 12.5", "\"lead\": 95", "out_of_range", ".manual_postures[0].lead");
        wrong("\"lead\": 12.5, ", "", "missing_key", ".manual_postures[0].lead");
        wrong("\"yaw\": 180", "\"yaw\": 200", "out_of_range", ".manual_postures[1].yaw");
        wrong("[1, 2.5, -0.1]", "[1, 2.5]", "wrong_type", ".manual_postures[0].point");
        wrong("\"yaw\": -30", "\"yaw\": -30, \"lift\": 1", "unknown_key", ".manual_postures[0].lift");
        Project off = p;
        Finish5Settings settings;
        settings.manual_postures = {{{0, 0, 0}, 2, 0}};
        off.operations[0] = std::make_unique<Finish5>(settings);
        QCOMPARE(failure_of([&] { check_project(off); }).where,
                 std::string("operations[0].manual_postures[0].lead"));
    }

    void edited_regions_are_saved() {
        const std::string edits = R"([{ "place": [1, 2.5, -0.1], "enabled": false, "grow": 0 },)"
                                  R"({ "place": [0, 0, 0], "enabled": true, "grow": -0.5 }])";
        const std::string drags = R"([{ "from": [1, 2, 3], "to": [1, 2.5, 3] }])";
        const std::string text =
            changed("\"kind\": \"finish3\",", "\"kind\": \"global_local\", \"region_edits\": " + edits
                                                  + ", \"boundary_drags\": " + drags + ",");
        const Project p = parsed(text);
        const GlobalLocalSettings& s = *p.operations[0]->rework();
        QVERIFY(
            (s.region_edits
             == std::vector<RegionEdit>{{{25.4, 2.5 * 25.4, -2.54}, false, 0}, {{0, 0, 0}, true, -12.7}}));
        QCOMPARE(s.boundary_drags.size(), std::size_t(1));
        QCOMPARE(s.boundary_drags[0].to[1], 63.5);
        // Last of the operation, in this order; without any, the file says nothing of them.
        const std::string once = project_to_json(p);
        const std::size_t at = once.find("\"region_edits\": [");
        QVERIFY(at != std::string::npos && at < once.find("\"boundary_drags\": ["));
        QVERIFY(once.find("\"accelerations\"") < at);
        QVERIFY(once.find("{ \"place\": [1, 2.5, -0.1], \"enabled\": false, \"grow\": 0 }")
                != std::string::npos);
        QCOMPARE(project_to_json(parsed(once)), once);
        Project none = p;
        region_edit_list.set(*none.operations[0], {});
        boundary_drag_list.set(*none.operations[0], {});
        QVERIFY(project_to_json(none).find("region_edits") == std::string::npos);
        QVERIFY(project_to_json(none).find("boundary_drags") == std::string::npos);
        // On the command line as in the file.
        apply_setting(none, "1.boundary_drags=" + drags);
        QVERIFY(none.operations[0]->rework()->boundary_drags == s.boundary_drags);
        apply_setting(none, "1.boundary_drags=[]");
        QVERIFY(none.operations[0]->rework()->boundary_drags.empty());

        const auto wrong = [&](const char* from, const char* to, const char* code, const char* where) {
            check_refusal(text, from, to, code, where);
        };
        wrong("global_local", "finish5", "unknown_key", ".region_edits");
        wrong("\"place\": [0, 0, 0], ", "", "missing_key", ".region_edits[1].place");
        wrong("\"grow\": -0.5", "\"grow\": -500", "out_of_range", ".region_edits[1].grow");
        wrong("\"enabled\": false", "\"enabled\": 0", "wrong_type", ".region_edits[0].enabled");
        wrong(", \"to\": [1, 2.5, 3]", "", "missing_key", ".boundary_drags[0].to");
        wrong("\"to\": [1, 2.5, 3]", "\"too\": 1, \"to\": [1, 2.5, 3]", "unknown_key",
              ".boundary_drags[0].too");
    }

    void any_number_of_fifteen_digits_survives() {
        std::mt19937_64 rng(5);
        std::uniform_real_distribution<double> exponent(-6, 1.5);
        for (const char* unit : {"mm", "in"})
            for (int i = 0; i < trials(3000); ++i) {
                // Digits as a user may type them.
                const int digits = 1 + int(rng() % 15);
                const double v = std::pow(10.0, exponent(rng));
                const std::string number = QString::number(v, 'g', digits).toStdString();
                std::string text = changed("0.004", number);
                if (std::string(unit) == "mm") text.replace(text.find("\"in\""), 4, "\"mm\"");
                const std::string once = project_to_json(parsed(text));
                const Json back = Json::parse(once);
                QCOMPARE(back["operations"][0]["tolerance"].get<double>(),
                         QString::fromStdString(number).toDouble());
                QCOMPARE(project_to_json(parsed(once)), once);
            }
    }

    void wrong_projects_are_named_data() {
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("code");
        QTest::addColumn<QString>("where");
        const auto row = [](const char* name, const std::string& text, const char* code, const char* where) {
            QTest::newRow(name) << QString::fromStdString(text) << code << where;
        };
        row("unknown top key", changed("\"machine\"", "\"machin\""), "unknown_key", "p.facetmill: machin");
        row("unknown part key", changed("\"rotate\"", "\"rotat\""), "unknown_key", "p.facetmill: part.rotat");
        row("unknown stock key", changed("\"margin\"", "\"margins\""), "unknown_key",
            "p.facetmill: stock.margins");
        row("unknown tool key", changed("\"flute_length\"", "\"edges\""), "unknown_key",
            "p.facetmill: tools[0].edges");
        row("unknown holder key", changed("\"length\": 3", "\"length\": 3, \"x\": 1"), "unknown_key",
            "p.facetmill: tools[0].holder[0].x");
        row("unknown operation key", changed("\"tolerance\"", "\"tolerence\""), "unknown_key",
            "p.facetmill: operations[0].tolerence");
        row("another kind's key", changed("\"spindle\"", "\"posture\": \"cm2\", \"spindle\""), "unknown_key",
            "p.facetmill: operations[0].posture");
        row("unknown kind", changed("finish3", "finish9"), "out_of_range", "p.facetmill: operations[0].kind");
        row("no kind", changed("\"kind\": \"finish3\",", ""), "missing_key",
            "p.facetmill: operations[0].kind");
        row("no tool of the operation", changed("\"tool\": 1,", ""), "missing_key",
            "p.facetmill: operations[0].tool");
        row("no diameter", changed("\"diameter\": 0.5,", ""), "missing_key",
            "p.facetmill: tools[0].diameter");
        row("no units", changed("\"units\": \"in\",\n", "\n"), "missing_key", "p.facetmill: units");
        row("no part", changed("\"part\"", "\"stock\""), "syntax", "p.facetmill: stock");
        row("no file", changed("\"file\": \"convex.stl\",", ""), "missing_key", "p.facetmill: part.file");
        row("empty file", changed("convex.stl", ""), "missing_key", "p.facetmill: part.file");
        row("a project as part", changed("convex.stl", "p.FacetMill"), "unsupported_format",
            "p.facetmill: part.file");
        row("tolerance 0", changed("0.004", "0"), "out_of_range", "p.facetmill: operations[0].tolerance");
        row("tolerance text", changed("0.004", "\"small\""), "wrong_type",
            "p.facetmill: operations[0].tolerance");
        row("tolerance null", changed("0.004", "null"), "wrong_type", "p.facetmill: operations[0].tolerance");
        row("tolerance list", changed("0.004", "[1]"), "wrong_type", "p.facetmill: operations[0].tolerance");
        row("tolerance huge", changed("0.004", "1e999"), "out_of_range", "p.facetmill:7:86");
        row("tolerance large", changed("0.004", "1e300"), "out_of_range",
            "p.facetmill: operations[0].tolerance");
        row("NaN", changed("0.004", "NaN"), "syntax", "p.facetmill:7:82");
        row("step-over 0", changed("\"adaptive\"", "0"), "out_of_range",
            "p.facetmill: operations[0].stepover");
        row("step-over word", changed("\"adaptive\"", "\"wide\""), "out_of_range",
            "p.facetmill: operations[0].stepover");
        row("step-over type", changed("\"adaptive\"", "true"), "wrong_type",
            "p.facetmill: operations[0].stepover");
        row("negative diameter", changed("\"diameter\": 0.5", "\"diameter\": -0.5"), "out_of_range",
            "p.facetmill: tools[0].diameter");
        row("corner too large", changed("0.125", "0.3"), "out_of_range",
            "p.facetmill: tools[0].corner_radius");
        row("negative holder", changed("\"length\": 3", "\"length\": -3"), "out_of_range",
            "p.facetmill: tools[0].holder[0].length");
        row("holder type", changed("[ { \"diameter\": 2, \"length\": 3 } ]", "7"), "wrong_type",
            "p.facetmill: tools[0].holder");
        row("tool number 1.5", changed("\"number\": 1", "\"number\": 1.5"), "wrong_type",
            "p.facetmill: tools[0].number");
        row("tool number 0", changed("\"number\": 1", "\"number\": 0"), "out_of_range",
            "p.facetmill: tools[0].number");
        row("tool missing", changed("\"tool\": 1", "\"tool\": 2"), "missing_reference",
            "p.facetmill: operations[0].tool");
        row("machine unknown", changed("tarus", "taurus"), "missing_reference", "p.facetmill: machine");
        row("machine type", changed("\"tarus-tpi-2000\"", "3"), "wrong_type", "p.facetmill: machine");
        row("unit unknown", changed("\"units\": \"in\"", "\"units\": \"ft\""), "out_of_range",
            "p.facetmill: units");
        row("part unit unknown", changed("\"units\": \"in\", \"rotate\"", "\"units\": \"yd\", \"rotate\""),
            "out_of_range", "p.facetmill: part.units");
        row("two rotations", changed("[0, 0, 90]", "[0, 90]"), "wrong_type", "p.facetmill: part.rotate");
        row("rotation of text", changed("[0, 0, 90]", "[0, 0, \"90\"]"), "wrong_type",
            "p.facetmill: part.rotate[2]");
        row("margin negative", changed("[0.5, 0.5, 0.25]", "[0.5, -0.5, 0.25]"), "out_of_range",
            "p.facetmill: stock.margin");
        row("stock kind", changed("\"box\"", "\"ball\""), "out_of_range", "p.facetmill: stock.kind");
        const std::string box = R"({ "kind": "box", "margin": [0.5, 0.5, 0.25] })";
        const auto stock = [&](const char* text) { return changed(box, text); };
        row("a box with a diameter", stock(R"({ "kind": "box", "diameter": 2 })"), "unknown_key",
            "p.facetmill: stock.diameter");
        row("a cylinder with a file", stock(R"({ "kind": "cylinder", "file": "x.stl" })"), "unknown_key",
            "p.facetmill: stock.file");
        row("a cylinder of no size", stock(R"({ "kind": "cylinder", "diameter": 0 })"), "out_of_range",
            "p.facetmill: stock.diameter");
        row("a cylinder along w", stock(R"({ "kind": "cylinder", "axis": "w" })"), "out_of_range",
            "p.facetmill: stock.axis");
        row("a mesh with a margin", stock(R"({ "kind": "mesh", "file": "x.stl", "margin": [1, 1, 1] })"),
            "unknown_key", "p.facetmill: stock.margin");
        row("a mesh without a file", stock(R"({ "kind": "mesh" })"), "missing_key",
            "p.facetmill: stock.file");
        row("a mesh with an empty file", stock(R"({ "kind": "mesh", "file": "" })"), "missing_key",
            "p.facetmill: stock.file");
        row("a project as stock", stock(R"({ "kind": "mesh", "file": "x.facetmill" })"), "unsupported_format",
            "p.facetmill: stock.file");
        row("tools no list", "{\"facetmill\":1,\"units\":\"mm\",\"part\":{\"file\":\"a\"},\"tools\":{}}",
            "wrong_type", "p.facetmill: tools");
        row("name empty", changed("\"name\": \"Finish\"", "\"name\": \" \""), "out_of_range",
            "p.facetmill: operations[0].name");
        row("control character", changed("\"name\": \"Finish\"", "\"name\": \"a\\u0000b\""), "out_of_range",
            "p.facetmill: operations[0].name");
        row("version missing", changed("\"facetmill\": 1,", ""), "missing_key", "p.facetmill: facetmill");
        row("version 3", changed("\"facetmill\": 1", "\"facetmill\": 3"), "newer_version",
            "p.facetmill: facetmill");
        row("version huge", changed("\"facetmill\": 1", "\"facetmill\": 18446744073709551615"),
            "newer_version", "p.facetmill: facetmill");
        row("version -1", changed("\"facetmill\": 1", "\"facetmill\": -1"), "out_of_range",
            "p.facetmill: facetmill");
        row("version text", changed("\"facetmill\": 1", "\"facetmill\": \"1\""), "wrong_type",
            "p.facetmill: facetmill");
        row("key twice", changed("\"feed\": 100", "\"feed\": 100, \"feed\": 200"), "syntax",
            "p.facetmill: operations[0].feed");
        row("key twice above", changed("\"machine\"", "\"units\": \"mm\", \"machine\""), "syntax",
            "p.facetmill: units");
        row("trailing garbage", std::string(contract_project) + " x", "syntax", "p.facetmill:8:74");
        row("two values", std::string(contract_project) + "{}", "syntax", "p.facetmill:8:73");
        row("comment", changed("\"machine\"", "// x\n\"machine\""), "syntax", "p.facetmill:4:3");
        row("trailing comma", changed("\"clearance\": 0.5", "\"clearance\": 0.5,"), "syntax",
            "p.facetmill:8:69");
        row("a list", "[1]", "wrong_type", "p.facetmill");
        row("a number", "1", "wrong_type", "p.facetmill");
        row("empty object", "{}", "missing_key", "p.facetmill: facetmill");
        row("binary", std::string("{\0}", 3), "encoding", "p.facetmill");
        row("UTF-16", "\xFF\xFE{", "encoding", "p.facetmill");
        row("blank", " \n ", "truncated", "p.facetmill:2:2");
        row("deep", std::string(100000, '['), "limit_exceeded",
            "p.facetmill: [0][0][0][0][0][0][0][0][0][0][0][0][0][0][0][0]");
    }
    void wrong_projects_are_named() {
        QFETCH(QString, text);
        QFETCH(QString, code);
        QFETCH(QString, where);
        std::string bytes = text.toStdString();
        if (text.startsWith(QChar(0xFFFD))) bytes = "\xFF\xFE{";
        const Failure f = failure_of(bytes);
        QCOMPARE(QString::fromStdString(f.code), code);
        QCOMPARE(QString::fromStdString(f.where), where);
        QVERIFY(f.line.find('\n') == std::string::npos);
        QVERIFY(f.line.ends_with(")")); // a remedy
    }

    void invalid_utf8_is_refused() {
        const Failure f = failure_of(changed("FEC", "F\xC3"));
        QCOMPARE(f.code, std::string("encoding"));
        QVERIFY(f.where.starts_with("p.facetmill:5:"));
        QCOMPARE(parsed(changed("FEC", "F\xC3\xA9")).tools[0].name, std::string("F\xC3\xA9 0.5"));
    }

    void suggestions_help() {
        QVERIFY(failure_of(changed("\"tolerance\"", "\"tolerence\"")).line.find("did you mean 'tolerance'?")
                != std::string::npos);
        QVERIFY(failure_of(changed("0.004", "0")).line.find("in") != std::string::npos);
        // Ranges are told in the project's unit.
        QVERIFY(failure_of(changed("\"diameter\": 0.5", "\"diameter\": -0.5")).line.find("-0.5 in")
                != std::string::npos);
    }

    void names_and_numbers_occur_once() {
        const std::string tool = R"({ "number": 1, "diameter": 1 }, { "number": 1, "name")";
        Failure f = failure_of(changed("{ \"number\": 1, \"name\"", tool));
        QCOMPARE(f.code, std::string("out_of_range"));
        QCOMPARE(f.where, std::string("p.facetmill: tools[1].number"));
        f = failure_of(changed("[ { \"kind\"",
                               "[ { \"kind\": \"finish3\", \"name\": \"Finish\", \"tool\": 1 }, { \"kind\""));
        QCOMPARE(f.where, std::string("p.facetmill: operations[1].name"));
    }

    void every_truncation_is_an_error() {
        const std::string whole = contract_project;
        for (std::size_t n = 0; n < whole.size(); ++n) {
            const Failure f = failure_of(whole.substr(0, n));
            QVERIFY2(f.code == "truncated" || f.code == "syntax", f.line.c_str());
            QVERIFY(f.where.starts_with("p.facetmill:"));
        }
    }

    void mutations_never_crash() {
        std::mt19937_64 rng(3);
        static constexpr char alphabet[] = "{}[]\",:0123456789.-eEtruefalsn \\u";
        int ok = 0, bad = 0;
        for (int round = 0; round < 4000; ++round) {
            std::string text = contract_project;
            for (int c = 1 + int(rng() % 3); c > 0; --c) {
                const std::size_t at = rng() % text.size();
                switch (rng() % 3) {
                case 0:
                    text[at] = alphabet[rng() % (sizeof alphabet - 1)];
                    break;
                case 1:
                    text.erase(at, 1 + rng() % 9);
                    break;
                default:
                    text.insert(at, text.substr(rng() % text.size(), 1 + rng() % 30));
                }
            }
            try {
                const Project p = parsed(text);
                ++ok;
                QCOMPARE(project_to_json(parsed(project_to_json(p))), project_to_json(p));
            } catch (const Error& e) {
                ++bad;
                QVERIFY2(e.code() != ErrorCode::internal, e.what());
                QVERIFY(std::string(e.what()).starts_with("p.facetmill"));
                QVERIFY(std::string(e.what()).find('\n') == std::string::npos);
            }
        }
        QVERIFY(ok > 20 && bad > 2000);
    }

    void older_files_are_migrated() {
        const Project p = load_project(test::data_path("unit/job/fixtures/version_0.facetmill"));
        QCOMPARE(p.unit, LengthUnit::inch);
        QCOMPARE(p.part.unit, LengthUnit::inch);
        QCOMPARE(p.tools[0].corner_radius, 0.125 * 25.4);
        QCOMPARE(p.operations[0]->kind(), std::string_view("finish3"));
        QCOMPARE(std::get<double>(value(p, "stepover")), 0.02 * 25.4);
        QVERIFY(project_to_json(p).starts_with("{\n  \"facetmill\": 1,"));
        // Old words are not known in a file of today, and not beside the new ones in an old file.
        QCOMPARE(failure_of(R"({"facetmill":1,"unit":"in","part":{"file":"a"}})").code,
                 std::string("unknown_key"));
        QCOMPARE(failure_of(R"({"facetmill":0,"unit":"in","units":"in","part":{"file":"a"}})").where,
                 std::string("p.facetmill: unit"));
    }

    void settings_apply() {
        Project p = parsed(changed("\"name\": \"Finish\"", "\"name\": \"Finish.a=b\""));
        apply_setting(p, "Finish.a=b.tolerance=0.002");
        QCOMPARE(p.operations[0]->common().tolerance, 0.002 * 25.4);
        apply_setting(p, "1.direction=45");
        QVERIFY(std::abs(p.operations[0]->common().direction.number - radians(45)) < 1e-15);
        apply_setting(p, "1.direction=auto");
        QVERIFY(p.operations[0]->common().direction.is("auto"));
        apply_setting(p, "1.feed=10");
        QCOMPARE(p.operations[0]->common().feed, 254.0);
        const std::string before = project_to_json(p);
        const auto code = [&](const char* setting) {
            return failure_of([&] { apply_setting(p, setting); }).code;
        };
        QCOMPARE(code("tolerance=1"), std::string("usage"));
        QCOMPARE(code("1.tolerance"), std::string("usage"));
        QCOMPARE(code("1.=3"), std::string("usage"));
        QCOMPARE(code(".tolerance=3"), std::string("usage"));
        QCOMPARE(code(""), std::string("usage"));
        QCOMPARE(code("Rough.tolerance=1"), std::string("missing_reference"));
        QCOMPARE(code("1.tolerence=1"), std::string("unknown_key"));
        QCOMPARE(code("1.kind=rough"), std::string("unknown_key"));
        QCOMPARE(code("1.tolerance=0"), std::string("out_of_range"));
        QCOMPARE(code("1.tolerance=nan"), std::string("wrong_type"));
        QCOMPARE(code("1.tolerance=1 in"), std::string("wrong_type"));
        QCOMPARE(code("1.stepover=0"), std::string("out_of_range"));
        QCOMPARE(project_to_json(p), before);
    }

    void programmatic_edits_are_checked() {
        const auto refused = [](const std::function<void(Project&)>& change) {
            Project p = parsed(contract_project);
            change(p);
            return failure_of([&] { check_project(p); }).where;
        };
        const double nan = std::numeric_limits<double>::quiet_NaN();
        QCOMPARE(refused([](Project&) {}), std::string());
        QCOMPARE(refused([&](Project& p) { p.operations[0]->common().feed = nan; }),
                 std::string("operations[0].feed"));
        QCOMPARE(refused([&](Project& p) { p.tools[0].diameter = nan; }), std::string("tools[0].diameter"));
        QCOMPARE(refused([&](Project& p) { p.part.translate[1] = nan; }), std::string("part.translate"));
        QCOMPARE(refused([&](Project& p) { p.stock.margin[1] = infinity; }), std::string("stock.margin"));
        QCOMPARE(refused([&](Project& p) { p.operations.push_back(p.operations[0]->clone()); }),
                 std::string("operations[1].name"));
        Project p = parsed(contract_project);
        p.stock.margin[0] = nan;
        QCOMPARE(failure_of([&] { project_to_json(p); }).where, std::string("stock.margin"));
    }

    void copies_are_independent() {
        const Project a = parsed(contract_project);
        Project b = a;
        b.operations[0]->common().tolerance = 1;
        b.tools[0].diameter = 3;
        QCOMPARE(a.operations[0]->common().tolerance, 0.004 * 25.4);
        QCOMPARE(a.tools[0].diameter, 12.7);
    }

    void every_kind_of_stock_is_kept() {
        const std::string box = R"({ "kind": "box", "margin": [0.5, 0.5, 0.25] })";
        const Project round = parsed(
            changed(box, R"({ "kind": "cylinder", "axis": "x", "diameter": 2, "margin": [0.5, 0, 0] })"));
        QVERIFY(round.stock.kind == StockSpec::Kind::cylinder && round.stock.axis == StockSpec::Axis::x);
        QCOMPARE(round.stock.diameter.number, 50.8);
        const Project fitting = parsed(changed(box, R"({ "kind": "cylinder" })"));
        QVERIFY(fitting.stock.diameter.is("auto") && fitting.stock.axis == StockSpec::Axis::z);
        const Project cast = parsed(changed(
            box,
            R"({ "kind": "mesh", "file": "raw/cast.stl", "rotate": [0, 0, 180], "translate": [1, 0, 0] })"));
        QCOMPARE(cast.stock.file, std::string("raw/cast.stl"));
        QVERIFY(cast.stock.unit == LengthUnit::inch); // as the project
        QCOMPARE(cast.stock.translate[0], 25.4);
        QVERIFY(parsed(changed(box, R"({ "kind": "mesh", "file": "x.stl", "units": "mm" })")).stock.unit
                == LengthUnit::mm);
        for (const Project* p : {&round, &fitting, &cast}) {
            const std::string once = project_to_json(*p);
            QCOMPARE(project_to_json(parsed(once)), once);
            // Only what says something of the kind.
            QStringList keys;
            const Json written = Json::parse(once);
            for (auto it = written["stock"].begin(); it != written["stock"].end(); ++it)
                keys << QString::fromStdString(it.key());
            QStringList known;
            for (const std::string& key : stock_keys(p->stock.kind))
                known << QString::fromStdString(key);
            keys.sort();
            known.sort();
            QCOMPARE(keys, known);
        }
    }

    void the_stock_is_found_after_a_move() {
        QTemporaryDir dir;
        const std::filesystem::path root = std::filesystem::canonical(dir.path().toStdString());
        for (const char* f : {"a", "a/raw", "b"})
            std::filesystem::create_directories(root / f);
        Project p = parsed(contract_project);
        p.path = root / "a" / "p.facetmill";
        QVERIFY(p.stock_path().empty());
        p.stock.kind = StockSpec::Kind::mesh;
        p.stock.file = "raw/cast.stl";
        QCOMPARE(p.stock_path(), root / "a/raw/cast.stl");
        save_project(p, root / "b" / "q.facetmill");
        const Project moved = load_project(root / "b" / "q.facetmill");
        QCOMPARE(moved.stock.file, std::string("../a/raw/cast.stl"));
        QCOMPARE(std::filesystem::weakly_canonical(moved.stock_path()), root / "a/raw/cast.stl");
    }

    void the_part_is_found_after_a_move() {
        QTemporaryDir dir;
        const std::filesystem::path root = std::filesystem::canonical(dir.path().toStdString());
        for (const char* f : {"a", "a/parts", "b"})
            std::filesystem::create_directories(root / f);
        Project p = parsed(changed("convex.stl", "parts/x.stl"));
        p.path = root / "a" / "p.facetmill";
        QCOMPARE(p.part_path(), root / "a/parts/x.stl");
        save_project(p, root / "b" / "q.facetmill");
        const Project moved = load_project(root / "b" / "q.facetmill");
        QCOMPARE(moved.part.file, std::string("../a/parts/x.stl"));
        QCOMPARE(std::filesystem::weakly_canonical(moved.part_path()), root / "a/parts/x.stl");
        QCOMPARE(p.part.file, std::string("parts/x.stl"));
        move_project(p, root / "a" / "other.facetmill");
        QCOMPARE(p.part.file, std::string("parts/x.stl"));
    }

    void a_new_project_suits_its_part() {
        for (LengthUnit unit : {LengthUnit::mm, LengthUnit::inch})
            for (double size : {0.05, 3.0, 80.0, 250.0, 5000.0, 9e6}) {
                Box3 box;
                box.add(Vec3(0, 0, 0));
                box.add(Vec3(size, 0.7 * size, 0.2 * size));
                const Project p = default_project("/parts/x.stl", unit, box);
                check_project(p);
                const Tool& tool = p.tool_of(*p.operations.at(0));
                // The smallest that is sold is wider than an eighth of the smallest parts.
                const double smallest = unit == LengthUnit::inch ? 25.4 / 32 : 0.5;
                QVERIFY(tool.diameter <= size / 8
                        || (std::abs(tool.diameter - smallest) < 1e-9 && tool.diameter <= 0.7 * size / 2.5));
                QVERIFY(size > 1000 || tool.diameter >= size / 60);
                const OperationCommon& c = p.operations[0]->common();
                QVERIFY(c.tolerance <= tool.diameter / 99 && c.tolerance >= tool.diameter / 2000);
                QVERIFY(c.clearance >= 1 - 1e-9 && c.clearance <= std::max(size / 10, 1.3));
                QCOMPARE(project_to_json(parsed(project_to_json(p))), project_to_json(p));
            }
        // A sheet without width, a point: still a project.
        Box3 flat;
        flat.add(Vec3(0, 0, 0));
        flat.add(Vec3(100, 0, 0));
        check_project(default_project("x.stl", LengthUnit::mm, flat));
        const Project p = default_project("x.stl", LengthUnit::mm, flat);
        QVERIFY(std::filesystem::path(p.part.file).is_absolute());
    }

    void a_machine_file_goes_with_the_project() {
        QTemporaryDir folder;
        const std::filesystem::path root = folder.path().toStdString();
        std::filesystem::create_directories(root / "a" / "machines");
        std::filesystem::create_directories(root / "b");
        const auto text = InputFile(test::data_path("../resources/machines/trunnion-ac.json"));
        OutputFile own(root / "a" / "machines" / "own.json");
        own.write(text.bytes());
        own.commit();
        Project p =
            parsed(changed("tarus-tpi-2000", "machines/own.json")); // has no place yet: not looked for
        QCOMPARE(p.machine, std::string("machines/own.json"));
        save_project(p, root / "a" / "p.facetmill");
        p = load_project(root / "a" / "p.facetmill");
        QCOMPARE(project_machine(p).label, find_machine("trunnion-ac").label);
        check_project(p);
        save_project(p, root / "b" / "p.facetmill");
        p = load_project(root / "b" / "p.facetmill");
        QCOMPARE(p.machine, std::string("../a/machines/own.json"));
        QCOMPARE(project_machine(p).rotary.size(), std::size_t(2));
        p.machine = "none.json";
        QCOMPARE(failure_of([&] { check_project(p); }).code, std::string("not_found"));
        OutputFile bad(root / "b" / "none.json");
        bad.write("{}");
        bad.commit();
        const Failure failure = failure_of([&] { check_project(p); });
        QCOMPARE(failure.code, std::string("missing_key"));
        QVERIFY2(failure.where.find("none.json: facetmill_machine") != std::string::npos,
                 failure.line.c_str());
    }
};

FACETMILL_TEST(TestProject)
#include "test_project.moc"
