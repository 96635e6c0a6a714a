// The lathe-mill's lift against exact answers and Jasra's three checks, put right; frame, lines, side feed
// and way.
#include "core/mesh/sample.h"
#include "core/strategy/lathe/lathe_field.h"
#include "core/strategy/lathe/lathe_finish.h"
#include "core/strategy/lathe/lathe_route.h"
#include "tests/property/shapes.h"
#include "tests/support/error_code.h"
#include "tests/support/test_runner.h"

#include <QTest>

#include <cmath>
#include <optional>
#include <random>

using namespace facetmill;
using namespace facetmill::test;

namespace {

/// Jasra's points a turn.
constexpr int a_turn = 3620;

/// Tip of a ball of radius r, coming in at `angle` towards the middle of a prism with `sides` sides (side 0
/// faces angle `first`) of inscribed radius h: it touches a side, or the edge between two.
double on_prism(int sides, double h, double r, double first, double angle) {
    const double half = pi / sides;
    const double phi = std::remainder(angle - first, 2 * half); // from the middle of the nearest side
    const double along = (h + r) * std::tan(std::abs(phi));     // where the centre stands over the side
    if (along <= h * std::tan(half)) return (h + r) / std::cos(phi) - r;
    const double corner = h / std::cos(half), off = half - std::abs(phi);
    const double beside = corner * std::sin(off);
    return corner * std::cos(off) + std::sqrt(r * r - beside * beside) - r;
}

/// Largest relative error of the lift over one turn against on_prism.
double largest_error(const LatheField& field, int sides, double h, double r, double first, double y) {
    LatheField::Hint hint;
    double most = 0;
    for (int k = 0; k < a_turn; ++k) {
        const double angle = 2 * pi * k / a_turn, exact = on_prism(sides, h, r, first, angle);
        most = std::max(most, std::abs(field.u({angle, y}, hint) - exact) / exact);
    }
    return most;
}

/// Jasra 3.2.2 for a ball of radius r whose centre moves from `far` along -a: the largest distance along a,
/// from `far` on, at which it touches a triangle; nothing when it misses it.
std::optional<double> three_checks(const Vec3& foot, const Vec3& a, double r, const std::array<Vec3, 3>& p) {
    std::optional<double> most;
    const auto at = [&](double s) {
        if (!most || s > *most) most = s;
    };
    // Triangle, (1): foot + s a = P1 + (P2 - P1) t + (P3 - P1) w + N r, solved for (s, t, w).
    Vec3 n = (p[1] - p[0]).cross(p[2] - p[0]);
    if (n.norm() > 0) {
        n.normalize();
        if (n.dot(a) < 0) n = -n;
        Mat3 m;
        m << a, p[0] - p[1], p[0] - p[2];
        if (std::abs(m.determinant()) > 1e-12) {
            const Vec3 x = m.inverse() * (p[0] + r * n - foot);
            if (x[1] >= 0 && x[2] >= 0 && x[1] + x[2] <= 1) at(x[0]);
        }
    }
    for (std::size_t k = 0; k < 3; ++k) {
        // Edge, (2) put right: the centre is r away from the edge's line; the outer of two solutions.
        const Vec3 &from = p[k], &to = p[(k + 1) % 3], e = (to - from).normalized();
        const Vec3 off = (foot - from) - (foot - from).dot(e) * e, route = a - a.dot(e) * e;
        const double qa = route.squaredNorm(), qb = off.dot(route), qc = off.squaredNorm() - r * r;
        if (qa > 1e-14 && qb * qb >= qa * qc) {
            const double s = (-qb + std::sqrt(qb * qb - qa * qc)) / qa;
            const double on = (foot + s * a - from).dot(e);
            if (on >= 0 && on <= (to - from).norm()) at(s);
        }
        // Vertex, (3).
        const Vec3 v = foot - from;
        const double b = v.dot(a), c = v.squaredNorm() - r * r;
        if (b * b >= c) at(-b + std::sqrt(b * b - c));
    }
    return most;
}

LatheField field_of(const LatheCommon& s, const PlanContext& context) {
    return LatheField(s, context, 0, Progress());
}

} // namespace

