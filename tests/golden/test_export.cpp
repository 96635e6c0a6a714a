// facetmill-cli export, and what `repair` writes: files of every format, whole or not at all.
#include "core/mesh/mesh_io.h"
#include "tests/golden/run_cli.h"
#include "tests/support/dirty_scan.h"
#include "tests/support/test_runner.h"

#include <QTest>

using namespace facetmill;
using namespace facetmill::test;

namespace {

/// Flat on the table, a shallow dome.
Mesh dome() {
    return *field(12, 24,
                  [](double x, double y) { return 6 - 0.02 * ((x - 12) * (x - 12) + (y - 12) * (y - 12)); });
}

const char* const dome_job = R"({ "facetmill": 1, "units": "mm", "part": { "file": "part.stl", "units": "mm",
  "translate": [0, 0, 5] }, "stock": { "kind": "box", "margin": [2, 2, 1] },
  "tools": [ { "number": 1, "name": "Ball", "diameter": 6, "corner_radius": 3 } ],
  "operations": [ { "kind": "finish3", "name": "Finish", "tool": 1, "tolerance": 0.3, "stepover": "adaptive" } ] })";

LoadedMesh read_back(const Sandbox& s, const char* name) {
    return load_mesh((s.path() + "/" + name).toStdString(), LengthUnit::mm, {});
}

class ExportSandbox : public Sandbox {
public:
    ExportSandbox() {
        save_stl(dome(), (path() + "/part.stl").toStdString(), LengthUnit::mm, {});
        write("job.facetmill", dome_job);
    }
};

} // namespace

class TestExport : public QObject {
    Q_OBJECT
private slots:
    void a_part_in_every_format() {
        const ExportSandbox s;
        for (const char* name : {"a.stl", "a.3mf", "a.ply"}) {
            const CliRun run =
                run_cli({"export", "part.stl", "--units", "in", "--to", "mm", "-o", name}, s.path());
            QVERIFY2(run.status == 0, run.err.constData());
            QCOMPARE(json(run.out)["facets"].toInt(), 288);
            QCOMPARE(json(run.out)["units"].toString(), QString("mm"));
            const LoadedMesh loaded = read_back(s, name);
            QCOMPARE(loaded.mesh->facet_count(), std::size_t(288));
            QVERIFY(std::abs(loaded.mesh->box().hi.x() - 24 * 25.4) < 1e-3);
        }
    }

    void what_a_project_makes() {
        const ExportSandbox s;
        const auto exported = [&](const char* what, const char* name) {
            const CliRun run = run_cli({"export", "job.facetmill", "--what", what, "--resolution", "0.5",
                                        "--spacing", "0.5", "-o", name},
                                       s.path());
            if (run.status != 0) qWarning("%s", run.err.constData());
            return json(run.out);
        };
        QCOMPARE(exported("part", "part.3mf")["what"].toString(), QString("part"));
        QVERIFY(std::abs(read_back(s, "part.3mf").mesh->box().hi.z() - 11) < 1e-5); // where it is placed
        QCOMPARE(exported("stock", "stock.ply")["format"].toString(), QString("PLY"));
        const LoadedMesh stock = read_back(s, "stock.ply");
        QVERIFY(stock.report.watertight);
        // The box of the stock, less what lies above the dome.
        QVERIFY(stock.mesh->box().hi.z() < 12.01 && stock.mesh->box().size().x() > 27.9);
        const QJsonObject deviation = exported("deviation", "deviation.ply");
        QVERIFY(deviation["values"].toBool() && deviation["facets"].toInt() > 288);
        const QByteArray ply = bytes_of(s.path() + "/deviation.ply");
        QVERIFY(ply.contains("property uchar red\n") && ply.contains("property float deviation\n"));
        const LoadedMesh surface = read_back(s, "deviation.ply");
        QVERIFY(std::abs(surface.mesh->box().hi.z() - 11) < 1e-4);
        QVERIFY(!exported("deviation", "deviation.stl")["values"].toBool());
    }

    void repair_writes_every_format() {
        const ExportSandbox s;
        for (const char* name : {"r.stl", "r.3mf", "r.ply", "plain"}) {
            const CliRun run = run_cli({"repair", "part.stl", "--thicken", "2", "-o", name}, s.path());
            QVERIFY2(run.status == 0, run.err.constData());
            QVERIFY(read_back(s, name).report.watertight);
        }
    }

    void scans_are_joined() {
        const ExportSandbox s;
        const Mesh ball = ringed_sphere(20, 10);
        for (const double side : {1.0, -1.0}) {
            Mesh half{ball.vertices, {}};
            for (std::size_t f = 0; f < ball.facet_count(); ++f)
                if (side * ball.corner(f, 0).z() > -3) half.facets.push_back(ball.facets[f]);
            save_stl(half, (s.path() + (side > 0 ? "/top.stl" : "/bottom.stl")).toStdString(), LengthUnit::mm,
                     {});
        }
        const CliRun run =
            run_cli({"repair", "top.stl", "--join", "bottom.stl:0.1", "-o", "ball.3mf"}, s.path());
        QVERIFY2(run.status == 0, run.err.constData());
        QVERIFY(read_back(s, "ball.3mf").report.watertight);
        s.write("recipe.json", R"({"units": "mm", "repair": [{"kind": "join", "file": "bottom.stl"}]})");
        QCOMPARE(
            run_cli({"repair", "top.stl", "--recipe", "recipe.json", "-o", "again.stl"}, s.path()).status, 0);
        const CliRun none = run_cli({"repair", "top.stl", "--join", "nowhere.stl", "-o", "b.stl"}, s.path());
        QCOMPARE(none.status, 1);
        QCOMPARE(none.code(), QByteArray("not_found"));
    }

    void what_fails_leaves_nothing_data() {
        QTest::addColumn<QString>("line");
        QTest::addColumn<int>("status");
        QTest::newRow("format") << "export part.stl -o a.obj" << 1;
        QTest::newRow("repaired format") << "repair part.stl --turn -o a.step" << 1;
        QTest::newRow("nothing") << "export part.stl" << 2;
        QTest::newRow("a part's stock") << "export part.stl --what stock -o a.stl" << 2;
        QTest::newRow("anything") << "export job.facetmill --what shape -o a.stl" << 2;
        QTest::newRow("a project's unit") << "export job.facetmill --units in -o a.stl" << 2;
        QTest::newRow("no setup") << "export job.facetmill --what stock --setup Bottom -o a.stl" << 1;
        QTest::newRow("over the part") << "export job.facetmill -o part.stl" << 1;
        QTest::newRow("over itself") << "export part.stl -o part.stl" << 1;
    }
    void what_fails_leaves_nothing() {
        QFETCH(QString, line);
        QFETCH(int, status);
        const ExportSandbox s;
        const QByteArray part = bytes_of(s.path() + "/part.stl");
        const QStringList before = s.files();
        const CliRun run = run_cli(line.split(' '), s.path());
        QVERIFY2(run.status == status, run.err.constData());
        QVERIFY(run.err.startsWith("facetmill-cli: error ["));
        QCOMPARE(s.files(), before);
        QCOMPARE(bytes_of(s.path() + "/part.stl"), part);
    }
};

FACETMILL_TEST(TestExport)
#include "test_export.moc"
