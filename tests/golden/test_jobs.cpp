// Whole jobs through the program's own door: a project in, files out. The numbers are held at a declared
// tolerance, and the path is judged by a check of its own that shares no code with the planner.
#include "core/mesh/mesh_io.h"
#include "tests/golden/run_cli.h"
#include "tests/support/test_runner.h"

#include <QDir>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTest>

#include <cmath>
#include <map>
#include <sstream>

using namespace facetmill;
using namespace facetmill::test;

namespace {

struct Move {
    Vec3 tip; // inches, as in the file
    bool rapid = false;
};

/// The few words a 3-axis program may hold, read without the program's own reader.
std::vector<Move> moves_of(const QByteArray& apt) {
    std::vector<Move> moves;
    bool rapid = false;
    for (const QByteArray& line : apt.split('\n')) {
        if (line == "RAPID") rapid = true;
        if (!line.startsWith("GOTO/")) continue;
        const auto fields = line.mid(5).split(',');
        if (fields.size() != 3) qFatal("a GOTO of a 3-axis program has not three numbers");
        moves.push_back({Vec3(fields[0].toDouble(), fields[1].toDouble(), fields[2].toDouble()), rapid});
        rapid = false;
    }
    return moves;
}

/// Distance of a point from a triangle (Ericson, Real-Time Collision Detection, 5.1.5).
double distance(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
    const Vec3 ab = b - a, ac = c - a, ap = p - a;
    const double d1 = ab.dot(ap), d2 = ac.dot(ap);
    if (d1 <= 0 && d2 <= 0) return ap.norm();
    const Vec3 bp = p - b;
    const double d3 = ab.dot(bp), d4 = ac.dot(bp);
    if (d3 >= 0 && d4 <= d3) return bp.norm();
    const double vc = d1 * d4 - d3 * d2;
    if (vc <= 0 && d1 >= 0 && d3 <= 0) return (ap - ab * (d1 / (d1 - d3))).norm();
    const Vec3 cp = p - c;
    const double d5 = ab.dot(cp), d6 = ac.dot(cp);
    if (d6 >= 0 && d5 <= d6) return cp.norm();
    const double vb = d5 * d2 - d1 * d6;
    if (vb <= 0 && d2 >= 0 && d6 <= 0) return (ap - ac * (d2 / (d2 - d6))).norm();
    const double va = d3 * d6 - d5 * d4;
    if (va <= 0 && d4 >= d3 && d5 >= d6) return (bp - (c - b) * ((d4 - d3) / ((d4 - d3) + (d5 - d6)))).norm();
    const double s = 1 / (va + vb + vc);
    return (ap - ab * (vb * s) - ac * (vc * s)).norm();
}

/// Smallest distance of a point from the part.
double distance(const Vec3& p, const Mesh& mesh, double beyond) {
    double least = beyond;
    for (std::size_t f = 0; f < mesh.facet_count(); ++f)
        least = std::min(least, distance(p, mesh.corner(f, 0), mesh.corner(f, 1), mesh.corner(f, 2)));
    return least;
}

} // namespace

class TestJobs : public QObject {
    Q_OBJECT
private slots:

    void initTestCase() {
        QVERIFY(sandbox_.copy("golden/jobs/convex"));
        const CliRun run = run_cli({"plan", "job.facetmill", "-o", "out"}, sandbox_.path());
        QVERIFY2(run.status == 0, run.err);
        // Nothing but how far it is, which is told where it takes long.
        for (const QByteArray& line : run.err.split('\n'))
            QVERIFY2(line.isEmpty() || line.contains(" % "), run.err);
        QCOMPARE(sandbox_.files("out"), (QStringList{"01-Semi-finish.apt", "02-Finish.apt", "report.json"}));
        QCOMPARE(run.out, bytes_of(sandbox_.path() + "/out/report.json"));
        report_ = QJsonDocument::fromJson(run.out).object();
    }

