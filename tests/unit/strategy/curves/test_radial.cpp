// Radial, spiral and morph passes against what is known of planes and cones, and against a naive check.
#include "core/strategy/curves/morph.h"
#include "core/strategy/curves/radial.h"
#include "tests/property/shapes.h"
#include "tests/support/any_threads.h"
#include "tests/support/cancel_at.h"
#include "tests/support/error_code.h"
#include "tests/support/naive_finish.h"
#include "tests/support/test_runner.h"
#include "tests/support/told.h"
#include "tests/support/trials.h"

#include <QTest>

#include <set>

using namespace facetmill;
using namespace facetmill::test;

namespace {

constexpr double allowed = 0.1;

template <class S>
S asked() {
    S s;
    s.tolerance = allowed;
    return s;
}

std::unique_ptr<Operation> operation_of(const std::string& kind) {
    auto op = make_operation(kind);
    op->common().tolerance = allowed;
    return op;
}

StrategyResult planned_on(const Mesh& mesh, const Operation& op, const Tool& tool) {
    return op.plan(context_of(mesh, tool), Progress());
}

Mesh plane(double slope) {
    return height_field([slope](double x, double) { return slope * x; }, Vec2(-15, -12), Vec2(15, 12), 6, 6);
}

Mesh part_of_kind(int kind) {
    const auto hills = [](double x, double y) { return 3 * std::sin(0.25 * x) * std::cos(0.2 * y); };
    const auto tent = [](double x, double y) { return 9 - std::max(std::abs(x), 0.3 * std::abs(y)); };
    if (kind == 0) return dome(12, 24);
    if (kind == 1) return height_field(hills, Vec2(-14, -10), Vec2(14, 10), 56, 40);
    return height_field(tent, Vec2(-10, -10), Vec2(10, 10), 40, 40);
}

/// The step that a ball leaves the tolerance with, less the chord tolerance, on a level plane.
double level_step(double diameter) {
    const double cusp = allowed - 0.005;
    return 2 * std::sqrt(diameter * cusp - cusp * cusp);
}

double length_of(const StrategyResult& path) {
    double sum = 0;
    for (const Pass& p : path.passes)
        for (std::size_t i = 1; i < p.cl.size(); ++i)
            sum += (p.cl[i].tip - p.cl[i - 1].tip).head<2>().norm();
    return sum;
}

PlanCurve arc(double radius, double from, double to, const Vec2& about = Vec2::Zero()) {
    PlanCurve c;
    for (int k = 0; k <= 40; ++k) {
        const double a = from + (to - from) * k / 40;
        c.points.emplace_back(about + radius * Vec2(std::cos(a), std::sin(a)));
    }
    return c;
}

} // namespace

class TestRadial : public QObject {
    Q_OBJECT
private slots:
    void they_are_described() {
        for (const char* kind : {"radial", "spiral", "morph"}) {
            const auto op = make_operation(kind);
            for (const ParameterInfo* p : op->parameters()) {
                QVERIFY2(!p->label.empty() && !p->help.empty(), p->key.c_str());
                QVERIFY2(op->get(p->key) == p->default_value, p->key.c_str());
            }
            QVERIFY(op->has("stepover") && op->has("boundary") && op->three_axis() && op->reads_stock());
        }
    }

    /// On a level plane turns and spokes lie as far apart as the tolerance lets them, and no farther.
    void on_a_plane_they_are_as_far_apart_as_may_be() {
        const double step = level_step(6), area = 30 * 24;
        const StrategyResult spiral = planned_on(plane(0), *operation_of("spiral"), ball_tool(6));
        QVERIFY2(spiral.stepover_max < 1.001 * step && spiral.stepover_min > 0.98 * step,
                 qPrintable(QString("%1 of %2").arg(spiral.stepover_min).arg(step)));
        // Every pass clears a strip of that width; the ends go a little beyond the border.
        QVERIFY2(length_of(spiral) < 1.2 * area / step, qPrintable(QString::number(length_of(spiral))));
        const StrategyResult radial = planned_on(plane(0), *operation_of("radial"), ball_tool(6));
        // Spokes that thin out towards the centre: less than half as long again, instead of four times.
        QVERIFY2(length_of(radial) < 2.2 * area / step,
                 qPrintable(QString("%1 of %2").arg(length_of(radial)).arg(area / step)));
        for (const Pass& p : radial.passes)
            for (std::size_t i = 1; i < p.cl.size(); ++i) {
                // Straight to or from the centre.
                const Vec2 a = p.cl[i - 1].tip.head<2>(), b = p.cl[i].tip.head<2>();
                QVERIFY(std::abs(a.x() * b.y() - a.y() * b.x()) < 1e-6 * (1 + a.norm() * b.norm()));
            }
    }

