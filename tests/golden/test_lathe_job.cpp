// Turned parts through the program's own door: plan, tables of positions, report, and the verifier's
// judgement of roughing and finishing together.
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

const char* const lathe_project =
    R"({ "facetmill": 1, "units": "mm", "part": { "file": "PART.stl", "units": "mm" },
  "stock": { "kind": "cylinder", "axis": "x", "margin": [0, 1, 1] }, "machine": "lathe-mill",
  "tools": [ { "number": 1, "name": "Ball 8", "diameter": 8, "corner_radius": 4, "flute_length": 30,
               "shank_diameter": 8, "shank_length": 30, "holder": [ { "diameter": 40, "length": 30 } ] },
             { "number": 2, "name": "Ball 3.175", "diameter": 3.175, "corner_radius": 1.5875, "flute_length": 20,
               "shank_diameter": 3.175, "shank_length": 30 } ],
  "operations": [
    { "kind": "lathe_rough", "name": "Rough", "tool": 1, "tolerance": 0.8, "depth_of_cut": 4,
      "finishing_allowance": 0.5 },
    { "kind": "lathe_finish", "name": "Finish", "tool": 2, "tolerance": 0.3 } ] })";

/// Numbers of a table, three a line.
std::vector<std::array<double, 3>> rows_of(const QByteArray& text) {
    std::vector<std::array<double, 3>> rows;
    for (const QByteArray& line : text.split('\n')) {
        if (line.isEmpty() || line.startsWith('#')) continue;
        const QList<QByteArray> fields = line.split(' ');
        if (fields.size() != 3) return {};
        rows.push_back({fields[0].toDouble(), fields[1].toDouble(), fields[2].toDouble()});
    }
    return rows;
}

} // namespace

class TestLatheJob : public QObject {
    Q_OBJECT
private slots:
    void turned_samples_are_cut_to_tolerance_data() {
        QTest::addColumn<QString>("part");
        for (const char* part : {"twisted-prism", "extruded-pattern", "swept-pattern"})
            QTest::newRow(part) << part;
    }

    /// Gouge 0 (within the chord tolerance), cusps within the tolerance, nothing uncut.
    void turned_samples_are_cut_to_tolerance() {
        QFETCH(QString, part);
        CliRun run = run_cli({"sample", part, "--tolerance", "0.01", "-o", part + ".stl"}, sandbox_.path());
        QVERIFY2(run.status == 0, run.err);
        const QString job = part + ".facetmill";
        sandbox_.write(job, QByteArray(lathe_project).replace("PART", part.toUtf8()));
        run = run_cli({"simulate", job, "--resolution", "0.79", "--spacing", "0.79", "-o", "verified"},
                      sandbox_.path());
        QVERIFY2(run.status == 0, run.err);
        const QJsonObject v = json(run.out);
        QCOMPARE(v["verdict"].toString(), QString("verified"));
        QVERIFY(v["collisions"].toArray().isEmpty());
        QVERIFY2(v["gouge_max"].toDouble() <= 0.05 * 0.3 + 1e-9, run.out);
        QVERIFY2(v["excess_max"].toDouble() <= 1.03 * 0.3,
                 qPrintable(QString::number(v["excess_max"].toDouble())));
        QCOMPARE(v["uncut_fraction"].toDouble(), 0.0);
    }

