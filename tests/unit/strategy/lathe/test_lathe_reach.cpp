// What the cutter cannot come to on a turning part, and the creases that the side feed must pass slowly.
#include "core/base/parallel.h"
#include "core/mesh/sample.h"
#include "core/strategy/lathe/lathe_reach.h"
#include "tests/property/shapes.h"
#include "tests/support/test_runner.h"
#include "tests/support/trials.h"

#include <QTest>

#include <cmath>
#include <random>

using namespace facetmill;
using namespace facetmill::test;

namespace {

using Why = UnreachedRegion::Why;

/// A polygon (y, z), counter-clockwise seen against X, drawn out along X; without ends.
Mesh drawn_out(const std::vector<Vec2>& polygon, double length) {
    Mesh m;
    const auto n = Index(polygon.size());
    for (const double x : {0.0, length})
        for (const Vec2& p : polygon)
            m.vertices.emplace_back(x, p.x(), p.y());
    for (Index k = 0; k < n; ++k) {
        const Index next = (k + 1) % n;
        m.facets.push_back({k, next, next + n});
        m.facets.push_back({k, next + n, k + n});
    }
    return m;
}

/// A profile (x, radius) turned about X, of so many sides; without ends.
Mesh turned_profile(const std::vector<Vec2>& profile, int sides) {
    Mesh m;
    for (const Vec2& p : profile)
        for (int k = 0; k < sides; ++k) {
            const double angle = 2 * pi * k / sides;
            m.vertices.emplace_back(p.x(), p.y() * std::cos(angle), p.y() * std::sin(angle));
        }
    const auto at = [&](std::size_t i, int k) { return Index(int(i) * sides + k % sides); };
    for (std::size_t i = 0; i + 1 < profile.size(); ++i)
        for (int k = 0; k < sides; ++k) {
            m.facets.push_back({at(i, k), at(i, k + 1), at(i + 1, k + 1)});
            m.facets.push_back({at(i, k), at(i + 1, k + 1), at(i + 1, k)});
        }
    return m;
}

struct Looked {
    LatheReach reach;
    LatheRange range;
};

Looked look(const Mesh& part, const Tool& tool, LatheCommon s = {}, double allowed = 0.05,
            double advance = 0.1, bool across = true) {
    const PlanContext context = context_of(part, tool);
    const LatheField field(s, context, 0, Progress());
    Looked l;
    l.range = lathe_range(s, field, context, Progress());
    l.reach = lathe_reach(s, field, context, l.range, allowed, {across, [=](double) { return advance; }},
                          Progress());
    return l;
}

/// The largest, over these places of a part about X, of how far each stays from a cutter without flanks at
/// its nearest, over all angles and lengths within its diameter: on a grid, then on finer ones about the
/// best.
double largest_by_trying(const std::vector<Vec3>& places, const Mesh& part, const Tool& tool) {
    const PlanContext context = context_of(part, tool);
    const LatheField field({}, context, 0, Progress());
    const LatheRange range = lathe_range({}, field, context, Progress());
    const double radius = 0.5 * tool.diameter, corner = tool.corner_radius, level = radius - corner;
    LatheField::Hint hint;
    const auto distance = [&](const Vec3& p, const LathePlace& place) {
        const CutterLocation at = field.frame().at(place, field.u(place, hint));
        const Vec3 rel = p - at.tip;
        const double z = rel.dot(at.axis), rho = (rel - z * at.axis).norm();
        if (z >= corner) return std::max(rho - radius, 0.0);
        if (rho <= level) return std::max(-z, 0.0);
        return std::max(std::hypot(rho - level, z - corner) - corner, 0.0);
    };
    double most = 0;
    for (const Vec3& p : places) {
        LathePlace best{std::atan2(-p.y(), p.z()), p.x()};
        double least = infinity, half = tool.diameter;
        constexpr int pieces = 24, rounds = 4;
        for (int round = 0; round < rounds; ++round, half *= 4.0 / pieces) {
            const LathePlace about = best;
            for (int i = -pieces; i <= pieces; ++i)
                for (int k = -pieces; k <= pieces; ++k) {
                    const LathePlace place{about.angle + half * i / pieces / field.frame().away(p),
                                           std::clamp(about.y + half * k / pieces, range.from, range.to)};
                    if (const double here = distance(p, place); here < least) {
                        least = here;
                        best = place;
                    }
                }
        }
        most = std::max(most, least);
    }
    return most;
}

QByteArray told(const LatheReach& reach) {
    QByteArray all;
    for (const std::string& w : reach_warnings(reach, LengthUnit::mm))
        all += QByteArray::fromStdString(w) + "; ";
    return all;
}

} // namespace

