// The headless program's manners: exit status, one line on stderr, nothing left behind.
#include "core/gouge/axial_lift.h"
#include "core/job/planner.h"
#include "core/job/project.h"
#include "core/mesh/mesh_io.h"
#include "tests/golden/run_cli.h"
#include "tests/support/test_runner.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QTest>

#include <array>
#include <cmath>
#include <csignal>
#include <random>
#include <sstream>

using namespace facetmill;
using namespace facetmill::test;

namespace {

const char* const good_project = R"({ "facetmill": 1, "units": "mm", "part": { "file": "part.stl" },
  "tools": [ { "number": 1, "name": "Ball", "diameter": 6, "corner_radius": 3 } ],
  "operations": [ { "kind": "finish3", "name": "Finish", "tool": 1, "tolerance": 0.1, "stepover": "adaptive" } ] })";

QByteArray changed(const QByteArray& from, const QByteArray& to) {
    QByteArray text = good_project;
    if (!text.contains(from)) qFatal("the test's text is not in the project");
    return text.replace(from, to);
}

/// Three facets of a little roof.
const char* const small_part = R"(solid roof
facet normal 0 0 1 outer loop vertex 0 0 0 vertex 20 0 0 vertex 20 10 4 endloop endfacet
facet normal 0 0 1 outer loop vertex 0 0 0 vertex 20 10 4 vertex 0 10 4 endloop endfacet
facet normal 0 0 1 outer loop vertex 0 10 4 vertex 20 10 4 vertex 10 20 0 endloop endfacet
endsolid roof
)";

} // namespace

class TestCli : public QObject {
    Q_OBJECT
private slots:

    void help_and_version() {
        Sandbox s;
        const CliRun help = run_cli({"--help"}, s.path());
        QCOMPARE(help.status, 0);
        QVERIFY(help.err.isEmpty());
        for (const char* command : {"info", "sample", "place", "plan", "simulate", "cspace", "drop", "render",
                                    "export", "pack", "unpack", "template", "tools", "reference"}) {
            QVERIFY(help.out.contains(command));
            const CliRun one = run_cli({command, "--help"}, s.path());
            QCOMPARE(one.status, 0);
            QVERIFY(one.out.startsWith(QByteArray("usage: facetmill-cli ") + command));
        }
        const CliRun version = run_cli({"--version"}, s.path());
        QCOMPARE(version.status, 0);
        QVERIFY(version.out.startsWith("facetmill-cli ") && version.out.count('.') == 2);
    }

    void wrong_usage_is_2_data() {
        QTest::addColumn<QString>("line");
        for (const char* line : {"",
                                 "fly",
                                 "info",
                                 "info a.stl b.stl",
                                 "info part.stl --units",
                                 "info part.stl --units yd",
                                 "info part.stl --unit mm",
                                 "info part.stl --units mm --units in",
                                 "info part.stl --units=",
                                 "pack p.facetmill",
                                 "pack -o a.facetmill",
                                 "unpack a.facetmill",
                                 "template",
                                 "template save",
                                 "template save p.facetmill",
                                 "template save p.facetmill q.facetmill -o t",
                                 "template apply t -o p.facetmill",
                                 "template apply t part.stl -o p.facetmill",
                                 "template apply t p.facetmill --units mm -o q.facetmill",
                                 "template apply t part.stl --units mm",
                                 "template keep p.facetmill -o t",
                                 "place part.stl",
                                 "place part.stl --on",
                                 "place part.stl --on side",
                                 "place part.stl --on -1",
                                 "place part.stl --on 0.5",
                                 "sample",
                                 "sample concave",
                                 "sample conclave -o x.stl",
                                 "sample concave --tolerance wide -o x.stl",
                                 "plan",
                                 "plan job.facetmill",
                                 "plan job.facetmill -o",
                                 "plan job.facetmill -o out --threads 0",
                                 "plan job.facetmill -o out --threads 1.5",
                                 "plan job.facetmill -o out --set tolerance",
                                 "plan job.facetmill -o out --set tolerance=1",
                                 "drop part.stl -o x",
                                 "drop part.stl --cutter ball:6 -o x",
                                 "drop part.stl --cutter ball:6 --grid 5x5 --points p -o x",
                                 "drop part.stl --cutter ball:6 --grid 5 -o x",
                                 "drop part.stl --cutter ball:6 --grid 5x -o x",
                                 "drop part.stl --cutter ball:6 --grid 0x5 -o x",
                                 "drop part.stl --cutter ball:6 --grid -5x5 -o x",
                                 "drop part.stl --cutter ball:6 --grid 5x5x5 -o x",
                                 "drop part.stl --cutter ball:6 --grid 99999x99999 -o x",
                                 "drop part.stl --cutter ball --grid 5x5 -o x",
                                 "drop part.stl --cutter cube:6 --grid 5x5 -o x",
                                 "drop part.stl --cutter ball:six --grid 5x5 -o x",
                                 "reference more"})
            QTest::newRow(line) << line;
    }
    void wrong_usage_is_2() {
        QFETCH(QString, line);
        Sandbox s;
        s.write("part.stl", small_part);
        s.write("job.facetmill", good_project);
        const QStringList before = s.files();
        const CliRun run = run_cli(line.split(' ', Qt::SkipEmptyParts), s.path());
        QCOMPARE(run.status, 2);
        QCOMPARE(run.code(), QByteArray("usage"));
        QCOMPARE(run.err_lines(), 2); // what is wrong, and the usage
        QVERIFY(run.err.contains("\nusage: facetmill-cli "));
        QVERIFY(run.out.isEmpty());
        QCOMPARE(s.files(), before);
    }

