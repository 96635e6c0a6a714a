// Links and clearance moves: near passes on the surface, far ones over everything.
#include "core/link/envelope.h"
#include "core/link/later_cuts.h"
#include "core/link/link.h"
#include "core/link/shank_in_stock.h"
#include "core/strategy/five_axis/posture_path.h"
#include "core/strategy/lathe/lathe_finish.h"
#include "core/strategy/surface/stock_before.h"
#include "core/strategy/tilt/tilted_stock.h"
#include "tests/property/shapes.h"
#include "tests/property/turned_part.h"
#include "tests/support/path_checker.h"
#include "tests/support/test_runner.h"
#include "tests/support/trials.h"
#include "tests/unit/link/link_cases.h"

#include <QTest>

#include <algorithm>
#include <random>

using namespace facetmill;
using namespace facetmill::test;

namespace {

/// Between two passes the tool goes up and moves fast; at the end it does anyway.
bool travels_fast(const ToolMotions& m) {
    const std::string kinds = kinds_of(m);
    return kinds.find("^r") < kinds.rfind('a');
}

} // namespace

class TestLink : public QObject {
    Q_OBJECT
private slots:
    /// Against a field that is cut at once.
    void cuts_that_are_made_later_are_there_when_asked() {
        std::mt19937_64 rng(21);
        std::uniform_real_distribution<double> at(-45, 45), height(1, 9), step(-3, 3);
        const CutterProfile cutters[] = {CutterProfile(AptCutter::ball(6, 30)),
                                         CutterProfile(AptCutter::flat(6, 4)), // shorter than it cuts deep
                                         CutterProfile(AptCutter::from_shape(6, 0.5, 0, radians(-12), 12))};
        StockSolid solid;
        solid.box.lo = Vec3(-40, -40, 0);
        solid.box.hi = Vec3(40, 40, 10);
        for (const CutterProfile& profile : cutters)
            for (int trial = 0; trial < trials(20, 4); ++trial) {
                StockField at_once(solid, 0.5, Progress());
                LaterCuts later(at_once, profile, 1, Progress());
                const StockCutter cutter(profile);
                Vec3 from(at(rng), at(rng), height(rng));
                for (int i = 0; i < 200; ++i) {
                    const Vec3 to = i % 20 == 0 ? Vec3(at(rng), at(rng), height(rng))
                                                : Vec3(from + Vec3(step(rng), step(rng), 0));
                    at_once.cut(cutter, from, to);
                    later.feed(from, to);
                    from = to;
                    if (i % 25 != 7) continue;
                    const Vec2 p(at(rng), at(rng));
                    const double radius = 2 + height(rng);
                    QCOMPARE(later.about(p, p, radius).highest_near(p, p, radius),
                             at_once.highest_near(p, p, radius));
                    if (radius > profile.max_radius())
                        QCOMPARE(later.about(p, p, radius).clear_height(cutter, p, p),
                                 at_once.clear_height(cutter, p, p));
                }
                const StockField& all = later.about(Vec2(0, 0), Vec2(0, 0), 100);
                for (int row = 0; row < all.rows(); ++row)
                    for (int column = 0; column < all.columns(); ++column)
                        QVERIFY(std::abs(all.top(column, row) - at_once.top(column, row)) < 1e-9);
            }
    }

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

    void where_the_stock_is_known_tools_come_down_in_a_rapid() {
        PlanContext context = context_of(level(), ball_tool(6));
        context.stock.box = context.part_box;
        context.stock.box.hi.z() = 7;
        context.stock_box = context.stock.box;
        StrategyResult path;
        path.passes = {pass({Vec3(-10, 0, 0), Vec3(10, 0, 0)}), pass({Vec3(10, 3, 0), Vec3(-10, 3, 0)}),
                       pass({Vec3(-8, 1.5, -0.5), Vec3(8, 1.5, -0.5)})};
        const ToolMotions m = link_three_axis(path, context, 0, near_options(2), Progress());
        QCOMPARE(kinds_of(m), std::string("rrac^rrrac^rrrac^r"));
        // Over the block, over half of it, into the slot that is there: by half the radius above what stands.
        const double near = 1.5;
        std::vector<double> down;
        for (std::size_t i = 1; i < m.motions.size(); ++i) {
            if (m.motions[i].kind == MotionKind::approach) down.push_back(m.motions[i - 1].to.tip.z());
            if (m.motions[i].kind == MotionKind::retract)
                QCOMPARE(m.motions[i].to.tip.z(), m.motions[i - 1].to.tip.z() + near);
            // Down or level, never both.
            const Vec3 way = m.motions[i].to.tip - m.motions[i - 1].to.tip;
            if (m.motions[i].kind == MotionKind::rapid) QVERIFY(way.z() == 0 || way.head<2>().norm() == 0);
        }
        QCOMPARE(down.size(), std::size_t(3));
        QCOMPARE(down[0], 7 + near);
        QCOMPARE(down[1], 7 + near);
        QVERIFY2(down[2] > near + 0.2 && down[2] < near + 1, qPrintable(QString::number(down[2])));
    }

