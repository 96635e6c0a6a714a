// Finishing with five axes in passes that flow from edge to edge: blades that taper and twist, fans, a blade
// that stands upright with both of its faces.
#include "core/base/parallel.h"
#include "core/strategy/five_axis/five_axis_record.h"
#include "core/strategy/five_axis/five_axis_study.h"
#include "tests/property/five_axis_plan.h"
#include "tests/support/test_runner.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <functional>

using namespace facetmill;
using namespace facetmill::test;

namespace {

Mesh flow_sheet(const std::function<Vec3(double s, double t)>& at, int nx, int ny) {
    Mesh mesh;
    for (int i = 0; i <= nx; ++i)
        for (int k = 0; k <= ny; ++k)
            mesh.vertices.push_back(at(double(i) / nx, double(k) / ny));
    const auto index = [&](int i, int k) { return Index(i * (ny + 1) + k); };
    for (int i = 0; i < nx; ++i)
        for (int k = 0; k < ny; ++k) {
            mesh.facets.push_back({index(i, k), index(i + 1, k), index(i + 1, k + 1)});
            mesh.facets.push_back({index(i, k), index(i + 1, k + 1), index(i, k + 1)});
        }
    return mesh;
}

/// From a chord of 20 mm to one of 8.
Mesh blade_face() {
    return flow_sheet(
        [](double s, double t) -> Vec3 {
            const double half = 10 - 6 * s, turn = radians(30 * s - 10), y = (2 * t - 1) * half;
            return {36 * s, y * std::cos(turn) + 3 * s * s, y * std::sin(turn) - 0.015 * y * y};
        },
        36, 24);
}

Mesh fan() {
    return flow_sheet(
        [](double s, double t) -> Vec3 {
            const double radius = 14 + 20 * t, angle = radians(125 - 70 * s);
            return {radius * std::cos(angle), radius * std::sin(angle),
                    3 * std::sin(2 * angle) - 0.006 * (radius - 24) * (radius - 24)};
        },
        40, 24);
}

Finish5Settings flowing(double tolerance) {
    Finish5Settings s;
    s.tolerance = tolerance;
    s.direction = {0, "x"};
    s.grid_step = radians(6);
    s.passes = Finish5Settings::Passes::morph;
    return s;
}

double cut_length(const StrategyResult& path) {
    double sum = 0;
    for (const Pass& pass : path.passes)
        for (std::size_t i = 1; i < pass.cl.size(); ++i)
            sum += (pass.cl[i].tip - pass.cl[i - 1].tip).norm();
    return sum;
}

} // namespace

class TestFinish5Flow : public QObject {
    Q_OBJECT
private slots:
    void sheets_are_cut_to_tolerance_data() {
        QTest::addColumn<QString>("shape");
        QTest::addColumn<QString>("tool");
        QTest::newRow("blade, ball") << "blade"
                                     << "ball";
        QTest::newRow("blade, bull") << "blade"
                                     << "bull";
        QTest::newRow("fan, bull") << "fan"
                                   << "bull";
    }
    void sheets_are_cut_to_tolerance() {
        QFETCH(QString, shape);
        QFETCH(QString, tool);
        const bool is_fan = shape == "fan";
        const Mesh part = is_fan ? fan() : blade_face();
        const PlanContext context = five_axis_context(part, cutter(tool.toStdString()));
        Finish5Settings s = flowing(0.1);
        if (is_fan) s.grid_step = radians(3);
        const Finish5 op(s);
        const StrategyResult path = op.plan(context, Progress());
        QVERIFY(path.drive_planes >= 3);
        QVERIFY2(path.cleanup_points == 0, path.warnings.empty() ? "" : path.warnings.front().c_str());
        QVERIFY(path.cusp_max > 0 && path.cusp_max <= 0.1 * (1 + 1e-9));
        const Verification v = judged(part, context, linked(path, context, op), 0.1, path.chord_tolerance);
        QVERIFY(v.figures.samples > 500);
        QVERIFY2(!v.gouged(), qPrintable(QString::number(std::max(v.figures.gouge_max, v.border.gouge_max))));
        QVERIFY2(v.figures.excess_p999 <= 1.05 * 0.1, qPrintable(QString::number(v.figures.excess_p999)));
        QCOMPARE(v.figures.uncut_fraction, 0.0);
        QVERIFY2(v.border.uncut_fraction < 2e-3, qPrintable(QString::number(v.border.uncut_fraction)));
        // The passes of a fan keep their distance from its middle, those of a blade go all along it.
        for (const Pass& pass : path.passes) {
            double least = infinity, most = -infinity;
            for (const CutterContact& c : pass.cc) {
                const double at = is_fan ? std::hypot(c.point.x(), c.point.y()) : c.point.x();
                least = std::min(least, at);
                most = std::max(most, at);
            }
            if (is_fan)
                QVERIFY2(most - least < 0.6, qPrintable(QString("%1 to %2").arg(least).arg(most)));
            else
                QVERIFY(most - least > 3);
        }
    }

    /// Passes that follow a fan are longer than those that cross it, and fewer.
    void a_fan_is_followed_with_fewer_passes() {
        const PlanContext context = five_axis_context(fan(), cutter("flat"));
        Finish5Settings s = flowing(0.1);
        const StrategyResult flow = Finish5(s).plan(context, Progress());
        s.passes = Finish5Settings::Passes::parallel;
        const StrategyResult parallel = Finish5(s).plan(context, Progress());
        QVERIFY2(flow.passes.size() < parallel.passes.size() && cut_length(flow) < cut_length(parallel),
                 qPrintable(QString("%1 passes of %2 mm, %3 of %4")
                                .arg(flow.passes.size())
                                .arg(cut_length(flow))
                                .arg(parallel.passes.size())
                                .arg(cut_length(parallel))));
    }

    void a_constant_step_over_is_the_largest() {
        const Mesh part = blade_face();
        Finish5Settings s = flowing(0.5);
        s.stepover = {1.5, ""};
        const StrategyResult path = Finish5(s).plan(five_axis_context(part, cutter("ball")), Progress());
        QCOMPARE(path.stepover_max, 1.5);
        // At the wide end of 20 mm they are no farther apart than asked, at the narrow one of 8 not half as
        // far.
        QVERIFY2(path.drive_planes >= 13 && path.drive_planes < 26,
                 qPrintable(QString::number(path.drive_planes)));
    }

    void the_same_bits_with_any_number_of_threads_and_studied_again() {
        const PlanContext context = five_axis_context(blade_face(), cutter("bull"));
        const Finish5 op(flowing(0.1));
        set_thread_count(1);
        const auto one = numbers(op.plan(context, Progress()));
        set_thread_count(2);
        const StrategyResult path = op.plan(context, Progress());
        set_thread_count(0);
        QVERIFY(one.size() > 1000);
        QCOMPARE(numbers(path), one);
        // A space that is built again is that of the plan.
        const auto record = path.as<TiltedPath>()->record;
        const FiveAxisStudy study(record, Progress());
        const auto point = study.point(record->points.size() / 2, Progress());
        QVERIFY(point.planned.free);
        QCOMPARE(point.chosen[2].posture.lead, point.planned.posture.lead);
        QCOMPARE(point.chosen[2].posture.yaw, point.planned.posture.yaw);
    }
};

FACETMILL_TEST(TestFinish5Flow)
#include "test_finish5_flow.moc"
