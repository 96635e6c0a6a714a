// simulate: a plan or a foreign CL file against the part; planted gouges and collisions, and what is no CL
// file.
#include "core/mesh/mesh_io.h"
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

/// A plate 40 x 30 whose top is z = 0, with stock 2 above it and a tool with shank and holder.
const char* const plate_project = R"({ "facetmill": 1, "units": "mm", "part": { "file": "part.stl" },
  "stock": { "kind": "box", "margin": [1, 1, 2] },
  "tools": [ { "number": 1, "name": "Ball", "diameter": 8, "corner_radius": 4, "flute_length": 6, "shank_diameter": 8,
               "shank_length": 10, "holder": [ { "diameter": 30, "length": 20 } ] } ],
  "operations": [ { "kind": "finish3", "name": "Finish", "tool": 1, "tolerance": 0.05, "stepover": "adaptive" } ] })";

const char* const box_stock = R"({ "kind": "box", "margin": [1, 1, 2] })";

QByteArray plate() {
    const double x[2] = {0, 40}, y[2] = {0, 30}, z[2] = {-10, 0};
    const int corners[12][3] = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                                {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
    QByteArray text = "solid plate\n";
    for (const auto& facet : corners) {
        text += "facet normal 0 0 0 outer loop";
        for (int c : facet)
            text += QString(" vertex %1 %2 %3").arg(x[c & 1]).arg(y[c >> 1 & 1]).arg(z[c >> 2]).toUtf8();
        text += " endloop endfacet\n";
    }
    return text + "endsolid plate\n";
}

/// Rows 1 mm apart, 29 points a row; GOTO `n` (from 1) has `tip_z` in place of 0.
QByteArray cl(int n = 0, double tip_z = 0,
              const QByteArray& head = "UNITS/MM\nCUTTER/8,4,0,4,0,0,6\nLOADTL/1\n") {
    QByteArray text = "PARTNO PLATE\n" + head;
    int at = 0;
    const auto go = [&](double x, double y, double z) {
        ++at;
        text += QString("GOTO/%1,%2,%3\n")
                    .arg(x, 0, 'f', 4)
                    .arg(y, 0, 'f', 4)
                    .arg(at == n ? tip_z : z, 0, 'f', 4)
                    .toUtf8();
    };
    text += "RAPID\n";
    go(-8, -5, 30);
    for (int row = 0; row <= 40; ++row)
        for (int i = 0; i <= 28; ++i)
            go(row % 2 ? 48 - 2 * i : -8 + 2 * i, -5 + row, 0);
    go(-8, 35, 30);
    return text + "FINI\n";
}

QByteArray file(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

Sandbox& prepared_plate(Sandbox& s, const QByteArray& apt, const QByteArray& text = plate_project) {
    s.write("part.stl", plate());
    s.write("job.facetmill", text);
    s.write("path.apt", apt);
    return s;
}

const QStringList simulate = {"simulate",     "job.facetmill", "--cl", "path.apt",
                              "--resolution", "0.5",           "-o",   "out"};

} // namespace

class TestSimulate : public QObject {
    Q_OBJECT
private slots:
    void the_setup_sheet_tells_all() {
        Sandbox s;
        QByteArray text = plate_project;
        text.replace("\"flute_length\": 6", "\"flute_length\": 20");
        text.replace("\"units\": \"mm\",", "\"units\": \"mm\", \"post\": \"linuxcnc\", \"wcs\": \"G55\",");
        text.replace("\"name\": \"Ball\"", "\"name\": \"<b>Ball & co\"");
        text.replace("\"name\": \"Finish\"", "\"name\": \"Top \\\"A\\\" <i>\"");
        prepared_plate(s, {}, text);
        const CliRun run = run_cli({"report", "job.facetmill", "-o", "sheet.html"}, s.path());
        QVERIFY2(run.status == 0, run.err.constData());
        QCOMPARE(json(run.out)["verdict"].toString(), QString("verified"));
        const QByteArray sheet = file(s.path() + "/sheet.html");
        QVERIFY(sheet.startsWith("<!DOCTYPE html>") && sheet.endsWith("</html>\n"));
        for (const char* said :
             {"Verified: no gouge, no collision.", "&lt;b&gt;Ball &amp; co", "Top &quot;A&quot; &lt;i&gt;",
              "01-Top-A-i.apt", "42 × 32 × 12 mm", "Deepest gouge", "part.stl", "\u00d8 30 \u00d7 20",
              "1 program ·", "01-Top-A-i.ngc", "three axes", "G55, its zero in", "T1 50 mm"})
            QVERIFY2(sheet.contains(said), said);
        QVERIFY(!sheet.contains("<b>Ball") && !sheet.contains("do not run"));
        // Complete in itself.
        QVERIFY(!sheet.contains("http") && !sheet.contains("<script") && !sheet.contains("<link"));
#ifdef FACETMILL_HAS_PICTURES
        // Setup, path and deviation, each a picture that can be read.
        int pictures = 0;
        for (qsizetype at = 0; (at = sheet.indexOf("base64,", at)) >= 0; ++pictures) {
            at += 7;
            const QByteArray png = QByteArray::fromBase64(sheet.mid(at, sheet.indexOf('"', at) - at));
            QVERIFY(png.startsWith("\x89PNG\r\n\x1a\n") && png.contains("IEND"));
            QCOMPARE(png.mid(16, 8), QByteArray("\0\0\x03\x20\0\0\x02\x30", 8)); // 800 by 560
        }
        QCOMPARE(pictures, 3);
        QCOMPARE(json(run.out)["pictures"].toInt(), pictures);
#endif
    }

    /// A short tool whose shank runs into the stock, which five axes do not look at: there is a sheet, and it
    /// says so. Three axes find no place for it.
    void the_setup_sheet_warns() {
        Sandbox s;
        QByteArray text = QByteArray(plate_project).replace("\"flute_length\": 6", "\"flute_length\": 1");
        prepared_plate(s, {}, text);
        const CliRun none = run_cli({"report", "job.facetmill", "-o", "sheet.html"}, s.path());
        QCOMPARE(none.status, 1);
        QVERIFY2(none.err.contains("would come into the stock"), none.err.constData());
        QVERIFY(!QFile::exists(s.path() + "/sheet.html"));
        text.replace("\"kind\": \"finish3\"", "\"kind\": \"finish5\"")
            .replace("0.05, \"stepover\": \"adaptive\"", "0.6, \"stepover\": 4, \"grid_degrees\": 15")
            .replace("\"tools\"", "\"machine\": \"trunnion-ac\", \"tools\"");
        prepared_plate(s, {}, text);
        const CliRun run = run_cli({"report", "job.facetmill", "-o", "sheet.html"}, s.path());
        QCOMPARE(run.status, 1);
        QVERIFY(run.err.contains("not verified: "));
        const QByteArray sheet = file(s.path() + "/sheet.html");
        QVERIFY(sheet.contains("Not verified, do not run: "));
        QVERIFY(sheet.contains("in the stock</td>"));
        QVERIFY(!sheet.contains("no gouge, no collision"));
    }

    void no_setup_sheet_of_bad_input() {
        Sandbox s;
        prepared_plate(s, {});
        const QStringList before = s.files();
        QCOMPARE(run_cli({"report", "job.facetmill"}, s.path()).status, 2);
        QCOMPARE(run_cli({"report", "-o", "sheet.html"}, s.path()).status, 2);
        for (const QStringList& words : {QStringList{"report", "none.facetmill", "-o", "sheet.html"},
                                         QStringList{"report", "part.stl", "-o", "sheet.html"},
                                         QStringList{"report", "job.facetmill", "-o", "part.stl"},
                                         QStringList{"report", "job.facetmill", "-o", "job.facetmill"},
                                         QStringList{"report", "job.facetmill", "-o", "none/sheet.html"}}) {
            const CliRun run = run_cli(words, s.path());
            QCOMPARE(run.status, 1);
            QCOMPARE(run.err_lines(), 1);
            QVERIFY(run.out.isEmpty());
            QCOMPARE(s.files(), before);
        }
    }

    void a_plan_is_verified() {
        Sandbox s;
        QByteArray text = plate_project;
        text.replace("\"flute_length\": 6", "\"flute_length\": 20");
        prepared_plate(s, {}, text);
        const CliRun run =
            run_cli({"simulate", "job.facetmill", "--resolution", "0.5", "-o", "out"}, s.path());
        QVERIFY2(run.status == 0, run.err.constData());
        const QJsonObject o = json(run.out);
        QCOMPARE(o["verdict"].toString(), QString("verified"));
        for (const char* key : {"gouge_max", "excess_max", "excess_p95", "excess_p99", "uncut_fraction",
                                "collisions", "samples"})
            QVERIFY2(o.contains(key), key);
        QVERIFY(o["excess_max"].toDouble() <= 0.05);
        QVERIFY(o["gouge_max"].toDouble() <= o["settings"].toObject()["gouge_limit"].toDouble());
        QVERIFY(o["samples"].toInt() > 1000);
        QCOMPARE(s.files("out"), (QStringList{"deviation.vtp", "stock.stl", "verify.json"}));
        QFile written(s.path() + "/out/verify.json");
        QVERIFY(written.open(QIODevice::ReadOnly));
        QCOMPARE(written.readAll(), run.out);
        // The stock that is left is closed and about as large as the plate with its margins.
        const LoadedMesh stock =
            load_mesh((s.path() + "/out/stock.stl").toStdString(), LengthUnit::mm, Progress());
        QVERIFY(stock.report.watertight);
        QVERIFY(std::abs(stock.report.file_volume - o["stock_volume"].toDouble())
                < 0.02 * stock.report.file_volume);
        // One thread, the same figures.
        const CliRun one = run_cli(
            {"simulate", "job.facetmill", "--resolution", "0.5", "--threads", "1", "-o", "out1"}, s.path());
        QJsonObject again = json(one.out), first = o;
        for (QJsonObject* each : {&again, &first})
            each->remove("seconds");
        QCOMPARE(again, first);
    }

    void a_good_cl_file() {
        Sandbox s;
        const CliRun run = run_cli(simulate, prepared_plate(s, cl()).path());
        QVERIFY2(run.status == 0, run.err.constData());
        const double cusp = 4 - std::sqrt(16 - 0.25);
        QVERIFY(json(run.out)["excess_max"].toDouble() <= cusp + 1e-6);
        QVERIFY(json(run.out)["gouge_max"].toDouble() < 1e-6);
    }

    /// What plan writes for a control is read back as it stands in the file.
    void a_posted_program() {
        Sandbox s;
        QByteArray text = plate_project;
        text.replace("\"flute_length\": 6", "\"flute_length\": 20");
        prepared_plate(s, {}, text.replace("\"units\": \"mm\",", "\"units\": \"mm\", \"post\": \"grbl\","));
        const CliRun plan = run_cli({"plan", "job.facetmill", "-o", "out"}, s.path());
        QVERIFY2(plan.status == 0, plan.err.constData());
        QCOMPARE(s.files("out"), (QStringList{"01-Finish.apt", "01-Finish.nc", "report.json"}));
        const QStringList read = {"simulate",     "job.facetmill", "--nc", "out/01-Finish.nc",
                                  "--resolution", "0.5",           "-o",   "judged"};
        const CliRun good = run_cli(read, s.path());
        QVERIFY2(good.status == 0, good.err.constData());
        QVERIFY(json(good.out)["remarks"].toArray()[0].toString().startsWith("The posted program, "));
        // What the control runs can be looked at.
        const CliRun drawn = run_cli({"render", "job.facetmill", "--nc", "out/01-Finish.nc", "--show",
                                      "part,cl", "--size", "160x120", "-o", "p.png"},
                                     s.path());
        QVERIFY2(drawn.status == 0, drawn.err.constData());
        QVERIFY(file(s.path() + "/p.png").size() > 2000);
        // A cut that is too deep is found in its line, a word that is not known refused with its.
        QByteArray program = file(s.path() + "/out/01-Finish.nc");
        const auto cut = program.indexOf("\nX", program.size() / 2);
        const auto line = program.left(cut + 1).count('\n') + 1;
        QVERIFY(cut > 0);
        s.write("out/01-Finish.nc", QByteArray(program).insert(program.indexOf('\n', cut + 1), " Z-1.5"));
        const CliRun deep = run_cli(read, s.path());
        QCOMPARE(deep.status, 1);
        QVERIFY2(deep.err.contains("gouge of 1.") && deep.err.contains("line "), deep.err.constData());
        s.write("out/01-Finish.nc", program.insert(cut + 1, "G81 R1 "));
        const CliRun word = run_cli(read, s.path());
        QCOMPARE(word.status, 1);
        QVERIFY2(word.err.contains(("01-Finish.nc:" + QByteArray::number(line) + ": 'G81'")),
                 word.err.constData());
        QCOMPARE(run_cli({"simulate", "job.facetmill", "--nc", "p.nc", "--op", "Finish", "-o", "x"}, s.path())
                     .status,
                 2);
    }

    void what_no_control_could_run_data() {
        QTest::addColumn<QByteArray>("from");
        QTest::addColumn<QByteArray>("to");
        QTest::addColumn<QByteArray>("says");
        const auto row = [](const char* name, const QByteArray& from, const QByteArray& to,
                            const char* says) { QTest::newRow(name) << from << to << QByteArray(says); };
        row("unknown key", "\"grbl\"", "\"unknown.json\"", "[unknown_key] unknown.json: largest_tol: ");
        row("wrong type", "\"grbl\"", "\"type.json\"", "[wrong_type] type.json: largest_tool: ");
        row("template word", "\"grbl\"", "\"word.json\"", "there is no word {toolname}");
        row("no file", "\"grbl\"", "\"none.json\"", "none.json: no such file");
        row("several axes", "finish3", "finish5", "inclines the tool, and the control has three axes");
        row("travel", "\"post\"", "\"machine\": \"small.json\", \"post\"", "X ends ");
        row("feed", "\"tolerance\"", "\"feed\": 80000, \"tolerance\"", "a feed of 80000 mm/min");
        row("work coordinates", "\"G54\"", "\"G60\"", "no work coordinate system 'G60'");
        row("preset", "\"grbl\", \"wcs\": \"G54\"", "\"heidenhain\", \"wcs\": \"70000\"",
            "the numbers from 0 to 65535");
        row("tool number", "\"number\": 1,", "\"number\": 300,", "tool 300");
        row("program number", "\"wcs\"", "\"program_number\": 1000000, \"wcs\"", "program number 1000000");
    }
    /// One line that says what, exit status 1, and not a file more than before.
    void what_no_control_could_run() {
        QFETCH(QByteArray, from);
        QFETCH(QByteArray, to);
        QFETCH(QByteArray, says);
        QByteArray text = plate_project;
        text.replace("\"flute_length\": 6", "\"flute_length\": 20")
            .replace("\"units\": \"mm\",", "\"units\": \"mm\", \"post\": \"grbl\", \"wcs\": \"G54\",")
            .replace("\"stepover\": \"adaptive\"", "\"stepover\": 2");
        QVERIFY(text.contains(from));
        const bool renumbered = to.contains("300");
        text.replace(from, to);
        if (renumbered) text.replace("\"tool\": 1", "\"tool\": 300");
        Sandbox s;
        prepared_plate(s, {}, text);
        const QByteArray post = file(QString(FACETMILL_SOURCE) + "/resources/posts/grbl.json"),
                         machine = file(QString(FACETMILL_SOURCE) + "/resources/machines/trunnion-ac.json");
        s.write("unknown.json", QByteArray(post).replace("largest_tool", "largest_tol"));
        s.write("type.json", QByteArray(post).replace("\"largest_tool\": 255", "\"largest_tool\": \"many\""));
        s.write("word.json", QByteArray(post).replace("{tool_name}", "{toolname}"));
        s.write("small.json", QByteArray(machine).replace("[-350, 350]", "[-5, 5]"));
        const QStringList before = s.files();
        const CliRun run = run_cli({"plan", "job.facetmill", "-o", "out"}, s.path());
        QCOMPARE(run.status, 1);
        QVERIFY2(run.err.contains(says), run.err.constData());
        QCOMPARE(run.err.count("error ["), 1);
        QCOMPARE(s.files(), before);
    }

    void a_planted_gouge() {
        Sandbox s;
        const int at = 1 + 29 * 10 + 15; // row 9, in the middle
        const CliRun run = run_cli(simulate, prepared_plate(s, cl(at, -0.35)).path());
        QCOMPARE(run.status, 1);
        const QJsonObject o = json(run.out);
        QCOMPARE(o["verdict"].toString(), QString("failed"));
        QVERIFY(std::abs(o["gouge_max"].toDouble() - 0.35)
                < 0.02); // to what lies between the places compared
        const QJsonObject worst = o["gouges"].toArray()[0].toObject();
        QVERIFY(std::abs(worst["goto"].toInt() - at) <= 1);
        QVERIFY(run.err.contains("gouge of 0.3") && run.err.contains("GOTO"));
        QCOMPARE(run.err_lines(), 1);
        QCOMPARE(s.files("out").size(), 3);
    }

    void nothing_is_left() {
        Sandbox s;
        QByteArray apt = cl(0, 0, "UNITS/MM\nCUTTER/8,4,0,4,0,0,40\nLOADTL/1\n");
        apt.replace(",0.0000\n", ",-11.0000\n");
        const CliRun run = run_cli(simulate, prepared_plate(s, apt).path());
        QCOMPARE(run.status, 1);
        QCOMPARE(json(run.out)["verdict"].toString(), QString("failed"));
        QVERIFY2(run.err.contains("gouge of"), run.err.constData());
        QCOMPARE(s.files("out").size(), 3);
        QCOMPARE(file(s.path() + "/out/stock.stl").size(), 84); // no facets
    }

    void what_is_left_is_the_stock_of_the_next_job() {
        Sandbox s;
        QByteArray text = plate_project;
        text.replace("\"flute_length\": 6", "\"flute_length\": 40"); // nothing but the cutter meets the bar
        text.replace(box_stock, R"({ "kind": "cylinder", "diameter": 56, "margin": [0, 0, 2] })");
        const CliRun first = run_cli(simulate, prepared_plate(s, cl(), text).path());
        QVERIFY2(first.status == 0, first.err.constData());
        const QJsonObject before = json(first.out);
        // 2 mm off a bar of 56 mm where the rows go, 12 mm long.
        const double bar = 3.14159265358979 * 28 * 28 * 12, left = before["stock_volume"].toDouble();
        QVERIFY2(left < bar - 0.9 * 40 * 30 * 2 && left > bar - 52 * 50 * 2, first.out.constData());
        QVERIFY(before["gouge_max"].toDouble() < 1e-6);
        QVERIFY(load_mesh((s.path() + "/out/stock.stl").toStdString(), LengthUnit::mm, Progress())
                    .report.watertight);
        // Cut again, nothing is left to cut; and it may not be written over.
        text.replace(R"({ "kind": "cylinder", "diameter": 56, "margin": [0, 0, 2] })",
                     R"({ "kind": "mesh", "file": "out/stock.stl" })");
        s.write("job.facetmill", text);
        const CliRun over = run_cli(simulate, s.path());
        QCOMPARE(over.status, 1);
        QVERIFY(over.err.contains("stock.stl"));
        QStringList again = simulate;
        again.last() = "again";
        const CliRun second = run_cli(again, s.path());
        QVERIFY2(second.status == 0, second.err.constData());
        const QJsonObject after = json(second.out);
        QVERIFY(std::abs(after["stock_volume"].toDouble() - left) < 0.002 * left);
        QVERIFY(std::abs(after["excess_max"].toDouble() - before["excess_max"].toDouble()) < 0.05);
        QVERIFY(after["gouge_max"].toDouble() < 1e-6);
    }

    void a_stock_that_is_too_small_is_told() {
        Sandbox s;
        QByteArray text = plate_project;
        text.replace("\"flute_length\": 6", "\"flute_length\": 40");
        text.replace(box_stock, R"({ "kind": "cylinder", "diameter": 44, "margin": [0, 0, 2] })");
        prepared_plate(s, cl(), text);
        const CliRun run = run_cli(simulate, s.path());
        QCOMPARE(run.status, 1);
        QVERIFY2(run.err.contains("the stock does not reach there"), run.err.constData());
        const QJsonObject o = json(run.out);
        QCOMPARE(o["verdict"].toString(), QString("failed"));
        QCOMPARE(o["uncut_reasons"].toArray()[0].toObject()["why"].toString(), QString("outside_stock"));
        // What may stay is the user's to say.
        const CliRun lax = run_cli(QStringList(simulate) << "--uncut-limit"
                                                         << "0.05",
                                   s.path());
        QVERIFY2(lax.status == 0, lax.err.constData());
        const QByteArray remarks = QJsonDocument(o["remarks"].toArray()).toJson();
        QVERIFY2(remarks.contains("does not hold the part: its diameter is 44 mm, the part needs 50 mm"),
                 remarks.constData());
        QVERIFY2(remarks.contains("The stock does not reach"), remarks.constData());
    }

    void a_bad_stock_leaves_nothing_data() {
        QTest::addColumn<QByteArray>("stock");
        QTest::addColumn<QByteArray>("said");
        const auto row = [](const char* name, const char* stock, const char* said) {
            QTest::newRow(name) << QByteArray(stock) << QByteArray(said);
        };
        row("no such mesh", R"({ "kind": "mesh", "file": "none.stl" })", "none.stl");
        row("an open mesh", R"({ "kind": "mesh", "file": "open.stl" })",
            "open.stl: the stock's mesh is not closed");
        row("no mesh", R"({ "kind": "mesh", "file": "job.txt" })", "job.txt");
        row("another kind's key", R"({ "kind": "box", "axis": "x" })", "stock.axis");
        row("a cylinder of no size", R"({ "kind": "cylinder", "diameter": 0 })", "stock.diameter");
        row("far away", R"({ "kind": "mesh", "file": "part.stl", "translate": [500, 0, 0] })",
            "no motion at feed comes near the stock");
    }
    void a_bad_stock_leaves_nothing() {
        QFETCH(QByteArray, stock);
        QFETCH(QByteArray, said);
        Sandbox s;
        QByteArray text = plate_project;
        text.replace(box_stock, stock);
        QByteArray open = plate();
        open.replace(open.indexOf("facet"), open.indexOf("endfacet\n") + 9 - open.indexOf("facet"), "");
        s.write("open.stl", open);
        s.write("job.txt", "no mesh at all");
        const CliRun run = run_cli(simulate, prepared_plate(s, cl(), text).path());
        QCOMPARE(run.status, 1);
        QVERIFY2(run.err.contains(said), run.err.constData());
        QVERIFY(run.out.isEmpty());
        QVERIFY(!s.files().contains("out"));
    }

    void a_holder_in_the_stock() {
        Sandbox s;
        QByteArray text = plate_project;
        text.replace("\"shank_length\": 10", "\"shank_length\": 0")
            .replace("\"margin\": [1, 1, 2]", "\"margin\": [1, 1, 8]");
        const CliRun run = run_cli(simulate, prepared_plate(s, cl(), text).path());
        QCOMPARE(run.status, 1);
        const QJsonArray collisions = json(run.out)["collisions"].toArray();
        QVERIFY(!collisions.isEmpty());
        QCOMPARE(collisions[0].toObject()["kind"].toString(), QString("holder"));
        QVERIFY(run.err.contains("holder"));
    }

    void a_rapid_through_the_part() {
        Sandbox s;
        QByteArray apt = cl(0, 0, "UNITS/MM\nCUTTER/8,4,0,4,0,0,40\nLOADTL/1\n");
        apt.replace("FINI\n", "RAPID\nGOTO/60,15,-3\nRAPID\nGOTO/-20,15,-3\nFINI\n");
        const CliRun run = run_cli(simulate, prepared_plate(s, apt).path());
        QCOMPARE(run.status, 1);
        bool found = false;
        for (const auto& c : json(run.out)["collisions"].toArray()) {
            const QJsonObject o = c.toObject();
            if (o["kind"].toString() != "rapid" || o["goto"].toInt() != 1 + 41 * 29 + 1 + 2) continue;
            found = true;
            QCOMPARE(o["with"].toString(), QString("part"));
            QVERIFY(o["depth"].toDouble() > 2.9);
        }
        QVERIFY(found);
    }

    /// The whole tool is one thing in a rapid: one entry, with the stock and with the part.
    void a_rapid_with_the_holder_is_one_collision() {
        Sandbox s;
        QByteArray text = plate_project; // shank from 6, holder from 16 above the tip
        QByteArray apt = cl();
        // Past the cutter's and the shank's own way the holder comes down on the plate's side.
        apt.replace("FINI\n", "RAPID\nGOTO/-10,15,30\nRAPID\nGOTO/-10,15,-20\nRAPID\nGOTO/-10,15,30\nFINI\n");
        const CliRun run = run_cli(simulate, prepared_plate(s, apt, text).path());
        QCOMPARE(run.status, 1);
        const int down = 1 + 41 * 29 + 1 + 2;
        int found = 0;
        for (const auto& c : json(run.out)["collisions"].toArray()) {
            const QJsonObject o = c.toObject();
            if (o["goto"].toInt() != down) continue;
            ++found;
            QCOMPARE(o["kind"].toString(), QString("rapid"));
            QCOMPARE(o["with"].toString(), QString("part"));
            // x from 0 to 5, and the plate's top is 4 above the holder's end.
            QVERIFY2(std::abs(o["depth"].toDouble() - 4) < 0.05, run.out.constData());
        }
        QCOMPARE(found, 1);
        QVERIFY2(run.err.contains("by a rapid in the part"), run.err.constData());
    }

    void a_file_without_a_tool_takes_no_holder_of_another_data() {
        QTest::addColumn<QByteArray>("head");
        QTest::addColumn<bool>("collides");
        QTest::addColumn<QByteArray>("said");
        // The holder of tool 1 would stand in 8 mm of stock.
        QTest::newRow("named") << QByteArray("UNITS/MM\nCUTTER/8,4,0,4,0,0,6\nLOADTL/1\n") << true
                               << QByteArray();
        QTest::newRow("the same cutter") << QByteArray("UNITS/MM\nCUTTER/8,4,0,4,0,0,6\n") << true
                                         << QByteArray("its cutter is that of tool 1");
        QTest::newRow("another cutter") << QByteArray("UNITS/MM\nCUTTER/6,3,0,3,0,0,6\n") << false
                                        << QByteArray("its cutter is not that of tool 1");
        QTest::newRow("another tool") << QByteArray("UNITS/MM\nCUTTER/8,4,0,4,0,0,6\nLOADTL/7\n") << false
                                      << QByteArray("the project has no tool 7");
    }
    void a_file_without_a_tool_takes_no_holder_of_another() {
        QFETCH(QByteArray, head);
        QFETCH(bool, collides);
        QFETCH(QByteArray, said);
        Sandbox s;
        QByteArray text = plate_project;
        text.replace("\"shank_length\": 10", "\"shank_length\": 0")
            .replace("\"margin\": [1, 1, 2]", "\"margin\": [1, 1, 8]");
        const CliRun run = run_cli(simulate, prepared_plate(s, cl(0, 0, head), text).path());
        const QJsonObject o = json(run.out);
        QVERIFY2(o["collisions"].toArray().isEmpty() != collides, run.err.constData());
        const QByteArray remarks = QJsonDocument(o["remarks"].toArray()).toJson();
        QVERIFY2(said.isEmpty() ? !remarks.contains("tool") || !remarks.contains("LOADTL")
                                : remarks.contains(said),
                 remarks.constData());
    }

    /// A five-axis file: a flat end that leads, every GOTO with its own axis; then one swing too wide.
    void a_five_axis_file() {
        const double r = 5;
        const auto go = [](double x, double y, double z, double lean) {
            return QString("GOTO/%1,%2,%3,%4,0,%5\n")
                .arg(x, 0, 'f', 6)
                .arg(y, 0, 'f', 6)
                .arg(z, 0, 'f', 6)
                .arg(std::sin(lean), 0, 'f', 9)
                .arg(std::cos(lean), 0, 'f', 9)
                .toUtf8();
        };
        const double most = 10 * 3.14159265358979 / 180;
        QByteArray apt = "PARTNO PLATE\nUNITS/MM\nCUTTER/10,0,5,0,0,0,40\nMULTAX/ON\nRAPID\n"
                         + go(-12, -5, 40, 0.5 * most);
        for (int row = 0; row <= 40; ++row)
            for (int i = 0; i <= 120; ++i) {
                const int at = row % 2 ? 120 - i : i;
                const double lean = most * (0.5 + 0.5 * at / 120);
                apt += go(-12 + 0.5 * at, -5 + row, r * std::sin(lean), lean);
            }
        apt += "RAPID\n" + go(-12, 35, 60, 0.5 * most);
        Sandbox s;
        // Its walls, which a leaning axis sees, are nobody's business here.
        const QStringList top_alone = QStringList(simulate) << "--uncut-limit"
                                                            << "0.3";
        const CliRun good = run_cli(top_alone, prepared_plate(s, apt + "FINI\n").path());
        QVERIFY2(good.status == 0, good.err.constData());
        const QJsonObject o = json(good.out);
        const double cusp = std::sin(most) * (r - std::sqrt(r * r - 0.25));
        // The walls face the leaning axis, too, and keep their stock: the top alone.
        const double left = o["slope_bands"].toArray()[0].toObject()["excess_max"].toDouble();
        QVERIFY(left <= cusp + 2e-4 && left > 0.4 * cusp);
        QVERIFY(o["gouge_max"].toDouble() < 2e-4);
        QVERIFY(o["settings"].toObject()["motion_bound"].toDouble() > 0);

        // Both ends of the swing touch the plate; between them, where the axis moves along its chord, the rim
        // is 0.0776 r below it, and the plate's points come 0.0551 r inside, where end and side are as far
        // away.
        const double wide = 3.14159265358979 / 3;
        apt += "RAPID\n" + go(10, 15, 60, 0) + go(10, 15, 0, 0) + go(14, 15, r * std::sin(wide), wide)
               + "RAPID\n" + go(14, 15, 60, wide) + "FINI\n";
        const CliRun bad = run_cli(simulate, prepared_plate(s, apt).path());
        QCOMPARE(bad.status, 1);
        const QJsonObject b = json(bad.out);
        const double depth = b["gouge_max"].toDouble();
        QVERIFY2(depth > 0.2755 - 0.07 && depth < 0.276, bad.out.constData()); // places 0.5 apart
        QCOMPARE(b["gouges"].toArray()[0].toObject()["goto"].toInt(), 1 + 41 * 121 + 4);
        QVERIFY2(bad.err.contains("gouge of 0.") && bad.err.contains("GOTO"), bad.err.constData());
    }

    void words_that_are_read_over_are_listed() {
        Sandbox s;
        QByteArray apt = cl(0, 0, "UNITS/MM\nCUTTER/8,4,0,4,0,0,40\nLOADTL/1\n");
        apt.replace("LOADTL/1\n", "LOADTL/1\nPPRINT HELLO\nFROBNI/3\n");
        const CliRun run = run_cli(simulate, prepared_plate(s, apt).path());
        QCOMPARE(run.status, 0);
        QVERIFY(run.err.contains("FROBNI"));
    }

    void bad_cl_files_leave_nothing_data() {
        QTest::addColumn<QByteArray>("from");
        QTest::addColumn<QByteArray>("to");
        QTest::newRow("unknown unit") << QByteArray("UNITS/MM") << QByteArray("UNITS/FURLONG");
        QTest::newRow("no cutter, no such tool")
            << QByteArray("CUTTER/8,4,0,4,0,0,6\nLOADTL/1") << QByteArray("LOADTL/9");
        QTest::newRow("no cutter") << QByteArray("CUTTER/8,4,0,4,0,0,6\n") << QByteArray();
        QTest::newRow("NaN") << QByteArray("GOTO/-8.0000,-5.0000,30.0000") << QByteArray("GOTO/-8,NAN,30");
        QTest::newRow("an arc") << QByteArray("FINI") << QByteArray("MOVARC/0,0,0,0,0,1,5,ANGLE,90\nFINI");
        QTest::newRow("far away") << QByteArray("UNITS/MM") << QByteArray("UNITS/MM\nTRANS/1000,0,0");
        QTest::newRow("cut off") << QByteArray("FINI\n") << QByteArray("GOTO/1,2,");
    }
    void bad_cl_files_leave_nothing() {
        QFETCH(QByteArray, from);
        QFETCH(QByteArray, to);
        QByteArray apt = cl();
        QVERIFY(apt.contains(from));
        apt.replace(from, to);
        Sandbox s;
        const CliRun run = run_cli(simulate, prepared_plate(s, apt).path());
        QCOMPARE(run.status, 1);
        QVERIFY2(run.err.contains("path.apt"), run.err.constData());
        QVERIFY(run.out.isEmpty());
        QVERIFY(!s.files().contains("out"));
    }

    void no_motion_near_the_stock() {
        QByteArray apt = "UNITS/MM\nCUTTER/8,4,0,4,0,0,6\nRAPID\nGOTO/1000,0,0\nGOTO/1100,0,0\nFINI\n";
        Sandbox s;
        const CliRun run = run_cli(simulate, prepared_plate(s, apt).path());
        QCOMPARE(run.status, 1);
        QVERIFY2(run.err.contains("no motion at feed comes near the stock"), run.err.constData());
        QVERIFY(!s.files().contains("out"));
    }

#ifdef FACETMILL_HAS_PICTURES
    /// Beside findings the stock is drawn as it is left.
    /// A program is drawn as it is, also in a project that could not be planned.
    void pictures_show_programs_that_are_there() {
        Sandbox s;
        QByteArray text = plate_project;
        const auto operations = text.indexOf("\"operations\"");
        text = text.left(operations) + "\"operations\": [] }";
        prepared_plate(s, cl(), text);
        const auto render = [&](const QStringList& words) {
            return run_cli(QStringList{"render", "job.facetmill", "--size", "200x150", "-o", "p.png"} + words,
                           s.path());
        };
        QCOMPARE(render({"--show", "cl"}).status, 1); // nothing is planned
        const CliRun drawn = render({"--show", "part,cl", "--cl", "path.apt"});
        QVERIFY2(drawn.status == 0, drawn.err.constData());
        QFile file(s.path() + "/p.png");
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QByteArray with = file.readAll();
        file.close();
        QCOMPARE(render({"--show", "part"}).status, 0);
        QVERIFY(file.open(QIODevice::ReadOnly));
        QVERIFY(with.startsWith("\x89PNG") && with != file.readAll());
        QCOMPARE(render({"--cl", "path.apt", "--op", "Finish"}).status, 2);
        QCOMPARE(render({"--cl", "none.apt"}).status, 1);
        QCOMPARE(run_cli({"render", "part.stl", "--cl", "path.apt", "-o", "q.png"}, s.path()).status, 2);
    }

    void pictures_show_what_is_left_of_the_stock() {
        Sandbox s;
        QByteArray text = plate_project;
        text.replace("\"flute_length\": 6", "\"flute_length\": 20");
        prepared_plate(s, {}, text);
        const auto picture = [&](const char* layers) {
            const CliRun run = run_cli(
                {"render", "job.facetmill", "--show", layers, "--size", "200x150", "-o", "p.png"}, s.path());
            if (run.status != 0) return QByteArray(run.err);
            QFile file(s.path() + "/p.png");
            return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
        };
        const QByteArray block = picture("stock"), left = picture("stock,findings");
        QVERIFY2(block.startsWith("\x89PNG"), block.constData());
        QVERIFY2(left.startsWith("\x89PNG"), left.constData());
        QVERIFY(left != block); // the plan has no findings: all that differs is the stock
        QVERIFY(picture("deviation,stock").startsWith("\x89PNG"));
    }
#endif

    void moves_of_no_length_do_no_harm() {
        QByteArray apt = cl(0, 0, "UNITS/MM\nCUTTER/8,4,0,4,0,0,40\nLOADTL/1\n");
        apt.replace("GOTO/0.0000,0.0000,0.0000\n", "GOTO/0.0000,0.0000,0.0000\nGOTO/0.0000,0.0000,0.0000\n");
        Sandbox s;
        QCOMPARE(run_cli(simulate, prepared_plate(s, apt).path()).status, 0);
    }
};

FACETMILL_TEST(TestSimulate)
#include "test_simulate.moc"