    void failed_jobs_are_1_data() {
        QTest::addColumn<QString>("line");
        QTest::addColumn<QByteArray>("code");
        QTest::addColumn<QByteArray>("place"); // in the line on stderr
        QTest::addColumn<QByteArray>("project");
        const auto row = [](const char* name, const char* line, const char* code, const char* place,
                            const QByteArray& project = good_project) {
            QTest::newRow(name) << line << QByteArray(code) << QByteArray(place) << project;
        };
        row("no part", "info none.stl", "not_found", "none.stl");
        row("a folder", "info .", "is_directory", ".");
        row("empty", "info empty.stl", "empty_file", "empty.stl");
        row("truncated", "info cut.stl", "truncated", "cut.stl");
        row("no place for a sample", "sample concave -o none/x.stl", "unwritable", "none/x.stl");
        row("a folder as output", "sample concave -o .", "unwritable", ".");
        row("a device as output", "sample concave -o /dev/null", "unwritable", "/dev/null");
        row("tolerance 0 of a sample", "sample concave --tolerance 0 -o x.stl", "out_of_range", "concave");
        row("tolerance -1 of a sample", "sample concave --tolerance -1 -o x.stl", "out_of_range", "concave");
        row("negative cutter", "drop part.stl --cutter ball:-6 --grid 5x5 -o x", "out_of_range", "--cutter");
        row("corner too large", "drop part.stl --cutter bull:6,4 --grid 5x5 -o x", "out_of_range",
            "--cutter");
        row("bad points", "drop part.stl --cutter ball:6 --points bad.txt -o x", "syntax", "bad.txt:3");
        row("half a point", "drop part.stl --cutter ball:6 --points half.txt -o x", "syntax", "half.txt:1");
        row("three numbers", "drop part.stl --cutter ball:6 --points three.txt -o x", "syntax",
            "three.txt:2");
        row("far point", "drop part.stl --cutter ball:6 --points far.txt -o x", "coordinate_range",
            "far.txt:1");
        row("no points", "drop part.stl --cutter ball:6 --points comment.txt -o x", "empty_result",
            "comment.txt");
        row("drop on nothing", "drop none.stl --cutter ball:6 --grid 5x5 -o x", "not_found", "none.stl");
        row("drop over its part", "drop part.stl --cutter ball:6 --grid 5x5 -o ./part.stl", "unwritable",
            "part.stl");
        row("drop over its points", "drop part.stl --cutter ball:6 --points half.txt -o half.txt",
            "unwritable", "half.txt");
        row("render over its part", "render part.stl -o part.stl", "unwritable", "part.stl");
        row("no project", "plan none.facetmill -o out", "not_found", "none.facetmill");
        row("a mesh as project", "plan part.stl -o out", "syntax", "part.stl:1");
        row("a picture as part", "info picture.stl", "not_stl", "picture.stl");
        row("a file as folder", "plan job.facetmill -o part.stl", "unwritable", "part.stl");
        row("unknown operation", "plan job.facetmill -o out --op Rough", "missing_reference", "Rough");
        row("set unknown", "plan job.facetmill -o out --set Finish.tolerence=1", "unknown_key", "tolerence");
        row("set 0", "plan job.facetmill -o out --set Finish.tolerance=0", "out_of_range",
            "Finish.tolerance=0");
        row("set tool", "plan job.facetmill -o out --set Finish.tool=2", "missing_reference",
            "job.facetmill: operations[0].tool");
        const char* plan = "plan job.facetmill -o out";
        row("unknown key", plan, "unknown_key", "job.facetmill: operations[0].tolerence",
            changed("tolerance", "tolerence"));
        row("wrong type", plan, "wrong_type", "job.facetmill: tools[0].diameter",
            changed("\"diameter\": 6", "\"diameter\": \"6\""));
        row("negative diameter", plan, "out_of_range", "job.facetmill: tools[0].diameter",
            changed("\"diameter\": 6", "\"diameter\": -6"));
        row("step-over 0", plan, "out_of_range", "job.facetmill: operations[0].stepover",
            changed("\"adaptive\"", "0"));
        row("tolerance 0", plan, "out_of_range", "job.facetmill: operations[0].tolerance",
            changed("0.1", "0"));
        row("tool missing", plan, "missing_reference", "job.facetmill: operations[0].tool",
            changed("\"tool\": 1", "\"tool\": 7"));
        row("part missing", plan, "not_found", "nothing.stl", changed("part.stl", "nothing.stl"));
        row("part is a folder", plan, "is_directory", "folder", changed("part.stl", "folder"));
        row("part is empty", plan, "empty_file", "empty.stl", changed("part.stl", "empty.stl"));
        row("part is the project", plan, "unsupported_format", "job.facetmill: part.file",
            changed("part.stl", "job.facetmill"));
        row("no operations", plan, "missing_key", "job.facetmill: operations",
            "{\"facetmill\":1,\"units\":\"mm\",\"part\":{\"file\":\"part.stl\"}}");
        row("cut project", plan, "truncated", "job.facetmill:2", QByteArray(good_project).left(110));
        row("newer project", plan, "newer_version", "job.facetmill",
            changed("\"facetmill\": 1", "\"facetmill\": 99"));
        row("empty project", plan, "empty_file", "job.facetmill", "");
        row("NaN", plan, "syntax", "job.facetmill:3", changed("0.1", "NaN"));
    }
    void failed_jobs_are_1() {
        QFETCH(QString, line);
        QFETCH(QByteArray, code);
        QFETCH(QByteArray, place);
        QFETCH(QByteArray, project);
        Sandbox s;
        s.write("part.stl", small_part);
        s.write("job.facetmill", project);
        s.write("empty.stl", "");
        s.write("cut.stl", QByteArray(small_part).left(150));
        s.write("picture.stl", QByteArray("\x89PNG\r\n\x1a\n\0\0\0\rIHDR\0\0\0\1\0\0\0\1\x08\2\0\0\0", 29));
        s.write("bad.txt", "1 2\n# note\n1 x\n");
        s.write("half.txt", "1\n");
        s.write("three.txt", "1 2\n1 2 3\n");
        s.write("far.txt", "1 2e9\n");
        s.write("comment.txt", "# nothing\n\n");
        QVERIFY(QDir(s.path()).mkdir("folder"));
        const QStringList before = s.files();
        const CliRun run = run_cli(line.split(' '), s.path());
        QVERIFY2(run.status == 1, run.err);
        QVERIFY2(run.code() == code, run.err);
        QVERIFY2(run.err_lines() == 1 && run.err.endsWith(")\n"), run.err); // one line, with a remedy
        QVERIFY2(run.err.contains(place), run.err);
        QVERIFY(run.out.isEmpty());
        QCOMPARE(s.files(), before); // nothing written, nothing left
    }