class TestLathe : public QObject {
    Q_OBJECT
private slots:
    /// Jasra: 0.0752 %.
    void a_square_prism_is_exact() {
        const auto part = make_sample("square-prism", default_sample_tolerance, Progress());
        const PlanContext context = context_of(*part, ball_tool(12.7));
        const LatheField field = field_of(LatheCommon(), context);
        for (const double y : {0.5, 20.0, 39.0}) {
            const double error = largest_error(field, 4, 25, 6.35, 0, y);
            QVERIFY2(error <= 1e-12, qPrintable(QString::number(error)));
        }
    }

    /// Jasra: 0.007058 % and 0.003398 %. The chord error of the sample's own facets is 0.0508 mm at most;
    /// what the lift adds to it is rounding.
    void a_cylinder_is_exact_but_for_its_facets() {
        const auto part = make_sample("cylinder", default_sample_tolerance, Progress());
        int sides = 0;
        for (const Vec3& v : part->vertices)
            sides += v.x() == 0 && std::hypot(v.y(), v.z()) > 19;
        const double inscribed = 20 * std::cos(pi / sides);
        QVERIFY(20 - inscribed <= default_sample_tolerance);
        for (const double r : {1.5875, 1e-7}) { // the second for Jasra's radius 0
            const PlanContext context = context_of(*part, ball_tool(2 * r));
            const LatheField field = field_of(LatheCommon(), context);
            const double error = largest_error(field, sides, inscribed, r, pi / sides, 12.3);
            QVERIFY2(error <= 1e-10, qPrintable(QString::number(error)));
            // And against the round: the facets' own error, relative to the radius.
            LatheField::Hint hint;
            for (int k = 0; k < a_turn; ++k) {
                const double u = field.u({2 * pi * k / a_turn, 12.3}, hint);
                QVERIFY(u <= 20 + 1e-9 && u >= inscribed - 1e-9);
            }
        }
    }

    /// Any place of a part without symmetry, by all facets one by one.
    void the_three_checks_agree() {
        const auto part = make_sample("twisted-prism", 1.0, Progress());
        const double r = 4;
        const PlanContext context = context_of(*part, ball_tool(2 * r));
        LatheCommon s;
        s.offset = 1.5;
        s.tilt = radians(20);
        for (const bool plain : {true, false}) {
            const LatheField field = field_of(plain ? LatheCommon() : s, context);
            std::mt19937 random(5);
            std::uniform_real_distribution<double> turn(-pi, pi), along(5, 55);
            LatheField::Hint hint;
            for (int i = 0; i < 400; ++i) {
                const LathePlace place{turn(random), along(random)};
                const CutterLocation foot = field.frame().at(place, 0);
                double u = -infinity;
                for (std::size_t f = 0; f < part->facet_count(); ++f)
                    if (const auto found =
                            three_checks(foot.tip + r * foot.axis, foot.axis, r,
                                         {part->corner(f, 0), part->corner(f, 1), part->corner(f, 2)}))
                        u = std::max(u, *found);
                QVERIFY2(std::abs(field.u(place, hint) - u) <= 1e-9,
                         qPrintable(QString("%1 against %2").arg(field.u(place, hint)).arg(u)));
            }
        }
    }

