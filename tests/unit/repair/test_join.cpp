// Scans that overlap, joined: one closed surface, of which the first scan is a part to the last bit.
#include "core/mesh/mesh_io.h"
#include "core/mesh/unused_vertices.h"
#include "core/repair/crossings.h"
#include "core/repair/holes.h"
#include "core/repair/join.h"
#include "tests/support/dirty_scan.h"
#include "tests/support/error_code.h"
#include "tests/support/test_runner.h"
#include "tests/unit/repair/repair_support.h"

#include <QTemporaryDir>
#include <QTest>

#include <Eigen/Geometry>

#include <functional>

using namespace facetmill;
using namespace facetmill::test;

namespace {

using Kind = RepairStep::Kind;

/// The facets whose middles are wanted.
Mesh where(const Mesh& mesh, const std::function<bool(const Vec3&)>& wanted) {
    Mesh part;
    part.vertices = mesh.vertices;
    for (std::size_t f = 0; f < mesh.facet_count(); ++f)
        if (wanted((mesh.corner(f, 0) + mesh.corner(f, 1) + mesh.corner(f, 2)) / 3))
            part.facets.push_back(mesh.facets[f]);
    drop_unused_vertices(part, {});
    return part;
}

/// One facet of so many.
Mesh some(const Mesh& mesh, std::size_t step) {
    Mesh part;
    part.vertices = mesh.vertices;
    for (std::size_t f = 0; f < mesh.facet_count(); f += step)
        part.facets.push_back(mesh.facets[f]);
    return part;
}

Mesh moved(Mesh mesh, const Vec3& axis, double angle, const Vec3& by) {
    const Mat3 turn = Eigen::AngleAxisd(angle, axis.normalized()).toRotationMatrix();
    for (Vec3& p : mesh.vertices)
        p = rounded_to_float(turn * p + by);
    return mesh;
}

class Joined {
public:
    explicit Joined(Mesh first) : mesh_(std::make_shared<Mesh>(std::move(first))) {}

    /// As a recipe does it, from a file.
    StepReport add(const Mesh& other, double apart, double move = 0) {
        const std::string file = folder_.filePath("other.stl").toStdString();
        save_stl(other, file, LengthUnit::mm, {});
        Repaired r = run_recipe(mesh_, {{.kind = Kind::join, .size = apart, .bound = move, .file = file}}, {},
                                LengthUnit::mm);
        mesh_ = r.mesh;
        return r.steps.front();
    }
    const Mesh& mesh() const { return *mesh_; }

private:
    QTemporaryDir folder_;
    MeshPtr mesh_;
};

/// A tube of noise without ends, `from` and `to` in radians.
Mesh tube(int around, int along, double from, double to, std::uint64_t seed) {
    Random rng(seed);
    Mesh mesh;
    for (int j = 0; j <= along; ++j)
        for (int i = 0; i <= around; ++i) {
            const double u = from + (to - from) * i / around, r = 20 + uniform(rng, -0.02, 0.02);
            mesh.vertices.push_back(
                rounded_to_float(Vec3(r * std::cos(u), r * std::sin(u), 30.0 * j / along)));
        }
    for (int j = 0; j < along; ++j)
        for (int i = 0; i < around; ++i) {
            const Index a = Index(j * (around + 1) + i), b = a + 1, c = a + Index(around) + 1, d = c + 1;
            mesh.facets.push_back({a, b, d});
            mesh.facets.push_back({a, d, c});
        }
    return mesh;
}

} // namespace

class TestJoin : public QObject {
    Q_OBJECT
private slots:
    void two_halves_of_a_ball_are_a_ball() {
        for (const int rings : {23, 40, 61}) {
            const Mesh top = where(ringed_sphere(40, 30), [](const Vec3& p) { return p.z() > -4; });
            const Mesh bottom = where(moved(ringed_sphere(rings, 30), Vec3(1, 2, 3), 1, Vec3::Zero()),
                                      [](const Vec3& p) { return p.z() < 5; });
            Joined ball(top);
            const StepReport step = ball.add(bottom, 0.5);
            QCOMPARE(step.count("seams_left_open"), std::size_t(0));
            const MeshReport report = report_of_mesh(ball.mesh());
            QVERIFY2(report.watertight, qPrintable(QString::number(report.open_edges)));
            QCOMPARE(report.shells, std::size_t(1));
            QCOMPARE(report.inconsistent_edges, std::size_t(0));
            QVERIFY(std::abs(report.file_volume / (4.0 / 3 * pi * 27000) - 1) < 0.015);
            QVERIFY(stands_in_order(top, ball.mesh()));
            QVERIFY(crossing_facets(ball.mesh(), {}).empty());
            // What it says of the displacement is what a look at some of all facets finds, and little.
            Mesh both = top;
            append_mesh(both, bottom);
            const double off = std::max(brute_deviation(some(ball.mesh(), 41), both),
                                        brute_deviation(some(bottom, 23), ball.mesh()));
            QVERIFY2(off <= step.displacement + 1e-9,
                     qPrintable(QString("%1 %2").arg(off).arg(step.displacement)));
            QVERIFY2(step.displacement < 0.5, qPrintable(QString::number(step.displacement)));
        }
    }