    /// A pass that says how high a link to it has to be: up, level and down instead of all the way up.
    void a_link_goes_as_high_as_a_pass_asks_for() {
        PlanContext context = context_of(level(), ball_tool(6));
        context.stock.box = context.part_box;
        context.stock.box.hi.z() = 7;
        context.stock_box = context.stock.box;
        StrategyResult path;
        path.passes = {pass({Vec3(-10, 0, 0), Vec3(10, 0, 0)}), pass({Vec3(10, 1, 0), Vec3(-10, 1, 0)})};
        const auto over = [&](double z, bool from_above) {
            path.passes[1].entry = {{Vec3(10, 1, z), Vec3::UnitZ()}};
            path.passes[1].from_above = from_above;
            const ToolMotions m = link_three_axis(path, context, 0, near_options(2), Progress());
            double highest = 0, lowest = infinity;
            std::size_t k = 1;
            while (m.motions[k].pass != 0 || m.motions[k].point != 1)
                ++k;
            for (; m.motions[k + 1].pass != 1 || m.motions[k + 1].point != 0; ++k) {
                const Vec3 a = m.motions[k].to.tip, b = m.motions[k + 1].to.tip;
                highest = std::max(highest, b.z());
                if (a.head<2>() != b.head<2>()) lowest = std::min({lowest, a.z(), b.z()});
            }
            return std::pair(lowest, highest);
        };
        QCOMPARE(over(3, false), std::pair(3.0, 3.0));
        QCOMPARE(over(6, false), std::pair(6.0, 6.0));
        // Not beside the stock that stands there, but by the clearance above what of it the ball meets.
        const auto above = over(3, true);
        QVERIFY2(above.first == above.second && above.first > 11 && above.first < 12,
                 qPrintable(QString::number(above.first)));
        QCOMPARE(over(12, false), above);
    }

    /// A ball that is lower than its slot is deep, on a slim shank: what stands beside the shank is in its
    /// way up. A shank wider than the cutter is in stock itself, that nobody roughed.
    void no_rapid_up_meets_what_stands_beside_the_shank() {
        for (const double shank : {4.0, 8.0}) {
            Tool tool = ball_tool(6);
            tool.flute_length = 4;
            tool.shank_diameter = shank;
            tool.shank_length = 30;
            PlanContext context = context_of(level(), tool);
            context.stock.box = context.part_box;
            context.stock.box.hi.z() = 7;
            context.stock_box = context.stock.box;
            StrategyResult path;
            path.passes = {pass({Vec3(-10, 0, 0), Vec3(10, 0, 0)}), pass({Vec3(10, 3, 0), Vec3(-10, 3, 0)})};
            const ToolMotions m = link_three_axis(path, context, 0, near_options(2), Progress());
            QCOMPARE(kinds_of(m), std::string("rrac^rrrac^r"));
            for (std::size_t i = 1; i < m.motions.size(); ++i)
                if (m.motions[i].kind == MotionKind::retract)
                    QVERIFY2(m.motions[i].to.tip.z() + tool.flute_length >= 7,
                             qPrintable(QString::number(m.motions[i].to.tip.z())));
        }
    }

