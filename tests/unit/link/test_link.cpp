// Links and clearance moves: near passes on the surface, far ones over everything.
#include "core/link/link.h"
#include "core/strategy/five_axis/posture_path.h"
#include "tests/property/shapes.h"
#include "tests/support/path_checker.h"
#include "tests/support/test_runner.h"

#include <QTest>

using namespace facetmill;
using namespace facetmill::test;

namespace {

Pass pass(std::initializer_list<Vec3> tips) {
    Pass p;
    for (const Vec3& t : tips) {
        p.cl.push_back({t, Vec3(0, 0, 1)});
        p.cc.push_back({t, Vec3(0, 0, 1)});
    }
    return p;
}

std::string kinds_of(const ToolMotions& m) {
    std::string text;
    for (const Motion& motion : m.motions)
        text += "racl^"[int(motion.kind)];
    return text;
}

LinkOptions near_options(double distance) {
    LinkOptions o;
    o.clearance = 5;
    o.link_distance = distance;
    o.chord_tolerance = 0.002;
    return o;
}

const Mesh& level() {
    static const Mesh mesh =
        height_field([](double, double) { return 0.0; }, Vec2(-20, -15), Vec2(20, 15), 4, 3);
    return mesh;
}

} // namespace

class TestLink : public QObject {
    Q_OBJECT
private slots:
    void near_passes_are_linked_and_far_ones_are_not() {
        PlanContext context = context_of(level(), ball_tool(6));
        context.stock_box.hi.z() = 7;
        StrategyResult path;
        path.passes = {pass({Vec3(-10, 0, 0), Vec3(10, 0, 0)}), pass({Vec3(10, 1, 0), Vec3(-10, 1, 0)}),
                       pass({Vec3(10, 2, 0), Vec3(-10, 2, 0)})};
        const ToolMotions m = link_three_axis(path, context, 0, near_options(2), Progress());
        QCOMPARE(kinds_of(m), std::string("raclc^rac^"));
        QCOMPARE(m.clearance_z, 12.0); // above the stock
        for (const Motion& motion : m.motions)
            if (motion.kind == MotionKind::rapid || motion.kind == MotionKind::retract)
                QCOMPARE(motion.to.tip.z(), 12.0);
        // Every point of every pass is met, in order.
        std::vector<std::pair<Index, Index>> points;
        for (const Motion& motion : m.motions)
            if (motion.pass != no_index) {
                points.emplace_back(motion.pass, motion.point);
                QCOMPARE(motion.to.tip, path.passes[motion.pass].cl[motion.point].tip);
            }
        QCOMPARE(points.size(), std::size_t(6));
        QVERIFY(std::is_sorted(points.begin(), points.end()));
        // Rapids run level: up and down goes at feed.
        for (std::size_t i = 1; i < m.motions.size(); ++i)
            if (m.motions[i].kind == MotionKind::rapid)
                QCOMPARE(m.motions[i].to.tip.z(), m.motions[i - 1].to.tip.z());
    }

    void a_link_climbs_over_what_stands_between() {
        // A rib of height 2 along y = 3.
        const Mesh m = height_field([](double, double y) { return std::abs(y - 3) < 0.5 ? 2.0 : 0.0; },
                                    Vec2(-20, -15), Vec2(20, 15), 4, 300);
        const Tool tool = ball_tool(4);
        const PlanContext context = context_of(m, tool);
        StrategyResult path;
        path.passes = {pass({Vec3(-10, -1, 0), Vec3(10, -1, 0)}), pass({Vec3(10, 7, 0), Vec3(-10, 7, 0)})};
        const ToolMotions motions = link_three_axis(path, context, 0, near_options(10), Progress());
        double highest = -infinity;
        TipLine line;
        for (const Motion& motion : motions.motions) {
            line.push_back(motion.to.tip);
            if (motion.kind == MotionKind::link) highest = std::max(highest, motion.to.tip.z());
            QVERIFY(motion.kind != MotionKind::rapid || &motion == &motions.motions.front());
        }
        QVERIFY2(std::abs(highest - 2) < 0.01, qPrintable(QString::number(highest)));
        PathCheckOptions options;
        options.spacing = 0.2;
        const std::vector<TipLine> tips{line};
        QVERIFY(check_path(m, tool.cutter(), tips, options).gouge_max <= 0.002);
    }

    void a_link_crosses_a_hole_level() {
        const Mesh m =
            only(height_field([](double, double) { return 0.0; }, Vec2(-20, -15), Vec2(20, 15), 40, 30),
                 [](const Vec3& p) { return std::abs(p.x()) > 5; });
        const PlanContext context = context_of(m, ball_tool(6));
        StrategyResult path;
        path.passes = {pass({Vec3(-15, 0, 0), Vec3(-5, 0, 0)}), pass({Vec3(5, 0, 0), Vec3(15, 0, 0)})};
        for (const Motion& motion : link_three_axis(path, context, 0, near_options(20), Progress()).motions)
            QVERIFY(motion.to.tip.z() >= 0);
    }