    void info_tells_what_is_there() {
        Sandbox s;
        s.write("part.stl", small_part);
        const QJsonObject o = json(run_cli({"info", "part.stl", "--units", "in"}, s.path()).out);
        QCOMPARE(o["facets"].toInt(), 3);
        QCOMPARE(o["welded_vertices"].toInt(), 5);
        QCOMPARE(o["vertices"].toInt(), 5);
        QCOMPARE(o["shells"].toInt(), 1);
        QCOMPARE(o["open_edges"].toInt(), 5);
        QCOMPARE(o["watertight"].toBool(true), false);
        QCOMPARE(o["bbox"].toArray(), (QJsonArray{0, 0, 0, 20, 20, 4}));
        QCOMPARE(o["size_mm"].toArray(), (QJsonArray{508, 508, 101.6}));
        for (const char* key : {"degenerate", "duplicate", "non_manifold_edges", "volume"})
            QVERIFY2(o[key].isDouble(), key);
        QVERIFY(o["warnings"].toArray().contains("open_edges"));
        QVERIFY(!o["explanations"]["open_edges"].toString().isEmpty());
    }

    /// What is printed is what a project takes, and the part lies then.
    void place_prints_what_a_project_takes() {
        Sandbox s;
        run_cli({"sample", "square-prism", "--tolerance", "0.5", "--units", "mm", "-o", "bar.stl"}, s.path());
        const Box3 bar = load_mesh((s.path() + "/bar.stl").toStdString(), LengthUnit::mm, {}).mesh->box();
        // Of a file in metres, too, for which a project has no unit of its own.
        const std::vector<std::array<QString, 3>> asked{{"best", "mm", "mm"},
                                                        {"largest", "mm", "mm"},
                                                        {"0", "mm", "mm"},
                                                        {"0", "m", "mm"},
                                                        {"0", "ft", "in"}};
        for (const auto& [on, of_file, of_project] : asked) {
            const QJsonObject o =
                json(run_cli({"place", "bar.stl", "--on", on, "--square", "--units", of_file}, s.path()).out);
            QCOMPARE(o["units"].toString(), of_project);
            const QJsonObject project{{"facetmill", 1}, {"units", o["units"]}, {"part", o["part"]}};
            s.write("p.facetmill", QJsonDocument(project).toJson());
            const Project placed = load_project((s.path() + "/p.facetmill").toStdString());
            const Box3 box = Planner().prepare(placed, {})->box;
            const double per = of_project == "in" ? 25.4 : 1, rounded = of_file == "mm" ? 1e-6 : 1e-4;
            for (int k = 0; k < 3; ++k) {
                QVERIFY(std::abs(o["low"][k].toDouble() * per - box.lo[k]) < rounded);
                QVERIFY(std::abs(o["high"][k].toDouble() * per - box.hi[k]) < rounded);
            }
            QVERIFY(std::abs(box.lo.z()) < rounded);
            if (on == "0") continue;
            // A bar lies along, not on its end.
            QVERIFY(std::abs(box.size().x() - bar.size().maxCoeff()) < 1e-6);
            QVERIFY(o["lies_on"]["contact_area"].toDouble() > 0);
            QVERIFY(o["candidates"].toArray().size() > 1);
        }
        const CliRun far = run_cli({"place", "bar.stl", "--on", "123456"}, s.path());
        QCOMPARE(far.status, 1);
        QVERIFY(far.err.contains("--on"));
    }