    /// The same of a part that turns, and the planner's word for it.
    void a_shank_in_raw_material_comes_out_at_feed() {
        Tool tool = ball_tool(4);
        tool.flute_length = 3;
        tool.shank_diameter = 6;
        tool.shank_length = 40;
        PlanContext context = context_of(turned_part(48, 4, 20, [](double, double) { return 8.0; }), tool);
        context.stock.kind = StockSolid::Kind::cylinder;
        context.stock.axis = 0;
        context.stock_box = context.stock.box = {Vec3(0, -15, -15), Vec3(20, 15, 15)};
        LatheFinishSettings s;
        s.pattern = LatheCommon::Pattern::rings;
        const auto planned = [&](double radius) {
            context.stock.radius = radius;
            const LatheFinish op(s);
            const StrategyResult path = op.plan(context, Progress());
            return link_lathe(path, context, s, default_link_options(path, context, op.common()), Progress());
        };
        for (const double radius : {9.0, 15.0}) {
            const ToolMotions m = planned(radius);
            const ShankInStock in = shank_in_stock(m, s, context, Progress());
            QCOMPARE(in.length > 0.9 * in.whole, radius > 8 + tool.flute_length);
            QCOMPARE(shank_in_stock_warning(in, context).empty(), radius < 8 + tool.flute_length);
            const auto base = [&](std::size_t i) {
                const Vec3& p = m.motions[i].to.tip;
                return std::hypot(p.y(), p.z()) + tool.flute_length;
            };
            std::size_t rapids = 0;
            for (std::size_t i = 1; i < m.motions.size(); ++i)
                if (m.motions[i].kind == MotionKind::rapid) {
                    ++rapids;
                    QVERIFY2(base(i - 1) >= radius, qPrintable(QString::number(base(i - 1))));
                }
            QCOMPARE(rapids > 0, radius < 8 + tool.flute_length); // all the way out at feed
        }
    }

    /// A wall of height 8, its skin cut once: up along it, and down beside it, in rapids.
    void along_a_wall_that_is_cut_tools_move_fast() {
        const Mesh m = height_field([](double x, double) { return x > 5 ? 8.0 : 0.0; }, Vec2(-20, -15),
                                    Vec2(20, 15), 400, 3);
        Tool tool = ball_tool(6);
        tool.flute_length = 12;
        PlanContext context = context_of(m, tool);
        context.stock.box = context.part_box;
        // No wider than the cutter: nothing but the wall stays.
        context.stock.box.lo.y() = -2;
        context.stock.box.hi.y() = 2;
        context.stock_box = context.stock.box;
        const double x = 5 - 0.5 * tool.diameter - 0.2;
        StrategyResult path;
        path.passes = {pass({Vec3(-10, 0, 0), Vec3(x, 0, 0), Vec3(x, 0, 8)}),
                       pass({Vec3(x, 0.5, 0), Vec3(x, 1, 0)})};
        path.passes[1].from_above = true;
        const ToolMotions all = link_three_axis(path, context, 0, near_options(0.1), Progress());
        QVERIFY2(kinds_of(all) == "rraccrc^rrrac^r", kinds_of(all).c_str());
        double up = 0, down = 0;
        for (std::size_t i = 1; i < all.motions.size(); ++i) {
            const Vec3 way = all.motions[i].to.tip - all.motions[i - 1].to.tip;
            const MotionKind kind = all.motions[i].kind;
            if (kind == MotionKind::cut) up += std::max(way.z(), 0.0);
            if (kind == MotionKind::approach) down = way.norm();
            // Down or level, never both; never down on what is not known to be gone.
            if (kind == MotionKind::rapid) QVERIFY(way.z() == 0 || way.head<2>().norm() == 0);
        }
        QVERIFY2(std::abs(up - 1.65) < 1e-9, qPrintable(QString::number(up)));
        QVERIFY2(down < 3, qPrintable(QString::number(down)));
        // Flutes that end below the top of the wall: what a shank would come to from beside may stand.
        tool.flute_length = 6;
        context.tool = tool;
        for (const Motion& motion : link_three_axis(path, context, 0, near_options(0.1), Progress()).motions)
            if (motion.kind == MotionKind::approach) down = std::abs(motion.to.tip.x() - x);
        QVERIFY(down < 1e-9);
    }

    /// Roughing along a wall, as near as it may cut and nearer than links keep: out of it in a rapid as well,
    /// from half the cutter's radius on, but beside a slim shank not through what stands above the flutes.
    void roughing_comes_up_a_wall_in_a_rapid() {
        for (const bool slim : {false, true}) {
            Tool tool = flat_tool(6);
            tool.flute_length = 4;
            tool.shank_diameter = slim ? 4 : 6;
            tool.shank_length = 30;
            PlanContext context = context_of(step(0, 12), tool);
            context.stock.box = context.stock_box = context.part_box;
            StrategyResult path;
            path.chord_tolerance = 0.01;
            RoughPath rough;
            rough.stock_cell = 0.3;
            path.detail = rough;
            // The second pass is on the other side of the wall's top.
            path.passes = {pass({Vec3(-25, 3, 0), Vec3(10, 3, 0)}),
                           pass({Vec3(-10, -10, 12), Vec3(0, -10, 12)})};
            const ToolMotions all = link_rough(path, context, 0, near_options(0), Progress());
            const auto out = std::ranges::find(all.motions, MotionKind::retract, &Motion::kind);
            QVERIFY(out != all.motions.end());
            const double up = out->to.tip.z();
            QVERIFY2(slim ? up >= 12 : up == 1.5, qPrintable(QString::number(up)));
        }
    }

