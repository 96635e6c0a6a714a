// Curves in the plane against circles, squares and brute force.
#include "core/strategy/curves/plan_curve.h"
#include "tests/support/random_meshes.h"
#include "tests/support/test_runner.h"

#include <QTest>

#include <cmath>

using namespace facetmill;
using namespace facetmill::test;

namespace {

const PlanCurve square{{Vec2(0, 0), Vec2(10, 0), Vec2(10, 10), Vec2(0, 10)}, true};

PlanCurve circle(double radius, int corners) {
    PlanCurve c{{}, true};
    for (int k = 0; k < corners; ++k) {
        const double a = 2 * pi * k / corners;
        c.points.emplace_back(radius * std::cos(a), radius * std::sin(a));
    }
    return c;
}

double distance(const Vec2& p, const Vec2& a, const Vec2& b) {
    const double t = std::clamp((p - a).dot(b - a) / (b - a).squaredNorm(), 0.0, 1.0);
    return (p - a - t * (b - a)).norm();
}
double distance(const Vec2& p, const PlanCurve& c) {
    double least = infinity;
    for (std::size_t i = 0; i + (c.closed ? 0 : 1) < c.points.size(); ++i)
        least = std::min(least, distance(p, c.points[i], c.points[(i + 1) % c.points.size()]));
    return least;
}

} // namespace

class TestPlanCurve : public QObject {
    Q_OBJECT
private slots:
    void a_course_goes_by_length() {
        const CurveCourse course(square);
        QCOMPARE(course.length(), 40.0);
        QVERIFY((course.at(12) - Vec2(10, 2)).norm() < 1e-12);
        QVERIFY((course.at(-5) - Vec2(0, 5)).norm() < 1e-12 && (course.at(45) - Vec2(5, 0)).norm() < 1e-12);
        QVERIFY((course.direction(25) - Vec2(-1, 0)).norm() < 1e-12);
        const PlanLine over = course.stretch(35, 52); // over the first corner, and the second
        QCOMPARE(over.size(), std::size_t(4));
        QVERIFY((over[1] - Vec2(0, 0)).norm() < 1e-12 && (over[2] - Vec2(10, 0)).norm() < 1e-12);
        const CurveCourse open({{Vec2(0, 0), Vec2(0, 0), Vec2(3, 4)}, false});
        QCOMPARE(open.length(), 5.0);
        QVERIFY((open.at(9) - Vec2(3, 4)).norm() < 1e-12);
    }

    void beside_a_closed_curve() {
        const auto within = curves_beside(square, 2, 1e-3, {});
        QCOMPARE(within.size(), std::size_t(1));
        QVERIFY(within[0].closed);
        QVERIFY(std::abs(turned_area(within[0]) - 72) < 0.2); // 6 x 6, twice
        const auto around = curves_beside(square, -2, 1e-3, {});
        QCOMPARE(around.size(), std::size_t(1));
        QVERIFY(std::abs(0.5 * turned_area(around[0]) - (100 + 80 + pi * 4)) < 0.05);
        QVERIFY(curves_beside(square, 6, 1e-3, {}).empty());
        const auto ring = curves_beside(circle(10, 200), 4, 1e-3, {});
        QCOMPARE(ring.size(), std::size_t(1));
        for (const Vec2& p : ring[0].points)
            QVERIFY(std::abs(p.norm() - 6) < 5e-3);
    }

    /// Of any line: nowhere nearer than asked, and every place at that distance to that side is near to it.
    void beside_any_line() {
        for (std::uint64_t seed = 0; seed < 30; ++seed) {
            Random rng(seed);
            PlanCurve line{{Vec2(0, 0)}, false};
            double angle = 0;
            for (int k = 0; k < 12; ++k) {
                angle += uniform(rng, -1.2, 1.2);
                line.points.emplace_back(line.points.back()
                                         + uniform(rng, 0.5, 4) * Vec2(std::cos(angle), std::sin(angle)));
            }
            const double left = uniform(rng, 0.3, 2) * (seed % 2 == 0 ? 1 : -1), detail = 1e-3;
            const auto beside = curves_beside(line, left, detail, {});
            for (const PlanCurve& c : beside) {
                const CurveCourse course(c);
                for (double s = 0; s < course.length(); s += 0.05) {
                    const double d = distance(course.at(s), line);
                    // Where two pieces meet at an inner corner the straight way between their ends is short.
                    QVERIFY2(d > std::abs(left) - 0.05 && d < std::abs(left) + 0.01,
                             qPrintable(QString("%1: %2 of %3").arg(seed).arg(d).arg(left)));
                }
            }
            // The foot of the line's own middles, where nothing else is nearer, lies on one of them.
            for (std::size_t i = 0; i + 1 < line.points.size(); ++i) {
                const Vec2 d = (line.points[i + 1] - line.points[i]).normalized();
                const Vec2 p = 0.5 * (line.points[i] + line.points[i + 1]) + left * Vec2(-d.y(), d.x());
                if (distance(p, line) < std::abs(left) - 1e-9) continue;
                double least = infinity;
                for (const PlanCurve& c : beside)
                    least = std::min(least, distance(p, c));
                QVERIFY2(least < 0.02, qPrintable(QString("%1: %2").arg(seed).arg(least)));
            }
        }
    }

    void loose_edges_are_joined() {
        std::vector<PlanEdge> edges;
        for (const PlanCurve& c : {square, circle(3, 7)})
            for (std::size_t i = 0; i < c.points.size(); ++i) {
                const Vec2 a = c.points[i], b = c.points[(i + 1) % c.points.size()];
                edges.push_back(i % 2 == 0 ? PlanEdge{a, b} : PlanEdge{b, a});
            }
        edges.push_back({Vec2(20, 0), Vec2(21, 0)});
        edges.push_back({Vec2(20, 0), Vec2(20, 5)});
        const auto curves = joined_loops(edges);
        QCOMPARE(curves.size(), std::size_t(3));
        QVERIFY(curves[0].closed && curves[1].closed && !curves[2].closed);
        QCOMPARE(turned_area(curves[0]), 200.0);
        QCOMPARE(curves[1].points.size(), std::size_t(7));
        QVERIFY(turned_area(curves[1]) > 0);
        QCOMPARE(curves[2].points.size(), std::size_t(3));
        QVERIFY(turned_area(reversed(curves[0])) < 0);
    }

    void crossings_are_found() {
        const PlanLine a{Vec2(0, 0), Vec2(4, 0), Vec2(4, 4)}, b{Vec2(2, 3), Vec2(6, 3)},
            c{Vec2(0, 1), Vec2(3, 1)};
        const auto at = crossing_of(a, b, {});
        QVERIFY(at && (*at - Vec2(4, 3)).norm() < 1e-12);
        QVERIFY(!crossing_of(a, c, {}));
    }
};

FACETMILL_TEST(TestPlanCurve)
#include "test_plan_curve.moc"