    /// Out of a project, over Fusion's format into the user's own libraries, and from there into another one.
    void tools_go_from_hand_to_hand() {
        const Sandbox s;
        QFile::copy(QStringLiteral(FACETMILL_TEST_DATA "/golden/jobs/rough.facetmill"),
                    s.path() + QStringLiteral("/p.facetmill"));
        const CliRun out = run_cli({"tools", "export", "shop.json", "--project", "p.facetmill"}, s.path());
        QVERIFY2(out.status == 0, out.err.constData());
        QCOMPARE(json(out.out)["remarks"].toArray().size(), 0);
        const CliRun in = run_cli({"tools", "import", "shop.json", "--library", "own"}, s.path());
        QVERIFY2(in.status == 0, in.err.constData());
        QVERIFY(QFile::exists(s.path() + QStringLiteral("/own/shop.fmtools")));
        // A second library of the name takes no place of the first.
        QCOMPARE(run_cli({"tools", "import", "shop.json", "--library", "own"}, s.path()).status, 0);
        QVERIFY(QFile::exists(s.path() + QStringLiteral("/own/shop 2.fmtools")));
        QFile::remove(s.path() + QStringLiteral("/own/shop 2.fmtools"));
        const auto tools = json(in.out)["tools"].toArray();
        QVERIFY(!tools.isEmpty());
        const CliRun put =
            run_cli({"tools", "import", "own/shop.fmtools", "--project", "p.facetmill", "-o", "q.facetmill"},
                    s.path());
        QVERIFY2(put.status == 0, put.err.constData());
        QFile both(s.path() + QStringLiteral("/q.facetmill"));
        QVERIFY(both.open(QIODevice::ReadOnly));
        const auto listed = json(both.readAll())["tools"].toArray();
        QCOMPARE(listed.size(), 2 * tools.size());
        QSet<int> numbers;
        for (const auto& tool : listed)
            numbers.insert(tool.toObject()["number"].toInt());
        QCOMPARE(numbers.size(), listed.size());
        // What a format leaves out is said; what it cannot carry at all is an error that writes nothing.
        const CliRun table = run_cli({"tools", "export", "t.tbl", "--library", "own"}, s.path());
        QVERIFY2(table.status == 0, table.err.constData());
        QVERIFY(!json(table.out)["remarks"].toArray().isEmpty());
        const CliRun over = run_cli(
            {"tools", "import", "shop.json", "--project", "p.facetmill", "-o", "p.facetmill"}, s.path());
        QCOMPARE(over.status, 1);
        const CliRun none = run_cli({"tools", "export", "x.json", "--library", "empty"}, s.path());
        QCOMPARE(none.status, 1);
        QVERIFY(none.err.contains("not_found"));
        QVERIFY(!QFile::exists(s.path() + QStringLiteral("/x.json")));
        QCOMPARE(run_cli({"tools", "lend", "x.json"}, s.path()).status, 2);
    }