    /// Nor through stock that no pass has cut above the flutes, where the part itself lies low.
    void roughing_comes_up_beside_stock_at_feed() {
        Tool tool = flat_tool(6);
        tool.flute_length = 4;
        tool.shank_diameter = 4;
        tool.shank_length = 30;
        PlanContext context = context_of(box(Vec3(-30, -20, -5), Vec3(30, 20, 0)), tool);
        context.stock_box = context.part_box;
        context.stock_box.hi.z() = 12;
        context.stock.box = context.stock_box;
        StrategyResult path;
        path.chord_tolerance = 0.01;
        RoughPath rough;
        rough.stock_cell = 0.3;
        path.detail = rough;
        path.passes = {pass({Vec3(-35, 3, 1), Vec3(10, 3, 1)})};
        const ToolMotions all = link_rough(path, context, 0, near_options(0), Progress());
        const auto out = std::ranges::find(all.motions, MotionKind::retract, &Motion::kind);
        QVERIFY(out != all.motions.end());
        QVERIFY2(out->to.tip.z() >= 12, qPrintable(QString::number(out->to.tip.z())));
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
        QVERIFY2(kinds_of(m).find("cl") != std::string::npos && !travels_fast(m), kinds_of(m).c_str());
        path.passes[1].cc.front().point.y() = path.passes[1].cl.front().tip.y() = 15;
        QVERIFY(travels_fast(link_five_axis(path, context, {}, near_options(2), Progress())));
    }

    /// Rapids above or round part and stock: no body of the tool comes nearer to them than the clearance, and
    /// the tips stay near the part however far the axes lean.
    void rapids_stay_near_the_part_and_clear_of_it() {
        std::mt19937 random(6);
        std::uniform_real_distribution<double> share(-1, 1);
        Tool tool = flat_tool(10);
        tool.holder = {{40, 50}};
        EnvelopeInput in;
        in.part = {Vec3(-60, -50, 0), Vec3(60, 50, 80)};
        in.stock = {Vec3(-62, -52, 0), Vec3(62, 52, 85)};
        in.tool = &tool;
        in.cutter_radius = 5;
        in.highest_tip = 80;
        in.lowest_axis_z = 0.15;
        in.clearance = 4;
        const Envelope envelope(in);
        std::vector<std::pair<double, double>> bodies{{5, 0}, {5, tool.flute_length}}; // radius, height
        double height = tool.flute_length + tool.shank_length;
        bodies.push_back({0.5 * tool.shank_diameter, height});
        bodies.push_back({20, height});
        bodies.push_back({20, height + 50});
        const auto location = [&] {
            Vec3 axis;
            do
                axis = Vec3(share(random), share(random), std::abs(share(random))).normalized();
            while (axis.z() < 0.15);
            return CutterLocation{Vec3(60 * share(random), 50 * share(random), 40 + 40 * share(random)),
                                  axis};
        };
        for (int round = 0; round < trials(400); ++round) {
            const CutterLocation from = location(), to = location();
            const auto route = envelope.route(from, to);
            QVERIFY((route.front().tip - from.tip).cross(from.axis).norm() < 1e-9);
            QVERIFY((route.back().tip - to.tip).cross(to.axis).norm() < 1e-9);
            QVERIFY(route.front().axis == from.axis && route.back().axis == to.axis);
            for (std::size_t i = 1; i < route.size(); ++i) {
                QVERIFY(route[i].axis.dot(route[i - 1].axis) > std::cos(radians(5.001)));
                QVERIFY(route[i].tip.norm() < 330);
                for (int k = 0; k <= 6; ++k) {
                    const CutterLocation at = location_on_route(route[i - 1], route[i], k / 6.0);
                    const Vec3 x = at.axis.unitOrthogonal(), y = at.axis.cross(x);
                    for (const auto& [radius, up] : bodies)
                        for (int turn = 0; turn < 24; ++turn) {
                            const double a = 2 * pi * turn / 24;
                            const Vec3 p =
                                at.tip + up * at.axis + radius * (std::cos(a) * x + std::sin(a) * y);
                            const double away = (p - p.cwiseMax(in.stock.lo).cwiseMin(in.stock.hi)).norm();
                            QVERIFY2(away > 4 - 1e-6, qPrintable(QString::number(away)));
                        }
                }
            }
        }
    }

