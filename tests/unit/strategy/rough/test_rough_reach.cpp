// Where the tool of roughing may stand: against closed forms beside walls and blocks, and against the
// brute-force lift on random sheets.
#include "core/strategy/rough/rough_reach.h"
#include "tests/property/shapes.h"
#include "tests/support/brute_lift.h"
#include "tests/support/random_meshes.h"
#include "tests/support/test_runner.h"
#include "tests/support/trials.h"
#include "tests/unit/strategy/rough/polyline_distance.h"

#include <QTest>

using namespace facetmill;
using namespace facetmill::test;

namespace {

constexpr double allowance = 0.3, margin = 0.02;

struct Reach {
    PlanContext context;
    RoughReach reach;

    Reach(const Mesh& mesh, const Tool& tool, double kept_off = margin)
        : context(context_of(mesh, tool)), reach(context.contact, context, allowance, kept_off, 0) {}
};

/// Lowest tip of a ball of diameter d over a mesh grown by what is kept: a larger ball's, as much higher.
double brute_ball(const Mesh& mesh, double d, const Vec2& p, double kept_off = margin) {
    const double kept = allowance + kept_off;
    const BruteCutter larger(AptCutter::ball(d + 2 * kept, unlimited_height));
    return brute_lift(larger, mesh, p.x(), p.y()) + kept;
}

std::shared_ptr<Mesh> random_sheet(Random& rng, std::uint64_t seed) {
    const double a = uniform(rng, 1, 4), b = uniform(rng, 0.2, 0.6), c = uniform(rng, 0.2, 0.6);
    return field(
        10, 24, [=](double x, double y) { return a * std::sin(b * x) * std::cos(c * y); }, 0.3, seed);
}

} // namespace

class TestRoughReach : public QObject {
    Q_OBJECT
private slots:
    void lowest_tips_against_brute_force() {
        Random rng(3);
        for (int trial = 0; trial < trials(6, 3); ++trial) {
            const auto mesh = random_sheet(rng, std::uint64_t(trial + 1));
            const Reach r(*mesh, ball_tool(5));
            RoughReach::Hints hints;
            for (int k = 0; k < 20; ++k) {
                const Vec2 p(uniform(rng, 0, 24), uniform(rng, 0, 24));
                const double exact = brute_ball(*mesh, 5, p), z = r.reach.tip_z(p, hints);
                QVERIFY2(std::abs(z - exact) < 1e-6, qPrintable(QString("%1 %2").arg(z).arg(exact)));
                QVERIFY(r.reach.is_free(p, exact + 1e-5, hints));
                QVERIFY(!r.reach.is_free(p, exact - 1e-5, hints));
                const std::array<Vec2, 1> one{p};
                std::array<double, 1> height{};
                r.reach.tip_z(one, height, Progress());
                QCOMPARE(height[0], z);
            }
        }
    }

    /// What lies between two free places that are `spacing` apart is within the margin, and the allowance is
    /// not touched: with the margin that is used, and with half and double of it.
    void no_place_between_free_ones_is_missed() {
        Random rng(9);
        const auto mesh = random_sheet(rng, 4);
        for (const double kept_off : {0.5 * margin, margin, 2 * margin}) {
            const Reach r(*mesh, ball_tool(5), kept_off);
            RoughReach::Hints hints;
            for (int k = 0; k < trials(15); ++k) {
                const Vec2 a(uniform(rng, 3, 21), uniform(rng, 3, 21));
                const double turn = uniform(rng, 0, 2 * pi);
                const Vec2 b = a + uniform(rng, 0.5, 3) * Vec2(std::cos(turn), std::sin(turn));
                const double z = r.reach.highest(a, b, hints);
                QVERIFY(r.reach.is_free(a, b, z + 1e-9, hints));
                QVERIFY(!r.reach.is_free(a, b, z - 1e-6, hints));
                for (double t = 0; t <= 1; t += 0.125) {
                    const Vec2 p = a + t * (b - a);
                    QVERIFY(brute_ball(*mesh, 5, p, kept_off) <= z + 0.5 * kept_off + 1e-6);
                    QVERIFY(brute_ball(*mesh, 5, p, 0) <= z);
                }
            }
        }
    }

    /// A flat end beside an upright wall stands free a radius and what is kept away from it.
    void the_last_free_place_is_at_the_wall() {
        const Reach r(step(0, 8), flat_tool(6)); // falls at y = 0
        const double wall = 3 + allowance + margin;
        RoughReach::Hints hints;
        Random rng(2);
        for (int k = 0; k < 50; ++k) {
            const Vec2 free(uniform(rng, -10, 10), uniform(rng, 4, 9)),
                blocked(uniform(rng, -10, 10), uniform(rng, -9, 2.5));
            const double z = uniform(rng, 1, 7);
            const double t = r.reach.last_free(free, r.reach.tip_z(free, hints), blocked,
                                               r.reach.tip_z(blocked, hints), z, hints);
            const double exact = (free.y() - wall) / (free.y() - blocked.y()),
                         length = (free - blocked).norm();
            QVERIFY(t <= exact + 1e-9);
            QVERIFY2((exact - t) * length <= 0.25 * margin + 1e-9, qPrintable(QString::number(exact - t)));
        }
    }

