// The kernels for the several instruction sets give the same bits, at any axis and with any hint.
#include "core/cutter/cutter.h"
#include "core/gouge/axial_kernel.h"
#include "core/gouge/contact_impl.h"
#include "core/gouge/lower_surface.h"
#include "tests/support/test_runner.h"
#include "tests/unit/gouge/lift_cases.h"

#include <QTest>

#include <cstring>

using namespace facetmill;
using namespace facetmill::test;

class TestKernelSets : public QObject {
    Q_OBJECT
private slots:
    void same_bits() {
        const AxialKernels* sets[4];
        const int count = axial_kernel_sets(sets);
        QVERIFY(count >= 1);
        QCOMPARE(sets[0]->name, "baseline");
        Random rng(21);
        const auto mesh = field(
            40, 40, [](double x, double y) { return 3 * std::sin(0.3 * x) * std::cos(0.4 * y); }, 0.3);
        const ContactIndex index(mesh, Progress());
        const IndexView view = index.impl().view();
        int met = 0;
        for (int i = 0; i < 20000; ++i) {
            const SurfaceTable surface =
                lower_surface(CutterProfile(random_cutter(rng, i, uniform(rng, 1, 12))));
            const Vec3 axis =
                Vec3(uniform(rng, -1, 1), uniform(rng, -1, 1), uniform(rng, 0.1, 1)).normalized();
            const Vec3 u = axis.unitOrthogonal(), v = axis.cross(u);
            AxialQuery query;
            for (int k = 0; k < 3; ++k) {
                query.frame[0][k] = u[k];
                query.frame[1][k] = v[k];
                query.frame[2][k] = axis[k];
                query.place[k] = k < 2 ? uniform(rng, -5, 45) : 0;
            }
            AxialAnswer first[2];
            for (int set = 0; set < count; ++set)
                for (const bool hinted : {false, true}) {
                    query.hint =
                        hinted ? std::uint32_t(whole(rng, 0, int(mesh->facet_count()) - 1)) : no_slot;
                    AxialAnswer upright, tilted;
                    sets[set]->upright(view, surface, query, upright);
                    sets[set]->tilted(view, surface, query, tilted);
                    if (set == 0 && !hinted) {
                        first[0] = upright;
                        first[1] = tilted;
                        met += upright.slot != no_slot;
                    }
                    QVERIFY(std::memcmp(&upright.tip, &first[0].tip, sizeof(double)) == 0);
                    QVERIFY(std::memcmp(&tilted.tip, &first[1].tip, sizeof(double)) == 0);
                }
        }
        QVERIFY(met > 10000);
    }
};

FACETMILL_TEST(TestKernelSets)
#include "test_kernel_sets.moc"