    void packed_projects_are_told_by_their_name() {
        Sandbox s;
        s.write("part.stl", "no mesh at all");
        s.write("p.facetmill", good_project);
        const CliRun packed = run_cli({"pack", "p.facetmill", "-o", "sent.facetmill"}, s.path());
        QVERIFY2(packed.status == 0, packed.err.constData());
        const QJsonObject told = json(packed.out);
        QCOMPARE(told["project"].toString(), QString("p.facetmill"));
        QCOMPARE(told["files"][1].toObject()["name"].toString(), QString("files/part.stl"));
        const CliRun failed = run_cli({"plan", "sent.facetmill", "-o", "out"}, s.path());
        QCOMPARE(failed.status, 1);
        QVERIFY2(failed.err.contains("] sent.facetmill: files/part.stl: "), failed.err.constData());
        QCOMPARE(failed.err_lines(), 1);
        for (const QString output : {"sent.facetmill", "./sent.facetmill", "p.facetmill", "part.stl"}) {
            const QByteArray before = bytes_of(s.path() + "/" + output);
            const QString from = output.contains("sent") ? "sent.facetmill" : "p.facetmill";
            const CliRun over = run_cli({"pack", from, "-o", output}, s.path());
            QCOMPARE(over.status, 1);
            QCOMPARE(over.code(), QByteArray("unwritable"));
            QVERIFY(bytes_of(s.path() + "/" + output) == before);
        }
        const QByteArray whole = bytes_of(s.path() + "/sent.facetmill");
        s.write("cut.facetmill", whole.left(whole.size() / 2));
        const CliRun cut = run_cli({"unpack", "cut.facetmill", "-o", "there"}, s.path());
        QCOMPARE(cut.status, 1);
        QVERIFY2(cut.err.contains("cut.facetmill: is no sound archive"), cut.err.constData());
        QVERIFY(!QDir(s.path() + "/there").exists());
        const CliRun unpacked = run_cli({"unpack", "sent.facetmill", "-o", "there"}, s.path());
        QVERIFY2(unpacked.status == 0, unpacked.err.constData());
        QCOMPARE(json(unpacked.out)["files"][0].toObject()["file"].toString(), QString("there/p.facetmill"));
        QCOMPARE(s.files("there"), QStringList({"files", "p.facetmill"}));
        // Once more is no harm; never over another file.
        QCOMPARE(run_cli({"unpack", "sent.facetmill", "-o", "there"}, s.path()).status, 0);
        s.write("there/p.facetmill", "{}");
        const CliRun over = run_cli({"unpack", "sent.facetmill", "-o", "there"}, s.path());
        QCOMPARE(over.status, 1);
        QCOMPARE(over.code(), QByteArray("unwritable"));
        QCOMPARE(bytes_of(s.path() + "/there/p.facetmill"), QByteArray("{}"));
    }

    void samples_are_in_their_units() {
        Sandbox s;
        const QJsonObject made = json(
            run_cli({"sample", "cylinder", "--tolerance", "0.5", "--units", "mm", "-o", "c.stl"}, s.path())
                .out);
        QCOMPARE(made["units"].toString(), QString("mm"));
        const QJsonObject read = json(run_cli({"info", "c.stl"}, s.path()).out);
        QCOMPARE(read["facets"].toInt(), made["facets"].toInt());
        QCOMPARE(read["watertight"].toBool(), true);
        for (int k = 0; k < 6; ++k)
            QVERIFY(std::abs(read["bbox"][k].toDouble() - made["bbox"][k].toDouble()) < 1e-4);
        const QJsonObject inch = json(
            run_cli({"sample", "cylinder", "--tolerance", "0.02", "--units", "in", "-o", "c.stl"}, s.path())
                .out);
        QVERIFY(std::abs(inch["bbox"][3].toDouble() * 25.4 - made["bbox"][3].toDouble()) < 0.6);
        QCOMPARE(s.files(), QStringList{"c.stl"});
    }

