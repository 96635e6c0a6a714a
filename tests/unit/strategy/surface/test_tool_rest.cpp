// What a tool leaves, against closed forms, and against tips looked at one by one.
#include "core/strategy/surface/boundary_region.h"
#include "core/strategy/surface/tool_rest.h"
#include "tests/support/error_code.h"
#include "tests/support/part_meshes.h"
#include "tests/support/random_meshes.h"
#include "tests/support/test_runner.h"
#include "tests/support/trials.h"

#include <QTest>

#include <cmath>

using namespace facetmill;
using namespace facetmill::test;

namespace {

ContactIndexPtr indexed(Mesh mesh) {
    return std::make_shared<ContactIndex>(std::make_shared<Mesh>(std::move(mesh)), Progress());
}

double area_in(const std::vector<PlanEdge>& edges) {
    double area = 0;
    for (const auto& [a, b] : edges)
        area += 0.5 * (a.x() * b.y() - a.y() * b.x());
    return area;
}

/// Two slopes of 45 degrees that meet in the Y axis.
Mesh groove() {
    return height_field([](double x, double) { return std::abs(x); }, Vec2(-10, -5), Vec2(10, 5), 2, 1);
}

/// A plate with a square pocket of this side, upright walls and a level floor 4 below.
Mesh pocket(double side) {
    const double far = side, at = 0.5 * side;
    Mesh mesh;
    const auto quad = [&](const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
        const auto first = Index(mesh.vertices.size());
        mesh.vertices.insert(mesh.vertices.end(), {a, b, c, d});
        mesh.facets.push_back({first, first + 1, first + 2});
        mesh.facets.push_back({first, first + 2, first + 3});
    };
    quad({-at, -at, -4}, {at, -at, -4}, {at, at, -4}, {-at, at, -4});
    for (int k = 0; k < 4; ++k) {
        const auto turned = [&](double x, double y, double z) {
            for (int i = 0; i < k; ++i)
                x = std::exchange(y, x) * -1;
            return Vec3(x, y, z);
        };
        quad(turned(-at, at, -4), turned(at, at, -4), turned(at, at, 0), turned(-at, at, 0));
        quad(turned(-at, at, 0), turned(at, at, 0), turned(far, far, 0), turned(-far, far, 0));
    }
    return mesh;
}

} // namespace

class TestToolRest : public QObject {
    Q_OBJECT

private slots:
    void a_ball_in_a_groove() {
        for (const auto& [radius, more_than] : {std::pair(3.0, 0.05), {1.0, 0.1}, {2.0, 0.002}}) {
            const ToolRest rest(indexed(groove()), CutterProfile(AptCutter::ball(2 * radius, 50)), more_than,
                                {});
            // The ball touches a radius up the slopes; between, along the normal, it stays a circle away.
            const double border =
                (radius - std::sqrt(2 * radius * more_than - more_than * more_than)) / std::sqrt(2.0);
            QVERIFY(rest.lack({0.99 * border, 0.3}) > 0 && rest.lack({-0.99 * border, -2}) > 0);
            QVERIFY(rest.lack({1.01 * border, 0.3}) <= 0 && rest.lack({-1.01 * border, -2}) <= 0);
            QVERIFY(rest.lack({0, 20}) == -infinity);
            const PlanRegion region(rest.outline({}), {});
            const double depth = region.depth({0, 0.123});
            QVERIFY2(std::abs(depth - border) < 0.5 * rest.spacing(),
                     qPrintable(QString("%1 for %2").arg(depth).arg(border)));
            const double area = area_in(rest.outline({}));
            QVERIFY2(std::abs(area - 20 * border) < 20 * rest.spacing(),
                     qPrintable(QString("%1 for %2").arg(area).arg(20 * border)));
        }
    }

    void a_flat_end_in_corners() {
        const double radius = 2.5;
        const ToolRest rest(indexed(pocket(20)), CutterProfile(AptCutter::flat(2 * radius, 50)), 0.05, {});
        const std::vector<PlanEdge> edges = rest.outline({});
        const double left = (4 - pi) * radius * radius; // four corners, a quarter of a disc missing in each
        QVERIFY2(std::abs(area_in(edges) - left) < 0.5 * rest.spacing() * 4 * (2 + pi / 2) * radius,
                 qPrintable(QString::number(area_in(edges))));
        const PlanRegion region(edges, {});
        for (const double x : {-9.8, 9.8})
            for (const double y : {-9.8, 9.8})
                QVERIFY(region.covers({x, y}));
        for (const Vec2& p : {Vec2(0, 0), Vec2(9.8, 0), Vec2(0, -9.8), Vec2(8.5, 8.5), Vec2(12, 12)})
            QVERIFY(!region.covers(p) && rest.lack(p) <= 0);
    }

    void nothing_is_left_where_the_cutter_reaches_all() {
        const auto none = [](Mesh mesh, const AptCutter& cutter) {
            return ToolRest(indexed(std::move(mesh)), CutterProfile(cutter), 0.05, {}).outline({}).empty();
        };
        const Mesh plane = height_field([](double x, double y) { return 0.3 * x + 0.1 * y; }, Vec2(-9, -9),
                                        Vec2(9, 9), 4, 4);
        for (const AptCutter& cutter : {AptCutter::ball(6, 50), AptCutter::flat(6, 50),
                                        AptCutter::bull(6, 1, 50), AptCutter::cone(6, radians(30))})
            QVERIFY2(none(plane, cutter), qPrintable(QString("%1 %2").arg(cutter.r).arg(cutter.alpha)));
        QVERIFY(none(dome(10, 20), AptCutter::ball(6, 50)));
        QVERIFY(none(box(Vec3(0, 0, 0), Vec3(9, 8, 7)), AptCutter::flat(6, 50)));
    }

