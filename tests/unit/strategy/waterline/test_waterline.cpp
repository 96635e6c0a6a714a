// Waterline finishing against what is known of a part, and against a naive check: points of the part asked
// one by one whether they lie inside the cutter anywhere on the path, and whether it came near enough to
// them.
#include "core/strategy/waterline/level_order.h"
#include "core/strategy/waterline/slope_steps.h"
#include "core/strategy/waterline/waterline.h"
#include "tests/property/shapes.h"
#include "tests/support/any_threads.h"
#include "tests/support/cancel_at.h"
#include "tests/support/error_code.h"
#include "tests/support/naive_finish.h"
#include "tests/support/test_runner.h"
#include "tests/support/trials.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <set>

using namespace facetmill;
using namespace facetmill::test;

namespace {

/// A block with a pocket in it, an island in the pocket, and sloping sides all over: wide below.
Mesh pocket_with_island() {
    const auto height = [](double x, double y) {
        const double r = std::hypot(x, y), outside = std::max(std::abs(x) / 20, std::abs(y) / 15);
        const double pocket = std::clamp((r - 9) * 1.5, 0.0, 6.0), island = std::clamp((4 - r) * 2, 0.0, 4.0);
        return std::max(pocket, island) + 0 * outside;
    };
    return height_field(height, Vec2(-20, -15), Vec2(20, 15), trials(160, 2), trials(120, 2));
}

WaterlineSettings settings_with(double tolerance) {
    WaterlineSettings s;
    s.tolerance = tolerance;
    return s;
}

StrategyResult planned_on(const Mesh& mesh, const WaterlineSettings& settings, const Tool& tool) {
    return Waterline(settings).plan(context_of(mesh, tool), Progress());
}

} // namespace

class TestWaterline : public QObject {
    Q_OBJECT
private slots:
    void it_is_described() {
        const auto op = make_operation("waterline");
        std::set<std::string> keys;
        for (const ParameterInfo* p : op->parameters()) {
            keys.insert(p->key);
            QVERIFY2(!p->label.empty() && !p->help.empty(), p->key.c_str());
            QVERIFY2(op->get(p->key) == p->default_value, p->key.c_str());
        }
        for (const char* key : {"tolerance", "stepdown", "max_stepdown", "slope_limits", "boundary", "avoid"})
            QVERIFY2(keys.count(key) == 1, key);
        QVERIFY(op->three_axis() && op->reads_stock() && op->linking() == Linking::upright);
        QCOMPARE(code_of([&] { op->set("stepdown", 0.0); }), std::string("out_of_range"));
        QCOMPARE(code_of([&] {
                     op->set("slope_limits", std::array{0.5, 2.0});
                 }),
                 std::string("out_of_range"));
    }

    /// A ball leaves r - sqrt(r^2 - d^2/4) between places d apart; a flat end a step of the stairs.
    void steps_down_as_the_cutter_and_the_slope_say() {
        constexpr double cusp = 0.05;
        const CutterProfile ball(AptCutter::ball(6, 50)), flat(AptCutter::flat(6, 50));
        const CutterCover round(ball, 0), sharp(flat, 0);
        const SlopeSteps by_ball(round, cusp, 6), by_flat(sharp, cusp, 6);
        const double along = 2 * std::sqrt(2 * 3 * cusp - cusp * cusp);
        // Steeper, the upper place covers the cusp with the shaft above its ball.
        for (double slope = radians(20); slope < radians(78); slope += radians(4)) {
            QVERIFY2(std::abs(by_ball.step(slope, 1) - along * std::sin(slope)) < 2e-3 * along,
                     qPrintable(QString::number(slope)));
            const double stairs = std::min(6.0, cusp / std::cos(slope));
            QVERIFY2(std::abs(by_flat.step(slope, 1) - stairs) < 0.02 * stairs,
                     qPrintable(QString("%1: %2 for %3").arg(slope).arg(by_flat.step(slope, 1)).arg(stairs)));
        }
        // In a fillet of twice the radius two places leave twice as much, rolling over an edge nothing.
        QVERIFY(std::abs(by_ball.step(1, 2) - by_ball.step(1, 1) / std::sqrt(2)) < 0.02 * by_ball.step(1, 1));
        QCOMPARE(by_ball.step(1, 0), 6.0);
        QVERIFY(std::abs(by_ball.cusp(1, 1, by_ball.step(1, 1)) - cusp) < 1e-6);
        QVERIFY(std::abs(by_ball.cusp(1, 1, 0.5 * by_ball.step(1, 1)) - cusp / 4) < 0.05 * cusp);
    }