    void the_report_and_the_tables_are_there() {
        QVERIFY(run_cli({"sample", "square-prism", "-o", "square-prism.stl"}, sandbox_.path()).status == 0);
        sandbox_.write("prism.facetmill", QByteArray(lathe_project).replace("PART", "square-prism"));
        const QStringList coarse{"--set", "Finish.points_per_turn=720", "--set", "Finish.side_feed=2",
                                 "--set", "Finish.tolerance=0.5"};
        CliRun run = run_cli(QStringList{"plan", "prism.facetmill", "-o", "prism"} + coarse, sandbox_.path());
        QVERIFY2(run.status == 0, run.err);
        const QJsonArray operations = json(run.out)["operations"].toArray();
        QCOMPARE(operations.size(), 2);
        const QJsonObject rough = operations[0].toObject(), finish = operations[1].toObject();
        for (const QJsonObject& o : {rough, finish}) {
            for (const char* key :
                 {"passes", "stepover_min", "stepover_max", "cc_points", "cl_points", "cut_length",
                  "rapid_length", "time_seconds", "cusp_max", "seconds_planning"})
                QVERIFY2(o[key].isDouble(), key);
            QCOMPARE(o["machine_findings"].toInt(), 0);
            QVERIFY2(o["warnings"].toArray().isEmpty(),
                     qPrintable(o["warnings"].toArray().isEmpty() ? QString()
                                                                  : o["warnings"].toArray()[0].toString()));
            const QJsonObject turning = o["turning"].toObject();
            QVERIFY(std::abs(turning["part_diameter"].toDouble() - 50 * std::sqrt(2.0)) < 1e-3);
            QCOMPARE(turning["axis_direction"].toArray()[0].toDouble(), 1.0);
        }
        // 36.36 of stock down to 25 + 0.5: three passes of 4, and one table of each.
        QCOMPARE(rough["layers"].toInt(), 3);
        double last = 1e9;
        for (const char* file : {"/01-Rough-pass-01.txt", "/01-Rough-pass-02.txt", "/01-Rough-pass-03.txt"}) {
            const auto rows = rows_of(bytes_of(sandbox_.path() + "/prism" + file));
            QVERIFY(rows.size() > 1000);
            double least = 1e9;
            for (const auto& row : rows)
                least = std::min(least, row[2]);
            QVERIFY(least < last && least > 25.49);
            last = least;
            // Begins and ends outside of the stock.
            QVERIFY(rows.front()[2] > 36.4 && rows.back()[2] > 36.4);
        }
        const QByteArray table = bytes_of(sandbox_.path() + "/prism/02-Finish.txt");
        const auto rows = rows_of(table);
        QCOMPARE(rows.size(),
                 std::size_t(bytes_of(sandbox_.path() + "/prism/02-Finish.apt").count("\nGOTO/")));
        // Unwound: it grows turn after turn, 1 + 20 + 1 of them.
        for (std::size_t i = 1; i < rows.size(); ++i)
            QVERIFY(rows[i][0] >= rows[i - 1][0] - 1e-6 && rows[i][0] - rows[i - 1][0] < 1);
        QVERIFY(std::abs(rows.back()[0] - rows.front()[0] - 22 * 360) < 1e-3);
        // Jasra's exact answer on the flats: half the side over the cosine, for the ball's centre.
        std::size_t on_flats = 0;
        for (const auto& row : rows) {
            const double off = std::remainder(row[0], 90.0) * M_PI / 180;
            if (row[2] > 29.5 || std::abs((25 + 1.5875) * std::tan(off)) > 25) continue;
            QVERIFY(std::abs(row[2] - ((25 + 1.5875) / std::cos(off) - 1.5875)) < 0.026 + 1e-6);
            ++on_flats;
        }
        QVERIFY(on_flats > 1000);
        run = run_cli(QStringList{"plan", "prism.facetmill", "--op", "Finish", "-o", "modulo", "--set",
                                  "Finish.winding=modulo"}
                          + coarse,
                      sandbox_.path());
        QVERIFY2(run.status == 0, run.err);
        const auto modulo = rows_of(bytes_of(sandbox_.path() + "/modulo/02-Finish.txt"));
        QCOMPARE(modulo.size(), rows.size());
        for (std::size_t i = 0; i < rows.size(); ++i) {
            QVERIFY(modulo[i][0] >= 0 && modulo[i][0] < 360);
            QVERIFY(std::abs(std::remainder(modulo[i][0] - rows[i][0], 360.0)) < 1e-5);
            QVERIFY(modulo[i][1] == rows[i][1] && modulo[i][2] == rows[i][2]);
        }
    }

    /// The program itself is right, too, for a reader that knows nothing of a turning part.
    void its_own_program_is_verified() {
        CliRun run = run_cli({"plan", "prism.facetmill", "-o", "own"}, sandbox_.path());
        QVERIFY2(run.status == 0, run.err);
        run = run_cli({"simulate", "prism.facetmill", "--cl", "own/01-Rough.apt", "--cl", "own/02-Finish.apt",
                       "--resolution", "1", "--spacing", "1.2", "-o", "judged"},
                      sandbox_.path());
        const QJsonObject v = json(run.out);
        QVERIFY2(v["gouge_max"].toDouble() <= 0.05 * 0.3, run.err);
        QVERIFY2(v["collisions"].toArray().isEmpty(), run.err);
        QVERIFY(v["excess_max"].toDouble() <= 1.05 * 0.3);
    }