    void everything_is_cut_to_the_tolerance_data() {
        QTest::addColumn<QString>("kind");
        QTest::addColumn<int>("part");
        QTest::addColumn<int>("tool");
        // Under a sanitizer two cutters a kind, all of them by one kind or another.
        int row = 0;
        for (const char* kind : {"radial", "spiral", "morph"})
            for (int p = 0; p < 3; ++p)
                for (int t = 0; t < 4; ++t, ++row)
                    if (all_cases
                        || ((p + t + row / 12) % 3 == 0 && (!under_sanitizer || (t + row / 12) % 2 == 0)))
                        QTest::addRow("%s %d %s", kind, p, tools_of_every_shape()[std::size_t(t)].name)
                            << kind << p << t;
    }
    void everything_is_cut_to_the_tolerance() {
        QFETCH(QString, kind);
        QFETCH(int, part);
        QFETCH(int, tool);
        const Mesh mesh = part_of_kind(part);
        const Tool cutter = tools_of_every_shape()[std::size_t(tool)].tool;
        const double tolerance = under_sanitizer ? 3 * allowed : allowed; // half as many passes
        const auto op = operation_of(kind.toStdString());
        op->common().tolerance = tolerance;
        const StrategyResult path = planned_on(mesh, *op, cutter);
        const BruteCutter brute(cutter.cutter());
        const double foot = 0.3 + double(brute.height(double(brute.radius())));
        const Naive naive = naive_check(mesh, path, cutter, tolerance, [&](const PartSample& s) {
            if (part == 0) return s.p.z() > std::min(foot + double(brute.radius()), 7.0);
            // Hollows keep a fillet of a wide cutter; the hills' tops do not.
            return s.normal.z() > 0.05 && (part == 2 || s.p.z() > 1) && std::abs(s.p.x()) < 9
                   && std::abs(s.p.y()) < 9;
        });
        QCOMPARE(naive.gouged, std::size_t(0));
        QVERIFY(naive.judged > 100);
        QVERIFY2(double(naive.high) <= 0.005 * double(naive.judged),
                 qPrintable(QString("%1 of %2; %3")
                                .arg(naive.high)
                                .arg(naive.judged)
                                .arg(path.warnings.empty() ? "" : path.warnings.front().c_str())));
        QVERIFY(!tells(path, "leave more than expected"));
    }

    void a_ring_is_cut_between_its_radii() {
        for (const char* kind : {"radial", "spiral"}) {
            auto op = operation_of(kind);
            op->set("center_of_part", false);
            op->set("center", std::array<double, 3>{2, 1, 0});
            op->set("from_radius", 4.0);
            op->set("to_radius", 9.0);
            const Mesh mesh = plane(0.3);
            const StrategyResult path = planned_on(mesh, *op, ball_tool(4));
            const auto radius = [](const Vec3& p) { return (p.head<2>() - Vec2(2, 1)).norm(); };
            double least = infinity, most = 0;
            for (const Pass& pass : path.passes)
                for (const CutterLocation& c : pass.cl) {
                    least = std::min(least, radius(c.tip));
                    most = std::max(most, radius(c.tip));
                }
            // Passes go beyond the border by a little more than the cutter rolls over it.
            QVERIFY2(least > 2.4 && least < 4.2 && most < 10.7 && most > 8.8,
                     qPrintable(QString("%1 %2").arg(least).arg(most)));
            const Naive naive = naive_check(mesh, path, ball_tool(4), allowed, [&](const PartSample& s) {
                return radius(s.p) > 4 && radius(s.p) < 9;
            });
            QVERIFY(naive.judged > 300 && naive.gouged == 0);
            QCOMPARE(naive.high, std::size_t(0));
            std::string message;
            op->set("to_radius", 3.0);
            QCOMPARE(code_of([&] { planned_on(mesh, *op, ball_tool(4)); }, &message),
                     std::string("out_of_range"));
            op->set("center", std::array<double, 3>{200, 1, 0});
            op->set("to_radius", 9.0);
            QCOMPARE(code_of([&] { planned_on(mesh, *op, ball_tool(4)); }, &message),
                     std::string("empty_result"));
            QVERIFY2(message.find("nothing of the part lies where it is to cut") != std::string::npos,
                     message.c_str());
        }
    }

