// Shapes of fixtures.
#include "core/setup/fixture.h"
#include "tests/support/test_runner.h"

#include <QTest>

#include <cmath>

using namespace facetmill;

namespace {

double volume_of(const Mesh& mesh) {
    double six = 0;
    for (std::size_t f = 0; f < mesh.facet_count(); ++f)
        six += mesh.corner(f, 0).dot(mesh.corner(f, 1).cross(mesh.corner(f, 2)));
    return six / 6;
}

} // namespace

class TestFixture : public QObject {
    Q_OBJECT
private slots:
    void a_box_stands_on_the_middle_of_its_bottom() {
        Fixture f;
        f.size = {4, 6, 10};
        f.rotate = {0, 0, radians(90)};
        f.translate = {1, 2, 3};
        const Mesh mesh = fixture_mesh(f);
        QVERIFY((mesh.box().lo - Vec3(-2, 0, 3)).norm() < 1e-12);
        QVERIFY((mesh.box().hi - Vec3(4, 4, 13)).norm() < 1e-12);
        QVERIFY(std::abs(volume_of(mesh) - 240) < 1e-9); // outward
        QVERIFY(std::abs(volume_of(fixture_mesh(f, 0.5)) - 5 * 7 * 11) < 1e-9);
        QVERIFY((fixture_mesh(f, 0.5).box().lo - Vec3(-2.5, -0.5, 2.5)).norm() < 1e-12);
    }
    void a_cylinder_holds_the_round_one() {
        Fixture f;
        f.kind = Fixture::Kind::cylinder;
        f.diameter = 8;
        f.height = 5;
        const double exact = pi * 16 * 5, made = volume_of(fixture_mesh(f));
        QVERIFY(made > exact && made < 1.002 * exact);
        for (int k = 0; k < 1000; ++k) {
            const Vec3 p(4 * std::cos(0.1 * k), 4 * std::sin(0.1 * k), 0);
            const Mesh mesh = fixture_mesh(f);
            double least = infinity;
            for (std::size_t t = 0; t < mesh.facet_count(); ++t) {
                const Vec3 n = mesh.facet_normal(t);
                if (std::abs(n.z()) < 0.5) least = std::min(least, n.dot(mesh.corner(t, 0) - p));
            }
            QVERIFY(least > -1e-12);
        }
    }
    /// Along its length it stands on the middle of its bottom; grown, it holds all that is nearer than that.
    void a_tab_stays_between_part_and_rest() {
        Fixture f;
        f.kind = Fixture::Kind::tab;
        f.size = {14, 6, 2};
        QVERIFY(std::abs(volume_of(fixture_mesh(f)) - 14 * 6 * 2) < 1e-9);
        f.shape = Fixture::TabShape::triangular;
        const Mesh plain = fixture_mesh(f);
        QVERIFY(std::abs(volume_of(plain) - 14 * 6 * 2 / 2.0) < 1e-9); // outward
        QVERIFY((plain.box().lo - Vec3(-7, -3, 0)).norm() < 1e-12);
        QVERIFY((plain.box().hi - Vec3(7, 3, 2)).norm() < 1e-12);
        const Mesh grown = fixture_mesh(f, 0.5);
        for (std::size_t t = 0; t < plain.facet_count(); ++t) {
            // Each plane of the plain one has one of the grown one half a millimetre farther out.
            const Vec3 n = plain.facet_normal(t);
            double out = -infinity;
            for (std::size_t g = 0; g < grown.facet_count(); ++g)
                if (grown.facet_normal(g).dot(n) > 1 - 1e-9) out = std::max(out, n.dot(grown.corner(g, 0)));
            QVERIFY(std::abs(out - n.dot(plain.corner(t, 0)) - 0.5) < 1e-9);
        }
        f.rotate = {0, 0, radians(90)};
        f.translate = {1, 2, 3};
        QVERIFY((fixture_mesh(f).box().lo - Vec3(-2, -5, 3)).norm() < 1e-12);
    }
    void a_mesh_is_read_elsewhere() {
        Fixture f;
        f.kind = Fixture::Kind::mesh;
        QVERIFY_EXCEPTION_THROWN(fixture_mesh(f), Error);
    }
    void every_parameter_belongs_to_a_kind() {
        for (const ParameterInfo* info : fixture_parameters().infos()) {
            int kinds = 0;
            for (const auto kind :
                 {Fixture::Kind::box, Fixture::Kind::cylinder, Fixture::Kind::mesh, Fixture::Kind::tab}) {
                const auto& keys = fixture_keys(kind);
                kinds += std::find(keys.begin(), keys.end(), info->key) != keys.end();
            }
            QVERIFY2(kinds > 0, info->key.c_str());
        }
    }
};

FACETMILL_TEST(TestFixture)
#include "test_fixture.moc"
