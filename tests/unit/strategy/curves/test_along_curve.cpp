// Passes along curves against their known course, and against a naive check.
#include "core/strategy/curves/along_curve.h"
#include "tests/property/shapes.h"
#include "tests/support/cancel_at.h"
#include "tests/support/error_code.h"
#include "tests/support/naive_finish.h"
#include "tests/support/test_runner.h"
#include "tests/support/told.h"

#include <QTest>

#include <set>

using namespace facetmill;
using namespace facetmill::test;

namespace {

const PlanCurve ring_of_corners{{Vec2(-6, -5), Vec2(7, -4), Vec2(6, 5), Vec2(0, 2), Vec2(-6, 6)}, true};

double hill(double x, double y) {
    return 1.5 * std::sin(0.3 * x) * std::cos(0.25 * y);
}
Mesh hills() {
    return height_field(hill, Vec2(-14, -10), Vec2(14, 10), 56, 40);
}

AlongCurveSettings along(const char* curve = "Curve") {
    AlongCurveSettings s;
    s.tolerance = 0.1;
    s.curve = curve;
    return s;
}

StrategyResult planned_on(const Mesh& mesh, const AlongCurveSettings& settings, const Tool& tool,
                          const PlanCurve& curve = ring_of_corners) {
    PlanContext context = context_of(mesh, tool);
    if (!settings.curve.empty()) context.curves = {{settings.curve, {curve}}};
    return AlongCurve(settings).plan(context, Progress());
}

double distance_from(const PlanCurve& curve, const Vec3& p) {
    const CurveCourse course(curve);
    return LineDistance(course.line(), {}).near(p.head<2>()).distance;
}

} // namespace

class TestAlongCurve : public QObject {
    Q_OBJECT
private slots:
    void it_is_described() {
        const auto op = make_operation("along_curve");
        std::set<std::string> keys;
        for (const ParameterInfo* p : op->parameters()) {
            keys.insert(p->key);
            QVERIFY2(!p->label.empty() && !p->help.empty(), p->key.c_str());
            QVERIFY2(op->get(p->key) == p->default_value, p->key.c_str());
        }
        for (const char* key : {"curve", "open", "side", "offset", "depth", "cuts", "cut_depth", "boundary"})
            QVERIFY2(keys.count(key) == 1, key);
        // A boundary that it names keeps being named.
        op->set("curve", std::string("A"));
        op->common().boundary = "A";
        op->rename_boundary("A", "B");
        QVERIFY(op->curve_names() == std::vector<std::string>{"B"} && op->common().boundary == "B");
        op->rename_boundary("A", "C");
        QVERIFY(op->curve_names() == std::vector<std::string>{"B"});
    }

    void the_tip_runs_over_the_curve() {
        const Mesh mesh = hills();
        for (const ShapedTool& shaped : tools_of_every_shape()) {
            const StrategyResult path = planned_on(mesh, along(), shaped.tool);
            QCOMPARE(path.passes.size(), std::size_t(1));
            const Pass& pass = path.passes.front();
            QVERIFY((pass.cl.front().tip - pass.cl.back().tip).norm() < 1e-9);
            double length = 0;
            for (std::size_t i = 0; i < pass.cl.size(); ++i) {
                QVERIFY(distance_from(ring_of_corners, pass.cl[i].tip) < 1e-9);
                if (i > 0) length += (pass.cl[i].tip - pass.cl[i - 1].tip).head<2>().norm();
            }
            QVERIFY(std::abs(length - CurveCourse(ring_of_corners).length()) < 1e-6);
            const Naive naive =
                naive_check(mesh, path, shaped.tool, 0.1, [](const PartSample&) { return false; });
            QVERIFY2(naive.gouged == 0, shaped.name);
            // It stands on the part: so much lower it would gouge.
            StrategyResult lower = path;
            for (Pass& p : lower.passes)
                for (CutterLocation& c : p.cl)
                    c.tip.z() -= 0.1;
            QVERIFY2(
                naive_check(mesh, lower, shaped.tool, 0.1, [](const PartSample&) { return false; }).gouged
                    > 10,
                shaped.name);
        }
    }