    void the_frame_says_where_the_tool_is() {
        const auto part = make_sample("square-prism", 0.1, Progress());
        PlanContext context = context_of(*part, ball_tool(6));
        LatheCommon s;
        s.offset = 2;
        s.tilt = radians(30);
        for (const auto axis : {LatheCommon::Axis::x, LatheCommon::Axis::points}) {
            s.axis = axis;
            s.axis_from = {0, 1, 2};
            s.axis_to = {40, -3, 4};
            const LatheFrame frame(s, context);
            const Vec3& d = frame.axis().direction;
            for (const double angle : {-1.0, 0.0, 0.4, 3.0}) {
                const CutterLocation c = frame.at({angle, 7}, 30);
                QVERIFY(std::abs(c.axis.norm() - 1) < 1e-15);
                QVERIFY(std::abs(c.axis.dot(d) - 0.5) < 1e-12);
                QVERIFY(std::abs(frame.radial(angle).dot(d)) < 1e-15);
                QVERIFY(std::abs(frame.height(c.tip, angle) - 30) < 1e-12);
                QVERIFY(std::abs(frame.along(c.tip) - (7 + 30 * 0.5)) < 1e-12);
                // Off the centre line by the offset, across the radial plane of the tool.
                const Vec3 off = c.tip - frame.axis().point;
                QVERIFY(std::abs(off.dot(d.cross(frame.radial(angle))) - 2) < 1e-12);
                // Turning the place turns the location about the axis.
                const Eigen::AngleAxisd turn(0.7, d);
                const CutterLocation on = frame.at({angle + 0.7, 7}, 30);
                QVERIFY((on.tip - (frame.axis().point + turn * off)).norm() < 1e-12);
                QVERIFY((on.axis - turn * c.axis).norm() < 1e-14);
            }
        }
        // A part beside the axis of its frame turns about its own middle when asked for.
        Mesh moved = *part;
        for (Vec3& v : moved.vertices)
            v += Vec3(3, 10, -200);
        context = context_of(moved, ball_tool(6));
        s = {};
        std::string said;
        QCOMPARE(code_of([&] { LatheFrame(s, context); }, &said), std::string("out_of_range"));
        QVERIFY2(said.find("axis") == 0 && said.find("beside the part") != std::string::npos, said.c_str());
        s.axis_through = LatheCommon::Through::middle;
        const LatheFrame frame(s, context);
        QCOMPARE(frame.axis().point, Vec3(0, 10, -200));
        const LatheField field = field_of(s, context);
        QVERIFY(largest_error(field, 4, 25, 3, 0, 23) < 1e-12);
    }

    void holes_and_the_axis_are_guarded() {
        // A slot right through the part, wider than the cutter.
        Mesh part = box(Vec3(0, -20, -20), Vec3(10, 20, 20));
        const Mesh other = box(Vec3(30, -20, -20), Vec3(40, 20, 20));
        const auto first = Index(part.vertices.size());
        part.vertices.insert(part.vertices.end(), other.vertices.begin(), other.vertices.end());
        for (const Facet& f : other.facets)
            part.facets.push_back({f[0] + first, f[1] + first, f[2] + first});
        const PlanContext context = context_of(part, ball_tool(6));
        LatheCommon s;
        s.core_radius = 4;
        const LatheField field = field_of(s, context);
        LatheField::Hint hint;
        const LathePoint in_slot = field.point({0.3, 20}, hint);
        QCOMPARE(in_slot.u, 4.0);
        QCOMPARE(in_slot.held, LathePoint::HeldBy::core);
        QCOMPARE(field.point({0, 5}, hint).u, 20.0);
        QCOMPARE(field.point({0, 5}, hint).held, LathePoint::HeldBy::part);
        // Beyond the axis nothing counts: half a part is not felt through the other half's gap.
        const Mesh half = box(Vec3(0, -20, -20), Vec3(40, 20, 0));
        const LatheField above = field_of({}, context_of(half, ball_tool(6)));
        QCOMPARE(above.u({0, 20}, hint), 0.0);
        QCOMPARE(above.u({pi, 20}, hint), 20.0);
    }