class TestLatheReach : public QObject {
    Q_OBJECT
private slots:
    /// Every place of a convex part, and of hollows wider than the cutter, is reached.
    void what_can_be_reached_is_not_told() {
        const auto prism = make_sample("square-prism", 0.1, Progress());
        for (const auto& [name, tool] : tools_of_every_shape()) {
            for (const double offset : {0.0, 1.0}) {
                LatheCommon s;
                s.offset = offset;
                const Looked l = look(*prism, tool, s);
                QVERIFY2(l.reach.regions.empty(), qPrintable(QString(name) + ": " + told(l.reach)));
                QVERIFY(std::abs(l.reach.area - 4 * 50 * 40) < 1e-6); // its ends are left out
                QVERIFY(l.reach.limits.empty());
            }
        }
        std::vector<Vec2> wave;
        for (int i = 0; i <= 120; ++i)
            wave.emplace_back(0.25 * i, 12 + std::cos(2 * pi * i / 120)); // curves with a radius of 23 mm
        const Looked l = look(turned_profile(wave, 180), ball_tool(8));
        QVERIFY2(l.reach.regions.empty(), told(l.reach).constData());
    }

    /// A ball of radius 3 over a groove 2 mm wide and deep rests on its edges.
    void a_groove_all_around() {
        const Mesh part = turned_profile({{0, 10}, {4, 10}, {4, 8}, {6, 8}, {6, 10}, {10, 10}}, 120);
        const Looked l = look(part, ball_tool(6));
        QCOMPARE(l.reach.regions.size(), std::size_t(1));
        const UnreachedRegion& r = l.reach.regions[0];
        QCOMPARE(r.why, Why::narrow);
        QVERIFY(r.angle_from == 0 && r.angle_to == 2 * pi);
        QVERIFY2(r.from >= 4 - 1e-6 && r.from < 4.2 && r.to <= 6 + 1e-6 && r.to > 5.8,
                 qPrintable(QString("%1 to %2").arg(r.from).arg(r.to)));
        // To the floor 1.83, into its corners 1.93 mm; the walls are touched by no more than 0.02 mm.
        QVERIFY2(r.distance > 1.80 && r.distance <= 1.94, qPrintable(QString::number(r.distance)));
        const double exact = 2 * pi * 8 * 2 + 2 * pi * (9.982 * 9.982 - 64);
        QVERIFY2(std::abs(r.area - exact) < 0.06 * exact,
                 qPrintable(QString("%1, %2").arg(r.area).arg(exact)));
        const QByteArray said = told(l.reach);
        QVERIFY2(said.contains("too large") && said.contains("all around") && said.contains("along the axis")
                     && said.contains("mm²"),
                 said.constData());
        // A ball that goes in reaches all but the fillets of the corners.
        const Looked small = look(part, ball_tool(1));
        double left = 0;
        for (const UnreachedRegion& u : small.reach.regions)
            left += u.area;
        QVERIFY2(left < 0.3 * exact && left > 0, qPrintable(QString::number(left)));
    }