    void three_scans_around_a_tube() {
        Joined whole(tube(60, 30, 0, 2.5, 1));
        const StepReport second = whole.add(tube(51, 25, 2, 4.6, 2), 0.2);
        const StepReport third = whole.add(tube(45, 33, 4.1, 2 * pi + 0.6, 3), 0.2);
        QCOMPARE(second.count("seams_left_open") + third.count("seams_left_open"), std::size_t(0));
        const HoleList holes = holes_of(whole.mesh(), {});
        QCOMPARE(holes.holes.size(), std::size_t(2)); // its ends
        QCOMPARE(holes.left_out, std::size_t(0));
        const Repaired closed =
            repaired(whole.mesh(), {{.kind = Kind::holes, .fill = RepairStep::Fill::flat}});
        const MeshReport report = report_of_mesh(*closed.mesh);
        QVERIFY(report.watertight);
        QVERIFY(std::abs(report.file_volume / (pi * 400 * 30) - 1) < 0.01);
    }

    void a_scan_is_laid_on_the_part() {
        const DirtyScan body = dirty_scan(40, 0.02, 0, 0, 7), again = dirty_scan(33, 0.02, 0, 0, 8);
        const Mesh top = where(body.mesh, [](const Vec3& p) { return p.z() > -15; });
        const Mesh bottom = where(again.mesh, [](const Vec3& p) { return p.z() < 15; });
        const Mesh beside = moved(bottom, Vec3(1, -1, 2), 0.01, Vec3(0.4, -0.3, 0.5));
        double farthest = 0;
        for (std::size_t v = 0; v < bottom.vertices.size(); ++v)
            farthest = std::max(farthest, (bottom.vertices[v] - beside.vertices[v]).norm());
        Mesh laid = beside;
        const detail::ScanGround ground(top, 3, {});
        const double moved_by = detail::lay_on(ground, laid, {});
        double off = 0;
        for (std::size_t v = 0; v < bottom.vertices.size(); ++v)
            off = std::max(off, (bottom.vertices[v] - laid.vertices[v]).norm());
        QVERIFY2(off < 0.1 * farthest, qPrintable(QString("%1 of %2").arg(off).arg(farthest)));
        QVERIFY(std::abs(moved_by - farthest) < 0.1 * farthest);

        Joined joined(top);
        const StepReport step = joined.add(beside, 1, 2);
        QVERIFY(report_of_mesh(joined.mesh()).watertight);
        QVERIFY(step.displacement >= moved_by);
        Joined not_so_far(top);
        QCOMPARE(code_of([&] { not_so_far.add(beside, 1, 0.3); }), std::string("out_of_range"));
    }

    void what_does_not_overlap_is_put_beside() {
        const Mesh ball = ringed_sphere(10, 5), other = ringed_sphere(9, 5, Vec3(20, 0, 0));
        Joined both(ball);
        const StepReport step = both.add(other, 1);
        QCOMPARE(both.mesh().facet_count(), ball.facet_count() + other.facet_count());
        QCOMPARE(step.displacement, 0.0);
        // And what is covered whole adds nothing.
        Joined twice(ball);
        twice.add(ball, 1);
        QVERIFY(equal_meshes(twice.mesh(), ball));
    }

    void a_patch_closes_a_hole_of_another_scan() {
        const Mesh open = where(ringed_sphere(40, 30), [](const Vec3& p) { return p.x() < 24; });
        const Mesh patch = where(moved(ringed_sphere(55, 30), Vec3(0, 1, 1), 2, Vec3::Zero()),
                                 [](const Vec3& p) { return p.x() > 20; });
        Joined closed(open);
        closed.add(patch, 0.3);
        QVERIFY(report_of_mesh(closed.mesh()).watertight);
        QVERIFY(stands_in_order(open, closed.mesh()));
    }
};

FACETMILL_TEST(TestJoin)
#include "test_join.moc"
