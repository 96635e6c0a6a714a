// Convex hulls, held against what a hull is: closed, around all points, made of them.
#include "core/mesh/convex_hull.h"
#include "tests/support/test_runner.h"

#include <QTest>

#include <cmath>
#include <map>
#include <random>

using namespace facetmill;

namespace {

/// What is wrong with a hull as that of a body; empty: nothing.
QString fault(const ConvexHull& hull, const std::vector<Vec3>& points) {
    if (hull.dimension != 3) return QStringLiteral("no body");
    std::map<std::pair<Index, Index>, int> sides;
    double volume = 0;
    for (const Facet& f : hull.facets) {
        const Vec3 &a = points[f[0]], &b = points[f[1]], &c = points[f[2]];
        const Vec3 n = (b - a).cross(c - a);
        if (!(n.norm() > 0)) return QStringLiteral("a facet without area");
        const double longest = std::max({(b - a).norm(), (c - b).norm(), (a - c).norm()});
        for (const Vec3& p : points) // the plane of a tiny facet tells nothing of what is far away
            if (n.norm() > 1e-3 * longest && n.normalized().dot(p - a) > 1e-6)
                return QStringLiteral("a point %1 outside").arg(n.normalized().dot(p - a));
        for (std::size_t k = 0; k < 3; ++k)
            ++sides[{f[k], f[(k + 1) % 3]}];
        volume += a.dot(b.cross(c));
    }
    for (const auto& [side, count] : sides)
        if (count != 1 || !sides.contains({side.second, side.first})) return QStringLiteral("not closed");
    std::mt19937 random(11);
    std::normal_distribution<double> any;
    for (int i = 0; i < 50; ++i) {
        const Vec3 d = Vec3(any(random), any(random), any(random)).normalized();
        double all = -infinity, corners = -infinity;
        for (const Vec3& p : points)
            all = std::max(all, d.dot(p));
        for (const Facet& f : hull.facets)
            for (const Index v : f)
                corners = std::max(corners, d.dot(points[v]));
        if (all - corners > 1e-8) return QStringLiteral("a corner is missing");
    }
    return volume > 0 ? QString() : QStringLiteral("inside out");
}

} // namespace

class TestConvexHull : public QObject {
    Q_OBJECT
private slots:
    void random_and_degenerate_points() {
        std::mt19937 random(7);
        std::uniform_real_distribution<double> u(-1, 1);
        for (int trial = 0; trial < 60; ++trial) {
            std::vector<Vec3> points;
            for (int i = 0; i < 150; ++i) {
                Vec3 p(u(random), u(random), u(random));
                switch (trial % 6) {
                case 0: // on a sphere: all are corners
                    p.normalize();
                    break;
                case 1: // a lattice: most lie in planes and on lines
                    p = (3 * p).array().round();
                    break;
                case 2: // an STL's: on a cylinder, in single precision
                    p = rounded_to_float(Vec3(std::cos(9 * p.x()), std::sin(9 * p.x()), p.y() > 0 ? 1 : -1));
                    break;
                case 3: // flat, and far away
                    p = Vec3(100 * p.x(), 100 * p.y(), 0.01 * p.z()) + Vec3(5000, 0, 0);
                    break;
                case 4: // heaps
                    p = 1e-9 * p + Vec3((i % 5) - 2, (i % 3) - 1, i % 2);
                    break;
                default:
                    break;
                }
                points.push_back(p);
            }
            const QString wrong = fault(convex_hull(points, Progress()), points);
            QVERIFY2(wrong.isEmpty(), qPrintable(QStringLiteral("%1: %2").arg(trial).arg(wrong)));
        }
    }

    void a_cube_has_twelve_facets() {
        std::vector<Vec3> points;
        for (int i = 0; i < 27; ++i)
            points.emplace_back(i % 3, i / 3 % 3, i / 9);
        const ConvexHull hull = convex_hull(points, Progress());
        double area = 0;
        for (const Facet& f : hull.facets)
            area += 0.5 * (points[f[1]] - points[f[0]]).cross(points[f[2]] - points[f[0]]).norm();
        QVERIFY(std::abs(area - 24) < 1e-9);
    }

    void points_that_make_no_body() {
        QCOMPARE(convex_hull({}, Progress()).dimension, 0);
        QCOMPARE(convex_hull({Vec3(1, 2, 3), Vec3(1, 2, 3)}, Progress()).dimension, 0);
        QCOMPARE(convex_hull({Vec3(0, 0, 0), Vec3(1, 1, 1), Vec3(3, 3, 3)}, Progress()).dimension, 1);
        const std::vector<Vec3> flat{Vec3(0, 0, 1), Vec3(2, 0, 1), Vec3(1, 0, 1),
                                     Vec3(2, 2, 1), Vec3(0, 2, 1), Vec3(1, 1, 1)};
        const ConvexHull hull = convex_hull(flat, Progress());
        QCOMPARE(hull.dimension, 2);
        QCOMPARE(hull.outline.size(), std::size_t(4));
        Vec3 turn = Vec3::Zero();
        for (std::size_t i = 0; i < 4; ++i)
            turn += flat[hull.outline[i]].cross(flat[hull.outline[(i + 1) % 4]]);
        QVERIFY(turn.dot(hull.normal) > 0);
    }
};

FACETMILL_TEST(TestConvexHull)
#include "test_convex_hull.moc"