    /// Where only one of the two surfaces is within the machine's travel rapids stay on it.
    void rapids_take_what_the_machine_reaches() {
        const Tool tool = ball_tool(6);
        EnvelopeInput in;
        in.part = in.stock = {Vec3(-20, -20, 0), Vec3(20, 20, 10)};
        in.tool = &tool;
        in.cutter_radius = 3;
        in.highest_tip = 10;
        in.clearance = 5;
        const CutterLocation from{Vec3(-15, 0, 5), Vec3(-0.1, 0, 1).normalized()},
            to{Vec3(15, 0, 5), Vec3(0.1, 0, 1).normalized()};
        const Envelope anywhere(in);
        const auto highest = [&](const std::vector<CutterLocation>& route) {
            double z = 0;
            for (const CutterLocation& c : route)
                z = std::max(z, c.tip.z());
            return z;
        };
        QCOMPARE(highest(anywhere.route(from, to)), anywhere.level());
        in.reachable = [&](const CutterLocation& c) { return c.tip.z() > anywhere.level() + 1; };
        const Envelope above(in);
        QVERIFY(highest(above.route(from, to)) > anywhere.level() + 1);
        QVERIFY(above.out(from).tip.z() > anywhere.level() + 1);
        in.reachable = [](const CutterLocation&) { return false; };
        QCOMPARE(highest(Envelope(in).route(from, to)), anywhere.level());
    }

    /// Against points all over the stock: never less than they ask for, and no more than they would with
    /// bodies wider by what a cell may be off.
    void a_tilted_tool_is_lifted_out_of_what_stands() {
        PlanContext context = context_of(level(), ball_tool(6));
        context.stock_box.hi.z() = 12;
        auto slot = std::make_shared<EarlierCuts>();
        slot->cutter = AptCutter::flat(16, 40);
        slot->motions = {{Vec3(-30, 0, 4), Vec3(30, 0, 4)}};
        context.earlier = {slot};
        Tool tool = ball_tool(6);
        tool.flute_length = 10;
        tool.shank_diameter = 5;
        tool.shank_length = 8;
        tool.holder = {{20, 30}};
        const double cell = 0.5, gap = 0.4, spacing = 0.5;
        const TiltedStock stock(stock_before(context, cell, Progress()), tool, 3, gap);
        std::vector<Vec3> points;
        for (double x = -20; x <= 20; x += spacing)
            for (double y = -15; y <= 15; y += spacing)
                for (double z = 0; z <= (std::abs(y) < 8 ? 4 : 12); z += spacing)
                    points.emplace_back(x, y, z);
        using Bodies = std::vector<std::pair<double, double>>; // radius, height
        const Bodies above{{3, 10}, {2.5, 10}, {10, 18}};
        Bodies whole = above, ball = above; // with the end in steps, and in steps that are within it
        for (const AxisCylinder& c : outer_cylinders(tool, cell))
            whole.emplace_back(c.radius, c.low);
        for (const double radius : {0.5, 1.0, 1.5, 2.0, 2.5, 2.8, 3.0})
            ball.emplace_back(radius, 3 - std::sqrt(9 - radius * radius));
        const auto lift_of = [&](const CutterLocation& at, const Bodies& bodies, double wider) {
            double lift = -infinity;
            for (const Vec3& p : points) {
                const double along = (p - at.tip).dot(at.axis), away = (p - at.tip).cross(at.axis).norm();
                for (const auto& [radius, height] : bodies)
                    if (away <= radius + wider) lift = std::max(lift, along - height);
            }
            return lift;
        };
        std::mt19937 random(3);
        std::uniform_real_distribution<double> share(-1, 1);
        int free = 0, not_free = 0;
        for (int round = 0; round < trials(60, 2); ++round) {
            Vec3 axis;
            do
                axis = Vec3(share(random), share(random), std::abs(share(random))).normalized();
            while (axis.z() < 0.15);
            const CutterLocation at{Vec3(24 * share(random), 18 * share(random), 6 + 8 * share(random)),
                                    axis};
            const double lift = stock.lift(at, 2) - 2;
            QVERIFY(lift >= lift_of(at, ball, 0) - 1e-9);
            QVERIFY(lift >= lift_of(at, whole, gap - 0.01) - 1e-9);
            QVERIFY(lift <= lift_of(at, whole, gap + 2 * cell + spacing) + cell + spacing);
            const bool is_free = stock.free_behind(at);
            if (is_free) QVERIFY(lift_of(at, above, 0) <= 0);
            if (!is_free) QVERIFY(lift_of(at, above, 2 * cell + spacing) > -cell - spacing);
            (is_free ? free : not_free) += 1;
            // What surely holds stock does, by points that may lie beside it; what holds much of it is seen.
            if (stock.holds_shank(at)) QVERIFY(lift_of(at, above, spacing) > -spacing);
            if (lift_of(at, above, -2 * cell) > 3 * cell) QVERIFY(stock.holds_shank(at));
        }
        QVERIFY(free > trials(5, 2) && not_free > trials(5, 2));
    }