    /// Tips a diameter apart, contacts beside each other: a flat end that turns round.
    void a_flat_end_turns_round_without_going_up() {
        const double lead = radians(5), radius = 5;
        StrategyResult path;
        for (const int travel : {1, -1}) {
            Pass p;
            const Vec3 axis(travel * std::sin(lead), 0, std::cos(lead)),
                down(travel * std::cos(lead), 0, -std::sin(lead)); // to the rim's lowest point
            const double y = travel > 0 ? 0 : 1;
            for (const double x : {-10.0 * travel, 10.0 * travel}) {
                p.cc.push_back({Vec3(x, y, 0), Vec3::UnitZ()});
                p.cl.push_back({Vec3(x, y, 0) - radius * down, axis});
            }
            path.passes.push_back(std::move(p));
        }
        const PlanContext context = context_of(level(), flat_tool(2 * radius));
        const ToolMotions m = link_five_axis(path, context, {}, near_options(2), Progress());
        QVERIFY2(kinds_of(m).find("cl") != std::string::npos && kinds_of(m).find("^r") == std::string::npos,
                 kinds_of(m).c_str());
        path.passes[1].cc.front().point.y() = path.passes[1].cl.front().tip.y() = 15;
        QVERIFY(kinds_of(link_five_axis(path, context, {}, near_options(2), Progress())).find("^r")
                != std::string::npos);
    }

    /// Deep in a block the way over the part is less than up and down again.
    void a_tilted_tool_goes_over_the_part_where_that_is_shorter() {
        const auto ridge = [](double, double y) { return 6 * std::max(0.0, 1 - std::abs(y - 10) / 6); };
        const Mesh m = height_field(ridge, Vec2(-30, -30), Vec2(30, 90), 60, 240);
        const auto path = [&](double from, double to, double turn) {
            StrategyResult result;
            for (const auto& [y, lean] : {std::pair(from, -0.5 * turn), std::pair(to, 0.5 * turn)}) {
                Pass p;
                const Vec3 axis(std::sin(lean), 0, std::cos(lean));
                for (const double x : {-10.0, 10.0}) {
                    const double at = y == from ? x : -x;
                    p.cc.push_back({Vec3(at, y, 0), Vec3::UnitZ()});
                    p.cl.push_back({Vec3(at, y, 3) - 3 * axis, axis});
                }
                result.passes.push_back(std::move(p));
            }
            return result;
        };
        PlanContext context = context_of(m, ball_tool(6));
        const auto linked = [&](const StrategyResult& passes) {
            return link_five_axis(passes, context, {}, near_options(2), Progress());
        };
        const auto goes_up = [&](const StrategyResult& passes) {
            return kinds_of(linked(passes)).find("^r") != std::string::npos;
        };
        // Hardly any way up: up.
        QVERIFY(goes_up(path(0, 20, radians(20))));
        context.stock_box.hi.z() = 40;
        QVERIFY(goes_up(path(-20, 80, radians(20)))); // far
        QVERIFY(goes_up(path(0, 20, radians(60))));   // the axes would turn far
        const ToolMotions over = linked(path(0, 20, radians(20)));
        QVERIFY2(kinds_of(over).find("^r") == std::string::npos, kinds_of(over).c_str());
        const ToolLift lift(context.contact, context.tool, ToolClearance{});
        ToolLift::Hint hint;
        double deepest = -infinity, highest = 0;
        for (std::size_t i = 1; i < over.motions.size(); ++i) {
            if (over.motions[i].kind != MotionKind::link) continue;
            for (int k = 0; k <= 200; ++k) {
                const CutterLocation at =
                    location_on_route(over.motions[i - 1].to, over.motions[i].to, k / 200.0);
                deepest = std::max(deepest, lift.lift({at.tip, at.axis}, hint));
                highest = std::max(highest, at.tip.z());
            }
        }
        QVERIFY2(deepest <= near_options(2).chord_tolerance, qPrintable(QString::number(deepest)));
        QVERIFY2(highest > 6 && highest < 9, qPrintable(QString::number(highest)));
    }