    /// A holder over a wall lifts the tip as much as it lacks.
    void bodies_hold_the_tip_up() {
        Tool tool = flat_tool(4);
        tool.flute_length = 5;
        tool.shank_diameter = 0;
        tool.shank_length = 0;
        tool.holder = {{20, 30}};
        const Reach r(step(0, 8), tool);
        RoughReach::Hints hints;
        QVERIFY(r.reach.has_bodies());
        // The wall of height 8 is nearer than the holder's radius, and farther than the cutter's.
        const double kept = allowance + margin;
        QVERIFY(std::abs(r.reach.tip_z(Vec2(0, 7), hints) - (8 + kept - 5)) < 1e-9);
        QVERIFY(std::abs(r.reach.tip_z(Vec2(0, 12), hints) - kept) < 1e-9);
        QVERIFY(std::abs(r.reach.cutter().tip_z(0, 7) - kept) < 1e-9);
        QVERIFY(!r.reach.is_free(Vec2(0, 7), 2, hints) && r.reach.is_free(Vec2(0, 7), 4, hints));
        const ReachGrid grid(r.reach, DriveFrame(0), Vec2(-2, 6), Vec2(2, 8), Progress());
        QCOMPARE(grid.held_up().size(), grid.columns() * grid.rows());
        for (const ReachGrid::HeldUp& h : grid.held_up())
            QVERIFY(std::abs(h.cutter - kept) < 1e-9 && std::abs(h.tool - (3 + kept)) < 1e-9);
        // Each at its own place.
        for (std::size_t i = 1; i < grid.held_up().size(); ++i) {
            const Vec2 &before = grid.held_up()[i - 1].place, &here = grid.held_up()[i].place;
            QVERIFY(here.y() > before.y() || (here.y() == before.y() && here.x() > before.x()));
        }
    }

    /// So does a shank that is wider than the cutter.
    void a_wide_shank_holds_the_tip_up() {
        Tool tool = flat_tool(4);
        tool.flute_length = 5;
        tool.shank_diameter = 12;
        tool.shank_length = 10;
        const Reach r(step(0, 8), tool);
        RoughReach::Hints hints;
        const double kept = allowance + margin;
        QVERIFY(r.reach.has_bodies());
        QVERIFY(std::abs(r.reach.tip_z(Vec2(0, 5), hints) - (8 + kept - 5)) < 1e-9);
        QVERIFY(std::abs(r.reach.tip_z(Vec2(0, 7), hints) - kept) < 1e-9);
        // Where even the lowest tip is high enough there is nothing to hold it up.
        tool.flute_length = 9;
        QVERIFY(!Reach(step(0, 8), tool).reach.has_bodies());
    }

    /// Over a saddle four quarters meet, and cells there are free at two opposite corners: what is blocked
    /// stays joined, and no border ends but at the grid's own.
    void borders_over_a_saddle_are_whole() {
        const Mesh saddle =
            height_field([](double x, double y) { return 0.15 * x * y; }, Vec2(-9, -9), Vec2(9, 9), 36, 36);
        const Reach r(saddle, ball_tool(4));
        RoughReach::Hints hints;
        Random rng(12);
        std::size_t borders = 0;
        for (int k = 0; k < trials(40, 10); ++k) {
            const Vec2 lo(uniform(rng, -5, -4), uniform(rng, -5, -4)), hi(5, 5);
            const ReachGrid grid(r.reach, DriveFrame(0), lo, hi, Progress());
            const double z = r.reach.tip_z(Vec2(uniform(rng, -0.05, 0.05), uniform(rng, -0.05, 0.05)), hints);
            for (const FreeContour& c : grid.contours(z, Progress())) {
                ++borders;
                if (c.closed) continue;
                for (const Vec2& end : {c.points.front(), c.points.back()}) {
                    const double inside = std::min((end - lo).minCoeff(), (hi - end).minCoeff());
                    QVERIFY2(inside < 1e-9, qPrintable(QString::number(inside)));
                }
            }
        }
        QVERIFY(borders >= trials(std::size_t(40)));
    }

