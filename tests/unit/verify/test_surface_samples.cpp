// Places at which a surface is asked: spread evenly, each standing for its share of the area, none across a
// crease.
#include "core/verify/deviation_surface.h"
#include "tests/support/part_meshes.h"
#include "tests/support/test_runner.h"

#include <QTest>

#include <algorithm>
#include <cmath>

using namespace facetmill;
using namespace facetmill::test;

namespace {

double level(double, double) {
    return 0;
}

} // namespace

class TestSurfaceSamples : public QObject {
    Q_OBJECT
private slots:
    void weights_add_up_and_points_keep_the_spacing() {
        for (const Mesh& part : {dome(10, 12), box(Vec3(0, 0, 0), Vec3(40, 3, 0.1)),
                                 height_field(level, Vec2(-20, -20), Vec2(20, 20), 100, 100)})
            for (double spacing : {5.0, 0.7, 0.2}) {
                const SurfaceSamples s = sample_surface(part, spacing, 1'000'000, Progress());
                double area = 0, sum = 0;
                for (std::size_t f = 0; f < part.facet_count(); ++f)
                    area += 0.5 * part.facet_cross(f).norm();
                for (double w : s.weights)
                    sum += w;
                QVERIFY(std::abs(sum - area) < 1e-9 * area);
                for (const auto& t : s.triangles) {
                    for (std::size_t k = 0; k < 3; ++k)
                        QVERIFY((s.points[t[k]] - s.points[t[(k + 1) % 3]]).norm() < 2.01 * spacing);
                    const Vec3 n = (s.points[t[1]] - s.points[t[0]]).cross(s.points[t[2]] - s.points[t[0]]);
                    for (auto p : t)
                        QVERIFY(n.dot(s.normals[p]) >= 0); // wound as the facets are
                }
            }
        const Mesh part = height_field(level, Vec2(-20, -20), Vec2(20, 20), 1, 1);
        const SurfaceSamples few = sample_surface(part, 0.01, 5000, Progress());
        QVERIFY(few.points.size() <= 5000 && few.points.size() > 3000);
        QVERIFY(few.spacing > 0.4);
    }

    void neither_side_of_a_crease_is_judged_across_it() {
        const Vec3 half(5, 4, 3);
        constexpr double inset = 0.1;
        // Also where no facet has to be divided.
        for (const double spacing : {100.0, 0.7}) {
            const SurfaceSamples s = sample_surface(box(-half, half), spacing, 1'000'000, Progress(), inset);
            for (std::size_t i = 0; i < s.points.size(); ++i) {
                QVERIFY(s.normals[i].cwiseAbs().maxCoeff() > 1 - 1e-12);
                Vec3 off = half - s.places[i].cwiseAbs(); // the faces of the box
                std::sort(off.begin(), off.end());
                QVERIFY(std::abs(off[0]) < 1e-12 && off[1] > 0.4 * inset);
            }
        }
    }
};

FACETMILL_TEST(TestSurfaceSamples)
#include "test_surface_samples.moc"