    /// A contour of a cone is a circle.
    void a_cone_is_cut_in_circles() {
        const double slope = std::atan(1.5);
        const Mesh cone = cone_of(10, 15, 720);
        const Tool tool = ball_tool(6);
        const StrategyResult path = planned_on(cone, settings_with(0.05), tool);
        const double along = 2 * std::sqrt(2 * 3 * 0.0475 - 0.0475 * 0.0475), step = along * std::sin(slope);
        QVERIFY(path.drive_planes >= int(15 / step) && path.drive_planes < int(15 / step) + 6);
        std::size_t circles = 0;
        for (const Pass& pass : path.passes) {
            const double z = pass.cl.front().tip.z();
            // The ball's middle is its radius away from the flank.
            const double radius = (15 - (z + 3)) / 1.5 + 3 / std::sin(slope);
            for (const CutterLocation& c : pass.cl) {
                QCOMPARE(c.tip.z(), z);
                if (z < 0.5 || z > 11) continue; // beside tip and foot
                QVERIFY2(std::abs(c.tip.head<2>().norm() - radius) < 1.5 * path.chord_tolerance,
                         qPrintable(QString("%1 for %2").arg(c.tip.head<2>().norm()).arg(radius)));
            }
            circles += is_closed(pass);
        }
        QVERIFY2(circles + 2 >= path.passes.size(), qPrintable(QString::number(circles)));
        // Steps are chosen by eighths of an octave, and bins of heights take a little more.
        QVERIFY(path.stepover_max < 1.05 * step && path.stepover_max > 0.88 * step);
    }

    void nothing_is_gouged_and_what_is_steep_is_cut_data() {
        QTest::addColumn<int>("part");
        QTest::addColumn<int>("tool");
        const char* parts[] = {"island", "cone", "dome", "mixed"};
        for (int p = 0; p < 4; ++p)
            for (int t = 0; t < 3; ++t)
                if (!under_sanitizer || (p + t) % 3 == 0) // every part and every cutter
                    QTest::addRow("%s %s", parts[p], tools_of_every_shape()[std::size_t(t)].name) << p << t;
    }
    void nothing_is_gouged_and_what_is_steep_is_cut() {
        QFETCH(int, part);
        QFETCH(int, tool);
        const Mesh mesh = part == 0   ? pocket_with_island()
                          : part == 1 ? cone_of(10, 15, 90)
                          : part == 2 ? dome(12, 24)
                                      : mixed();
        const Tool cutter = tools_of_every_shape()[std::size_t(tool)].tool;
        const WaterlineSettings settings = settings_with(0.1);
        const StrategyResult path = planned_on(mesh, settings, cutter);
        QVERIFY(path.passes.size() > 3);
        const BruteCutter brute(cutter.cutter());
        const double radius = double(brute.radius());
        const auto steep = [&](const PartSample& s) {
            const double slope = std::acos(std::clamp(s.normal.z(), -1.0, 1.0));
            if (slope < radians(32) || slope > radians(86)) return false;
            if (part == 3) return false; // what can be reached is not known by heart
            // Feet stand on a floor: a ball leaves its fillet there, a flat end comes as near as its chord.
            const double foot = part == 0 ? 0.5 : 0.3 + double(brute.height(radius));
            if (s.p.z() < foot + radius) return false;
            return part != 0 || s.p.z() < 5.5;
        };
        const Naive naive = naive_check(mesh, path, cutter, settings.tolerance, steep);
        QCOMPARE(naive.gouged, std::size_t(0));
        if (part == 1 || part == 2) {
            QVERIFY(naive.judged > 100);
            QVERIFY2(double(naive.high) <= 0.005 * double(naive.judged),
                     qPrintable(QString("%1 of %2").arg(naive.high).arg(naive.judged)));
        }
    }