    /// A boss thinner than a step of a long way that were looked at in a given number of places.
    void a_long_link_misses_no_thin_wall() {
        const auto wall = [](double x, double) {
            return std::abs(x - 150.3) < 0.31 ? 4.0 * (1 - std::abs(x - 150.3) / 0.31) : 0.0;
        };
        Mesh m;
        {
            // Facets no wider than the wall where it stands.
            std::vector<double> xs{-10};
            for (double x = 0; x <= 300; x += x > 149 && x < 151.5 ? 0.1 : 5)
                xs.push_back(x);
            xs.push_back(310);
            for (const double x : xs)
                for (const double y : {-10.0, 10.0})
                    m.vertices.push_back(Vec3(x, y, wall(x, y)));
            for (Index i = 0; i + 1 < Index(xs.size()); ++i) {
                const Index a = 2 * i, b = a + 1, c = a + 2, d = a + 3;
                m.facets.push_back({a, c, b});
                m.facets.push_back({c, d, b});
            }
        }
        PlanContext context = context_of(m, ball_tool(1));
        context.stock_box.hi.z() = 400;
        StrategyResult path;
        for (const double x : {0.0, 300.0}) {
            Pass p;
            const Vec3 axis(0, std::sin(0.1), std::cos(0.1));
            for (const double y : {-2.0, 2.0}) {
                p.cc.push_back({Vec3(x, y, 0), Vec3::UnitZ()});
                p.cl.push_back({Vec3(x, y, 0.5) - 0.5 * axis, axis});
            }
            path.passes.push_back(std::move(p));
        }
        const ToolMotions over = link_five_axis(path, context, {}, near_options(2), Progress());
        QVERIFY2(kinds_of(over).find("^r") == std::string::npos, kinds_of(over).c_str());
        const ToolLift lift(context.contact, context.tool, ToolClearance{});
        ToolLift::Hint hint;
        double deepest = -infinity;
        for (std::size_t i = 1; i < over.motions.size(); ++i)
            if (over.motions[i].kind == MotionKind::link)
                for (int k = 0; k <= 20000; ++k) {
                    const CutterLocation at =
                        location_on_route(over.motions[i - 1].to, over.motions[i].to, k / 20000.0);
                    deepest = std::max(deepest, lift.lift({at.tip, at.axis}, hint));
                }
        QVERIFY2(deepest <= near_options(2).chord_tolerance, qPrintable(QString::number(deepest)));
        Job job;
        job.cancel();
        QVERIFY_EXCEPTION_THROWN(link_five_axis(path, context, {}, near_options(2), Progress(job)),
                                 Cancelled);
    }

    void an_allowance_stays_under_links() {
        const PlanContext context = context_of(level(), ball_tool(6));
        StrategyResult path;
        path.passes = {pass({Vec3(-10, 0, 0.4), Vec3(10, 0, 0.4)}),
                       pass({Vec3(10, 4, 0.4), Vec3(-10, 4, 0.4)})};
        const ToolMotions m = link_three_axis(path, context, 0.4, near_options(5), Progress());
        for (const Motion& motion : m.motions)
            QVERIFY(motion.to.tip.z() >= 0.4 - 1e-9);
        // With more allowance than the passes were made with, the link rises off them.
        double highest = 0;
        for (const Motion& motion : link_three_axis(path, context, 0.6, near_options(5), Progress()).motions)
            if (motion.kind == MotionKind::link) highest = std::max(highest, motion.to.tip.z());
        QVERIFY(std::abs(highest - 0.6) < 1e-6);
    }

    void bad_options_and_cancel_are_honoured() {
        const PlanContext context = context_of(level(), ball_tool(6));
        StrategyResult path;
        QVERIFY(link_three_axis(path, context, 0, near_options(1), Progress()).motions.empty());
        path.passes = {pass({Vec3(-10, 0, 0), Vec3(10, 0, 0)})};
        LinkOptions bad = near_options(1);
        bad.clearance = 0;
        QVERIFY_EXCEPTION_THROWN(link_three_axis(path, context, 0, bad, Progress()), Error);
        bad = near_options(1);
        bad.chord_tolerance = std::nan("");
        QVERIFY_EXCEPTION_THROWN(link_three_axis(path, context, 0, bad, Progress()), Error);
        Job job;
        job.cancel();
        QVERIFY_EXCEPTION_THROWN(link_three_axis(path, context, 0, near_options(1), Progress(job)),
                                 Cancelled);
    }

    void default_links_reach_the_next_pass() {
        const PlanContext context = context_of(level(), ball_tool(6));
        auto op = make_operation("finish3");
        const StrategyResult path = op->plan(context, Progress());
        const LinkOptions options = default_link_options(path, context, op->common());
        const ToolMotions m = link_three_axis(path, context, 0, options, Progress());
        std::size_t rapids = 0;
        for (const Motion& motion : m.motions)
            rapids += motion.kind == MotionKind::rapid;
        QCOMPARE(rapids, std::size_t(1));
    }
};

FACETMILL_TEST(TestLink)
#include "test_link.moc"