    /// A spiral goes on from turn to turn.
    void a_spiral_is_one_pass() {
        auto op = operation_of("spiral");
        op->set("to_radius", 9.0);
        const StrategyResult path = planned_on(plane(0), *op, ball_tool(6));
        // But for pieces beyond the border.
        double angle = 0;
        const auto& cl = path.passes.front().cl;
        QVERIFY(cl.front().tip.head<2>().norm() < 1e-9);
        for (std::size_t i = 2; i < cl.size(); ++i) {
            const Vec2 a = cl[i - 1].tip.head<2>(), b = cl[i].tip.head<2>();
            angle += std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b));
        }
        QVERIFY2(std::abs(angle) > 2 * pi * 5, qPrintable(QString::number(angle)));
    }

    void a_length_of_ones_own_is_kept() {
        for (const char* kind : {"radial", "spiral", "morph"}) {
            auto op = operation_of(kind);
            op->set("stepover", 3.0);
            const StrategyResult path = planned_on(plane(0), *op, ball_tool(6));
            QVERIFY2(std::abs(path.stepover_max - 3) < 0.01, kind);
            QVERIFY2(tells(path, "the step-over of 3 mm leaves cusps of"), kind);
        }
    }

    /// Between arcs about two middles: narrow at one end, wide at the other.
    void a_morph_thins_out_where_the_strip_is_narrow() {
        const Mesh mesh = plane(0.1);
        PlanContext context = context_of(mesh, ball_tool(2));
        const PlanCurve low{{Vec2(-13, -6), Vec2(13, -6)}, false}, high{{Vec2(13, 8), Vec2(-13, -4)}, false};
        context.curves = {{"A", {low}}, {"B", {high}}};
        auto settings = asked<MorphSettings>();
        settings.first_curve = "A";
        settings.second_curve = "B";
        const StrategyResult path = Morph(settings).plan(context, Progress());
        const auto between = [](const Vec3& p) {
            const double top = -4 + 12 * (p.x() + 13) / 26;
            return std::abs(p.x()) < 13 && p.y() > -6 && p.y() < top;
        };
        const Naive naive =
            naive_check(mesh, path, ball_tool(2), allowed, [&](const PartSample& s) { return between(s.p); });
        QVERIFY(naive.judged > 300 && naive.gouged == 0);
        QCOMPARE(naive.high, std::size_t(0));
        const auto crossed_at = [&](double x) {
            int count = 0;
            for (const Pass& p : path.passes)
                for (std::size_t i = 1; i < p.cl.size(); ++i)
                    count += (p.cl[i - 1].tip.x() < x) != (p.cl[i].tip.x() < x);
            return count;
        };
        QVERIFY2(crossed_at(-11) < 0.6 * crossed_at(11),
                 qPrintable(QString("%1 %2").arg(crossed_at(-11)).arg(crossed_at(11))));
        // Two closed ones make a ring.
        PlanContext ring = context_of(plane(0), ball_tool(4));
        PlanCurve inner = arc(3, 0, 2 * pi), outer = arc(9, 1, 1 + 2 * pi);
        for (PlanCurve* c : {&inner, &outer}) {
            c->points.pop_back();
            c->closed = true;
        }
        ring.curves = {{"A", {inner}}, {"B", {outer}}};
        settings.open = false;
        const StrategyResult rings = Morph(settings).plan(ring, Progress());
        const Naive around = naive_check(plane(0), rings, ball_tool(4), allowed, [](const PartSample& s) {
            return s.p.head<2>().norm() > 3 && s.p.head<2>().norm() < 9;
        });
        QVERIFY(around.judged > 200);
        QCOMPARE(around.high, std::size_t(0));
    }

    void curves_that_cannot_be_morphed_are_refused() {
        const Mesh mesh = plane(0);
        PlanContext context = context_of(mesh, ball_tool(4));
        auto settings = asked<MorphSettings>();
        settings.first_curve = "A";
        std::string message;
        const auto code = [&] {
            return code_of([&] { Morph(settings).plan(context, Progress()); }, &message);
        };
        context.curves = {{"A", {{{Vec2(-5, -5), Vec2(5, 5)}, false}}}, {"", {}}};
        QCOMPARE(code(), std::string("missing_reference"));
        settings.second_curve = "B";
        context.curves[1] = {"B", {{{Vec2(-5, 5), Vec2(5, -5)}, false}}};
        QCOMPARE(code(), std::string("out_of_range"));
        QVERIFY2(message.find("cross or touch at (0, 0") != std::string::npos, message.c_str());
    }

    void threads_change_nothing_and_they_can_be_cancelled() {
        const Mesh mesh = under_sanitizer ? plane(0.3) : part_of_kind(1); // the rows before plan over hills
        for (const char* kind : {"radial", "spiral", "morph"}) {
            const auto op = operation_of(kind);
            QVERIFY2(same_with_any_threads([&] { return planned_on(mesh, *op, bull_tool(6, 1)); }), kind);
            for (const double at : {0.3, 0.9}) {
                Job job;
                QVERIFY2(
                    cancelled_at(job, at,
                                 [&](const Progress& p) { op->plan(context_of(mesh, ball_tool(6)), p); }),
                    kind);
            }
        }
    }
};

FACETMILL_TEST(TestRadial)
#include "test_radial.moc"
