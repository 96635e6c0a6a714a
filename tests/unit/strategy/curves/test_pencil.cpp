// Pencil passes against valleys whose course is known, and against a naive check.
#include "core/strategy/curves/pencil.h"
#include "tests/property/shapes.h"
#include "tests/support/any_threads.h"
#include "tests/support/cancel_at.h"
#include "tests/support/error_code.h"
#include "tests/support/naive_finish.h"
#include "tests/support/test_runner.h"
#include "tests/support/trials.h"

#include <QTest>

#include <set>

using namespace facetmill;
using namespace facetmill::test;

namespace {

PencilSettings beside(long passes) {
    PencilSettings s;
    s.tolerance = 0.1;
    s.side_passes = passes;
    return s;
}

StrategyResult planned_on(const Mesh& mesh, const PencilSettings& settings, const Tool& tool) {
    return Pencil(settings).plan(context_of(mesh, tool), Progress());
}

/// Two planes of a slope that meet over the X axis.
Mesh crease(double slope) {
    return height_field([slope](double, double y) { return slope * std::abs(y); }, Vec2(-20, -12),
                        Vec2(20, 12), 8, 8);
}

/// Two valleys that cross, one of them bent.
Mesh crossed() {
    const auto z = [](double x, double y) {
        return std::min(0.9 * std::abs(y - 0.02 * x * x), 0.7 * std::abs(x + 4));
    };
    return height_field(z, Vec2(-15, -12), Vec2(15, 12), trials(60, 2), trials(48, 2));
}

} // namespace

class TestPencil : public QObject {
    Q_OBJECT
private slots:
    void it_is_described() {
        const auto op = make_operation("pencil");
        std::set<std::string> keys;
        for (const ParameterInfo* p : op->parameters()) {
            keys.insert(p->key);
            QVERIFY2(!p->label.empty() && !p->help.empty(), p->key.c_str());
            QVERIFY2(op->get(p->key) == p->default_value, p->key.c_str());
        }
        for (const char* key : {"tolerance", "side_passes", "stepover", "boundary", "avoid", "rest_only"})
            QVERIFY2(keys.count(key) == 1, key);
        QVERIFY(op->three_axis() && op->linking() == Linking::upright);
    }

    /// In a crease a ball touches both flanks, its middle over the edge.
    void one_pass_lies_over_the_crease() {
        const double slope = 0.8, radius = 4, lifted = radius * std::hypot(1, slope) - radius;
        const StrategyResult path = planned_on(crease(slope), beside(0), ball_tool(2 * radius));
        QCOMPARE(path.passes.size(), std::size_t(1));
        double from = infinity, to = -infinity;
        for (const CutterLocation& c : path.passes.front().cl) {
            QVERIFY(std::abs(c.tip.y()) < 1e-4);
            QVERIFY2(std::abs(c.tip.z() - lifted) < path.chord_tolerance,
                     qPrintable(QString::number(c.tip.z() - lifted)));
            from = std::min(from, c.tip.x());
            to = std::max(to, c.tip.x());
        }
        QVERIFY2(from < -18 && to > 18, qPrintable(QString("%1 %2").arg(from).arg(to)));
    }

    /// Three to either side leave no more than the tolerance on both flanks, in as wide steps as that lets.
    void side_passes_keep_the_tolerance() {
        const double slope = 0.8, radius = 4;
        const Mesh mesh = crease(slope);
        for (const Tool& tool : {ball_tool(2 * radius), bull_tool(8, 1)}) {
            const StrategyResult path = planned_on(mesh, beside(3), tool);
            QCOMPARE(path.passes.size(), std::size_t(7));
            double left = 0, right = 0;
            for (const Pass& pass : path.passes) {
                left = std::max(left, pass.cl[pass.cl.size() / 2].tip.y());
                right = std::min(right, pass.cl[pass.cl.size() / 2].tip.y());
            }
            QVERIFY(std::abs(left - 3 * path.stepover_max) < 0.05 && std::abs(left + right) < 0.05);
            // Where the passes touch the flanks, and between.
            double first = infinity, last = 0;
            for (const Pass& pass : path.passes)
                for (const CutterContact& c : pass.cc) {
                    first = std::min(first, std::abs(c.point.y()));
                    last = std::max(last, std::abs(c.point.y()));
                }
            const Naive naive = naive_check(mesh, path, tool, 0.1, [&](const PartSample& s) {
                return std::abs(s.p.x()) < 15 && std::abs(s.p.y()) > first && std::abs(s.p.y()) < last;
            });
            QCOMPARE(naive.gouged, std::size_t(0));
            QVERIFY(naive.judged > 50);
            QCOMPARE(naive.high, std::size_t(0));
        }
        const StrategyResult ball = planned_on(mesh, beside(1), ball_tool(2 * radius));
        const double on_slope = 2 * std::sqrt(2 * radius * 0.095 - 0.095 * 0.095) / std::hypot(1, slope);
        QVERIFY2(ball.stepover_max > 0.9 * on_slope && ball.stepover_max < 1.02 * on_slope,
                 qPrintable(QString("%1 %2").arg(ball.stepover_max).arg(on_slope)));
        PencilSettings fixed = beside(2);
        fixed.stepover = {0.4, ""};
        QCOMPARE(planned_on(mesh, fixed, ball_tool(8)).stepover_max, 0.4);
    }

    void nothing_is_gouged_where_valleys_cross() {
        const Mesh mesh = crossed();
        for (const ShapedTool& shaped : tools_of_every_shape()) {
            const StrategyResult path = planned_on(mesh, beside(2), shaped.tool);
            QVERIFY2(path.passes.size() > 5, shaped.name);
            const Naive naive =
                naive_check(mesh, path, shaped.tool, 0.1, [](const PartSample&) { return false; });
            QVERIFY2(naive.gouged == 0, shaped.name);
        }
        // With an allowance the cutter keeps it off.
        PencilSettings thick = beside(1);
        thick.allowance = 0.5;
        const StrategyResult path = planned_on(mesh, thick, ball_tool(6));
        const BruteCutter grown(AptCutter::ball(6.98, 20));
        const std::vector<PartSample> samples = part_samples(mesh, 3);
        for (const Vec3& tip : tips_of(path, 1))
            for (const PartSample& s : samples)
                QVERIFY(!holds(grown, tip - Vec3(0, 0, 0.49), s.p, path.chord_tolerance));
    }

    void where_there_is_no_valley_that_is_said() {
        std::string message;
        QCOMPARE(code_of([] { planned_on(dome(12, 20), beside(1), ball_tool(6)); }, &message),
                 std::string("empty_result"));
        QVERIFY2(message.find("nowhere at two places") != std::string::npos, message.c_str());
        bool nothing = false;
        try {
            planned_on(dome(12, 20), beside(1), ball_tool(6));
        } catch (const NothingToDo&) {
            nothing = true;
        }
        QVERIFY(nothing);
    }

    void threads_change_nothing_and_it_can_be_cancelled() {
        const Mesh mesh = crossed();
        QVERIFY(same_with_any_threads([&] { return planned_on(mesh, beside(2), bull_tool(4, 1)); }));
        for (const double at : {0.3, 0.7}) {
            Job job;
            const Pencil op(beside(2));
            QVERIFY(cancelled_at(job, at,
                                 [&](const Progress& p) { op.plan(context_of(mesh, ball_tool(4)), p); }));
        }
    }
};

FACETMILL_TEST(TestPencil)
#include "test_pencil.moc"
