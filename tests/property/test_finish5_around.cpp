// Finishing with five axes in closed rings: about a thimble up to its end, about a blade that stands
// upright, round a crater from above. The ball is judged by its centre
// alone, other tools by a verifier that shares no code with the planner.
#include "core/base/parallel.h"
#include "core/strategy/five_axis/five_axis_record.h"
#include "core/strategy/five_axis/five_axis_study.h"
#include "core/strategy/five_axis/posture_path.h"
#include "core/strategy/surface/point_grid.h"
#include "tests/property/five_axis_plan.h"
#include "tests/support/part_meshes.h"
#include "tests/support/test_runner.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <functional>

using namespace facetmill;
using namespace facetmill::test;

namespace {

/// A tube over a round (s from 0 to 1) and t from 0 to 1, wound so that s grows anticlockwise seen against t.
Mesh ring_tube(const std::function<Vec3(double s, double t)>& at, int around, int along) {
    Mesh mesh;
    for (int i = 0; i < around; ++i)
        for (int k = 0; k <= along; ++k)
            mesh.vertices.push_back(at(double(i) / around, double(k) / along));
    const auto index = [&](int i, int k) { return Index(i % around * (along + 1) + k); };
    for (int i = 0; i < around; ++i)
        for (int k = 0; k < along; ++k) {
            mesh.facets.push_back({index(i, k), index(i + 1, k), index(i + 1, k + 1)});
            mesh.facets.push_back({index(i, k), index(i + 1, k + 1), index(i, k + 1)});
        }
    return mesh;
}

/// With its ends closed: a fan of facets at t = 0 and one at t = 1.
Mesh closed_tube(Mesh mesh, int around, int along, const Vec3& bottom, const Vec3& top) {
    const auto foot = Index(mesh.vertices.size()), head = foot + 1;
    mesh.vertices.push_back(bottom);
    mesh.vertices.push_back(top);
    for (int i = 0; i < around; ++i) {
        const auto from = Index(i * (along + 1)), to = Index((i + 1) % around * (along + 1));
        mesh.facets.push_back({to, from, foot});
        mesh.facets.push_back({Index(from + along), Index(to + along), head});
    }
    return mesh;
}

constexpr double dome_radius = 7, wall_height = 8;

/// A wall of 8 mm with half a ball on it.
Mesh standing_thimble() {
    constexpr int around = 72, along = 48;
    constexpr double length = wall_height + 0.5 * pi * dome_radius;
    return closed_tube(ring_tube(
                           [](double s, double t) -> Vec3 {
                               const double up = t * 0.97 * length,
                                            over = std::max(0.0, up - wall_height) / dome_radius,
                                            out = dome_radius * std::cos(over);
                               return {out * std::cos(2 * pi * s), out * std::sin(2 * pi * s),
                                       std::min(up, wall_height) + dome_radius * std::sin(over)};
                           },
                           around, along),
                       around, along, Vec3::Zero(), Vec3(0, 0, wall_height + dome_radius));
}

double away_from_thimble(const Vec3& p) {
    const double out = std::hypot(p.x(), p.y());
    return p.z() < wall_height ? out - dome_radius : std::hypot(out, p.z() - wall_height) - dome_radius;
}

/// Sections of 16 mm by 4, tapering to 10 by 3 and turned by 20 degrees.
Mesh standing_blade() {
    constexpr int around = 96, along = 30;
    return closed_tube(ring_tube(
                           [](double s, double t) -> Vec3 {
                               const double turn = radians(20 * t), angle = 2 * pi * s,
                                            x = (8 - 3 * t) * std::cos(angle),
                                            y = (2 - 0.5 * t) * std::sin(angle);
                               return {x * std::cos(turn) - y * std::sin(turn),
                                       x * std::sin(turn) + y * std::cos(turn), 16 * t};
                           },
                           around, along),
                       around, along, Vec3::Zero(), Vec3(0, 0, 16));
}

/// The inside of a bowl with a hole in it, and its rim, as a sheet that faces up.
Mesh crater() {
    return ring_tube(
        [](double s, double t) -> Vec3 {
            const double out = 20 - 14 * t;
            return {out * std::cos(2 * pi * s), 0.9 * out * std::sin(2 * pi * s),
                    0.015 * out * out + 0.6 * std::sin(4 * pi * s) * t};
        },
        80, 24);
}

Finish5Settings around(double tolerance) {
    Finish5Settings s;
    s.tolerance = tolerance;
    s.direction = {0, "x"};
    s.grid_step = radians(4);
    s.passes = Finish5Settings::Passes::around;
    return s;
}

PlanContext upright_context(const Mesh& part, const Tool& tool) {
    PlanContext context = five_axis_context(part, tool);
    context.machine = find_machine("trunnion-ac");
    return context;
}

/// How far a pass goes round the Z axis, in rounds.
double rounds(const Pass& pass) {
    double sum = 0;
    for (std::size_t i = 1; i < pass.cc.size(); ++i) {
        const Vec3 &p = pass.cc[i - 1].point, &q = pass.cc[i].point;
        sum += std::remainder(std::atan2(q.y(), q.x()) - std::atan2(p.y(), p.x()), 2 * pi);
    }
    return std::abs(sum) / (2 * pi);
}

std::string all_of(const std::vector<std::string>& warnings) {
    std::string said;
    for (const std::string& w : warnings)
        said += w + "\n";
    return said;
}

} // namespace

