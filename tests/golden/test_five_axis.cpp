// Five axes from the command line: reports, programs and configuration spaces, and what cannot be planned.
#include "tests/golden/run_cli.h"
#include "tests/support/test_runner.h"

#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTest>

#include <cmath>

using namespace facetmill;
using namespace facetmill::test;

namespace {

QByteArray facet(const QString& a, const QString& b, const QString& c) {
    return ("facet normal 0 0 0 outer loop vertex " + a + " vertex " + b + " vertex " + c
            + " endloop endfacet\n")
        .toUtf8();
}

/// A saddle over 24 x 16 mm as a sheet.
QByteArray saddle() {
    QByteArray text = "solid saddle\n";
    const auto at = [](int i, int k) {
        const double x = -12 + 2 * i, y = -8 + 2 * k;
        return QString("%1 %2 %3").arg(x).arg(y).arg(0.01 * (x * x - y * y), 0, 'f', 6);
    };
    for (int i = 0; i < 12; ++i)
        for (int k = 0; k < 8; ++k)
            text += facet(at(i, k), at(i + 1, k), at(i + 1, k + 1))
                    + facet(at(i, k), at(i + 1, k + 1), at(i, k + 1));
    return text + "endsolid saddle\n";
}

/// A sheet over 32 x 24 mm with a dent that a flat end of 8 mm enters at a large lead only.
QByteArray dent() {
    QByteArray text = "solid dent\n";
    const auto at = [](int i, int k) {
        const double x = -16 + i, y = -12 + k;
        return QString("%1 %2 %3").arg(x).arg(y).arg(-1.5 * std::exp(-(x * x + y * y) / 16), 0, 'f', 6);
    };
    for (int i = 0; i < 32; ++i)
        for (int k = 0; k < 24; ++k)
            text += facet(at(i, k), at(i + 1, k), at(i + 1, k + 1))
                    + facet(at(i, k), at(i + 1, k + 1), at(i, k + 1));
    return text + "endsolid dent\n";
}

/// A sheet that stands upright.
QByteArray wall() {
    return "solid wall\n" + facet("0 0 0", "20 0 0", "20 0 10") + facet("0 0 0", "20 0 10", "0 0 10")
           + "endsolid wall\n";
}

const char* const blade_project = R"({ "facetmill": 1, "units": "mm", "part": { "file": "part.stl" },
  "machine": "tarus-tpi-2000",
  "tools": [ { "number": 1, "name": "Flat", "diameter": 6, "corner_radius": 0, "flute_length": 20, "shank_diameter": 6,
               "shank_length": 20, "holder": [ { "diameter": 20, "length": 30 } ] },
             { "number": 2, "name": "Ball", "diameter": 6, "corner_radius": 3, "flute_length": 20, "shank_diameter": 6,
               "shank_length": 20 } ],
  "operations": [ { "kind": "finish5", "name": "Five", "tool": 1, "tolerance": 0.1, "direction": "x" },
                  { "kind": "finish3", "name": "Three", "tool": 2, "tolerance": 0.2, "stepover": 2 } ] })";

QByteArray changed_blade(const QByteArray& from, const QByteArray& to) {
    QByteArray text = blade_project;
    if (!text.contains(from)) qFatal("the test's text is not in the project");
    return text.replace(from, to);
}

Sandbox& prepared_blade(Sandbox& s, const QByteArray& project = blade_project) {
    s.write("part.stl", saddle());
    s.write("wall.stl", wall());
    s.write("job.facetmill", project);
    return s;
}

/// A machine with a head of two axes, whose Z ends at `top` mm above the part's bottom.
QByteArray own_machine(double top) {
    return QString(R"({ "facetmill_machine": 1, "label": "Own", "units": "mm", "axes": [
        { "name": "X", "kind": "linear", "speed": 170 },
        { "name": "Y", "kind": "linear", "speed": 180 },
        { "name": "Z", "kind": "linear", "speed": 240, "travel": [-1000, %1] },
        { "name": "C", "kind": "rotary", "carries": "tool", "direction": [0, 0, 1], "point": [0, 0, 0], "sign": 1, "travel": [-360, 360], "speed": 17 },
        { "name": "A", "kind": "rotary", "carries": "tool", "direction": [1, 0, 0], "point": [0, 0, 0], "sign": 1, "travel": [-110, 110], "speed": 28 } ] })")
        .arg(top)
        .toUtf8();
}

} // namespace

