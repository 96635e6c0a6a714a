// The flat face that a facet belongs to, and its middle.
#include "core/mesh/flat_face.h"
#include "core/mesh/sample.h"
#include "tests/support/test_runner.h"

#include <QTest>

using namespace facetmill;

class TestFlatFace : public QObject {
    Q_OBJECT
private slots:
    void ends_of_turned_parts() {
        for (const char* name : {"square-prism", "cylinder", "twisted-prism"}) {
            const auto mesh = make_sample(name, 0.05, Progress());
            const double length = mesh->box().hi.x();
            std::size_t ends = 0;
            for (Index f = 0; f < mesh->facet_count(); ++f) {
                const Vec3 n = mesh->facet_normal(f);
                const std::vector<Index> face = flat_face(*mesh, f);
                QVERIFY(std::is_sorted(face.begin(), face.end()));
                QVERIFY(std::find(face.begin(), face.end(), f) != face.end());
                if (std::abs(n.x()) < 0.999) continue;
                ++ends;
                const Vec3 middle = middle_of(*mesh, face), exact(n.x() > 0 ? length : 0, 0, 0);
                QVERIFY2((middle - exact).norm() < 1e-9,
                         qPrintable(QString::number((middle - exact).norm())));
            }
            QVERIFY(ends >= 4);
        }
    }

    /// In one plane, but apart: two faces. A slanted facet ends a face.
    void faces_hang_together() {
        Mesh m;
        for (const double at : {0.0, 10.0})
            for (const Vec3& p :
                 {Vec3(0, 0, 1), Vec3(1, 0, 1), Vec3(1, 1, 1), Vec3(0, 1, 1), Vec3(2, 0, 1.5)})
                m.vertices.emplace_back(p.x() + at, p.y(), p.z());
        for (const Index first : {0u, 5u})
            for (const Facet& f : {Facet{0, 1, 2}, Facet{0, 2, 3}, Facet{1, 4, 2}})
                m.facets.push_back({f[0] + first, f[1] + first, f[2] + first});
        QCOMPARE(flat_face(m, 0), (std::vector<Index>{0, 1}));
        QCOMPARE(flat_face(m, 4), (std::vector<Index>{3, 4}));
        QCOMPARE(flat_face(m, 2), (std::vector<Index>{2}));
        QVERIFY((middle_of(m, {0, 1}) - Vec3(0.5, 0.5, 1)).norm() < 1e-15);
        // Without area it is alone, its middle that of its corners.
        m.facets.push_back({0, 0, 1});
        QCOMPARE(flat_face(m, 6), (std::vector<Index>{6}));
        QVERIFY((middle_of(m, {6}) - Vec3(1.0 / 3, 0, 1)).norm() < 1e-15);
    }
};

FACETMILL_TEST(TestFlatFace)
#include "test_flat_face.moc"