    void drop_is_the_axial_lift() {
        Sandbox s;
        s.write("part.stl", small_part);
        const struct {
            const char* shape;
            AptCutter cutter; // of the same numbers in inches
        } cutters[] = {{"ball:6", AptCutter::ball(6 * 25.4, 1e5)},
                       {"flat:6", AptCutter::flat(6 * 25.4, 1e5)},
                       {"bull:6,1", AptCutter::bull(6 * 25.4, 25.4, 1e5)},
                       {"cone:6,30", AptCutter::cone(6 * 25.4, radians(30))},
                       {"apt:6,1,2,1,0,0,50", AptCutter{6 * 25.4, 25.4, 2 * 25.4, 25.4, 0, 0, 50 * 25.4}}};
        const LoadedMesh part = load_mesh((s.path() + "/part.stl").toStdString(), LengthUnit::inch, {});
        const auto index = std::make_shared<const ContactIndex>(part.mesh, Progress());
        for (const auto& c : cutters) {
            const CliRun run = run_cli(
                {"drop", "part.stl", "--units", "in", "--cutter", c.shape, "--grid", "13x9", "-o", "z.txt"},
                s.path());
            QVERIFY2(run.status == 0, run.err);
            const AxialLift lift(index, CutterProfile(c.cutter));
            QFile file(s.path() + "/z.txt");
            QVERIFY(file.open(QIODevice::ReadOnly));
            int n = 0;
            for (; !file.atEnd(); ++n) {
                const QByteArray line = file.readLine().trimmed();
                const auto fields = line.split(' ');
                QCOMPARE(fields.size(), 3);
                const double x = fields[0].toDouble(), y = fields[1].toDouble();
                QVERIFY(std::abs(x - 20.0 * (n % 13) / 12) < 1e-9
                        && std::abs(y - 20.0 * (n / 13) / 8) < 1e-9);
                QCOMPARE(fields[0].size() - fields[0].indexOf('.') - 1, 9);
                const double z = lift.tip_z(x * 25.4, y * 25.4) / 25.4;
                if (std::isinf(z))
                    QCOMPARE(fields[2], QByteArray("-inf"));
                else
                    QVERIFY(std::abs(fields[2].toDouble() - z) < 1e-9);
            }
            QCOMPARE(n, 13 * 9);
        }
        s.write("p.txt", "# x y\n10 5\r\n\n  0.5,1e1 \n100 100");
        const CliRun run =
            run_cli({"drop", "part.stl", "--cutter", "flat:2", "--points", "p.txt", "-o", "z.txt"}, s.path());
        QVERIFY2(run.status == 0, run.err);
        QCOMPARE(json(run.out)["contacts"].toInt(), 2);
        QFile file(s.path() + "/z.txt");
        QVERIFY(file.open(QIODevice::ReadOnly));
        QCOMPARE(file.readAll(),
                 QByteArray("10.000000000 5.000000000 2.400000000\n0.500000000 10.000000000 4.000000000\n"
                            "100.000000000 100.000000000 -inf\n"));
    }

    void a_full_or_closed_stdout_is_told() {
        Sandbox s;
        s.write("part.stl", small_part);
        QProcess process;
        process.setWorkingDirectory(s.path());
        process.setStandardOutputFile("/dev/full");
        process.start(FACETMILL_CLI, {"info", "part.stl"});
        QVERIFY(process.waitForFinished());
        QCOMPARE(process.exitStatus(), QProcess::NormalExit);
        QCOMPARE(process.exitCode(), 1);
        QVERIFY(process.readAllStandardError().startsWith("facetmill-cli: error [unwritable] stdout: "));
    }

    void more_work_than_usual_wants_a_word() {
        Sandbox s;
        s.write("part.stl", small_part);
        s.write("p.facetmill", changed("\"tolerance\": 0.1", "\"tolerance\": 1e-9"));
        const CliRun plan = run_cli({"plan", "p.facetmill", "-o", "out"}, s.path());
        QCOMPARE(plan.code(), QByteArray("limit_exceeded"));
        QVERIFY(plan.err.contains("operation 'Finish'") && plan.err.contains("--yes-large"));
        s.write("p.facetmill", good_project);
        const CliRun simulate =
            run_cli({"simulate", "p.facetmill", "--spacing", "1e-9", "-o", "out"}, s.path());
        QCOMPARE(simulate.code(), QByteArray("limit_exceeded"));
        QVERIFY(simulate.err.contains("--spacing"));
        QCOMPARE(s.files(), (QStringList{"p.facetmill", "part.stl"}));
    }

