// Roughing with every cutter shape over every part with known answers: the allowance stays, no more stays
// than is stated, nothing collides. Judged by the path checker and by the verifier, which share no code with
// the planner.
#include "core/base/parallel.h"
#include "core/link/motion.h"
#include "core/mesh/sample.h"
#include "core/strategy/rough.h"
#include "core/verify/verify.h"
#include "tests/property/shapes.h"
#include "tests/support/cancel_at.h"
#include "tests/support/path_checker.h"
#include "tests/support/test_runner.h"
#include "tests/support/trials.h"

#include <QTest>

#include <cstring>

using namespace facetmill;
using namespace facetmill::test;

namespace {

/// The cone cuts over all its length here: flutes as long as the part is high, and no shank above them.
std::vector<ShapedTool> cutters() {
    std::vector<ShapedTool> tools = tools_of_every_shape();
    tools.back().tool.flute_length = 30;
    tools.back().tool.shank_diameter = 0;
    return tools;
}

PlanContext raised(const Mesh& mesh, const Tool& tool) {
    PlanContext c = context_of(mesh, tool);
    c.stock_box.lo -= Vec3(3, 3, 0);
    c.stock_box.hi += Vec3(3, 3, 4);
    return c;
}

/// The motions at feed, which cut.
std::vector<TipLine> cuts(const ToolMotions& motions) {
    std::vector<TipLine> lines(1);
    for (const Motion& m : motions.motions) {
        if (m.kind == MotionKind::rapid && lines.back().size() > 1) lines.emplace_back();
        if (m.kind == MotionKind::rapid) lines.back().clear();
        lines.back().push_back(m.to.tip);
    }
    if (lines.back().size() < 2) lines.pop_back();
    return lines;
}

std::vector<double> numbers(const StrategyResult& r, const ToolMotions& m) {
    std::vector<double> all = r.layers;
    all.insert(all.end(), {r.cusp_max, r.stepover_min, double(r.passes.size()), m.air_length});
    for (const Motion& motion : m.motions) {
        all.push_back(double(int(motion.kind)));
        all.insert(all.end(), motion.to.tip.data(), motion.to.tip.data() + 3);
    }
    return all;
}

} // namespace

class TestRoughShapes : public QObject {
    Q_OBJECT
private slots:
    void shapes_keep_their_allowance_data() {
        QTest::addColumn<int>("shape");
        QTest::addColumn<int>("cutter");
        QTest::addColumn<bool>("by_tolerance");
        const auto parts = shapes();
        const auto tools = cutters();
        for (std::size_t s = 0; s < parts.size(); ++s)
            for (std::size_t c = 0; c < tools.size(); ++c) {
                const bool by_tolerance = (s + c) % 2 == 0;
                QTest::addRow("%s %s %s", parts[s].name.c_str(), tools[c].name,
                              by_tolerance ? "tolerance" : "depth")
                    << int(s) << int(c) << by_tolerance;
            }
    }

    void shapes_keep_their_allowance() {
        QFETCH(int, shape);
        QFETCH(int, cutter);
        QFETCH(bool, by_tolerance);
        const Shape part = shapes()[std::size_t(shape)];
        const Tool tool = cutters()[std::size_t(cutter)].tool;
        RoughSettings s;
        s.allowance = 0.4;
        s.tolerance = by_tolerance ? 1.2 : 6;
        if (!by_tolerance) s.depth = {1.5, {}};
        const Rough op(s);
        const PlanContext context = raised(part.mesh, tool);
        const StrategyResult path = op.plan(context, Progress());
        if (by_tolerance)
            QVERIFY2(path.cusp_max <= s.tolerance * (1 + 1e-9), qPrintable(QString::number(path.cusp_max)));
        const ToolMotions motions = link_operation(op, path, context, Progress());

        PathCheckOptions options;
        options.spacing = 2.2;
        options.border = 0.5 * tool.diameter;
        options.allowance = s.allowance;
        options.reach = 8;
        options.no_cusp = [&](const Vec3& p) {
            // What only tips below the lowest layer would touch, and what is steeper than a height tells.
            // The allowance keeps the tool a little farther from walls.
            for (const Vec3& beside :
                 {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(-1, 0, 0), Vec3(0, 1, 0), Vec3(0, -1, 0)})
                if (part.out_of_reach(p + beside, tool)) return true;
            return p.z() < context.part_box.lo.z() + 0.5 * tool.diameter;
        };
        const PathCheckResult result = check_path(part.mesh, tool.cutter(), cuts(motions), options);
        QVERIFY(result.samples > 150);
        QVERIFY2(result.gouge_max <= 1e-6, qPrintable(QString::number(result.gouge_max)));
        if (result.cusp_samples > 0)
            QVERIFY2(result.cusp_max <= path.cusp_max,
                     qPrintable(QString("%1 stated, %2 found").arg(path.cusp_max).arg(result.cusp_max)));

        if (cutter > 1 || shape % 2 != 0) return; // the verifier takes its time
        VerifySettings v;
        v.resolution = 0.6;
        v.sample_spacing = 1;
        v.allowance = s.allowance;
        v.tolerance = path.cusp_max;
        v.gouge_limit = 1e-3;
        StockSolid stock;
        stock.box = context.stock_box;
        const VerifyProgram program{"R", VerifyTool(tool), std::make_shared<ToolMotions>(motions), {}};
        const Verification judged = verify(part.mesh, stock, {&program, 1}, v, Progress());
        QVERIFY2(!judged.gouged(), qPrintable(QString::number(judged.figures.gouge_max)));
        QVERIFY2(judged.collisions.empty(),
                 qPrintable(QString("%1, first kind %2 depth %3")
                                .arg(judged.collisions.size())
                                .arg(judged.collisions.empty() ? -1 : int(judged.collisions[0].kind))
                                .arg(judged.collisions.empty() ? 0 : judged.collisions[0].depth)));
    }

    void threads_do_not_change_a_bit() {
        for (const char* word : {"from_tolerance", ""}) {
            RoughSettings s;
            s.tolerance = 1.5;
            s.depth = {*word ? 0.0 : 1.5, word};
            const Rough op(s);
            const PlanContext context = raised(mixed(), ball_tool(5));
            set_thread_count(1);
            const StrategyResult one = op.plan(context, Progress());
            const auto a = numbers(one, link_operation(op, one, context, Progress()));
            set_thread_count(0);
            const StrategyResult many = op.plan(context, Progress());
            const auto b = numbers(many, link_operation(op, many, context, Progress()));
            QVERIFY(a.size() > 500);
            QCOMPARE(a.size(), b.size());
            QVERIFY(std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0);
        }
    }

    void cancelling_anywhere_leaves_nothing() {
        const PlanContext context = raised(mixed(), ball_tool(5));
        RoughSettings s;
        s.tolerance = 1.5;
        const Rough op(s);
        const StrategyResult whole = op.plan(context, Progress());
        const auto reference = numbers(whole, link_operation(op, whole, context, Progress()));
        for (int point = 0; point < 10; ++point) {
            Job job;
            const double at = 0.1 * point;
            QVERIFY2(cancelled_at(job, at, [&](const Progress& p) { op.plan(context, p); }),
                     qPrintable(QString::number(at)));
        }
        const StrategyResult again = op.plan(context, Progress());
        QVERIFY(numbers(again, link_operation(op, again, context, Progress())) == reference);
    }
};

FACETMILL_TEST(TestRoughShapes)
#include "test_rough_shapes.moc"