    void chuck_and_tailstock_hold_the_tool_off() {
        const auto part = make_sample("square-prism", 0.1, Progress());
        PlanContext context = context_of(*part, ball_tool(6));
        context.stock_box.lo.x() -= 20;
        context.stock_box.hi.x() += 10;
        LatheCommon s;
        s.clearance = 2;
        s.chuck = {15, 120};
        s.tailstock = {14, 20};
        const LatheField field = field_of(s, context);
        LatheField::Hint hint;
        // The chuck ends at -20 + 15 + 2; the ball of radius 3 stands clear of it from 0 on, and rides over
        // it at its radius and the clearance. The prism around it is a hair larger than the cylinder.
        QCOMPARE(field.point({1, 0.001}, hint).held, LathePoint::HeldBy::part);
        const LathePoint over = field.point({1, -4}, hint);
        QCOMPARE(over.held, LathePoint::HeldBy::zone);
        QVERIFY(over.u >= 62 && over.u < 62.01);
        // The tailstock's small nose keeps the tool off where the part is lower only: nowhere down to 25.
        const LatheRange range = lathe_range(s, field, context, Progress());
        QVERIFY(std::abs(range.from) < 1e-3);
        QVERIFY2(std::abs(range.to - 40) < 1e-3, qPrintable(QString::number(range.to)));
        // A chuck over the part takes the length that it holds, and what the ball needs beside it.
        s.chuck = {30, 120};
        const LatheField deeper = field_of(s, context);
        const LatheRange left = lathe_range(s, deeper, context, Progress());
        QVERIFY2(left.from > 12 && left.from <= 15 + 1e-3, qPrintable(QString::number(left.from)));
        QVERIFY(std::abs(left.held_back - left.from) < 1e-3);
        s.chuck = {80, 120};
        const LatheField closed = field_of(s, context);
        QCOMPARE(code_of([&] { lathe_range(s, closed, context, Progress()); }), std::string("out_of_range"));
    }

    /// Rounded ends ask for the tool beyond them, flat ends do not.
    void the_range_follows_the_part() {
        const auto prism = make_sample("square-prism", 0.1, Progress());
        const PlanContext flat_ends = context_of(*prism, ball_tool(6));
        const LatheRange flat = lathe_range({}, field_of({}, flat_ends), flat_ends, Progress());
        QCOMPARE(flat.from, 0.0);
        QCOMPARE(flat.to, 40.0);
        Mesh half_round = dome(20, 40); // about Z, its level bottom at 0
        LatheCommon s;
        s.axis = LatheCommon::Axis::z;
        const PlanContext context = context_of(half_round, ball_tool(6));
        const LatheRange round = lathe_range(s, field_of(s, context), context, Progress());
        QVERIFY2(round.to > 22.9 && round.to <= 23, qPrintable(QString::number(round.to)));
        QVERIFY2(std::abs(round.from) < 0.1, qPrintable(QString::number(round.from)));
    }

    /// Between the points of a line the tool cuts no deeper than allowed and stays no higher, wherever one
    /// looks.
    void lines_hold_their_tolerance() {
        const auto part = make_sample("twisted-prism", 0.05, Progress());
        for (const auto& [name, tool] : tools_of_every_shape()) {
            const PlanContext context = context_of(*part, tool);
            const LatheField field = field_of({}, context);
            std::vector<LathePlace> route;
            for (int k = 0; k <= 120; ++k)
                route.push_back({2 * pi * k / 60, 20 + 0.02 * k});
            LineTolerance fine;
            fine.below = fine.above = 0.004;
            fine.spacing = safe_lathe_spacing(field.cover().profile(), field.part_radius(), fine.below);
            const auto all = trace(field, route, fine, Progress());
            const auto points = thinned(all, route, field.part_radius(), 0.004, 0.004);
            QVERIFY(points.size() < all.size() && points.size() >= route.size());
            std::size_t met = 0;
            for (const LathePoint& p : points)
                met += met < route.size() && p.place.angle == route[met].angle && p.place.y == route[met].y;
            QCOMPARE(met, route.size());
            // Along the path itself no two places that were looked at are farther apart than what lies
            // between them may be, but for radial moves.
            for (std::size_t i = 1; i < all.size(); ++i) {
                const double ds = lathe_distance(all[i - 1].place, all[i].place, field.part_radius());
                QVERIFY(ds <= fine.shortest()
                        || std::hypot(ds, all[i].u - all[i - 1].u) <= 1.000001 * fine.spacing);
            }
            LatheField::Hint hint;
            double deep = 0, high = 0;
            for (std::size_t i = 1; i < points.size(); ++i)
                for (const double t : {0.13, 0.5, 0.77}) {
                    const LathePoint &a = points[i - 1], &b = points[i];
                    const LathePlace at{a.place.angle + t * (b.place.angle - a.place.angle),
                                        a.place.y + t * (b.place.y - a.place.y)};
                    const double ds = lathe_distance(a.place, b.place, field.part_radius()), du = b.u - a.u;
                    if (ds == 0) continue;
                    const double off = (a.u + t * du - field.u(at, hint)) * ds / std::hypot(ds, du);
                    deep = std::max(deep, -off);
                    high = std::max(high, off);
                }
            QVERIFY2(deep <= 0.0081 && high <= 0.0081,
                     qPrintable(QString("%1: %2 below, %3 above").arg(name).arg(deep).arg(high)));
        }
    }