    /// A job whose result nobody could be told has failed, and a failed job leaves nothing.
    void a_full_stdout_leaves_no_files() {
        Sandbox s;
        s.write("part.stl", small_part);
        s.write("p.facetmill", good_project);
        const QStringList before = s.files();
        for (const QStringList& job :
             {QStringList{"sample", "pillar", "-o", "out.stl"},
              QStringList{"plan", "p.facetmill", "-o", "out"},
              QStringList{"drop", "part.stl", "--cutter", "ball:2", "--grid", "2x2", "-o", "out.txt"}}) {
            QProcess process;
            process.setWorkingDirectory(s.path());
            process.setStandardOutputFile("/dev/full");
            process.start(FACETMILL_CLI, job);
            QVERIFY(process.waitForFinished());
            QCOMPARE(process.exitCode(), 1);
            QCOMPARE(s.files(), before);
        }
    }

    /// By whatever name: an input that is called as an output, and a second name of one.
    void inputs_are_never_overwritten() {
        Sandbox s;
        s.write("report.json", good_project);
        s.write("part.stl", small_part);
        const auto refused = [&](const QStringList& job, const char* input) {
            const QByteArray before = bytes_of(s.path() + "/" + input);
            const CliRun run = run_cli(job, s.path());
            return run.code() == "unwritable" && bytes_of(s.path() + "/" + input) == before;
        };
        QVERIFY(refused({"plan", "report.json", "-o", "."}, "report.json"));
        QVERIFY(QFile::rename(s.path() + "/report.json", s.path() + "/p.facetmill"));
        QVERIFY(QFile::link("../part.stl", s.path() + "/link.stl") && QDir(s.path()).mkdir("out"));
        QVERIFY(QFile::link("../part.stl", s.path() + "/out/01-Finish.apt"));
        QVERIFY(refused({"plan", "p.facetmill", "-o", "out"}, "part.stl"));
        QVERIFY(QFile::remove(s.path() + "/out/01-Finish.apt"));
        const QByteArray machine =
            bytes_of(QString::fromStdString(data_path("../resources/machines/generic-3-axis.json")));
        QVERIFY(!machine.isEmpty());
        s.write("verify.json", machine);
        s.write("m.facetmill", changed("\"tools\"", "\"machine\": \"verify.json\", \"tools\""));
        QVERIFY(refused({"simulate", "m.facetmill", "-o", "."}, "verify.json"));
        for (const char* input : {"m.facetmill", "part.stl", "verify.json"})
            QVERIFY(refused({"report", "m.facetmill", "-o", input}, input));
        QVERIFY(refused({"drop", "part.stl", "--cutter", "ball:2", "--grid", "2x2", "-o", "./part.stl"},
                        "part.stl"));
    }

    void the_reference_page_prints() {
        Sandbox s;
        const CliRun run = run_cli({"reference"}, s.path());
        QCOMPARE(run.status, 0);
        QVERIFY(run.out.contains("### `finish3`"));
        QCOMPARE(run_cli({"reference", "-o", "r.md"}, s.path()).status, 0);
        QFile file(s.path() + "/r.md");
        QVERIFY(file.open(QIODevice::ReadOnly));
        QCOMPARE(file.readAll(), run.out);
    }

