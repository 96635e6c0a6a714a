// Machine files: what is refused, and what the error says.
#include "core/base/error.h"
#include "core/base/strict_json.h"
#include "core/setup/machine.h"
#include "tests/support/test_runner.h"

#include <QTest>

#include <cmath>

using namespace facetmill;

namespace {

const std::string good = R"({ "facetmill_machine": 1, "label": "Mine", "units": "mm", "table": [1, 2, 3],
  "axes": [ { "name": "X", "kind": "linear", "travel": [-10, 30], "speed": 100, "acceleration": 500 },
            { "name": "Y", "kind": "linear", "speed": 100 },
            { "name": "Z", "kind": "linear", "speed": 50 },
            { "name": "A", "kind": "rotary", "carries": "table", "direction": [2, 0, 0], "point": [0, 0, 50], "sign": -1,
              "travel": [-90, 45], "speed": 90, "acceleration": 180 },
            { "name": "C", "kind": "rotary", "carries": "table", "direction": [0, 0, 1], "point": [5, 6, 0], "speed": 180 } ] })";

/// The good file with `from` replaced once.
std::string with(const std::string& from, const std::string& to) {
    std::string text = good;
    const std::size_t at = text.find(from);
    if (at == std::string::npos) throw std::logic_error("no '" + from + "' in the file");
    return text.replace(at, from.size(), to);
}

} // namespace

class TestMachineFiles : public QObject {
    Q_OBJECT
private slots:

    void a_file_is_read() {
        const Machine m = parse_machine(good, "mine.json");
        QCOMPARE(m.label, std::string("Mine"));
        QCOMPARE(machine_kind(m), std::string("5-axis, table-table"));
        QCOMPARE(m.table, Vec3(1, 2, 3));
        QCOMPARE(m.rapid_mm_per_s, Vec3(100, 100, 50));
        QCOMPARE(m.acceleration(0), 500.0);
        QVERIFY(std::isinf(m.acceleration(1)) && !m.joint_travel(1).limited());
        QCOMPARE(m.travel[0].lo, -10.0);
        QCOMPARE(m.travel[0].hi, 30.0);
        QCOMPARE(m.rotary[0].direction, Vec3(1, 0, 0));
        QCOMPARE(m.rotary[0].sign, -1.0);
        QCOMPARE(m.rotary[0].travel.lo, -pi / 2);
        QCOMPARE(m.rotary[0].travel.hi, pi / 4);
        QCOMPARE(m.speed(3), pi / 2);
        QCOMPARE(m.acceleration(3), pi);
        QCOMPARE(m.rotary[1].sign, 1.0);
        // Without a place of its own the part stands on the table that turns about Z.
        QCOMPARE(parse_machine(with("\"table\": [1, 2, 3],", ""), "mine.json").table, Vec3(5, 6, 0));
    }

    void inches_are_inches() {
        const Machine m = parse_machine(with("\"mm\"", "\"in\""), "mine.json");
        QCOMPARE(m.rapid_mm_per_s, Vec3(2540, 2540, 1270));
        QCOMPARE(m.travel[0].lo, -254.0);
        QCOMPARE(m.acceleration(0), 12700.0);
        QVERIFY(m.table.isApprox(Vec3(25.4, 50.8, 76.2), 1e-15));
        QCOMPARE(m.rotary[0].point, Vec3(0, 0, 1270));
        QCOMPARE(m.speed(3), pi / 2);
    }