    void a_machine_that_cannot_turn_the_part_is_told() {
        sandbox_.write("three.facetmill", QByteArray(lathe_project)
                                              .replace("PART", "square-prism")
                                              .replace("lathe-mill", "generic-3-axis"));
        const CliRun run = run_cli(
            {"plan", "three.facetmill", "--op", "Finish", "--set", "Finish.tolerance=0.5", "-o", "three"},
            sandbox_.path());
        QVERIFY2(run.status == 1 && run.code() == "limit_exceeded", run.err);
        QVERIFY2(run.err.contains("Generic mill (3-axis)") && run.err.contains("operation 'Finish'"),
                 run.err);
        QVERIFY(sandbox_.files("three").isEmpty());
    }

    /// What the cutter cannot go to is told, with where it is, by the plan and its report.
    void what_is_out_of_reach_is_told() {
        QVERIFY(run_cli({"sample", "extruded-pattern", "--tolerance", "0.05", "-o", "pattern.stl"},
                        sandbox_.path())
                    .status
                == 0);
        // Feet of the pads' flanks curve with a radius of 3.2 mm.
        sandbox_.write("narrow.facetmill",
                       QByteArray(lathe_project)
                           .replace("PART", "pattern")
                           .replace("\"tool\": 2, \"tolerance\": 0.3", "\"tool\": 3, \"tolerance\": 0.1")
                           .replace(R"("shank_diameter": 3.175, "shank_length": 30 } ],)",
                                    R"("shank_diameter": 3.175, "shank_length": 30 },
             { "number": 3, "name": "Ball 30", "diameter": 30, "corner_radius": 15, "flute_length": 40,
               "shank_diameter": 30, "shank_length": 30 } ],)"));
        const CliRun run =
            run_cli({"plan", "narrow.facetmill", "--op", "Finish", "-o", "narrow"}, sandbox_.path());
        QVERIFY2(run.status == 0, run.err);
        const QJsonObject finish = json(run.out)["operations"].toArray()[0].toObject();
        const QJsonObject turning = finish["turning"].toObject();
        const QJsonArray regions = turning["unreached"].toArray();
        QVERIFY2(!regions.isEmpty(), run.out);
        double area = 0;
        for (const QJsonValue& value : regions) {
            const QJsonObject r = value.toObject();
            QCOMPARE(r["why"].toString(), QString("narrow"));
            QVERIFY(r["angle_from"].toDouble() >= 0 && r["angle_from"].toDouble() < 360);
            QVERIFY(r["angle_to"].toDouble() >= r["angle_from"].toDouble());
            QVERIFY(r["from"].toDouble() >= 0 && r["to"].toDouble() <= 54 && r["from"] != r["to"]);
            // No farther than the pads are high, plus what facets lie below the round between them: the tip
            // straight over a place comes down to the part's outside at least.
            QVERIFY2(r["distance"].toDouble() > 0 && r["distance"].toDouble() <= 1 + 0.05, run.out);
            area += r["area"].toDouble();
        }
        QVERIFY(area > 10 && area < turning["surface_area"].toDouble());
        const QByteArray warnings = QJsonDocument(finish["warnings"].toArray()).toJson();
        QVERIFY2(warnings.contains("too large for hollows") && warnings.contains("along the axis"), warnings);
    }

