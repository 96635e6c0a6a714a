// The kernels for the several instruction sets give the same bits, at any axis and with any hint.
#include "core/cutter/cutter.h"
#include "core/gouge/axial_kernel.h"
#include "core/gouge/contact_impl.h"
#include "core/gouge/lower_surface.h"
#include "tests/support/test_runner.h"
#include "tests/support/trials.h"
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
        for (int i = 0; i < trials(20000); ++i) {
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
        QVERIFY(met > trials(10000));
    }

    /// The lifts over a packet are those of its places one by one, over smooth and over ill-shaped facets.
    void packets_give_the_bits_of_single_queries() {
        const AxialKernels* sets[4];
        const int count = axial_kernel_sets(sets);
        Random rng(22);
        const auto hills = [](double x, double y) { return 3 * std::sin(0.3 * x) * std::cos(0.4 * y); };
        const auto steps = [](double x, double y) { return 4 * std::floor(x / 7) + (y > 20 ? 15 : 0); };
        auto far = field(30, 40, hills, 0.3);
        for (Vec3& v : far->vertices)
            v += Vec3(1e5, -3e4, 2e4);
        auto thin = field(30, 40, [](double, double y) { return 3 * std::sin(0.3 * y); });
        for (Vec3& v : thin->vertices)
            v.x() *= 1e-4;
        const auto slope = [](double x, double) { return 0.3 * x; };
        const auto slivers = field(60, 40, slope, 0.5, 7);
        int met = 0;
        for (const auto& mesh : {field(40, 40, hills, 0.3), field(200, 40, hills, 0.3), field(40, 40, steps),
                                 soup(400, 40, 3), far, thin, slivers}) {
            const ContactIndex index(mesh, Progress());
            const IndexView view = index.impl().view();
            const Box3 box = mesh->box();
            const auto prepared = std::make_unique<PreparedBlocks>();
            for (int i = 0; i < trials(3000); ++i) {
                const AptCutter cutter = random_cutter(rng, i, uniform(rng, 1, 12));
                const SurfaceTable surface =
                    lower_surface(CutterProfile(cutter).grown(i % 3 ? 0 : uniform(rng, 0, 2)));
                const double spread = surface.max_radius * std::pow(10.0, uniform(rng, -5, 0));
                AxialPacket packet;
                const int places = whole(rng, 1, AxialPacket::max_places);
                packet.cut = view.nodes;
                packet.cut_nodes = 1;
                Vec2 at(uniform(rng, box.lo.x() - 3, box.hi.x() + 3),
                        uniform(rng, box.lo.y() - 3, box.hi.y() + 3));
                if (i % 4 == 0)
                    at = mesh->vertices[std::size_t(whole(rng, 0, int(mesh->vertices.size()) - 1))].head<2>();
                for (int k = 0; k < places; ++k) {
                    packet.x[k] = at.x() + (k > 0 ? uniform(rng, 0, spread) : 0);
                    packet.y[k] = at.y() + (k > 0 ? uniform(rng, 0, spread) : 0);
                }
                AxialAnswer one[AxialPacket::max_places];
                for (int k = 0; k < places; ++k) {
                    AxialQuery query;
                    query.place[0] = packet.x[k];
                    query.place[1] = packet.y[k];
                    sets[0]->upright(view, surface, query, one[k]);
                }
                for (int set = 0; set < count; ++set) {
                    AxialPacketAnswer answer;
                    prepared->clear();
                    packet.prepared = prepared.get();
                    packet.count = std::min(places, sets[set]->packet_places);
                    sets[set]->packet(view, surface, packet, answer);
                    for (int k = 0; k < packet.count; ++k) {
                        QVERIFY2(std::memcmp(&one[k].tip, &answer.tips[k], sizeof(double)) == 0,
                                 qPrintable(QString("%1 %2").arg(one[k].tip).arg(answer.tips[k])));
                        QCOMPARE(answer.touched[k] == no_slot, one[k].slot == no_slot);
                        if (answer.touched[k] == no_slot) continue;
                        // The facet that the packet names is as high by itself.
                        AxialQuery query;
                        query.place[0] = packet.x[k];
                        query.place[1] = packet.y[k];
                        query.hint = answer.touched[k];
                        AxialAnswer touched;
                        sets[set]->touch(view, surface, query, touched);
                        QVERIFY(std::memcmp(&one[k].tip, &touched.tip, sizeof(double)) == 0);
                        met += one[k].slot != no_slot;
                    }
                }
            }
        }
        QVERIFY(met > trials(50000));
    }
};

FACETMILL_TEST(TestKernelSets)
#include "test_kernel_sets.moc"