class TestFiveAxis : public QObject {
    Q_OBJECT
private slots:
    /// Two programs of two tools, one entry in the report; both are verified together, and regions are shown.
    void global_local_writes_a_main_and_a_rework_program() {
        Sandbox s;
        s.write("dent.stl", dent());
        s.write("job.facetmill", R"({ "facetmill": 1, "units": "mm", "part": { "file": "dent.stl" },
  "machine": "tarus-tpi-2000",
  "tools": [ { "number": 1, "name": "Flat", "diameter": 8, "corner_radius": 0, "flute_length": 25, "shank_diameter": 8,
               "shank_length": 20 },
             { "number": 7, "name": "Ball", "diameter": 3, "corner_radius": 1.5, "flute_length": 25, "shank_diameter": 3,
               "shank_length": 20 } ],
  "operations": [ { "kind": "global_local", "name": "GL", "tool": 1, "rework_tool": 7, "tolerance": 0.1, "direction": "x",
                    "lead_limit": 6, "raise_lead_limit": false, "rework_offset": 1, "posture": "cm2" },
                  { "kind": "finish3", "name": "After", "tool": 7, "tolerance": 0.5 } ] })");
        const CliRun run = run_cli({"plan", "job.facetmill", "-o", "out"}, s.path());
        QVERIFY2(run.status == 0, run.err);
        QCOMPARE(s.files("out"),
                 (QStringList{"01-GL-rework.apt", "01-GL.apt", "02-After.apt", "report.json"}));
        const QJsonArray operations = json(run.out)["operations"].toArray();
        QCOMPARE(operations.size(), 2);
        const QJsonObject gl = operations[0].toObject();
        QCOMPARE(operations[1].toObject()["name"].toString(), QString("After"));
        QCOMPARE(gl["rework_regions"].toInt(), 1);
        const QJsonObject region = gl["regions"].toArray()[0].toObject();
        QVERIFY(region["area"].toDouble() > 20 && region["area"].toDouble() < 300);
        QCOMPARE(region["tool"].toInt(), 7);
        QVERIFY(region["enabled"].toBool() && !region["reason"].toString().isEmpty());
        const QJsonObject main = gl["main"].toObject(), rework = gl["rework"].toObject();
        for (const char* key : {"time_seconds", "cut_length", "rapid_length"})
            QVERIFY2(std::abs(gl[key].toDouble() - main[key].toDouble() - rework[key].toDouble())
                         <= 1e-6 * gl[key].toDouble(),
                     key);
        QCOMPARE(main["tool"].toInt(), 1);
        QVERIFY(gl["lead_degrees"].toArray()[1].toDouble() <= 6 + 1e-6);
        QVERIFY(gl["remaining_fraction"].toDouble() < 1e-3);
        QVERIFY(bytes_of(s.path() + "/out/01-GL.apt").contains("LOADTL/1\n"));
        QVERIFY(bytes_of(s.path() + "/out/01-GL-rework.apt").contains("LOADTL/7\n"));