    /// Flutes of 10 mm, 5 mm over the floor of a block: a shank comes into 30 mm of stock, not into 8, nor
    /// where a slot was cut before, and that is said.
    void shanks_in_stock_are_told() {
        PlanContext context = context_of(level(), ball_tool(6));
        context.tool.flute_length = 10;
        context.tool.shank_diameter = 6;
        context.tool.shank_length = 30;
        ToolMotions motions;
        const Vec3 axis = Vec3(0, 0.2, 1).normalized();
        motions.motions = {{MotionKind::rapid, {Vec3(-30, 0, 5), axis}, no_index, no_index},
                           {MotionKind::cut, {Vec3(-15, 0, 5), axis}, 0, 0}};
        for (int i = 1; i <= 30; ++i)
            motions.motions.push_back({MotionKind::cut, {Vec3(-15 + i, 0, 5), axis}, 0, Index(i)});
        const auto touched = [&](double top) {
            context.stock_box.hi.z() = top;
            return shank_in_stock(motions, context, Progress());
        };
        QVERIFY(touched(30).length > 0.9 * 30);
        QCOMPARE(touched(30).whole, 45.0);
        QVERIFY(!shank_in_stock_warning(touched(30), context).empty());
        QCOMPARE(touched(8).length, 0.0);
        QVERIFY(shank_in_stock_warning(touched(8), context).empty());
        auto slot = std::make_shared<EarlierCuts>();
        slot->cutter = AptCutter::flat(20, 40);
        slot->motions = {{Vec3(-40, 4, 4), Vec3(40, 4, 4)}};
        context.earlier = {slot};
        QCOMPARE(touched(30).length, 0.0);
    }

    /// Beside a wall that it has cut a cutter goes out in a rapid, an undercut one would cut what hangs
    /// over it.
    void beside_the_neck_of_an_undercut_cutter_something_stands() {
        PlanContext context = context_of(level(), ball_tool(6));
        context.stock_box.hi.z() = 12;
        auto slot = std::make_shared<EarlierCuts>();
        slot->cutter = AptCutter::flat(16, 40);
        slot->motions = {{Vec3(-30, 0, 4), Vec3(30, 0, 4)}};
        context.earlier = {slot};
        Tool straight = flat_tool(6);
        straight.flute_length = 10;
        Tool undercut = straight;
        undercut.taper_angle = -radians(5);
        const auto is_free = [&](const Tool& tool, double y) {
            return TiltedStock(stock_before(context, 0.5, Progress()), tool, 3, 0.4)
                .free_behind({Vec3(0, y, 4.5), Vec3::UnitZ()});
        };
        for (const double y : {0.0, 6.5})
            QVERIFY(is_free(straight, y));
        QVERIFY(is_free(undercut, 0));
        QVERIFY(!is_free(undercut, 6.5));
    }

