// A mesh grown by a distance holds all that is nearer, and little more.
#include "core/mesh/grown.h"
#include "core/mesh/triangle_distance.h"
#include "tests/support/random_meshes.h"
#include "tests/support/test_runner.h"

#include <QTest>

#include <cmath>

using namespace facetmill;
using namespace facetmill::test;

namespace {

double distance_of(const Mesh& mesh, const Vec3& p) {
    double least = infinity;
    for (std::size_t f = 0; f < mesh.facet_count(); ++f)
        least = std::min(least, squared_distance(p, mesh.corner(f, 0), mesh.corner(f, 1), mesh.corner(f, 2)));
    return std::sqrt(least);
}

/// Parameters along a line p + t n at which it goes through a facet.
bool passes(const Mesh& mesh, const Vec3& p, const Vec3& q) {
    for (std::size_t f = 0; f < mesh.facet_count(); ++f) {
        const Vec3 &a = mesh.corner(f, 0), &b = mesh.corner(f, 1), &c = mesh.corner(f, 2),
                   n = (b - a).cross(c - a);
        const double hp = n.dot(p - a), hq = n.dot(q - a);
        if ((hp > 0) == (hq > 0) || hp == hq) continue;
        const Vec3 at = p + hp / (hp - hq) * (q - p);
        if (n.dot((b - a).cross(at - a)) >= 0 && n.dot((c - b).cross(at - b)) >= 0
            && n.dot((a - c).cross(at - c)) >= 0)
            return true;
    }
    return false;
}

} // namespace

class TestGrown : public QObject {
    Q_OBJECT
private slots:
    /// Whoever comes from outside to a place nearer than the distance goes through the grown mesh; and one
    /// who stays beyond what corners may add does not meet it.
    void nothing_comes_nearer_unseen() {
        Random rng(5);
        int near = 0, far = 0;
        for (int round = 0; round < 30; ++round) {
            const auto mesh = soup(whole(rng, 1, 6), 10, std::uint64_t(round));
            const double by = uniform(rng, 0.2, 2);
            const Mesh grown = grown_mesh(*mesh, by, {});
            for (int k = 0; k < 200; ++k) {
                const std::size_t f = std::size_t(whole(rng, 0, int(mesh->facet_count()) - 1));
                const double u = uniform(rng, 0, 1), v = uniform(rng, 0, 1 - u);
                const Vec3 on = mesh->corner(f, 0) + u * (mesh->corner(f, 1) - mesh->corner(f, 0))
                                + v * (mesh->corner(f, 2) - mesh->corner(f, 0));
                const Vec3 way =
                    Vec3(uniform(rng, -1, 1), uniform(rng, -1, 1), uniform(rng, -1, 1)).normalized();
                const Vec3 p = on + uniform(rng, 0, 3) * by * way, outside = p + 100 * way;
                const double d = distance_of(*mesh, p);
                if (d < 0.999 * by) {
                    ++near;
                    QVERIFY(passes(grown, p, outside));
                }
                // On a straight way outside all of it.
                if (mesh->facet_count() == 1 && d > 1.8 * by) {
                    ++far;
                    bool stays = true;
                    for (int s = 0; s <= 100; ++s)
                        stays = stays && distance_of(*mesh, p + 0.05 * s * way) > 1.8 * by;
                    if (stays) QVERIFY(!passes(grown, p, p + 5 * way));
                }
            }
        }
        QVERIFY(near > 500 && far > 20);
    }
};

FACETMILL_TEST(TestGrown)
#include "test_grown.moc"