class TestFinish5Around : public QObject {
    Q_OBJECT
private slots:
    /// Every place of it is cut, and none too deep, by the distance from a ball's centre.
    void a_thimble_is_cut_to_its_end() {
        const PlanContext context = upright_context(standing_thimble(), with_holder(ball_tool(6)));
        const Finish5 op(around(0.1));
        const StrategyResult path = op.plan(context, Progress());
        std::vector<Vec3> centres;
        std::size_t whole = 0;
        for (const Pass& pass : path.passes) {
            whole += rounds(pass) > 1 && rounds(pass) < 2.2;
            for (std::size_t i = 0; i < pass.cl.size(); ++i)
                for (int k = 0; i > 0 && k <= 4; ++k) {
                    const CutterLocation at = location_on_route(pass.cl[i - 1], pass.cl[i], k / 4.0);
                    centres.push_back(at.tip + 3 * at.axis);
                    QVERIFY(away_from_thimble(centres.back()) >= 3 - path.chord_tolerance - 0.02);
                }
        }
        QVERIFY2(whole >= 5 && whole == path.passes.size(),
                 qPrintable(QString("%1 of %2").arg(whole).arg(path.passes.size())));
        QCOMPARE(path.cleanup_points, std::size_t(0));
        const PointGrid near_by(centres, 0.5);
        for (double up = 0.5; up < wall_height + 0.5 * pi * dome_radius; up += 0.23)
            for (double angle = 0; angle < 360; angle += 2.5) {
                const double over = std::max(0.0, up - wall_height) / dome_radius,
                             out = dome_radius * std::cos(over);
                const Vec3 p(out * std::cos(radians(angle)), out * std::sin(radians(angle)),
                             std::min(up, wall_height) + dome_radius * std::sin(over));
                double nearest = infinity;
                near_by.near(p, 3.3,
                             [&](std::size_t i) { nearest = std::min(nearest, (centres[i] - p).norm()); });
                QVERIFY2(nearest <= 3 + 1.05 * 0.1,
                         qPrintable(QString("%1 at %2 %3 %4").arg(nearest).arg(p.x()).arg(p.y()).arg(p.z())));
            }
        const Verification v =
            judged(*context.part, context, linked(path, context, op), 0.1, path.chord_tolerance);
        QVERIFY(!v.gouged());
    }