    /// In a block that nobody roughed the tool goes in at feed once, and from then on through what it has
    /// cut.
    void a_tilted_tool_goes_in_where_it_has_cut() {
        PlanContext context = context_of(level(), ball_tool(6));
        context.stock_box.hi.z() = 40;
        const Vec3 axis = Vec3(0, 0.3, 1).normalized();
        StrategyResult path;
        for (const double y : {-3.0, 0.0}) {
            Pass p;
            for (const double x : {-15.0, -14.0, 0.0, 15.0}) {
                p.cc.push_back({Vec3(x, y, 0), Vec3::UnitZ()});
                p.cl.push_back({Vec3(x, y, 3) - 3 * axis, axis});
            }
            path.passes.push_back(std::move(p));
        }
        const auto linked = [&] { return link_five_axis(path, context, {}, near_options(2), Progress()); };
        const auto slow = [](const ToolMotions& m, MotionKind kind, Index first_pass) {
            double length = 0;
            bool counts = first_pass == 0;
            for (std::size_t i = 1; i < m.motions.size(); ++i) {
                const double far = (m.motions[i].to.tip - m.motions[i - 1].to.tip).norm();
                if (counts && m.motions[i].kind == kind) length += far;
                const Index of_pass = m.motions[i].pass;
                counts = counts || (of_pass != no_index && of_pass >= first_pass - 1);
            }
            return length;
        };
        const ToolMotions own = linked();
        QVERIFY2(travels_fast(own), kinds_of(own).c_str());
        QVERIFY(slow(own, MotionKind::approach, 0) - slow(own, MotionKind::approach, 1) > 35);
        // No farther from what stands than half the cutter's radius, though the clearance is 5.
        QVERIFY(slow(own, MotionKind::approach, 1) < 5);
        QVERIFY(slow(own, MotionKind::retract, 0) < 3.1); // twice off the part
        // Rapids within the stock run in and out along the axis of a location that was cut.
        for (std::size_t i = 1; i < own.motions.size(); ++i) {
            if (own.motions[i].kind != MotionKind::rapid) continue;
            const CutterLocation &a = own.motions[i - 1].to, &b = own.motions[i].to;
            if (std::min(a.tip.z(), b.tip.z()) > 40) continue;
            const Vec3 low = a.tip.z() < b.tip.z() ? a.tip : b.tip;
            QVERIFY(a.axis == b.axis && (b.tip - a.tip).cross(a.axis).norm() < 1e-9);
            bool along = false;
            for (const Pass& p : path.passes)
                for (const CutterLocation& c : p.cl)
                    along = along || (low - c.tip - 1.5 * c.axis).norm() < 1e-9;
            QVERIFY(along);
        }
        // Flutes that end within the stock: their shank was never free there.
        context.tool.flute_length = 20;
        const ToolMotions deep = linked();
        QVERIFY(slow(deep, MotionKind::retract, 0) > 35 || kinds_of(deep).find("cl") != std::string::npos);
        for (std::size_t i = 1; i < deep.motions.size(); ++i)
            if (deep.motions[i].kind == MotionKind::rapid)
                QVERIFY(std::min(deep.motions[i].to.tip.z(), deep.motions[i - 1].to.tip.z()) > 40);
        // What was roughed stands no more.
        auto roughed = std::make_shared<EarlierCuts>();
        roughed->cutter = AptCutter::flat(20, 60);
        for (double y = -20; y <= 80; y += 5)
            roughed->motions.push_back({Vec3(-40, y, 4), Vec3(40, y, 4)});
        context.earlier = {roughed};
        QVERIFY(slow(linked(), MotionKind::approach, 0) < 25);
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
        const auto goes_up = [&](const StrategyResult& passes) { return travels_fast(linked(passes)); };
        // Hardly any way up: up.
        QVERIFY(goes_up(path(0, 20, radians(20))));
        context.stock_box.hi.z() = 40;
        QVERIFY(goes_up(path(-20, 80, radians(20)))); // far
        QVERIFY(goes_up(path(0, 20, radians(60))));   // the axes would turn far
        const ToolMotions over = linked(path(0, 20, radians(20)));
        QVERIFY2(!travels_fast(over), kinds_of(over).c_str());
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
            const Vec3 axis(0, std::sin(0.05), std::cos(0.05));
            for (const double y : {-2.0, 2.0}) {
                p.cc.push_back({Vec3(x, y, 0), Vec3::UnitZ()});
                p.cl.push_back({Vec3(x, y, 0.5) - 0.5 * axis, axis});
            }
            path.passes.push_back(std::move(p));
        }
        const ToolMotions over = link_five_axis(path, context, {}, near_options(2), Progress());
        QVERIFY2(!travels_fast(over), kinds_of(over).c_str());
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