    void pictures_are_drawn() {
        Sandbox s;
        s.write("part.stl", small_part);
        const CliRun run =
            run_cli({"render", "part.stl", "--view", "top", "--size", "160x120", "-o", "p.png"}, s.path());
#ifdef FACETMILL_HAS_PICTURES
        QVERIFY2(run.status == 0, run.err);
        QFile file(s.path() + "/p.png");
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QByteArray png = file.readAll();
        QVERIFY(png.startsWith("\x89PNG\r\n\x1a\n"));
        QCOMPARE(png.mid(16, 8), QByteArray("\0\0\0\xA0\0\0\0\x78", 8));
        for (const char* bad : {"--view=sideways", "--size=0x5", "--size=big", "--show=part,soul"}) {
            const CliRun refused = run_cli({"render", "part.stl", bad, "-o", "q.png"}, s.path());
            QCOMPARE(refused.status, 2);
            QCOMPARE(refused.code(), QByteArray("usage"));
        }
        QCOMPARE(run_cli({"render", "part.stl", "--show", "cl", "-o", "q.png"}, s.path()).status, 1);
        QCOMPARE(s.files(), (QStringList{"p.png", "part.stl"}));
#else
        QCOMPARE(run.status, 1);
        QCOMPARE(run.code(), QByteArray("unsupported_format"));
        QCOMPARE(s.files(), QStringList{"part.stl"});
#endif
    }

#ifdef FACETMILL_HAS_PICTURES
    /// What draws is another program; where it is missing that is said, and all else goes on without it.
    void the_program_that_draws_may_be_missing() {
        Sandbox s;
        s.write("part.stl", small_part);
        QByteArray said;
        const auto status_of = [&](const QString& program, const QStringList& arguments) {
            QProcess run;
            run.setWorkingDirectory(s.path());
            run.start(program, arguments);
            if (!run.waitForFinished(60'000)) return -1;
            said = run.readAllStandardError();
            return run.exitCode();
        };
        const QStringList draw{"render", "part.stl", "--size", "160x120", "-o", "p.png"};
        const QString alone = s.path() + "/facetmill-cli", installed = s.path() + "/bin/facetmill-cli";
        QVERIFY(QFile::copy(QStringLiteral(FACETMILL_CLI), alone));
        QCOMPARE(status_of(alone, draw), 1);
        QVERIFY2(said.contains("[not_found] facetmill-pictures"), said);
        QVERIFY(!QFile::exists(s.path() + "/p.png"));
        QCOMPARE(status_of(alone, {"render", "--help"}), 0);
        QCOMPARE(status_of(alone, {"info", "part.stl"}), 0);
        // Installed, it stands in ../libexec/facetmill.
        QVERIFY(QDir(s.path()).mkpath("bin") && QDir(s.path()).mkpath("libexec/facetmill"));
        QVERIFY(QFile::rename(alone, installed));
        const QString beside = QFileInfo(QStringLiteral(FACETMILL_CLI)).path() + "/facetmill-pictures";
        QVERIFY(QFile::copy(beside, s.path() + "/libexec/facetmill/facetmill-pictures"));
        QVERIFY2(status_of(installed, draw) == 0, said);
        QVERIFY(QFile::exists(s.path() + "/p.png"));
    }
#endif

    void signals_leave_nothing_data() {
        QTest::addColumn<QStringList>("arguments");
        QTest::addColumn<QStringList>("outputs"); // of a run that was faster than the signal
        QTest::newRow("plan") << QStringList{"plan", "job.facetmill", "-o", "out"} << QStringList{"out"};
        QTest::newRow("report") << QStringList{"report", "job.facetmill", "-o", "sheet.html"}
                                << QStringList{"sheet.html"};
        QTest::newRow("drop") << QStringList{"drop",   "part.stl",  "--cutter", "bull:1,0.2",
                                             "--grid", "1500x1500", "-o",       "z.txt"}
                              << QStringList{"z.txt"};
        QTest::newRow("sample") << QStringList{"sample", "complex", "--tolerance", "0.0001", "-o", "big.stl"}
                                << QStringList{"big.stl"};
    }
    /// At any time: either the run ends as cancelled and the folder is as before, or it was done already, or
    /// the signal came while the program was being loaded or unloaded and took its default action.
    void signals_leave_nothing() {
        QFETCH(QStringList, arguments);
        QFETCH(QStringList, outputs);
        Sandbox s;
        QCOMPARE(run_cli({"sample", "concave", "--tolerance", "0.001", "-o", "part.stl"}, s.path()).status,
                 0);
        s.write("job.facetmill", changed("\"tolerance\": 0.1", "\"tolerance\": 0.00002")
                                     .replace("6, \"corner_radius\": 3", "0.5, \"corner_radius\": 0.25"));
        const QStringList before = s.files();
        std::mt19937 rng(11);
        int cancelled = 0;
        // Where the machine is busy a program may take its time to be loaded: more tries, and later ones.
        for (int round = 0; round < 6 || (cancelled == 0 && round < 40); ++round) {
            const int after = round == 0 ? 60 : 20 + int(rng() % (round < 6 ? 500 : 2000));
            const CliRun run = run_cli_and_signal(arguments, s.path(), round % 2 ? SIGTERM : SIGINT, after);
            if (run.status == 0 || run.killed) {
                for (const QString& o : outputs) {
                    QDir(s.path() + "/" + o).removeRecursively();
                    QFile::remove(s.path() + "/" + o);
                }
            } else {
                ++cancelled;
                QCOMPARE(run.status, 1);
                QVERIFY2(run.err.endsWith("facetmill-cli: cancelled\n"), run.err);
                QVERIFY(run.out.isEmpty());
            }
            QCOMPARE(s.files(), before);
        }
        QVERIFY(cancelled > 0);
    }
};

FACETMILL_TEST(TestCli)
#include "test_cli.moc"