    void bad_files_are_refused_data() {
        QTest::addColumn<QString>("file");
        QTest::addColumn<QString>("code");
        QTest::addColumn<QString>("place");
        const auto row = [](const char* name, const std::string& file, const char* code, const char* place) {
            QTest::newRow(name) << QString::fromStdString(file) << code << place;
        };
        row("not json", "{", "truncated", "mine.json:1");
        row("no object", "[1]", "wrong_type", "mine.json");
        row("nan", with("\"speed\": 50", "\"speed\": NaN"), "syntax", "mine.json:4");
        row("huge", with("\"speed\": 50", "\"speed\": 1e999"), "out_of_range", "mine.json:4");
        row("large", with("\"speed\": 50", "\"speed\": 1e200"), "out_of_range", "axes[2].speed");
        row("no version", with("\"facetmill_machine\": 1,", ""), "missing_key", "facetmill_machine");
        row("new version", with("machine\": 1", "machine\": 2"), "newer_version", "facetmill_machine");
        row("version 0", with("machine\": 1", "machine\": 0"), "out_of_range", "facetmill_machine");
        row("version text", with("machine\": 1", "machine\": \"1\""), "wrong_type", "facetmill_machine");
        row("no units", with("\"units\": \"mm\",", ""), "missing_key", "units");
        row("cm", with("\"mm\"", "\"cm\""), "out_of_range", "units");
        row("no label", with("\"label\": \"Mine\",", ""), "missing_key", "label");
        row("empty label", with("Mine", ""), "out_of_range", "label");
        row("unknown key", with("\"table\"", "\"tabel\""), "unknown_key", "mine.json: tabel");
        row("unknown axis key", with("\"speed\": 50", "\"speed\": 50, \"sped\": 1"), "unknown_key",
            "axes[2].sped");
        row("rotary key of a linear axis", with("\"speed\": 50", "\"speed\": 50, \"sign\": 1"), "unknown_key",
            "axes[2].sign");
        row("no axes", with("\"axes\"", "\"axis\""), "missing_key", "axes");
        row("axes object", R"({"facetmill_machine": 1, "label": "a", "units": "mm", "axes": {}})",
            "wrong_type", "axes");
        row("axes empty", R"({"facetmill_machine": 1, "label": "a", "units": "mm", "axes": []})",
            "missing_key", "axes");
        row("axis text", with("{ \"name\": \"Y\", \"kind\": \"linear\", \"speed\": 100 }", "\"Y\""),
            "wrong_type", "axes[1]");
        row("twice X", with("\"Y\"", "\"X\""), "out_of_range", "axes[1].name");
        row("linear A", with("\"Y\"", "\"A\""), "out_of_range", "axes[1].name");
        row("no kind", with("\"name\": \"Y\", \"kind\": \"linear\"", "\"name\": \"Y\""), "missing_key",
            "axes[1].kind");
        row("bad kind", with("linear", "lineal"), "out_of_range", "axes[0].kind");
        row("speed 0", with("\"speed\": 50", "\"speed\": 0"), "out_of_range", "axes[2].speed");
        row("speed < 0", with("\"speed\": 180", "\"speed\": -180"), "out_of_range", "axes[4].speed");
        row("no speed", with(", \"speed\": 50", ""), "missing_key", "axes[2].speed");
        row("speed text", with("\"speed\": 50", "\"speed\": \"50\""), "wrong_type", "axes[2].speed");
        row("acceleration 0", with("\"acceleration\": 500", "\"acceleration\": 0"), "out_of_range",
            "axes[0].acceleration");
        row("travel reversed", with("[-10, 30]", "[30, -10]"), "out_of_range", "axes[0].travel");
        row("travel none", with("[-10, 30]", "[30, 30]"), "out_of_range", "axes[0].travel");
        row("travel rotary reversed", with("[-90, 45]", "[45, -90]"), "out_of_range", "axes[3].travel");
        row("travel one", with("[-10, 30]", "[30]"), "wrong_type", "axes[0].travel");
        row("travel null", with("[-10, 30]", "[null, 30]"), "wrong_type", "axes[0].travel[0]");
        row("travel number", with("[-10, 30]", "30"), "wrong_type", "axes[0].travel");
        row("direction 0", with("[2, 0, 0]", "[0, 0, 0]"), "out_of_range", "axes[3].direction");
        row("A about Y", with("[2, 0, 0]", "[0, 1, 0]"), "out_of_range", "axes[3].direction");
        row("no direction", with("\"direction\": [2, 0, 0], ", ""), "missing_key", "axes[3].direction");
        row("no carries", with("\"carries\": \"table\", \"direction\": [2", "\"direction\": [2"),
            "missing_key", "axes[3].carries");
        row("bad carries", with("\"table\", \"direction\"", "\"part\", \"direction\""), "out_of_range",
            "axes[3].carries");
        row("sign 0", with("\"sign\": -1", "\"sign\": 0"), "out_of_range", "axes[3].sign");
        row("sign text", with("\"sign\": -1", "\"sign\": \"-\""), "wrong_type", "axes[3].sign");
        row("two A", with("\"name\": \"C\"", "\"name\": \"A\""), "out_of_range", "axes[4].direction");
        row("two A inclined",
            with("\"name\": \"C\", \"kind\": \"rotary\", \"carries\": \"table\", \"direction\": [0, 0, 1]",
                 "\"name\": \"A\", \"kind\": \"rotary\", \"carries\": \"table\", \"direction\": [0, 1, 1]"),
            "out_of_range", "axes[4]");
        row("parallel", with("\"direction\": [2, 0, 0]", "\"direction\": [0, 1e-9, 1]"), "out_of_range",
            "axes[3].direction");
        row("third", with("\"speed\": 180 }", "\"speed\": 180 }, { \"name\": \"B\", \"kind\": \"rotary\" }"),
            "out_of_range", "axes[5]");
        row("table 2", with("[1, 2, 3]", "[1, 2]"), "wrong_type", "table");
        row("table huge", with("[1, 2, 3]", "[1, 2, 1e30]"), "out_of_range", "table[2]");
        row("description list", with("\"units\"", "\"description\": [], \"units\""), "wrong_type",
            "description");
        // Chains that incline nothing: C next to the tool, as the inner axis of a head or the outer one of a
        // table.
        const std::string linear = R"({"facetmill_machine": 1, "label": "a", "units": "mm", "axes": [
            {"name": "X", "kind": "linear", "speed": 1}, {"name": "Y", "kind": "linear", "speed": 1},
            {"name": "Z", "kind": "linear", "speed": 1}, )";
        const auto rotary = [](const char* name, const char* carries, const char* direction) {
            return std::string("{\"kind\": \"rotary\", \"speed\": 1, \"name\": \"") + name
                   + "\", \"carries\": \"" + carries + "\", \"direction\": " + direction + "}";
        };
        row("C alone", linear + rotary("C", "table", "[0, 0, 1]") + "]}", "out_of_range", "axes[3]");
        row("head A C",
            linear + rotary("A", "tool", "[1, 0, 0]") + "," + rotary("C", "tool", "[0, 0, 1]") + "]}",
            "out_of_range", "axes[4]");
        row("table C A",
            linear + rotary("C", "table", "[0, 0, 1]") + "," + rotary("A", "table", "[1, 0, 0]") + "]}",
            "out_of_range", "axes[3]");
        row("head C table A",
            linear + rotary("C", "tool", "[0, 0, -1]") + "," + rotary("A", "table", "[1, 0, 0]") + "]}",
            "out_of_range", "axes[3]");
        row("parallel inclined",
            linear + rotary("A", "tool", "[1, 1, 0]") + "," + rotary("B", "table", "[-1, -1, 0]") + "]}",
            "out_of_range", "axes[4]");
    }
    void bad_files_are_refused() {
        QFETCH(QString, file);
        QFETCH(QString, code);
        QFETCH(QString, place);
        try {
            parse_machine(file.toStdString(), "mine.json");
            QFAIL("read");
        } catch (const Error& e) {
            QCOMPARE(QString::fromUtf8(code_name(e.code()).data()), code);
            QVERIFY2(QString::fromStdString(e.where()).startsWith("mine.json"), e.what());
            QVERIFY2(QString::fromStdString(e.where()).contains(place), e.what());
            QVERIFY2(!e.remedy().empty(), e.what());
        }
    }

    void a_name_or_a_file() {
        QVERIFY(is_machine_file("machines/mine.json"));
        QVERIFY(!is_machine_file("tarus-tpi-2000"));
        QVERIFY_THROWS_EXCEPTION(Error, load_machine(test::data_path("no/such.json")));
        const Machine m = load_machine(test::data_path("../resources/machines/trunnion-ac.json"));
        QCOMPARE(m.source, find_machine("trunnion-ac").source);
        for (const Machine& known : machines())
            QVERIFY2(machine_kind(known).size() > 5 && !known.description.empty(), known.name.c_str());
    }
};

FACETMILL_TEST(TestMachineFiles)
#include "test_machine_files.moc"