    /// Slots lengthwise at angles 0 (over the seam) and 90 degrees.
    void slots_are_told_apart() {
        const Mesh part = drawn_out({{-10, -10},
                                     {10, -10},
                                     {10, 10},
                                     {1, 10},
                                     {1, 8},
                                     {-1, 8},
                                     {-1, 10},
                                     {-10, 10},
                                     {-10, 1.5},
                                     {-7, 1.5},
                                     {-7, -1.5},
                                     {-10, -1.5}},
                                    20);
        const Looked l = look(part, ball_tool(6));
        QCOMPARE(l.reach.regions.size(), std::size_t(2));
        const UnreachedRegion &large = l.reach.regions[0], &small = l.reach.regions[1];
        QVERIFY(large.area > small.area);
        for (const UnreachedRegion& r : l.reach.regions) {
            QCOMPARE(r.why, Why::narrow);
            QVERIFY(r.from < 0.5 && r.to > 19.5);
        }
        const double half = degrees(std::atan(1.0 / 8));
        QVERIFY2(std::abs(degrees(small.angle_from) - (360 - half)) < 2
                     && std::abs(degrees(small.angle_to) - (360 + half)) < 2,
                 qPrintable(QString("%1 %2").arg(degrees(small.angle_from)).arg(degrees(small.angle_to))));
        // From +Z by the right hand about +X comes -Y.
        const double wide = degrees(std::atan(1.5 / 7));
        QVERIFY2(std::abs(degrees(large.angle_from) - (90 - wide)) < 2
                     && std::abs(degrees(large.angle_to) - (90 + wide)) < 2,
                 qPrintable(QString("%1 %2").arg(degrees(large.angle_from)).arg(degrees(large.angle_to))));
    }

    void bores_and_undercuts_are_covered() {
        // A bore along the axis.
        Mesh tube = drawn_out({{-10, -10}, {10, -10}, {10, 10}, {-10, 10}}, 20);
        const Mesh bore = drawn_out({{-3, -3}, {-3, 3}, {3, 3}, {3, -3}}, 20);
        const auto first = Index(tube.vertices.size());
        tube.vertices.insert(tube.vertices.end(), bore.vertices.begin(), bore.vertices.end());
        for (const Facet& f : bore.facets)
            tube.facets.push_back({f[0] + first, f[1] + first, f[2] + first});
        const Looked l = look(tube, ball_tool(6));
        QCOMPARE(l.reach.regions.size(), std::size_t(1));
        QCOMPARE(l.reach.regions[0].why, Why::covered);
        QVERIFY(std::abs(l.reach.regions[0].area - 4 * 6 * 20) < 1);
        QVERIFY(l.reach.regions[0].angle_to - l.reach.regions[0].angle_from == 2 * pi);
        // A slot that widens inward, wide enough for the cutter at its mouth: what its lips hide is covered.
        const Mesh dovetail =
            drawn_out({{-20, -20}, {20, -20}, {20, 20}, {4, 20}, {9, 14}, {-9, 14}, {-4, 20}, {-20, 20}}, 20);
        const Looked d = look(dovetail, ball_tool(4));
        double covered = 0;
        for (const UnreachedRegion& r : d.reach.regions)
            if (r.why == Why::covered) covered += r.area;
        // The flanks, and 5 mm of the floor to either side.
        const double exact = 20 * 2 * (std::hypot(5, 6) + 5);
        QVERIFY2(std::abs(covered - exact) < 0.15 * exact,
                 qPrintable(QString("%1 of %2").arg(covered).arg(exact)));
        QVERIFY(told(d.reach).contains("under the part itself"));
    }

    /// A slot right through, so narrow that the tool can hardly lean: of its walls, whose normals point to
    /// the other wall and not away from the axis, only the mouths are reached.
    void walls_of_a_slot_through_the_axis_are_not_taken_for_served() {
        Mesh part = drawn_out({{4, -20}, {20, -20}, {20, 20}, {4, 20}}, 20);
        const Mesh other = drawn_out({{-20, -20}, {-4, -20}, {-4, 20}, {-20, 20}}, 20);
        const auto first = Index(part.vertices.size());
        part.vertices.insert(part.vertices.end(), other.vertices.begin(), other.vertices.end());
        for (const Facet& f : other.facets)
            part.facets.push_back({f[0] + first, f[1] + first, f[2] + first});
        const Looked l = look(part, ball_tool(6));
        double left = 0;
        for (const UnreachedRegion& r : l.reach.regions)
            left += r.area;
        // At the depth z below the mouth at 20 the shank stays 1 - z / 20 away from the wall.
        const double walls = 2 * 40 * 20, mouths = 4 * 20 * (20 * 0.05);
        QVERIFY2(std::abs(left - (walls - mouths)) < 0.03 * walls,
                 qPrintable(QString("%1 of %2").arg(left).arg(walls - mouths)));
    }