    /// FACETMILL_UPDATE_GOLDEN=1 renews expected.json; look at the change before you commit it.
    void the_report_is_as_expected() {
        const QString path = QString::fromStdString(test::data_path("golden/jobs/convex/expected.json"));
        // Relative. A better step-over or fewer points may move them; a different path would move them more.
        const std::map<QString, double> tolerances = {
            {"passes", 0.025},      {"stepover_min", 0.02}, {"stepover_max", 0.02}, {"cc_points", 0.05},
            {"cl_points", 0.05},    {"cleanup_points", 0},  {"rework_regions", 0},  {"cut_length", 0.02},
            {"rapid_length", 0.03}, {"time_seconds", 0.02}, {"cusp_max", 0.05}};
        const QJsonArray operations = report_["operations"].toArray();
        QCOMPARE(operations.size(), 2);
        if (qEnvironmentVariableIsSet("FACETMILL_UPDATE_GOLDEN")) {
            QJsonArray kept;
            for (const auto& o : operations) {
                QJsonObject entry{{"name", o.toObject()["name"]}, {"kind", o.toObject()["kind"]}};
                for (const auto& [key, relative] : tolerances)
                    entry[key] = o.toObject()[key];
                kept.append(entry);
            }
            QFile file(path);
            QVERIFY(file.open(QIODevice::WriteOnly));
            file.write(QJsonDocument(QJsonObject{{"operations", kept}}).toJson());
        }
        const QJsonArray expected = QJsonDocument::fromJson(bytes_of(path)).object()["operations"].toArray();
        QCOMPARE(expected.size(), operations.size());
        for (qsizetype i = 0; i < operations.size(); ++i) {
            const QJsonObject o = operations[i].toObject(), e = expected[i].toObject();
            QCOMPARE(o["name"], e["name"]);
            QCOMPARE(o["kind"], e["kind"]);
            for (const auto& [key, relative] : tolerances) {
                QVERIFY2(o[key].isDouble() && e[key].isDouble(), qPrintable(key));
                const double is = o[key].toDouble(), should = e[key].toDouble();
                QVERIFY2(std::abs(is - should) <= relative * std::abs(should),
                         qPrintable(QString("%1 of %2: %3, expected %4")
                                        .arg(key, o["name"].toString())
                                        .arg(is)
                                        .arg(should)));
            }
            QVERIFY(o["warnings"].isArray());
            QVERIFY(o["seconds_planning"].toDouble() > 0);
        }
        const QJsonObject finish = operations[1].toObject();
        QVERIFY(finish["cusp_max"].toDouble() <= 0.01 * (1 + 1e-9));
        QVERIFY(finish["stepover_max"].toDouble() > finish["stepover_min"].toDouble());
        QVERIFY(std::abs(operations[0]["stepover_max"].toDouble() - 0.25) < 1e-9);
    }

    /// Along every cut of the ball, sampled densely: its centre keeps the radius from the mesh within the
    /// chord tolerance (a twentieth of the tolerance) and the last digit of the file.
    void the_ball_does_not_gouge() {
        const LoadedMesh part =
            load_mesh((sandbox_.path() + "/convex.stl").toStdString(), LengthUnit::mm, {});
        const auto moves = moves_of(bytes_of(sandbox_.path() + "/out/02-Finish.apt"));
        QVERIFY(moves.size() > 300);
        const double radius = 0.25, deepest_allowed = 0.01 / 20 + 2e-6;
        const Box3 box = part.mesh->box();
        double deepest = 0, highest_rapid = -infinity, lowest_rapid = infinity;
        std::size_t samples = 0, touching = 0, upright_rapids = 0;
        for (std::size_t i = 1; i < moves.size(); ++i) {
            if (moves[i].rapid) {
                const Vec3 &a = moves[i - 1].tip, &b = moves[i].tip;
                highest_rapid = std::max(highest_rapid, b.z());
                if (a.head<2>() != b.head<2>()) {
                    lowest_rapid = std::min({lowest_rapid, a.z(), b.z()});
                    for (int k = 0; k <= 20; ++k) {
                        const Vec3 center = a + k / 20.0 * (b - a) + Vec3(0, 0, radius);
                        QVERIFY(distance(center, *part.mesh, 2 * radius) > 1.5 * radius);
                    }
                } else {
                    // Straight down to what stands, or up from the pass.
                    const Vec3 low = (a.z() < b.z() ? a : b) + Vec3(0, 0, radius);
                    QVERIFY(distance(low, *part.mesh, 2 * radius) > radius);
                    ++upright_rapids;
                }
                continue;
            }
            if (i % 3 != 0) continue; // a third of the path: enough to find what is wrong everywhere
            for (double t : {0.21, 0.5, 1.0}) {
                const Vec3 center = moves[i - 1].tip * (1 - t) + moves[i].tip * t + Vec3(0, 0, radius);
                const double d = distance(center, *part.mesh, 2 * radius);
                deepest = std::max(deepest, radius - d);
                touching += std::abs(d - radius) < 2 * deepest_allowed;
                ++samples;
            }
        }
        QVERIFY(samples > 300);
        QVERIFY2(deepest <= deepest_allowed, qPrintable(QString::number(deepest)));
        QVERIFY2(touching > samples * 8 / 10,
                 qPrintable(QString("%1 of %2").arg(touching).arg(samples))); // it cuts, and not air
        // Into the first pass above all of the stock, then no higher than what is left of it asks.
        QVERIFY(highest_rapid >= box.hi.z() + 0.125 + 0.5 - 1e-5 && highest_rapid < box.hi.z() + 2);
        QVERIFY(lowest_rapid < box.hi.z() + 0.125);
        QVERIFY(upright_rapids > 0);
    }