    /// Two balls on a cylinder, a side feed apart, leave r - sqrt(r^2 - f^2 / 4).
    void the_side_feed_comes_from_the_cusp() {
        const auto part = make_sample("cylinder", 0.001, Progress());
        const double r = 3, cusp = 0.05, exact = 2 * std::sqrt(2 * r * cusp - cusp * cusp);
        const PlanContext context = context_of(*part, ball_tool(2 * r));
        const LatheField field = field_of({}, context);
        SideFeed feed(field, true, 0, 25, cusp, Progress());
        feed.measure(Progress());
        for (const double y : {0.0, 7.0, 20.0}) {
            QVERIFY2(feed.allowed(y) <= exact * 1.001 && feed.allowed(y) >= 0.97 * exact,
                     qPrintable(QString("%1 of %2").arg(feed.allowed(y)).arg(exact)));
        }
        QCOMPARE(feed.unsatisfied(), 0.0);
        const double found = feed.cusp_of(exact, Progress());
        QVERIFY2(std::abs(found - cusp) < 0.03 * cusp, qPrintable(QString::number(found)));
        // Lines along it stand on a convex surface: wider apart than on a plane, but for the same cusp.
        SideFeed lines(field, false, 0, 25, cusp, Progress());
        lines.measure(Progress());
        const double center = 20 + r, half = 0.5 * lines.allowed(1);
        // Height of the point where two balls at +-half meet.
        const double top = center * std::cos(half) - std::sqrt(r * r - std::pow(center * std::sin(half), 2));
        QVERIFY2(std::abs(top - 20 - cusp) < 0.06 * cusp, qPrintable(QString::number(top - 20)));
    }

    void a_helix_begins_and_ends_with_a_ring() {
        const LatheRange range{2, 10, 0};
        // Finer in the middle, as towards a shoulder.
        const auto feed = [](double y) { return 0.1 + 0.4 * std::abs(y - 6); };
        const LatheRoute route = lathe_route(LatheCommon::Pattern::helix, range, 36, feed, Progress());
        QCOMPARE(route.places.front().y, 2.0);
        QCOMPARE(route.places.back().y, 10.0);
        for (std::size_t i = 1; i < route.places.size(); ++i) {
            QVERIFY(std::abs(route.places[i].angle - route.places[i - 1].angle - 2 * pi / 36) < 1e-9);
            const double rise = route.places[i].y - route.places[i - 1].y;
            QVERIFY2(rise >= 0 && rise < 0.3, qPrintable(QString::number(rise)));
            if (i >= 36) {
                const double before = route.places[i - 36].y;
                QVERIFY(route.places[i].y - before <= feed(before) + 1e-9);
            }
        }
        for (std::size_t k = 0; k < 36; ++k) {
            QCOMPARE(route.places[k].y, 2.0);
            QCOMPARE(route.places[route.places.size() - 1 - k].y, 10.0);
        }
        const LatheRoute rings = lathe_route(LatheCommon::Pattern::rings, range, 36, feed, Progress());
        QCOMPARE(rings.places.back().y, 10.0);
        QCOMPARE(rings.places.size(), rings.turns.size() * 37);
        const LatheRoute lines = lathe_route(
            LatheCommon::Pattern::lengthwise, range, 36, [](double) { return pi / 4; }, Progress());
        QCOMPARE(lines.turns.size(), std::size_t(8));
        QCOMPARE(turn_steps({3620, ""}, 20, 0.001), std::size_t(3620));
        QCOMPARE(turn_steps({100, ""}, 20, 0.001) % 100, std::size_t(0));
        QCOMPARE(code_of([] { turn_steps({3.5, ""}, 20, 0.001); }), std::string("out_of_range"));
    }
};

FACETMILL_TEST(TestLathe)
#include "test_lathe.moc"