    void core_shaft_and_chuck_have_their_own_reasons() {
        const Mesh block = drawn_out({{-5, -5}, {5, -5}, {5, 5}, {-5, 5}}, 20);
        LatheCommon s;
        s.core_radius = 8;
        const Looked core = look(block, ball_tool(6), s);
        QCOMPARE(core.reach.regions.size(), std::size_t(1));
        QCOMPARE(core.reach.regions[0].why, Why::core);
        QVERIFY(core.reach.regions[0].area > 0.95 * core.reach.area);
        QVERIFY2(std::abs(core.reach.regions[0].distance - 3) < 0.1,
                 qPrintable(QString::number(core.reach.regions[0].distance)));

        // The cutter is small enough, its shank is not.
        const Mesh groove = turned_profile({{0, 12}, {4, 12}, {6, 6}, {14, 6}, {16, 12}, {20, 12}}, 120);
        const auto area_of = [](const Looked& l, Why why) {
            double area = 0;
            for (const UnreachedRegion& r : l.reach.regions)
                if (r.why == why) area += r.area;
            return area;
        };
        const Looked slim = look(groove, ball_tool(3)); // into all but the corners of its floor
        QVERIFY(slim.reach.regions.size() <= 2 && area_of(slim, Why::shaft) == 0);
        Tool stubby = ball_tool(3);
        stubby.flute_length = 2;
        stubby.shank_diameter = 20;
        const Looked shaft = look(groove, stubby);
        QVERIFY(!shaft.reach.regions.empty());
        QCOMPARE(shaft.reach.regions[0].why, Why::shaft);
        // The floor, at least.
        QVERIFY2(area_of(shaft, Why::shaft) > 2 * pi * 6 * 8, told(shaft.reach).constData());
        QVERIFY(told(shaft.reach).contains("shank or holder"));

        s = {};
        s.chuck = {6, 40};
        s.clearance = 1;
        const Mesh bar = turned_profile({{0, 10}, {30, 10}}, 120);
        PlanContext context = context_of(bar, ball_tool(6));
        const Looked held = look(bar, ball_tool(6), s);
        QCOMPARE(held.reach.regions.size(), std::size_t(1));
        QCOMPARE(held.reach.regions[0].why, Why::held);
        QVERIFY2(held.reach.regions[0].to > 6.5 && held.reach.regions[0].to < held.range.from + 1,
                 qPrintable(QString("%1").arg(held.reach.regions[0].to)));
    }

    void the_distance_is_the_largest_of_the_nearest_data() {
        QTest::addColumn<int>("seed");
        QTest::addColumn<double>("corner");
        for (int seed = 0; seed < 4; ++seed)
            for (const double corner : {3.0, 1.0, 0.0}) {
                if (under_sanitizer && corner != 1) continue;
                if (!all_cases && corner != 1 && (seed % 2 == 0) != (corner == 0)) continue;
                QTest::addRow("part %d corner %g", seed, corner) << seed << corner;
            }
    }

