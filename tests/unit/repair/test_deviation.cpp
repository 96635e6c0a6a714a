// Distances of surfaces: closed forms, and brute force.
#include "core/base/parallel.h"
#include "core/repair/deviation.h"
#include "tests/support/dirty_scan.h"
#include "tests/support/test_runner.h"
#include "tests/unit/mesh/shapes.h"
#include "tests/unit/repair/repair_support.h"

#include <QTest>

using namespace facetmill;
using namespace facetmill::test;

class TestSurfaceDeviation : public QObject {
    Q_OBJECT
private slots:
    void a_moved_sheet_is_as_far_as_it_moved() {
        const auto flat = [](double a, double b) { return Vec3(10 * a, 10 * b, 0.0); };
        const auto lifted = [](double a, double b) { return Vec3(10 * a, 10 * b, 0.25); };
        const Mesh sheet = grid_mesh(7, 7, false, false, 0.3, flat);
        const Mesh moved = grid_mesh(9, 5, false, false, 0.3, lifted);
        const SurfaceDeviation d = surface_deviation(sheet, moved, 1e-4, {});
        QVERIFY(std::abs(d.forward - 0.25) <= 1e-4);
        QVERIFY(std::abs(d.backward - 0.25) <= 1e-4);
    }

    void a_missing_half_is_seen_from_one_side_alone() {
        const auto whole = [](double a, double b) { return Vec3(10 * a, 10 * b, 0.0); };
        const auto half = [](double a, double b) { return Vec3(5 * a, 10 * b, 0.0); };
        const SurfaceDeviation d = surface_deviation(grid_mesh(8, 8, false, false, 0.2, whole),
                                                     grid_mesh(3, 3, false, false, 0, half), 1e-3, {});
        QVERIFY(std::abs(d.forward - 5) <= 1e-3);
        QVERIFY(d.backward <= 1e-3);
    }

    void two_spheres_are_as_far_as_their_facets_say() {
        const Mesh fine = ringed_sphere(16, 10), coarse = ringed_sphere(9, 10);
        const SurfaceDeviation d = surface_deviation(fine, coarse, 1e-3, {});
        const double brute_forward = brute_deviation(fine, coarse),
                     brute_backward = brute_deviation(coarse, fine);
        QVERIFY(d.forward >= brute_forward - 1e-9 && d.forward <= 1.15 * brute_forward + 1e-3);
        QVERIFY(d.backward >= brute_backward - 1e-9 && d.backward <= 1.15 * brute_backward + 1e-3);
    }

    void random_meshes_are_no_nearer_than_brute_force_says() {
        for (std::uint64_t seed = 1; seed <= 3; ++seed) {
            const DirtyScan a = dirty_scan(10, 0.4, 0, 1, seed), b = dirty_scan(9, 0.4, 0, 1, seed + 50);
            const SurfaceDeviation d = surface_deviation(a.mesh, b.mesh, 0.01, {});
            QVERIFY(d.forward >= brute_deviation(a.mesh, b.mesh) - 1e-9);
            QVERIFY(d.backward >= brute_deviation(b.mesh, a.mesh) - 1e-9);
        }
    }

    void the_same_mesh_is_nowhere_off_itself() {
        const DirtyScan a = dirty_scan(12, 0.4, 2, 1, 3);
        const SurfaceDeviation d = surface_deviation(a.mesh, a.mesh, 0.01, {});
        QCOMPARE(d.largest(), 0.0);
    }

    void threads_do_not_matter() {
        const DirtyScan a = dirty_scan(20, 0.4, 0, 1, 3), b = dirty_scan(21, 0.4, 0, 1, 4);
        set_thread_count(1);
        const SurfaceDeviation one = surface_deviation(a.mesh, b.mesh, 0.01, {});
        set_thread_count(3);
        const SurfaceDeviation three = surface_deviation(a.mesh, b.mesh, 0.01, {});
        set_thread_count(0);
        QCOMPARE(one.forward, three.forward);
        QCOMPARE(one.backward, three.backward);
    }
};

FACETMILL_TEST(TestSurfaceDeviation)
#include "test_deviation.moc"