        const CliRun both = run_cli({"simulate", "job.facetmill", "-o", "sim", "--op", "GL"}, s.path());
        QVERIFY2(both.status == 0, both.err);
        const QJsonObject verdict = json(bytes_of(s.path() + "/sim/verify.json"));
        QCOMPARE(verdict["uncut_fraction"].toDouble(-1), 0.0);
        QCOMPARE(verdict["operations"].toArray().size(), 2);
#ifdef FACETMILL_HAS_PICTURES
        const CliRun picture =
            run_cli({"render", "job.facetmill", "--op", "GL", "--show", "part,strips", "-o", "regions.png"},
                    s.path());
        QVERIFY2(picture.status == 0, picture.err);
        QVERIFY(bytes_of(s.path() + "/regions.png").size() > 10000);
#endif
        // What is edited by hand is kept, and counts.
        const QByteArray off =
            bytes_of(s.path() + "/job.facetmill")
                .replace("\"lead_limit\": 6,", "\"lead_limit\": 6, \"region_edits\": [ { "
                                               "\"place\": [0, 0, -1.5], \"enabled\": false } ],");
        s.write("job.facetmill", off);
        const CliRun without = run_cli({"plan", "job.facetmill", "-o", "off", "--op", "GL"}, s.path());
        QVERIFY2(without.status == 0, without.err);
        QCOMPARE(s.files("off"), (QStringList{"01-GL.apt", "report.json"}));
        QVERIFY(!json(without.out)["operations"]
                     .toArray()[0]
                     .toObject()["regions"]
                     .toArray()[0]
                     .toObject()["enabled"]
                     .toBool(true));
    }

    void the_report_has_the_keys_of_five_axes() {
        Sandbox s;
        prepared_blade(s);
        const CliRun run = run_cli({"plan", "job.facetmill", "-o", "out"}, s.path());
        QVERIFY2(run.status == 0, run.err);
        QCOMPARE(s.files("out"), (QStringList{"01-Five.apt", "02-Three.apt", "report.json"}));
        const QJsonArray operations = json(run.out)["operations"].toArray();
        const QJsonObject five = operations[0].toObject(), three = operations[1].toObject();
        const QStringList own = {"seconds_by_stage", "lead_degrees", "joint_reversals",
                                 "largest_angular_rate_degrees_per_second", "machine_findings"};
        for (const QString& key : own)
            QVERIFY2(five.contains(key) && !three.contains(key), qPrintable(key));
        for (const QString& key : three.keys())
            QVERIFY2(five.contains(key), qPrintable(key));
        double seconds = 0;
        for (const char* stage : {"cc", "bottom", "top", "choose"}) {
            const double one = five["seconds_by_stage"][stage].toDouble(-1);
            QVERIFY2(one >= 0, stage);
            seconds += one;
        }
        QCOMPARE(five["seconds_by_stage"].toObject().size(), 4);
        QVERIFY(seconds > 0 && seconds <= five["seconds_planning"].toDouble());
        const QJsonArray leads = five["lead_degrees"].toArray();
        QCOMPARE(leads.size(), 2);
        QVERIFY(leads[0].toDouble() >= 0 && leads[0].toDouble() <= leads[1].toDouble()
                && leads[1].toDouble() <= 45);
        const QJsonObject reversals = five["joint_reversals"].toObject();
        for (const char* joint : {"X", "Y", "Z", "C", "A"})
            QVERIFY2(reversals[joint].toInt(-1) >= 0, joint);
        // Neighbouring passes run to and fro.
        QVERIFY(reversals["X"].toInt() >= five["passes"].toInt() - 1);
        // What its axes can do at most: 0.5 rad/s.
        QVERIFY(five["largest_angular_rate_degrees_per_second"].toDouble() > 0);
        QVERIFY(five["largest_angular_rate_degrees_per_second"].toDouble() < 28.65);
        QCOMPARE(five["machine_findings"].toInt(-1), 0);
        QVERIFY(five["cusp_max"].toDouble() > 0 && five["cusp_max"].toDouble() <= 0.1 + 1e-12);
        QCOMPARE(five["cleanup_points"].toInt(-1), 0);
        QVERIFY(five["time_seconds"].toDouble() > five["cut_length"].toDouble() / 1000 * 60 - 1e-6);
    }

    void the_program_turns_its_axis() {
        Sandbox s;
        prepared_blade(s);
        const CliRun run = run_cli({"plan", "job.facetmill", "-o", "out", "--op", "Five"}, s.path());
        QVERIFY2(run.status == 0, run.err);
        QCOMPARE(s.files("out"), (QStringList{"01-Five.apt", "report.json"}));
        const QList<QByteArray> lines = bytes_of(s.path() + "/out/01-Five.apt").split('\n');
        int places = 0, tilted = 0, on = -1, rapids = 0;
        for (int i = 0; i < lines.size(); ++i) {
            QByteArray line = lines[i].trimmed();
            QVERIFY(line.size() <= 72);
            if (line == "MULTAX/ON") on = i;
            rapids += line == "RAPID";
            if (!line.startsWith("GOTO/")) continue;
            while (line.endsWith('$'))
                line = line.chopped(1).trimmed() + lines[++i].trimmed();
            QVERIFY2(on >= 0, "a GOTO before MULTAX/ON");
            ++places;
            const QList<QByteArray> numbers = line.mid(5).split(',');
            QCOMPARE(numbers.size(), 6);
            double square = 0;
            for (int k = 3; k < 6; ++k)
                square += std::pow(numbers[k].toDouble(), 2);
            QVERIFY(std::abs(square - 1) < 1e-6);
            QVERIFY(numbers[5].toDouble() > 0.7);
            tilted += numbers[5].toDouble() < 0.9999;
        }
        QVERIFY(rapids >= 1);
        const int cl = json(run.out)["operations"][0]["cl_points"].toInt();
        QVERIFY(cl > 50 && places > cl); // and the way there and back
        QVERIFY(tilted > cl / 2);
    }

    void a_point_has_its_configuration_space() {
        Sandbox s;
        prepared_blade(s);
        const CliRun run =
            run_cli({"cspace", "job.facetmill", "--op", "Five", "--point", "7", "-o", "c.json"}, s.path());
        QVERIFY2(run.status == 0, run.err);
        QCOMPARE(bytes_of(s.path() + "/c.json"), run.out);
        const QJsonObject o = json(run.out);
        QCOMPARE(o["point"].toInt(), 7);
        const QJsonArray lead = o["lambda_deg"].toArray(), yaw = o["omega_deg"].toArray();
        QVERIFY(std::abs(lead.first().toDouble()) < 1e-9 && std::abs(lead.last().toDouble() - 45) < 1e-9);
        QVERIFY(std::abs(yaw.first().toDouble() + 45) < 1e-9 && std::abs(yaw.last().toDouble() - 45) < 1e-9);
        int free = 0;
        for (int l = 0; l < lead.size(); ++l)
            for (int w = 0; w < yaw.size(); ++w) {
                const QJsonValue bottom = o["delta_bottom"][l][w], top = o["delta_top"][l][w];
                const QString why = o["blocked"][l][w].toString();
                QVERIFY(QStringList({"free", "local", "global", "shank", "holder", "lift", "machine"})
                            .contains(why));
                if (why != "free") continue;
                ++free;
                QVERIFY(bottom.isDouble() && bottom.toDouble() >= 0);
                QVERIFY(top.isNull() || top.toDouble() >= bottom.toDouble());
            }
        QVERIFY(free > 0);
        for (const char* grid : {"delta_bottom", "delta_top", "blocked"}) {
            QCOMPARE(o[grid].toArray().size(), lead.size());
            QCOMPARE(o[grid][0].toArray().size(), yaw.size());
        }
        for (const char* method : {"cm2", "local", "global", "planned"})
            QVERIFY2(o["chosen"][method]["free"].isBool(), method);
        QCOMPARE(o["chosen"]["planned"]["free"].toBool(), true);
    }

    void no_configuration_space_is_an_error_data() {
        QTest::addColumn<QString>("line");
        QTest::addColumn<int>("status");
        QTest::addColumn<QByteArray>("said");
        const auto row = [](const char* line, int status, const char* said) {
            QTest::newRow(line) << QString(line) << status << QByteArray(said);
        };
        row("--op Five --point 99999", 1, "99999");
        row("--op Three --point 0", 1, "finish5");
        row("--op Four --point 0", 1, "Four");
        row("--point 0", 2, "--op");
        row("--op Five", 2, "--point");
        row("--op Five --point -1", 2, "--point");
        row("--op Five --point 1.5", 2, "--point");
        row("--op Five --point 99999999999999999999999", 2, "--point");
        row("--op Five --point x", 2, "--point");
    }
    void no_configuration_space_is_an_error() {
        QFETCH(QString, line);
        QFETCH(int, status);
        QFETCH(QByteArray, said);
        Sandbox s;
        prepared_blade(s);
        const QStringList before = s.files();
        const CliRun run =
            run_cli(QStringList{"cspace", "job.facetmill", "-o", "c.json"} + line.split(' '), s.path());
        QVERIFY2(run.status == status, run.err);
        QVERIFY2(run.err.contains(said), run.err);
        QVERIFY(run.out.isEmpty());
        QCOMPARE(s.files(), before);
    }

    void what_cannot_be_planned_is_told_data() {
        QTest::addColumn<QByteArray>("project");
        QTest::addColumn<QByteArray>("code");
        QTest::addColumn<QByteArray>("said");
        const auto row = [](const char* name, const char* code, const char* said, const QByteArray& project) {
            QTest::newRow(name) << project << QByteArray(code) << QByteArray(said);
        };
        const QByteArray key = "\"direction\": \"x\"";
        const auto with = [&](const QByteArray& more) { return changed_blade(key, key + ", " + more); };
        const char* none = "empty_result";
        row("lead limits reversed", "out_of_range", "lead_limits", with("\"lead_limits\": [45, 0]"));
        row("lead limits equal", "out_of_range", "lead_limits", with("\"lead_limits\": [20, 20]"));
        row("lead limits too large", "out_of_range", "lead_limits", with("\"lead_limits\": [0, 90]"));
        row("yaw limits reversed", "out_of_range", "yaw_limits", with("\"yaw_limits\": [45, -45]"));
        row("grid of 0", "out_of_range", "grid_degrees", with("\"grid_degrees\": 0"));
        row("unknown posture", "out_of_range", "posture", with("\"posture\": \"best\""));
        row("nothing from above", none, "from above",
            with("\"sides\": \"top\"").replace("part.stl", "wall.stl"));
        row("holder everywhere", none, "would hit the part",
            changed_blade("\"tool\": 1", "\"tool\": 1, \"holder_clearance\": 500"));
        row("machine without rotary axes", none, "machine",
            changed_blade("tarus-tpi-2000", "generic-3-axis"));
        row("machine that cannot reach", none, "machine", changed_blade("tarus-tpi-2000", "own.json"));
        row("no such machine", "missing_reference", "machine", changed_blade("tarus-tpi-2000", "tarus"));
        row("no such machine file", "not_found", "none.json", changed_blade("tarus-tpi-2000", "none.json"));
    }
    void what_cannot_be_planned_is_told() {
        QFETCH(QByteArray, project);
        QFETCH(QByteArray, code);
        QFETCH(QByteArray, said);
        Sandbox s;
        prepared_blade(s, project);
        s.write("own.json", own_machine(20)); // hardly longer than the flutes
        const QStringList before = s.files();
        const CliRun run = run_cli({"plan", "job.facetmill", "-o", "out", "--op", "Five"}, s.path());
        QVERIFY2(run.status == 1, run.err);
        QVERIFY2(run.code() == code, run.err);
        QVERIFY2(run.err_lines() == 1 && run.err.endsWith(")\n"), run.err);
        QVERIFY2(run.err.contains(said), run.err);
        QVERIFY(run.out.isEmpty());
        QCOMPARE(s.files(), before);
    }

    /// The surface lies within the machine's travel, the clearance above it does not.
    void a_machine_that_does_not_hold_the_program_is_told() {
        Sandbox s;
        prepared_blade(s, changed_blade("tarus-tpi-2000", "own.json"));
        s.write("own.json", own_machine(76));
        const CliRun run = run_cli({"plan", "job.facetmill", "-o", "out", "--op", "Five"}, s.path());
        QVERIFY2(run.status == 1 && run.code() == "limit_exceeded", run.err);
        QVERIFY2(run.err.contains("Own cannot make") && run.err.contains("Z ends"), run.err);
        QVERIFY(s.files("out").isEmpty());
    }
};

FACETMILL_TEST(TestFiveAxis)
#include "test_five_axis.moc"