    /// Tips all round, a thirtieth of the radius apart: where one of them holds the place, it is not left.
    void tips_one_by_one() {
        Random rng(29);
        std::size_t left = 0, held = 0;
        const int across = trials(60, 4); // tips looked at over the cutter's width
        for (int trial = 0; trial < 4; ++trial) {
            const double a = uniform(rng, 0.8, 1.3), b = uniform(rng, 0.8, 1.3), h = uniform(rng, 1, 2);
            const ContactIndexPtr part = indexed(
                height_field([&](double x, double y) { return h * std::sin(a * x) * std::cos(b * y); },
                             Vec2(-8, -6), Vec2(8, 6), trials(40, 2), trials(30, 2)));
            const double d = uniform(rng, 3, 6), more_than = uniform(rng, 0.02, 0.2);
            const std::array<AptCutter, 4> cutters{AptCutter::ball(d, 50), AptCutter::flat(d, 50),
                                                   AptCutter::bull(d, 0.2 * d, 50),
                                                   AptCutter::cone(d, radians(40))};
            const CutterProfile cutter(cutters[std::size_t(trial % 4)]);
            const ToolRest rest(part, cutter, more_than, {});
            const AxialLift lift(part, cutter);
            const PlanRegion region(rest.outline({}), {});
            for (int k = 0; k < trials(40, 3); ++k) {
                const Vec2 p(uniform(rng, -7.9, 7.9), uniform(rng, -5.9, 5.9));
                const double lack = rest.lack(p);
                (lack > 0 ? left : held)++;
                if (std::abs(region.depth(p)) > 1.5 * rest.spacing()) QVERIFY(region.covers(p) == (lack > 0));
                if (!(lack > 0)) continue;
                double lowest = infinity;
                const Vec3 q = place_over(*part, p, more_than);
                for (double x = -d / 2; x <= d / 2; x += d / across)
                    for (double y = -d / 2; y <= d / 2; y += d / across) {
                        const double rho = std::hypot(x, y);
                        if (rho > d / 2) continue;
                        const double tip = lift.tip_z(q.x() + x, q.y() + y);
                        lowest = std::min(lowest, tip + cutter.height_at(rho) - q.z());
                    }
                QVERIFY2(lowest > -0.05 * more_than,
                         qPrintable(QString("trial %1: %2 and %3").arg(trial).arg(lack).arg(lowest)));
            }
        }
        const auto some = trials(std::size_t(15), std::size_t(3));
        QVERIFY2(left > some && held > some, qPrintable(QString("%1 left, %2 held").arg(left).arg(held)));
    }

    void as_a_boundary() {
        Boundary b;
        b.name = "Corners";
        b.kind = Boundary::Kind::rest;
        b.more_than = 0.05;
        const auto part = std::make_shared<Mesh>(pocket(20));
        const AptCutter flat = AptCutter::flat(5, 50);
        const BoundaryRegion corners(b, part, {}, flat);
        Index hint = no_index;
        QVERIFY(corners.holds({9.8, -9.8, -4}, hint) && !corners.holds({0, 0, -4}, hint));
        QVERIFY(corners.depth({0, 0}) < -5);
        b.offset = 1;
        QVERIFY(std::abs(BoundaryRegion(b, part, {}, flat).depth({0, 0}) - corners.depth({0, 0}) - 1) < 1e-9);
        b.offset = 0;
        b.invert = true;
        const BoundaryRegion others(b, part, {}, flat);
        QVERIFY(!others.holds({9.8, -9.8, -4}, hint) && others.holds({0, 0, -4}, hint));
        b.invert = false;
        std::string message;
        QCOMPARE(code_of([&] { BoundaryRegion(b, part, {}); }, &message), std::string("missing_reference"));
        QVERIFY(message.find("boundary 'Corners'") != std::string::npos);
        const auto plane = std::make_shared<Mesh>(
            height_field([](double, double) { return 0.0; }, Vec2(0, 0), Vec2(9, 9), 1, 1));
        QCOMPARE(code_of([&] { BoundaryRegion(b, plane, {}, flat); }, &message), std::string("empty_result"));
        QVERIFY(message.find("leaves nothing") != std::string::npos);
        // A needle on a large plate.
        QCOMPARE(code_of([&] { BoundaryRegion(b, plane, {}, AptCutter::ball(0.005, 50)); }, &message),
                 std::string("limit_exceeded"));
        QVERIFY(message.find("boundary 'Corners'") != std::string::npos);
    }

private:
    /// What the cutter is to hold: from the highest facet at p, by its plane alone.
    static Vec3 place_over(const ContactIndex& part, const Vec2& p, double more_than) {
        const Mesh& mesh = part.mesh();
        Vec3 best(0, 0, -infinity), normal = Vec3::UnitZ();
        for (std::size_t f = 0; f < mesh.facet_count(); ++f) {
            const Vec3 n = mesh.facet_normal(f), a = mesh.corner(f, 0);
            bool inside = true;
            for (int k = 0; k < 3; ++k) {
                const Vec2 from = mesh.corner(f, k).head<2>(),
                           e = mesh.corner(f, (k + 1) % 3).head<2>() - from;
                inside = inside && e.x() * (p - from).y() - e.y() * (p - from).x() >= 0;
            }
            if (!inside) continue;
            const double z = a.z() - (n.x() * (p.x() - a.x()) + n.y() * (p.y() - a.y())) / n.z();
            if (z > best.z()) {
                best = Vec3(p.x(), p.y(), z);
                normal = n;
            }
        }
        return best + more_than * normal;
    }
};

FACETMILL_TEST(TestToolRest)
#include "test_tool_rest.moc"