    void blades_and_craters_are_cut_to_tolerance_data() {
        QTest::addColumn<QString>("shape");
        QTest::addColumn<QString>("tool");
        QTest::newRow("blade, ball") << "blade"
                                     << "ball";
        QTest::newRow("blade, bull") << "blade"
                                     << "bull";
        QTest::newRow("crater, bull") << "crater"
                                      << "bull";
    }
    void blades_and_craters_are_cut_to_tolerance() {
        QFETCH(QString, shape);
        QFETCH(QString, tool);
        const bool is_blade = shape == "blade";
        const Mesh part = is_blade ? standing_blade() : crater();
        const Tool cuts = cutter(tool.toStdString());
        const PlanContext context = is_blade ? upright_context(part, cuts) : five_axis_context(part, cuts);
        const Finish5 op(around(0.1));
        const StrategyResult path = op.plan(context, Progress());
        const Verification v = judged(part, context, linked(path, context, op), 0.1, path.chord_tolerance);
        QVERIFY(v.figures.samples > 500);
        QVERIFY2(!v.gouged(), qPrintable(QString::number(std::max(v.figures.gouge_max, v.border.gouge_max))));
        // A blade stands on its foot, which is not cut.
        if (!is_blade) {
            QVERIFY2(v.figures.excess_p999 <= 1.05 * 0.1, qPrintable(QString::number(v.figures.excess_p999)));
            QCOMPARE(v.figures.uncut_fraction, 0.0);
        }
        std::size_t whole = 0;
        for (const Pass& pass : path.passes)
            whole += rounds(pass) > 1;
        const std::string said = all_of(path.warnings);
        QVERIFY2(whole >= 4,
                 qPrintable(QString("%1 of %2 %3").arg(whole).arg(path.passes.size()).arg(said.c_str())));
        // Its walls face sideways: strips are as wide as axes clear them that stay over the ground.
        const std::size_t points = path.five_axis()->points.size();
        QVERIFY2(50 * path.cleanup_points <= points,
                 qPrintable(QString("%1 of %2 %3").arg(path.cleanup_points).arg(points).arg(said.c_str())));
    }

    /// What has one border alone and faces one way is cut from edge to edge.
    void what_does_not_go_round_flows() {
        const Mesh mesh =
            height_field([](double x, double y) { return 0.4 * std::sin(0.2 * x) + 0.01 * x * y; },
                         Vec2(-10, -8), Vec2(10, 8), 20, 16);
        const PlanContext context = five_axis_context(mesh, cutter("ball"));
        Finish5Settings s = around(0.2);
        const StrategyResult path = Finish5(s).plan(context, Progress());
        const auto rings = numbers(path);
        QVERIFY(all_of(path.warnings).find("nothing of the part goes round") != std::string::npos);
        s.passes = Finish5Settings::Passes::morph;
        QVERIFY(rings.size() > 1000);
        QCOMPARE(rings, numbers(Finish5(s).plan(context, Progress())));
    }

    void the_same_bits_with_any_number_of_threads_and_studied_again() {
        const PlanContext context = upright_context(standing_blade(), cutter("ball"));
        const Finish5 op(around(0.3));
        set_thread_count(1);
        const auto one = numbers(op.plan(context, Progress()));
        set_thread_count(2);
        const StrategyResult path = op.plan(context, Progress());
        set_thread_count(0);
        QVERIFY(one.size() > 1000);
        QCOMPARE(numbers(path), one);
        const auto record = path.as<TiltedPath>()->record;
        const FiveAxisStudy study(record, Progress());
        for (const double share : {0.2, 0.9}) {
            const auto point = study.point(std::size_t(share * double(record->points.size())), Progress());
            if (!point.planned.free) continue;
            QCOMPARE(point.chosen[2].posture.lead, point.planned.posture.lead);
            QCOMPARE(point.chosen[2].posture.yaw, point.planned.posture.yaw);
        }
    }
};

FACETMILL_TEST(TestFinish5Around)
#include "test_finish5_around.moc"