    /// Round a block the border of what is free is the block grown by the radius and what is kept.
    void the_border_round_a_block_is_as_long_as_it_should_be() {
        const Reach r(box(Vec3(-4, -3, 0), Vec3(4, 3, 6)), flat_tool(5));
        const ReachGrid grid(r.reach, DriveFrame(0.3), Vec2(-12, -12), Vec2(12, 12), Progress());
        const auto contours = grid.contours(2, Progress());
        QCOMPARE(contours.size(), std::size_t(1));
        QVERIFY(contours.front().closed);
        const double rho = 2.5 + allowance + margin, exact = 2 * (8 + 6) + 2 * pi * rho;
        QVERIFY2(std::abs(contours.front().length() - exact) < 0.01 * exact,
                 qPrintable(QString("%1 of %2").arg(contours.front().length()).arg(exact)));
        RoughReach::Hints hints;
        double area = 0;
        const auto& points = contours.front().points;
        for (std::size_t i = 1; i < points.size(); ++i) {
            QVERIFY(r.reach.is_free(points[i], 2, hints));
            area += 0.5 * (points[i - 1].x() * points[i].y() - points[i - 1].y() * points[i].x());
        }
        // The free side is on the left: the block, which is not free, is passed clockwise.
        const double inside = 8 * 6 + 2 * (8 + 6) * rho + pi * rho * rho;
        QVERIFY2(area < 0 && std::abs(area + inside) < 0.01 * inside, qPrintable(QString::number(area)));
        QVERIFY(grid.contours(7, Progress()).empty()); // above it all is free
    }

    void free_ranges_of_a_line_against_brute_force() {
        Random rng(21);
        int free = 0, blocked = 0;
        for (int trial = 0; trial < trials(6, 3); ++trial) {
            const auto mesh = random_sheet(rng, std::uint64_t(trial + 30));
            const Reach r(*mesh, ball_tool(4));
            const DriveFrame frame(uniform(rng, -0.3, 0.3));
            const double v = uniform(rng, 8, 14), z = uniform(rng, 0, 3);
            const ReachLine line(r.reach, frame, v, 2, 20);
            RoughReach::Hints hints;
            const auto ranges = line.free(z, hints);
            for (std::size_t i = 0; i < ranges.size(); ++i) {
                QVERIFY(ranges[i].lo <= ranges[i].hi);
                if (i > 0) QVERIFY(ranges[i].lo > ranges[i - 1].hi);
            }
            for (double u = 2.02; u < 20; u += 0.31) {
                const bool in = std::any_of(ranges.begin(), ranges.end(), [&](const Interval& i) {
                    return u >= i.lo - 1e-9 && u <= i.hi + 1e-9;
                });
                const double exact = brute_ball(*mesh, 4, frame.xy(u, v));
                // Between places that were looked at the lift may rise by half of the margin.
                if (in) QVERIFY(exact <= z + 0.5 * margin + 1e-6);
                // Surely free: so are the places about it.
                bool surely = true;
                for (const double d : {-0.3 * margin, 0.0, 0.3 * margin})
                    surely = surely && brute_ball(*mesh, 4, frame.xy(u + d, v)) < z - 0.5 * margin;
                if (surely) QVERIFY2(in, qPrintable(QString("%1 at z %2").arg(u).arg(z)));
                ++(in ? free : blocked);
            }
        }
        QVERIFY2(free > trials(50) && blocked > trials(50),
                 qPrintable(QString("%1 %2").arg(free).arg(blocked)));
    }

    void thinned_routes_pass_what_they_leave_out() {
        Random rng(8);
        for (int trial = 0; trial < 50; ++trial) {
            std::vector<Vec2> route{Vec2(0, 0)};
            for (int k = 0; k < 60; ++k)
                route.push_back(route.back() + Vec2(uniform(rng, 0, 1), uniform(rng, -0.2, 0.2)));
            const double beside = uniform(rng, 0.05, 0.4);
            const auto thin = thinned_route(route, beside);
            QVERIFY(thin.size() < route.size());
            QCOMPARE(thin.front(), route.front());
            QCOMPARE(thin.back(), route.back());
            for (const Vec2& p : route)
                QVERIFY(distance_to(thin, p) <= beside + 1e-12);
        }
        // A spur there and back is no part of a straight line, ahead or behind.
        for (const double spur : {-3.0, 3.0, 13.0})
            QVERIFY(
                distance_to(thinned_route(std::vector<Vec2>{{0, 0}, {spur, 0}, {10, 0}}, 0.5), Vec2(spur, 0))
                < 0.5 + 1e-12);
        const std::vector<Vec3> straight{{0, 0, 0}, {1, 0, 0.5}, {2, 0, 1}, {3, 1, 1}};
        QCOMPARE(thinned_route(straight, 1e-9).size(), std::size_t(3));
    }
};

FACETMILL_TEST(TestRoughReach)
#include "test_rough_reach.moc"