    /// A region's distance against the largest, over the part, of the smallest, over all places of the
    /// cutter: notches lengthwise and around, with floors or pointed, leaning, deeper and narrower at random.
    void the_distance_is_the_largest_of_the_nearest() {
        QFETCH(int, seed);
        QFETCH(double, corner);
        std::mt19937 random{std::mt19937::result_type(seed)};
        const auto any = [&](double low, double high) {
            return std::uniform_real_distribution<double>(low, high)(random);
        };
        const double mouth = any(2.5, 5), floor = seed % 2 == 0 ? 0 : any(0.5, 1.5), depth = any(1.2, 3),
                     lean = any(-0.4, 0.4) * mouth;
        // Along the section, or from end to end; the middle of a side of the turned one is its lowest.
        std::vector<Vec2> notch;
        constexpr int sides = 24;
        const bool lengthwise = seed < 2;
        if (lengthwise)
            notch = {{0.5 * mouth, 8},
                     {lean + 0.5 * floor + 0.01, 8 - depth},
                     {lean - 0.5 * floor - 0.01, 8 - depth},
                     {-0.5 * mouth, 8}};
        else
            notch = {{6 - 0.5 * mouth, 9},
                     {6 + lean - 0.5 * floor - 0.01, 9 - depth},
                     {6 + lean + 0.5 * floor + 0.01, 9 - depth},
                     {6 + 0.5 * mouth, 9}};
        std::vector<Vec2> outline = notch;
        if (lengthwise) {
            outline.insert(outline.begin(), {{-8, -8}, {8, -8}, {8, 8}});
            outline.emplace_back(-8, 8);
        } else {
            outline.insert(outline.begin(), Vec2(0, 9));
            outline.emplace_back(12, 9);
        }
        const Mesh part = lengthwise ? drawn_out(outline, 6) : turned_profile(outline, sides);
        std::vector<Vec3> places;
        const double turn = pi / sides;
        for (std::size_t i = 1; i < notch.size(); ++i)
            for (int k = 0; k <= 6; ++k) {
                const Vec2 q = notch[i - 1] + k / 6.0 * (notch[i] - notch[i - 1]);
                if (lengthwise)
                    places.emplace_back(3, q.x(), q.y());
                else {
                    places.emplace_back(q.x(), q.y(), 0); // a corner of the section
                    const double low = q.y() * std::cos(turn);
                    places.emplace_back(q.x(), low * std::cos(turn), low * std::sin(turn));
                }
            }
        Tool tool = ball_tool(6);
        tool.corner_radius = corner;
        const double exact = largest_by_trying(places, part, tool);
        QVERIFY2(exact > 0.1, qPrintable(QString::number(exact)));
        double most = 0;
        for (const UnreachedRegion& r : look(part, tool).reach.regions)
            most = std::max(most, r.distance);
        // The search ends with steps of a 64th of the cutter's radius. The worst place is an edge of the
        // floor, where both look; not so under a wall that hangs over, where samples of the facets are what
        // there is, and the distance changes by no more than the way between them.
        const bool hangs_over = std::abs(lean) + 0.5 * floor + 0.01 > 0.5 * mouth;
        const double lack = hangs_over ? std::sqrt(0.5) * std::sqrt(2 * 3 * 0.05) : 0.02;
        QVERIFY2(most <= exact + 3.0 / 64 && most >= exact - lack,
                 qPrintable(QString("%1, not %2").arg(most).arg(exact)));
    }

    /// Straight over a place the cutter is no farther from it than the part's outside.
    void the_distance_has_a_bound() {
        std::mt19937 random(7);
        std::uniform_real_distribution<double> bump(0, 1);
        for (int round = 0; round < (all_cases ? 6 : trials(3, 3)); ++round) {
            const int around = 24, along = 10;
            Mesh part;
            for (int i = 0; i <= along; ++i)
                for (int k = 0; k < around; ++k) {
                    const double angle = 2 * pi * k / around, r = 10 + bump(random);
                    part.vertices.emplace_back(1.5 * i, r * std::cos(angle), r * std::sin(angle));
                }
            for (int i = 0; i < along; ++i)
                for (int k = 0; k < around; ++k) {
                    const auto at = [&](int a, int b) { return Index(a * around + b % around); };
                    part.facets.push_back({at(i, k), at(i, k + 1), at(i + 1, k + 1)});
                    part.facets.push_back({at(i, k), at(i + 1, k + 1), at(i + 1, k)});
                }
            double outside = 0;
            for (const Vec3& v : part.vertices)
                outside = std::max(outside, std::hypot(v.y(), v.z()));
            // Of the middles of facets' edges at the innermost.
            const double inside = 10 * std::cos(pi / around);
            for (const auto& [name, tool] : tools_of_every_shape()) {
                const Looked l = look(part, tool);
                QVERIFY(!l.reach.regions.empty());
                for (const UnreachedRegion& r : l.reach.regions) {
                    QVERIFY(r.distance > 0 && r.area > 0);
                    QVERIFY2(
                        r.distance <= outside - inside + 1e-9,
                        qPrintable(QString("%1: %2 > %3").arg(name).arg(r.distance).arg(outside - inside)));
                    QVERIFY(r.from >= -1e-9 && r.to <= 15 + 1e-9 && r.from < r.to);
                    QVERIFY(r.angle_from < r.angle_to && r.angle_to - r.angle_from <= 2 * pi + 1e-9);
                }
            }
        }
    }

