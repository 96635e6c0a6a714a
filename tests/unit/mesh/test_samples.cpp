// Sample parts: published poles, true distance to the surface, closed where they must be.
#include "core/mesh/bspline.h"
#include "core/mesh/sample.h"
#include "core/mesh/sample_surface.h"
#include "core/mesh/topology.h"
#include "tests/support/test_runner.h"
#include "tests/unit/mesh/shapes.h"

#include <QTest>

using namespace facetmill;
using namespace facetmill::test;

class TestSamples : public QObject {
    Q_OBJECT
private slots:

    void spline_has_its_derivatives() {
        const CubicBSpline curve({{0, 0}, {1, 2}, {3, 1}, {4, -1}, {6, 0}, {7, 3}, {9, 1}});
        QCOMPARE(curve.point(0.0), Vec2(0, 0));
        QCOMPARE(curve.point(1.0), Vec2(9, 1));
        const double h = 1e-5;
        for (double t = 0.01; t < 1.0; t += 0.0137) {
            const CurvePoint2 c = curve.evaluate(t);
            const Vec2 before = curve.point(t - h), after = curve.point(t + h);
            QVERIFY((c.d1 - (after - before) / (2 * h)).norm() < 1e-6 * c.d1.norm());
            QVERIFY((c.d2 - (after - 2 * c.point + before) / (h * h)).norm() < 1e-3);
        }
    }
};

FACETMILL_TEST(TestSamples)
#include "test_samples.moc"