    /// Every one says what, where and what to do; nothing is written.
    void bad_projects_are_refused_data() {
        QTest::addColumn<QString>("op");
        QTest::addColumn<QString>("setting");
        QTest::addColumn<QStringList>("says");
        const auto row = [](const char* name, const char* op, const char* setting, const QStringList& says) {
            QTest::newRow(name) << op << setting << says;
        };
        row("side feed 0", "Finish", "side_feed=0", {"side_feed", "above 0"});
        row("side feed a word", "Finish", "side_feed=wide", {"side_feed", "adaptive"});
        row("two points a turn", "Finish", "points_per_turn=2", {"points_per_turn", "3"});
        row("half a point", "Finish", "points_per_turn=72.5", {"points_per_turn", "whole number"});
        row("negative core", "Finish", "core_radius=-1", {"core_radius", "0"});
        row("depth of cut 0", "Rough", "depth_of_cut=0", {"depth_of_cut", "above 0"});
        row("depth of cut too small", "Rough", "depth_of_cut=1e-6", {"depth_of_cut", "larger depth of cut"});
        row("finishing allowance over the stock", "Rough", "finishing_allowance=40",
            {"Rough", "nothing of the stock stands above", "allowance"});
        row("allowance over the stock", "Rough", "allowance=40",
            {"Rough", "nothing of the stock stands above", "allowance"});
        row("allowance over the stock in finishing", "Finish", "allowance=40",
            {"Finish", "nothing of the stock stands above", "allowance"});
        row("points per turn 2 of lines", "Finish", "pattern=lengthwise;points_per_turn=2",
            {"points_per_turn", "3"});
        row("chuck without diameter", "Finish", "chuck=10,0", {"chuck", "diameter"});
        row("chuck over all", "Finish", "chuck=80,100", {"chuck", "no room"});
        row("no axis", "Finish", "axis=points;axis_to=0,0,0", {"axis_to", "the same"});
        row("axis beside the part", "Finish", "axis=points;axis_from=0,60,0;axis_to=40,60,0",
            {"axis", "35 mm beside the part", "move the part"});
        row("stop before start", "Finish", "start=30;stop=10", {"stop", "start before the stop"});
        row("beyond the part", "Finish", "start=100;stop=120", {"Finish", "start"});
    }

    void bad_projects_are_refused() {
        QFETCH(QString, op);
        QFETCH(QString, setting);
        QFETCH(QStringList, says);
        QStringList arguments{"plan", "prism.facetmill", "--op", op, "-o", "bad"};
        for (const QString& one : setting.split(';'))
            arguments << "--set" << op + "." + one;
        const CliRun run = run_cli(arguments, sandbox_.path());
        QCOMPARE(run.status, 1);
        for (const QString& what : says)
            QVERIFY2(QString::fromUtf8(run.err).contains(what), run.err);
        QVERIFY(!QFile::exists(sandbox_.path() + "/bad"));
    }

    void a_part_beside_its_axis_is_refused() {
        sandbox_.write("off.facetmill",
                       QByteArray(lathe_project)
                           .replace("PART.stl\", \"units\": \"mm\"",
                                    "square-prism.stl\", \"units\": \"mm\", \"translate\": [0, 100, 0]"));
        const CliRun run = run_cli({"plan", "off.facetmill", "-o", "bad"}, sandbox_.path());
        QCOMPARE(run.status, 1);
        QVERIFY2(run.err.contains("beside the part") && run.err.contains("Rough")
                     && run.err.contains("middle"),
                 run.err);
        // Off the axis, but over it: planned, and told.
        const QByteArray beside = bytes_of(sandbox_.path() + "/off.facetmill");
        sandbox_.write("over.facetmill", QByteArray(beside).replace("[0, 100, 0]", "[0, 5, 0]"));
        const CliRun over = run_cli(
            {"plan", "over.facetmill", "--op", "Finish", "-o", "over", "--set", "Finish.tolerance=0.5"},
            sandbox_.path());
        QVERIFY2(over.status == 0, over.err);
        QVERIFY2(over.out.contains("off the turning axis"), over.out);
    }

    void a_depth_of_cut_beyond_the_stock_is_one_pass() {
        const CliRun run = run_cli(
            {"plan", "prism.facetmill", "--op", "Rough", "-o", "deep", "--set", "Rough.depth_of_cut=50"},
            sandbox_.path());
        QVERIFY2(run.status == 0, run.err);
        const QJsonObject rough = json(run.out)["operations"].toArray()[0].toObject();
        QCOMPARE(rough["layers"].toInt(), 1);
        const QByteArray warnings = QJsonDocument(rough["warnings"].toArray()).toJson();
        QVERIFY2(warnings.contains("one pass takes all"), warnings);
        QVERIFY(QFile::exists(sandbox_.path() + "/deep/01-Rough-pass-01.txt"));
        QVERIFY(!QFile::exists(sandbox_.path() + "/deep/01-Rough-pass-02.txt"));
    }

private:
    Sandbox sandbox_;
};

FACETMILL_TEST(TestLatheJob)
#include "test_lathe_job.moc"