    void or_beside_it() {
        const Mesh mesh = hills();
        for (const auto side : {AlongCurveSettings::Side::left, AlongCurveSettings::Side::right}) {
            AlongCurveSettings s = along();
            s.side = side;
            const StrategyResult path = planned_on(mesh, s, ball_tool(2));
            const bool left = side == AlongCurveSettings::Side::left;
            for (const Pass& pass : path.passes)
                for (const CutterLocation& c : pass.cl) {
                    QVERIFY2(std::abs(distance_from(ring_of_corners, c.tip) - 1) < 0.02,
                             qPrintable(QString::number(distance_from(ring_of_corners, c.tip))));
                    // Counter-clockwise: left is within.
                    const bool within = std::abs(c.tip.x()) < 7 && std::abs(c.tip.y()) < 5.5
                                        && distance_from(ring_of_corners, Vec3(-2, -1, 0)) > 1;
                    if (left) QVERIFY(within);
                }
            QVERIFY(!path.passes.empty());
        }
        AlongCurveSettings far = along();
        far.side = AlongCurveSettings::Side::left;
        far.offset = {9, ""};
        std::string message;
        QCOMPARE(code_of([&] { planned_on(mesh, far, ball_tool(2)); }, &message),
                 std::string("empty_result"));
        QVERIFY2(message.find("nothing runs 9 mm to that side") != std::string::npos, message.c_str());
        // A curve drawn the other way round is run the same way.
        AlongCurveSettings s = along();
        s.side = AlongCurveSettings::Side::left;
        QCOMPARE(planned_on(mesh, s, ball_tool(2), reversed(ring_of_corners)).passes.size(),
                 planned_on(mesh, s, ball_tool(2)).passes.size());
    }

    void so_much_below_in_so_many_cuts() {
        const Mesh mesh = hills();
        AlongCurveSettings s = along();
        s.open = true;
        s.depth = 0.4;
        s.cuts = 3;
        s.cut_depth = 0.3;
        const StrategyResult path = planned_on(mesh, s, ball_tool(2));
        QVERIFY(tells(path, "0.4 mm into the part on purpose"));
        QCOMPARE(path.passes.size(), std::size_t(3));
        const Pass plain = planned_on(
                               mesh,
                               [] {
                                   AlongCurveSettings flat = along();
                                   flat.open = true;
                                   return flat;
                               }(),
                               ball_tool(2))
                               .passes.front();
        for (std::size_t k = 0; k < 3; ++k) {
            Pass pass = path.passes[k];
            if (k == 1) std::reverse(pass.cl.begin(), pass.cl.end()); // to and fro
            QCOMPARE(pass.cl.size(), plain.cl.size());
            const double rise = 0.3 * double(2 - k) - 0.4;
            for (std::size_t i = 0; i < plain.cl.size(); ++i)
                QVERIFY((pass.cl[i].tip - plain.cl[i].tip - Vec3(0, 0, rise)).norm() < 1e-9);
        }
        // An open curve does not go back to its first corner.
        QVERIFY((plain.cl.back().tip.head<2>() - ring_of_corners.points.back()).norm() < 1e-9);
    }

    void what_lies_off_the_part_is_said() {
        const Mesh mesh = hills();
        PlanCurve off = ring_of_corners;
        for (Vec2& p : off.points)
            p.x() += 100;
        std::string message;
        QCOMPARE(code_of([&] { planned_on(mesh, along(), ball_tool(2), off); }, &message),
                 std::string("out_of_range"));
        QVERIFY2(message.find("boundary 'Curve'") != std::string::npos
                     && message.find("all of it lies off the part, as at (94, -5") != std::string::npos,
                 message.c_str());
        PlanCurve half = ring_of_corners;
        for (Vec2& p : half.points)
            p.x() += 12;
        const StrategyResult path = planned_on(mesh, along(), ball_tool(2), half);
        QVERIFY(tells(path, "of the curve lies off the part, as at (14"));
        for (const Pass& pass : path.passes)
            for (const CutterLocation& c : pass.cl)
                QVERIFY(c.tip.x() < 14.02);
    }

    /// With no curve named it is the outline.
    void the_outline_is_trimmed() {
        const StrategyResult path = planned_on(dome(12, 30), along(""), ball_tool(4));
        QCOMPARE(path.passes.size(), std::size_t(1));
        for (const CutterLocation& c : path.passes.front().cl)
            QVERIFY2(std::abs(c.tip.head<2>().norm() - 12) < 0.1,
                     qPrintable(QString::number(c.tip.head<2>().norm())));
    }

    void it_can_be_cancelled() {
        const Mesh mesh = hills();
        Job job;
        PlanContext context = context_of(mesh, ball_tool(2));
        context.curves = {{"Curve", {ring_of_corners}}};
        QVERIFY(cancelled_at(job, 0.3, [&](const Progress& p) { AlongCurve(along()).plan(context, p); }));
    }
};

FACETMILL_TEST(TestAlongCurve)
#include "test_along_curve.moc"