    /// Three planes that all turn by the same from each other meet in a corner, where a ball leaves more than
    /// in the edges between them.
    void corners_where_hollow_edges_meet() {
        const double r = 6.35, slope = std::tan(radians(8));
        // A shallow pit with three sides in the top of a block; its deepest place at (15, 0).
        const auto pit = [&](double x, double y) {
            double z = -infinity;
            for (int k = 0; k < 3; ++k) {
                const double angle = 2 * pi * (k + 0.25) / 3;
                z = std::max(z, slope * ((x - 15) * std::cos(angle) + y * std::sin(angle)));
            }
            return 18 + z;
        };
        // Rays from the middle, some of them along the edges.
        Mesh part;
        part.vertices.emplace_back(15, 0, pit(15, 0));
        constexpr int rays = 12;
        for (int k = 0; k < rays; ++k) {
            const double angle = 2 * pi * k / rays, x = 15 + 12 * std::cos(angle), y = 12 * std::sin(angle);
            part.vertices.emplace_back(x, y, pit(x, y));
        }
        for (Index k = 0; k < rays; ++k)
            part.facets.push_back({0, 1 + k, 1 + (k + 1) % rays});
        // And a speck opposite, so that the axis runs through the part.
        part.vertices.insert(part.vertices.end(), {{14.9, -0.1, -18}, {15.1, -0.1, -18}, {15, 0.1, -18}});
        part.facets.push_back({rays + 1, rays + 2, rays + 3});
        // Over the deepest place the ball touches all three sides: its centre is r / cos(slope angle) above.
        const double corner = r / std::cos(radians(8)) - r;
        // In an edge two sides turn by 2 alpha: cos(2 alpha) = n1 . n2.
        const double c = std::cos(radians(8)), s = std::sin(radians(8));
        const double two_alpha = std::acos(c * c + s * s * std::cos(2 * pi / 3));
        const double edge = r * (1 / std::cos(0.5 * two_alpha) - 1);
        QVERIFY(edge < 0.8 * corner);
        // Between the two: edges are cut, the corner is not.
        const Looked l = look(part, ball_tool(2 * r), {}, 0.5 * (edge + corner), 0.2);
        QVERIFY2(l.reach.regions.size() == 1, told(l.reach).constData());
        const UnreachedRegion& region = l.reach.regions[0];
        QVERIFY2(std::abs(0.5 * (region.from + region.to) - 15) < 0.1
                     && std::abs(0.5 * (region.angle_from + region.angle_to) - 2 * pi) < 0.1,
                 qPrintable(QString("%1 %2 %3 %4")
                                .arg(region.from)
                                .arg(region.to)
                                .arg(region.angle_from)
                                .arg(region.angle_to)));
        QVERIFY(region.area < 3 && region.from < 15 && region.to > 15);
        QVERIFY(std::abs(region.distance - corner) < 0.02 * corner);
        // Where both are allowed, the corner is what limits the feed.
        const Looked limited = look(part, ball_tool(2 * r), {}, 1.2 * corner, 3.0);
        double least = infinity, at = 0;
        for (const FeedLimit& f : limited.reach.limits)
            if (f.advance < least) {
                least = f.advance;
                at = f.at;
            }
        QVERIFY2(std::abs(at - 15) < 0.1, qPrintable(QString::number(at)));
    }

    /// What the settings leave out is no finding.
    void start_and_stop_are_the_users() {
        const Mesh part = turned_profile({{0, 10}, {4, 10}, {4, 8}, {6, 8}, {6, 10}, {20, 10}}, 90);
        LatheCommon s;
        s.start = {8, ""};
        s.stop = {15, ""};
        const Looked l = look(part, ball_tool(6), s);
        QVERIFY2(l.reach.regions.empty(), told(l.reach).constData());
    }

