// What a recipe does, as the view shows it: how far the surface moved and to which side, what is new, what
// went.
#include "tests/support/part_meshes.h"
#include "tests/support/test_runner.h"
#include "viz/repair_display.h"

#include <QTest>

#include <algorithm>
#include <cmath>

using namespace facetmill;
using namespace facetmill::test;

namespace {

MeshPtr sheet(double z, int n = 10) {
    return std::make_shared<Mesh>(
        height_field([z](double, double) { return z; }, Vec2(0, 0), Vec2(n, n), n, n));
}

MeshPtr both(const Mesh& a, const Mesh& b) {
    auto mesh = std::make_shared<Mesh>(a);
    append_mesh(*mesh, b);
    return mesh;
}

RepairDisplayPtr display(const RepairedSurfaces& surfaces, const PlaceMesh& place = {}) {
    return prepare_repair_display(surfaces,
                                  place ? place : [](const MeshPtr& mesh, const Progress&) { return mesh; },
                                  LengthUnit::mm, {});
}

std::size_t count(const std::vector<char>& marks) {
    return std::size_t(std::count(marks.begin(), marks.end(), char(1)));
}

} // namespace

class TestRepairDisplay : public QObject {
    Q_OBJECT
private slots:
    void outward_is_positive() {
        for (const double by : {0.25, -0.25}) {
            const RepairDisplayPtr moved = display({sheet(1), sheet(1 + by), {}, 0.25});
            QVERIFY(!moved->added && !moved->removed);
            QVERIFY(std::abs(moved->largest - 0.25) < 1e-9);
            for (const float d : moved->displacement)
                QVERIFY(std::abs(double(d) - by) < 1e-6);
            QVERIFY(moved->scale.high >= 0.25 && moved->scale.high <= 0.5);
            QCOMPARE(moved->scale.low, -moved->scale.high);
            QCOMPARE(moved->colors.size(), 4 * moved->displacement.size());
        }
        const RepairDisplayPtr same = display({sheet(1), sheet(1), {}, 0});
        QCOMPARE(same->largest, 0.0);
    }

    /// What went is told from what was moved: by how far it lies from all that is there afterwards.
    void what_went_and_what_is_new() {
        const MeshPtr low = sheet(0), all = both(*low, *sheet(5, 2));
        const RepairDisplayPtr gone = display({all, low, {}, 0});
        QVERIFY(gone->removed && !gone->added);
        QCOMPARE(gone->removed->mesh->facet_count(), std::size_t(8));
        QCOMPARE(gone->before->mesh->facet_count(), std::size_t(208));
        QVERIFY(!display({all, both(*sheet(0.1), *sheet(5.1, 2)), {}, 0.1})->removed);

        std::vector<char> added = new_surface(*low, {}, *all, true, {});
        QCOMPARE(count(added), std::size_t(8));
        QCOMPARE(count(new_surface(*low, {}, *all, false, {})), std::size_t(0));
        const RepairDisplayPtr made = display({low, all, added, 0});
        QVERIFY(made->added && !made->removed);
        QCOMPARE(made->added->mesh->facet_count(), std::size_t(8));
        QCOMPARE(made->kept->mesh->facet_count(), std::size_t(200));
        QCOMPARE(made->largest, 0.0);
        // It stays new when a later step moves it.
        const MeshPtr later = both(*sheet(0.1), *sheet(5.1, 2));
        QCOMPARE(count(new_surface(*all, added, *later, false, {})), std::size_t(8));
    }

    /// Distances are those of the file, whatever becomes of the part in the view.
    void it_stands_where_the_part_stands() {
        const auto place = [](const MeshPtr& mesh, const Progress&) -> MeshPtr {
            auto moved = std::make_shared<Mesh>(*mesh);
            for (Vec3& v : moved->vertices)
                v = 2 * v + Vec3(100, 0, 0);
            return moved;
        };
        const RepairDisplayPtr moved = display({sheet(1), sheet(1.25), {}, 0.25}, place);
        QVERIFY(std::abs(moved->largest - 0.25) < 1e-9);
        QVERIFY((moved->kept->box.lo - Vec3(100, 0, 2.5)).norm() < 1e-9);
        QVERIFY((moved->before->box.hi - Vec3(120, 20, 2)).norm() < 1e-9);
    }
};

FACETMILL_TEST(TestRepairDisplay)
#include "test_repair_display.moc"
