// Divided meshes: the surface stays as it is, what is closed stays closed, and what is carried over is what
// lies there.
#include "core/mesh/refine.h"
#include "core/mesh/sample.h"
#include "tests/property/shapes.h"
#include "tests/support/error_code.h"
#include "tests/support/test_runner.h"

#include <QTest>

#include <cmath>
#include <random>

using namespace facetmill;
using namespace facetmill::test;

namespace {

double area(const Mesh& m) {
    double sum = 0;
    for (std::size_t f = 0; f < m.facets.size(); ++f)
        sum += 0.5 * m.facet_cross(f).norm();
    return sum;
}

double loop_length(const std::vector<Vec3>& loop) {
    double sum = 0;
    for (std::size_t i = 0; i < loop.size(); ++i)
        sum += (loop[(i + 1) % loop.size()] - loop[i]).norm();
    return sum;
}

} // namespace

class TestRefine : public QObject {
    Q_OBJECT
private slots:
    void facets_are_divided_where_wanted() {
        for (const Mesh& part : {box(Vec3(-20, -15, 0), Vec3(20, 15, 8)), dome(12, 6), mixed()}) {
            const auto wanted = [](const std::array<Vec3, 3>& p) { return (p[0] + p[1] + p[2]).x() / 3 < 2; };
            const DerivedMesh d = refined(part, wanted, 1.0, 1'000'000, Progress());
            QVERIFY(std::abs(area(d.mesh) - area(part)) < 1e-9 * area(part));
            QCOMPARE(border_loops(d.mesh).size(), border_loops(part).size());
            QCOMPARE(d.mesh.vertices.size(), d.kept + d.added.size());
            QCOMPARE(d.facet_of.size(), d.mesh.facets.size());
            std::size_t divided_facets = 0;
            for (std::size_t f = 0; f < d.mesh.facets.size(); ++f) {
                const std::array<Vec3, 3> p{d.mesh.corner(f, 0), d.mesh.corner(f, 1), d.mesh.corner(f, 2)};
                QVERIFY(d.mesh.facet_normal(f).dot(part.facet_normal(d.facet_of[f])) > 1 - 1e-9);
                if (!wanted(p)) continue;
                ++divided_facets;
                for (std::size_t k = 0; k < 3; ++k)
                    QVERIFY((p[(k + 1) % 3] - p[k]).norm() <= 1.0 + 1e-12);
            }
            QVERIFY(divided_facets > 200);
            for (std::size_t i = 0; i < d.added.size(); ++i) {
                const Between& v = d.added[i];
                QVERIFY(v.a < d.kept + i && v.b < d.kept + i);
                const Vec3 there = (1 - v.t) * d.mesh.vertices[v.a] + v.t * d.mesh.vertices[v.b];
                QVERIFY((there - d.mesh.vertices[d.kept + i]).norm() < 1e-12);
            }
        }
        QCOMPARE(code_of([] {
                     refined(
                         dome(12, 6), [](const auto&) { return true; }, 0.01, 1000, Progress());
                 }),
                 std::string("limit_exceeded"));
        // Nothing wanted: nothing changes.
        const Mesh part = mixed();
        QVERIFY(refined(
                    part, [](const auto&) { return false; }, 0.01, 10, Progress())
                    .mesh.facets
                == part.facets);
    }

    void whoever_asks_slowly_can_be_cancelled() {
        Job job;
        int asked = 0;
        const auto wanted = [&](const std::array<Vec3, 3>&) {
            job.cancel();
            return ++asked > 0;
        };
        const Mesh part = shapes().front().mesh;
        QVERIFY(part.facet_count() > 1);
        QVERIFY_EXCEPTION_THROWN(refined(part, wanted, 1e-3, 1'000'000, Progress(job)), Cancelled);
        QCOMPARE(asked, 1);
    }

