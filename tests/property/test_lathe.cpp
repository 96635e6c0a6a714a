// Every registered operation that turns the part, with every cutter shape over parts with and without
// symmetry: judged by the verifier, which shares no code with the planner and turns the part as the machine
// does.
#include "core/base/parallel.h"
#include "core/link/link.h"
#include "core/output/apt.h"
#include "core/strategy/lathe/lathe_finish.h"
#include "core/strategy/lathe/lathe_rough.h"
#include "core/verify/verify.h"
#include "tests/property/shapes.h"
#include "tests/property/turned_part.h"
#include "tests/support/cancel_at.h"
#include "tests/support/path_numbers.h"
#include "tests/support/test_runner.h"

#include <QTest>

#include <cmath>

using namespace facetmill;
using namespace facetmill::test;

namespace {

constexpr double length = 9;

Mesh part_named(const std::string& name) {
    // Hollows are wide enough for a ball of diameter 6.
    if (name == "lobes")
        return turned_part(60, 18, length,
                           [](double a, double x) { return 8 + 0.6 * std::cos(3 * a + 0.25 * x); });
    if (name == "waist")
        return turned_part(48, 24, length,
                           [](double, double x) { return 7 + 0.6 * std::cos(2 * pi * x / length); });
    return turned_part(4, 9, length, [](double, double) { return 9.0; }); // square
}

PlanContext turning_context(const Mesh& part, const Tool& tool) {
    PlanContext c = context_of(part, tool);
    c.machine = find_machine("lathe-mill");
    double radius = 0;
    for (const Vec3& v : part.vertices)
        radius = std::max(radius, std::hypot(v.y(), v.z()));
    c.stock.kind = StockSolid::Kind::cylinder;
    c.stock.axis = 0;
    c.stock.radius = radius + 1.5;
    c.stock_box = {Vec3(0, -c.stock.radius, -c.stock.radius), Vec3(length, c.stock.radius, c.stock.radius)};
    c.stock.box = c.stock_box;
    return c;
}

std::vector<std::string> turning_kinds() {
    std::vector<std::string> kinds;
    for (const OperationKind& k : operation_kinds())
        if (k.make()->turning()) kinds.push_back(k.kind);
    return kinds;
}

Verification judged(const Mesh& part, const PlanContext& context, const ToolMotions& motions,
                    double tolerance, double chord, double allowance) {
    VerifySettings s;
    s.resolution = 0.8;
    s.sample_spacing = 0.8;
    s.tolerance = tolerance;
    s.gouge_limit = chord;
    s.allowance = allowance;
    const VerifyProgram program{"L", VerifyTool(context.tool), std::make_shared<ToolMotions>(motions),
                                motions.turning};
    return verify(part, context.stock, {&program, 1}, s, Progress());
}

} // namespace

class TestLatheShapes : public QObject {
    Q_OBJECT
private slots:
    void parts_are_cut_to_tolerance_data() {
        QTest::addColumn<QString>("kind");
        QTest::addColumn<QString>("part");
        QTest::addColumn<int>("cutter");
        QTest::addColumn<int>("pattern");
        const auto tools = tools_of_every_shape();
        int next = 0; // patterns in turn
        // Every cutter on every part; which pattern changes from one to the next. The verifier takes its time
        // over roughing, so that each cutter is asked once there.
        for (const std::string& kind : turning_kinds())
            for (const char* part : {"lobes", "waist", "square"})
                for (std::size_t c = 0; c < tools.size(); ++c) {
                    const int pattern = next++ % 3;
                    const std::size_t row = part[0] == 'l' ? 0 : part[0] == 'w' ? 1 : 2;
                    if (kind == "lathe_rough" && (c + row) % 4 != 0 && (c + row) % 4 != 3) continue;
                    QTest::addRow("%s %s %s %d", kind.c_str(), part, tools[c].name, pattern)
                        << QString::fromStdString(kind) << QString(part) << int(c) << pattern;
                }
    }

    void parts_are_cut_to_tolerance() {
        QFETCH(QString, kind);
        QFETCH(QString, part);
        QFETCH(int, cutter);
        QFETCH(int, pattern);
        const Mesh mesh = part_named(part.toStdString());
        const Tool tool = tools_of_every_shape()[std::size_t(cutter)].tool;
        const PlanContext context = turning_context(mesh, tool);
        const auto op = make_operation(kind.toStdString());
        const bool sharp = tool.corner_radius < 1, rough = kind == "lathe_rough";
        op->common().tolerance = sharp || rough ? 0.4 : 0.15;
        op->set("pattern", std::vector<std::string>{"helix", "rings", "lengthwise"}[std::size_t(pattern)]);
        const StrategyResult path = op->plan(context, Progress());
        const ToolMotions motions = link_operation(*op, path, context, Progress());
        QVERIFY(motions.turning);
        const double tolerance = op->common().tolerance;
        const Verification v =
            judged(mesh, context, motions, tolerance, path.chord_tolerance, op->left_on_purpose());
        QVERIFY2(!v.gouged(), qPrintable(QString("gouge %1").arg(v.figures.gouge_max)));
        for (const Collision& c : v.collisions)
            QFAIL(qPrintable(QString("collision of kind %1, %2 deep, motion %3")
                                 .arg(int(c.kind))
                                 .arg(c.depth)
                                 .arg(c.at.motion)));
        QVERIFY(v.figures.samples > 200);
        // A level bottom stands over a hollow on its rim.
        const bool bridges = (tool.corner_radius < 2 && part != "square");
        if (!bridges) {
            QVERIFY2(v.figures.excess_p999 <= 1.03 * tolerance,
                     qPrintable(QString("excess %1 of %2").arg(v.figures.excess_p999).arg(tolerance)));
            QVERIFY2(v.figures.uncut_fraction == 0, qPrintable(QString::number(v.figures.uncut_fraction)));
        }
        QVERIFY(path.cusp_max <= tolerance * (1 + 1e-9));
    }