    /// A valley between planes that turn by 2 alpha: the fillet of a ball is r (1 / cos(alpha) - 1).
    void creases_limit_the_feed() {
        const double r = 6.35, alpha = radians(8), fillet = r * (1 / std::cos(alpha) - 1);
        const Mesh part =
            drawn_out({{-20, -20}, {20, -20}, {20, 20}, {0, 20 - 20 * std::tan(alpha)}, {-20, 20}}, 30);
        QVERIFY(fillet > 0.062 && fillet < 0.063);
        // Lengthwise valley, turns across: at the place of each turn it is the fillet that stays, between two
        // turns the cusp of a feed f stands on it. Along the side's normal, which leans by alpha: the balls'
        // centres are r / cos(alpha) above the crease and f / 2 to either side.
        const double allowed = 0.1;
        const auto left = [&](double f) {
            const double h = r / std::cos(alpha), square = r * r - f * f / 4; // the section halfway
            // q = t n with |q - c| = sqrt(square), n = (sin, cos) alpha, c = (0, h).
            const double along = h * std::cos(alpha);
            return along - std::sqrt(square - std::pow(h * std::sin(alpha), 2));
        };
        double exact = 0;
        for (double f = 0; left(f) < allowed; f += 1e-4)
            exact = f;
        const Looked wide = look(part, ball_tool(2 * r), {}, allowed, 3.0);
        QVERIFY(wide.reach.regions.empty());
        QVERIFY(wide.reach.limits.size() > 10);
        QVERIFY(std::abs(wide.reach.crease_cusp - left(3)) < 0.02 * left(3));
        for (const FeedLimit& l : wide.reach.limits)
            if (l.at > 4 && l.at < 26)
                QVERIFY2(std::abs(l.advance - exact) < 0.04 * exact,
                         qPrintable(QString("%1, not %2").arg(l.advance).arg(exact)));
        // A feed that is short enough already is not limited, and a plane edge that bulges never.
        QVERIFY(look(part, ball_tool(2 * r), {}, allowed, 0.9 * exact).reach.limits.empty());
        // Where the fillet alone is more, it is out of reach.
        const Looked narrow = look(part, ball_tool(2 * r), {}, 0.05, 3.0);
        QVERIFY(!narrow.reach.regions.empty());
        QVERIFY(narrow.reach.limits.empty());
        QCOMPARE(narrow.reach.regions[0].why, Why::narrow);
    }

    void limits_shorten_the_feed_about_them() {
        const auto part = make_sample("cylinder", 0.001, Progress());
        const PlanContext context = context_of(*part, ball_tool(6));
        const LatheField field({}, context, 0, Progress());
        SideFeed feed(field, true, 0, 25, 0.05, Progress());
        feed.measure(Progress());
        const double level = feed.allowed(12);
        const std::vector<FeedLimit> limits{{10, 0.4}, {17, 0.3}, {17.1, 0.2}};
        feed.limit(limits);
        QVERIFY(feed.allowed(3) <= level && feed.allowed(3) > 0.9 * level);
        for (double a = 0; a < 25; a += 0.003)
            for (const FeedLimit& l : limits) {
                const double advance = feed.allowed(a);
                QVERIFY2(!(a <= l.at && a + advance >= l.at) || advance <= l.advance + 1e-9,
                         qPrintable(QString("%1 at %2").arg(advance).arg(a)));
            }
        QVERIFY(feed.allowed(12.5) > 0.7 * level);
    }

    void threads_do_not_change_a_bit() {
        const Mesh part =
            turned_profile({{0, 10}, {4, 10}, {4, 8}, {6, 8}, {6, 10}, {10, 9.5}, {14, 10}}, 60);
        const auto numbers = [&] {
            std::vector<double> all;
            const Looked l = look(part, ball_tool(6), {}, 0.05, 1.5);
            for (const UnreachedRegion& r : l.reach.regions)
                all.insert(all.end(), {r.area, r.angle_from, r.angle_to, r.from, r.to, r.distance});
            for (const FeedLimit& f : l.reach.limits)
                all.insert(all.end(), {f.at, f.advance});
            return all;
        };
        set_thread_count(1);
        const auto one = numbers();
        set_thread_count(2);
        const auto two = numbers();
        set_thread_count(0);
        QVERIFY(!one.empty());
        QVERIFY(one == two);
    }
};

FACETMILL_TEST(TestLatheReach)
#include "test_lathe_reach.moc"