    void a_circle_is_cut_out() {
        const Mesh plane =
            height_field([](double x, double) { return 0.2 * x; }, Vec2(-10, -10), Vec2(10, 10), 100, 100);
        std::vector<double> value;
        for (const Vec3& v : plane.vertices)
            value.push_back(std::hypot(v.x(), v.y()) - 6.03);
        const DividedMesh cut = divided(plane, value);
        std::vector<Index> inside, outside;
        for (std::size_t f = 0; f < cut.inside.size(); ++f)
            (cut.inside[f] ? inside : outside).push_back(Index(f));
        const PartOfMesh in = part_of(cut.derived.mesh, inside), out = part_of(cut.derived.mesh, outside);
        QVERIFY(std::abs(area(in.mesh) + area(out.mesh) - area(plane)) < 1e-9);
        const double slanted = std::hypot(1, 0.2);
        QVERIFY(std::abs(area(in.mesh) - slanted * pi * 6.03 * 6.03) < 0.003 * area(in.mesh));
        const auto loops = border_loops(in.mesh);
        QCOMPARE(loops.size(), std::size_t(1));
        QCOMPARE(border_loops(out.mesh).size(), std::size_t(2));
        for (const Vec3& p : loops[0])
            QVERIFY(std::abs(std::hypot(p.x(), p.y()) - 6.03) < 0.01);
        QVERIFY(std::abs(loop_length(loops[0]) - 38.27) < 0.2);
        for (const Facet& f : in.mesh.facets)
            for (const Index v : f)
                QVERIFY(in.mesh.vertices[v] == cut.derived.mesh.vertices[in.vertex_of[v]]);
    }

    void pieces_are_counted() {
        Mesh two = box(Vec3(0, 0, 0), Vec3(1, 1, 1));
        const Mesh other = box(Vec3(3, 0, 0), Vec3(4, 1, 1));
        for (const Facet& f : other.facets)
            two.facets.push_back({f[0] + 8, f[1] + 8, f[2] + 8});
        two.vertices.insert(two.vertices.end(), other.vertices.begin(), other.vertices.end());
        std::vector<Index> all;
        for (std::size_t f = two.facets.size(); f-- > 0;)
            all.push_back(Index(f));
        std::size_t count = 0;
        const auto piece = connected_pieces(two, all, count);
        QCOMPARE(count, std::size_t(2));
        for (std::size_t i = 0; i < all.size(); ++i)
            QCOMPARE(piece[i], std::size_t(all[i] >= 12 ? 0 : 1));
        QVERIFY(border_loops(two).empty());
        all.resize(1);
        connected_pieces(two, all, count);
        QCOMPARE(count, std::size_t(1));
    }

    /// On a sphere normals and curvatures are known everywhere.
    void what_is_known_of_vertices_is_carried_over() {
        const double r = 30;
        const Mesh cap = height_field([r](double x, double y) { return std::sqrt(r * r - x * x - y * y); },
                                      Vec2(-10, -10), Vec2(10, 10), 12, 12);
        const auto normals = vertex_normals(cap, NormalWeight::angle, Progress());
        const auto curvatures = vertex_curvatures(cap, normals, Progress());
        const DerivedMesh d = refined(
            cap, [](const auto&) { return true; }, 0.5, 1'000'000, Progress());
        const auto n = carried_normals(d, normals);
        const auto c = carried_curvatures(d, curvatures, n);
        QCOMPARE(n.size(), d.mesh.vertices.size());
        QCOMPARE(c.size(), n.size());
        std::size_t judged = 0;
        for (std::size_t v = 0; v < n.size(); ++v) {
            const Vec3& p = d.mesh.vertices[v];
            if (std::abs(p.x()) > 6 || std::abs(p.y()) > 6) continue;
            ++judged;
            QVERIFY(n[v].dot(p.normalized()) > 1 - 1e-5);
            QVERIFY(std::abs(n[v].norm() - 1) < 1e-9);
            QVERIFY(std::abs(c[v].k1 - 1 / r) < 0.01 / r && std::abs(c[v].k2 - 1 / r) < 0.01 / r);
        }
        QVERIFY(judged > 300);
    }

    void the_directions_of_a_cylinder_are_kept() {
        const double r = 20;
        const Mesh trough = height_field([r](double x, double) { return -std::sqrt(r * r - x * x); },
                                         Vec2(-8, -8), Vec2(8, 8), 16, 16);
        const auto normals = vertex_normals(trough, NormalWeight::angle, Progress());
        const DerivedMesh d = refined(
            trough, [](const auto&) { return true; }, 0.6, 1'000'000, Progress());
        const auto n = carried_normals(d, normals);
        const auto c = carried_curvatures(d, vertex_curvatures(trough, normals, Progress()), n);
        for (std::size_t v = 0; v < n.size(); ++v) {
            const Vec3& p = d.mesh.vertices[v];
            if (std::abs(p.x()) > 5 || std::abs(p.y()) > 5) continue;
            QVERIFY(std::abs(c[v].k1) < 0.02 / r && std::abs(c[v].k2 + 1 / r) < 0.02 / r);
            QVERIFY(std::abs(c[v].direction1.y()) > 0.999 && std::abs(c[v].direction2.y()) < 0.03);
        }
    }
};

FACETMILL_TEST(TestRefine)
#include "test_refine.moc"