    /// The machine turns the part evenly; a reader of the program that takes motions for straight is within
    /// the tolerance too.
    void straight_motion_is_within_tolerance_too() {
        const Mesh mesh = part_named("lobes");
        const PlanContext context = turning_context(mesh, ball_tool(6));
        LatheFinishSettings s;
        s.tolerance = 0.1;
        const LatheFinish op(s);
        const StrategyResult path = op.plan(context, Progress());
        ToolMotions motions = link_operation(op, path, context, Progress());
        motions.turning.reset();
        const Verification v = judged(mesh, context, motions, s.tolerance, path.chord_tolerance, 0);
        QVERIFY2(!v.gouged() && v.collisions.empty(), qPrintable(QString::number(v.figures.gouge_max)));
        QVERIFY(v.figures.excess_p999 <= 1.03 * s.tolerance);
    }

    void tilted_and_off_center_tools_keep_clear() {
        const Mesh mesh = part_named("lobes");
        for (const auto& [name, tool] : tools_of_every_shape()) {
            const PlanContext context = turning_context(mesh, tool);
            LatheFinishSettings s;
            s.tolerance = 0.3;
            s.tilt = radians(15);
            s.offset = 1;
            const LatheFinish op(s);
            const StrategyResult path = op.plan(context, Progress());
            const Verification v = judged(mesh, context, link_operation(op, path, context, Progress()),
                                          s.tolerance, path.chord_tolerance, 0);
            QVERIFY2(!v.gouged(), qPrintable(QString("%1: %2").arg(name).arg(v.figures.gouge_max)));
            QVERIFY2(v.collisions.empty(), name);
            if (tool.corner_radius == 3)
                QVERIFY2(v.figures.excess_p999 <= 1.05 * s.tolerance,
                         qPrintable(QString::number(v.figures.excess_p999)));
        }
    }

    void roughing_then_finishing_is_free_of_collisions() {
        const Mesh mesh = part_named("square");
        const PlanContext context = turning_context(mesh, ball_tool(6));
        LatheRoughSettings r;
        r.depth_of_cut = 1.5;
        r.tolerance = 0.4;
        LatheFinishSettings f;
        f.tolerance = 0.1;
        const LatheRough rough(r);
        const LatheFinish finish(f);
        std::vector<VerifyProgram> programs;
        double chord = 0;
        for (const Operation* op :
             {static_cast<const Operation*>(&rough), static_cast<const Operation*>(&finish)}) {
            const StrategyResult path = op->plan(context, Progress());
            const auto motions =
                std::make_shared<ToolMotions>(link_operation(*op, path, context, Progress()));
            programs.push_back(
                {std::string(op->kind()), VerifyTool(context.tool), motions, motions->turning});
            chord = std::max(chord, path.chord_tolerance);
        }
        VerifySettings s;
        s.resolution = 0.6;
        s.tolerance = f.tolerance;
        s.gouge_limit = chord;
        const Verification v = verify(mesh, context.stock, programs, s, Progress());
        QVERIFY(v.passed());
        QCOMPARE(v.figures.uncut_fraction, 0.0);
        QVERIFY2(v.figures.excess_p999 <= 1.03 * f.tolerance,
                 qPrintable(QString::number(v.figures.excess_p999)));
    }

    void threads_do_not_change_a_bit() {
        const PlanContext context = turning_context(part_named("lobes"), ball_tool(6));
        for (const std::string& kind : turning_kinds()) {
            const auto op = make_operation(kind);
            op->common().tolerance = 0.2;
            set_thread_count(1);
            const auto one = path_numbers(op->plan(context, Progress()));
            set_thread_count(2);
            const auto two = path_numbers(op->plan(context, Progress()));
            set_thread_count(0);
            QVERIFY(one.size() > 1000);
            QVERIFY(one == two);
        }
    }

    void cancelling_anywhere_leaves_nothing() {
        const PlanContext context = turning_context(part_named("lobes"), ball_tool(6));
        for (const std::string& kind : turning_kinds()) {
            const auto op = make_operation(kind);
            op->common().tolerance = 0.1;
            for (int point = 0; point < 10; ++point) {
                Job job;
                const double at = 0.075 * point;
                QVERIFY2(cancelled_at(job, at, [&](const Progress& p) { op->plan(context, p); }),
                         qPrintable(QString::number(at)));
            }
        }
    }
};

FACETMILL_TEST(TestLatheShapes)
#include "test_lathe.moc"
