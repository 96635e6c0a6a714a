// The distance from the facets of an index against that from all of them.
#include "core/gouge/part_distance.h"
#include "core/mesh/triangle_distance.h"
#include "tests/support/random_meshes.h"
#include "tests/support/test_runner.h"
#include "tests/support/trials.h"

#include <QTest>

using namespace facetmill;
using namespace facetmill::test;

class TestPartDistance : public QObject {
    Q_OBJECT
private slots:

    void is_that_of_the_nearest_facet() {
        const auto askew = needles_askew(100, 10); // listed in pieces
        const auto far_away = field(20, 10, [](double x, double y) { return 1e4 + std::sin(x + 2 * y); });
        for (Vec3& v : far_away->vertices)
            v += Vec3(2e4, -3e4, 0);
        for (const MeshPtr& mesh :
             {MeshPtr(soup(1, 10, 1)), MeshPtr(soup(300, 10, 2)), MeshPtr(askew), MeshPtr(far_away)}) {
            const ContactIndex index(mesh, Progress());
            const Box3 box = mesh->box();
            Random rng(3);
            for (int trial = 0; trial < trials(300, 30); ++trial) {
                Vec3 p;
                for (int k = 0; k < 3; ++k)
                    p[k] = uniform(rng, box.lo[k] - 5, box.hi[k] + 5);
                double square = infinity;
                for (std::size_t f = 0; f < mesh->facet_count(); ++f)
                    square = std::min(square, squared_distance(p, mesh->corner(f, 0), mesh->corner(f, 1),
                                                               mesh->corner(f, 2)));
                const double distance = std::sqrt(square), noise = 1e-12 * box.hi.cwiseAbs().maxCoeff();
                QVERIFY(std::abs(part_distance(index, p) - distance) <= noise);
                QVERIFY(std::abs(part_distance(index, p, 1.01 * distance) - distance) <= noise);
                QCOMPARE(part_distance(index, p, 0.99 * distance), 0.99 * distance);
            }
        }
        QCOMPARE(part_distance(ContactIndex(std::make_shared<Mesh>(), Progress()), Vec3::Zero(), 7), 7.0);
    }
};

FACETMILL_TEST(TestPartDistance)
#include "test_part_distance.moc"