    /// Every vertex of the part, those of its slanted border too, lies within the cusp of some cut.
    void nothing_is_left_uncut() {
        const LoadedMesh part =
            load_mesh((sandbox_.path() + "/convex.stl").toStdString(), LengthUnit::mm, {});
        const auto moves = moves_of(bytes_of(sandbox_.path() + "/out/02-Finish.apt"));
        const double radius = 0.25, allowed = 0.01 + 0.01 / 20 + 1e-5;
        double worst = 0;
        for (const Vec3& v : part.mesh->vertices) {
            double nearest = infinity;
            for (std::size_t m = 1; m < moves.size(); ++m) {
                if (moves[m].rapid) continue;
                const Vec3 a = moves[m - 1].tip + Vec3(0, 0, radius), d = moves[m].tip - moves[m - 1].tip;
                const double t = std::clamp((v - a).dot(d) / std::max(d.squaredNorm(), 1e-30), 0.0, 1.0);
                nearest = std::min(nearest, (v - a - t * d).norm());
            }
            worst = std::max(worst, nearest - radius);
        }
        QVERIFY(part.mesh->vertices.size() > 400);
        QVERIFY2(worst <= allowed, qPrintable(QString::number(worst)));
    }

    void threads_do_not_matter() {
        for (const char* n : {"1", "3"}) {
            const QString folder = QString("threads") + n;
            const CliRun run =
                run_cli({"plan", "job.facetmill", "-o", folder, "--threads", n}, sandbox_.path());
            QVERIFY2(run.status == 0, run.err);
            for (const char* file : {"/01-Semi-finish.apt", "/02-Finish.apt"})
                QVERIFY(bytes_of(sandbox_.path() + "/out" + file)
                        == bytes_of(sandbox_.path() + "/" + folder + file));
        }
    }

    void one_operation_with_settings() {
        const CliRun run = run_cli({"plan", "job.facetmill", "-o", "one", "--op", "Finish", "--set",
                                    "Finish.tolerance=0.03", "--set=2.feed=55"},
                                   sandbox_.path());
        QVERIFY2(run.status == 0, run.err);
        QCOMPARE(sandbox_.files("one"), (QStringList{"02-Finish.apt", "report.json"}));
        const QJsonArray operations = QJsonDocument::fromJson(run.out).object()["operations"].toArray();
        QCOMPARE(operations.size(), 1);
        QVERIFY(operations[0]["passes"].toInt() < report_["operations"][1]["passes"].toInt());
        QVERIFY(bytes_of(sandbox_.path() + "/one/02-Finish.apt").contains("\nFEDRAT/55.000000,IPM\n"));
    }

    /// The smallest constant step-over of the adaptive plan keeps the same cusp everywhere, with more passes.
    void adaptive_needs_fewer_passes() {
        const QJsonObject adaptive = report_["operations"][1].toObject();
        const QString step = QString::number(adaptive["stepover_min"].toDouble(), 'g', 12);
        const CliRun run = run_cli(
            {"plan", "job.facetmill", "-o", "constant", "--op", "Finish", "--set", "Finish.stepover=" + step},
            sandbox_.path());
        QVERIFY2(run.status == 0, run.err);
        const QJsonObject constant = QJsonDocument::fromJson(run.out).object()["operations"][0].toObject();
        QVERIFY(constant["passes"].toInt() > adaptive["passes"].toInt());
    }

private:
    Sandbox sandbox_;
    QJsonObject report_;
};

FACETMILL_TEST(TestJobs)
#include "test_jobs.moc"