    /// The part stays on the right of closed passes, of islands and hollows alike, and one way of all.
    void passes_go_round_islands_and_hollows() {
        WaterlineSettings s = settings_with(0.1);
        s.pattern = WaterlineSettings::Pattern::oneway;
        const StrategyResult path = planned_on(pocket_with_island(), s, ball_tool(3));
        int clockwise = 0, counter = 0;
        for (const Pass& pass : path.passes) {
            if (!is_closed(pass) || pass.cl.front().tip.z() > 3) continue;
            double area = 0;
            for (std::size_t i = 1; i < pass.cl.size(); ++i) {
                const Vec3 &a = pass.cl[i - 1].tip, &b = pass.cl[i].tip;
                area += 0.5 * (a.x() * b.y() - a.y() * b.x());
            }
            ++(area > 0 ? counter : clockwise);
        }
        QVERIFY2(clockwise > 3 && counter > 3, qPrintable(QString("%1, %2").arg(clockwise).arg(counter)));
    }

    /// Upright walls are as far apart as is allowed for a flat end, down to the floor.
    void a_wall_is_cut_down_to_its_foot() {
        WaterlineSettings s = settings_with(0.1);
        const StrategyResult path = planned_on(step(0, 5), s, flat_tool(6));
        double lowest = infinity;
        for (const Pass& pass : path.passes)
            for (const CutterLocation& c : pass.cl) {
                lowest = std::min(lowest, c.tip.z());
                if (std::abs(c.tip.x()) > 19) continue; // a little round the end of the wall
                QVERIFY(c.tip.y() >= 3 - 1e-9 && c.tip.y() < 3 + 0.02);
            }
        QVERIFY2(lowest >= 0 && lowest <= path.chord_tolerance, qPrintable(QString::number(lowest)));
        s.max_stepdown = {1.0, ""};
        const StrategyResult finer = planned_on(step(0, 5), s, flat_tool(6));
        QVERIFY(finer.drive_planes >= 5 && finer.stepover_max <= 1 + 1e-6);
    }

    void a_constant_step_is_kept() {
        WaterlineSettings s = settings_with(0.02);
        s.stepdown = {1.0, ""};
        const StrategyResult path = planned_on(cone_of(10, 15, 90), s, ball_tool(6));
        for (const Pass& pass : path.passes)
            QCOMPARE(pass.cl.front().tip.z(), pass.cl.back().tip.z());
        QVERIFY(std::abs(path.stepover_max - 1) < 1e-9);
        QVERIFY(path.cusp_max > 0.02);
        const auto told = [&](const std::string& words) {
            return std::any_of(path.warnings.begin(), path.warnings.end(),
                               [&](const std::string& w) { return w.find(words) != std::string::npos; });
        };
        QVERIFY(told("step-down"));
    }

    void what_cannot_be_is_refused() {
        const Mesh level = height_field([](double, double) { return 3.0; }, Vec2(-9, -9), Vec2(9, 9), 4, 3);
        std::string message;
        QCOMPARE(code_of([&] { planned_on(level, settings_with(0.05), ball_tool(6)); }, &message),
                 std::string("empty_result"));
        QVERIFY2(message.find("30 to 90 degrees") != std::string::npos, message.c_str());
        WaterlineSettings narrow = settings_with(0.05);
        narrow.slope_limits = {radians(70), radians(75)};
        QCOMPARE(code_of([&] { planned_on(cone_of(10, 15, 90), narrow, ball_tool(6)); }),
                 std::string("empty_result"));
        narrow.stepdown = {1e-9, ""};
        narrow.slope_limits = {radians(30), radians(90)};
        QCOMPARE(code_of([&] { planned_on(cone_of(10, 15, 90), narrow, ball_tool(6)); }),
                 std::string("limit_exceeded"));
    }

    void threads_change_nothing_and_it_can_be_cancelled() {
        const Mesh mesh = pocket_with_island();
        const WaterlineSettings settings = settings_with(under_sanitizer ? 0.5 : 0.1);
        QVERIFY(same_with_any_threads([&] { return planned_on(mesh, settings, bull_tool(4, 1)); }));
        for (const double at : {0.1, 0.5, 0.8}) {
            Job job;
            const Waterline op(settings);
            QVERIFY(cancelled_at(job, at,
                                 [&](const Progress& p) { op.plan(context_of(mesh, ball_tool(4)), p); }));
        }
    }
};

FACETMILL_TEST(TestWaterline)
#include "test_waterline.moc"
