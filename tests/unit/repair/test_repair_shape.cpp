// Smoothing, decimating, needles, cuts, sheets made solid: within their bounds by brute force.
#include "core/repair/crossings.h"
#include "core/repair/needles.h"
#include "tests/support/dirty_scan.h"
#include "tests/support/test_runner.h"
#include "tests/unit/mesh/shapes.h"
#include "tests/unit/repair/repair_support.h"

#include <QTest>

using namespace facetmill;
using namespace facetmill::test;

namespace {

using Kind = RepairStep::Kind;

RepairStep bounded(Kind kind, double bound) {
    RepairStep step{.kind = kind};
    step.bound = bound;
    return step;
}

RepairStep plane(const Vec3& normal, double offset, bool close = true) {
    RepairStep step{.kind = Kind::cut};
    step.normal = {normal.x(), normal.y(), normal.z()};
    step.offset = offset;
    step.close = close;
    return step;
}

/// A cube whose sides are grids of facets.
Mesh gridded_cube(int n, double size) {
    Mesh cube;
    for (int axis = 0; axis < 3; ++axis)
        for (const double at : {0.0, size}) {
            const bool outward = at > 0;
            cube = welded(cube, grid_mesh(n, n, false, false, 0, [&](double a, double b) {
                              if (!outward) std::swap(a, b);
                              Vec3 p;
                              p[axis] = at;
                              p[(axis + 1) % 3] = size * a;
                              p[(axis + 2) % 3] = size * b;
                              return p;
                          }));
        }
    return cube;
}

double root_mean_square(const std::vector<Vec3>& vertices, double radius) {
    double sum = 0;
    for (const Vec3& p : vertices)
        sum += (p.norm() - radius) * (p.norm() - radius);
    return std::sqrt(sum / double(vertices.size()));
}

} // namespace

class TestRepairShape : public QObject {
    Q_OBJECT
private slots:
    void noise_goes_within_the_bound() {
        Random rng(3);
        Mesh sphere = ringed_sphere(40, 30);
        for (Vec3& p : sphere.vertices)
            p *= 1 + uniform(rng, -0.05, 0.05) / 30;
        const Repaired r = repaired(sphere, {bounded(Kind::smooth, 0.06)});
        QVERIFY(r.steps[0].displacement <= 0.06);
        for (std::size_t v = 0; v < sphere.vertices.size(); ++v)
            QVERIFY((r.mesh->vertices[v] - sphere.vertices[v]).norm() <= 0.06);
        QVERIFY(r.mesh->facets == sphere.facets);
        const double before = root_mean_square(sphere.vertices, 30),
                     after = root_mean_square(r.mesh->vertices, 30);
        // Waves longer than about six edges are taken for the shape and stay: 0.39 is measured.
        QVERIFY2(after < 0.45 * before, qPrintable(QString("%1 %2").arg(before).arg(after)));
    }

    void a_clean_cube_is_left_to_the_last_bit() {
        const Mesh cube = gridded_cube(6, 20);
        const Repaired r = repaired(cube, {bounded(Kind::smooth, 0.5)});
        QVERIFY(equal_meshes(*r.mesh, cube));
        QCOMPARE(r.steps[0].displacement, 0.0);
    }

    void edges_stay_sharp_where_noise_goes() {
        Random rng(4);
        const Mesh clean = gridded_cube(16, 20);
        Mesh cube = clean;
        for (Vec3& p : cube.vertices)
            p += Vec3(uniform(rng, -0.06, 0.06), uniform(rng, -0.06, 0.06), uniform(rng, -0.06, 0.06));
        const Repaired r = repaired(cube, {bounded(Kind::smooth, 0.2)});
        double corner = infinity, before = 0, after = 0;
        for (std::size_t v = 0; v < clean.vertices.size(); ++v) {
            corner = std::min(corner, (r.mesh->vertices[v] - Vec3(20, 20, 20)).norm());
            before += std::pow(brute_distance(cube.vertices[v], cube_mesh(20)), 2);
            after += std::pow(brute_distance(r.mesh->vertices[v], cube_mesh(20)), 2);
        }
        // The corner, where three edges meet, stays where the noise has put it: by 0.06 along each axis.
        QVERIFY2(corner <= 0.06 * std::sqrt(3.0), qPrintable(QString::number(corner)));
        // Of squares: 0.135 is measured.
        QVERIFY2(after < 0.2 * before, qPrintable(QString("%1 %2").arg(before).arg(after)));
    }

    void borders_of_a_sheet_stay() {
        const Mesh sheet = grid_mesh(12, 12, false, false, 0.3, [](double a, double b) {
            return Vec3(20 * a, 20 * b, 0.3 * std::sin(40 * a) * std::sin(50 * b));
        });
        const Repaired r = repaired(sheet, {bounded(Kind::smooth, 0.3)});
        for (std::size_t v = 0; v < sheet.vertices.size(); ++v) {
            const std::size_t i = v % 13, j = v / 13;
            if (i == 0 || j == 0 || i == 12 || j == 12) QVERIFY(r.mesh->vertices[v] == sheet.vertices[v]);
        }
    }

    void decimated_bodies_stay_within_the_bound() {
        for (std::uint64_t seed = 1; seed <= 3; ++seed) {
            const DirtyScan scan = dirty_scan(14, 0.05, 0, 0, seed);
            RepairStep step = bounded(Kind::decimate, 0.4);
            step.share = seed % 2 ? 0.4 : 0;
            const Repaired r = repaired(scan.mesh, {step});
            QVERIFY(r.mesh->facet_count() < scan.mesh.facet_count());
            if (seed % 2) QVERIFY(double(r.mesh->facet_count()) >= 0.4 * double(scan.mesh.facet_count()) - 2);
            const double off =
                std::max(brute_deviation(scan.mesh, *r.mesh), brute_deviation(*r.mesh, scan.mesh));
            QVERIFY2(off <= 0.4, qPrintable(QString::number(off)));
            QVERIFY(off <= r.steps[0].displacement + 1e-9);
            QVERIFY(r.steps[0].displacement <= 0.4);
            const MeshReport report = report_of_mesh(*r.mesh);
            QVERIFY(report.watertight);
            QCOMPARE(report.shells, std::size_t(1));
        }
    }

    void noise_of_the_size_of_the_bound_takes_several_rounds() {
        std::size_t most = 0;
        for (std::uint64_t seed = 1; seed <= 4; ++seed) {
            const DirtyScan scan = dirty_scan(16, 0.4, 0, 0, seed);
            const Repaired r = repaired(scan.mesh, {bounded(Kind::decimate, 0.5)});
            most = std::max(most, r.steps[0].count("attempts"));
            QVERIFY(r.mesh->facet_count() < scan.mesh.facet_count());
            const double off =
                std::max(brute_deviation(scan.mesh, *r.mesh), brute_deviation(*r.mesh, scan.mesh));
            QVERIFY2(off <= r.steps[0].displacement + 1e-9, qPrintable(QString::number(off)));
            QVERIFY(r.steps[0].displacement <= 0.5);
            QVERIFY(report_of_mesh(*r.mesh).watertight);
        }
        QVERIFY2(most > 1, qPrintable(QString::number(most)));
    }

    void a_gridded_cube_loses_what_says_nothing() {
        const Mesh cube = gridded_cube(10, 20);
        const Repaired r = repaired(cube, {bounded(Kind::decimate, 1e-3)});
        // Twelve would do; 48 is what a greedy order comes to.
        QVERIFY(r.mesh->facet_count() <= 48);
        const MeshReport report = report_of_mesh(*r.mesh);
        QVERIFY(report.watertight);
        QVERIFY(std::abs(report.file_volume - 8000) < 1e-6);
    }

    void holes_and_borders_keep_their_course() {
        const Mesh sheet = grid_mesh(20, 20, false, false, 0.2, [](double a, double b) {
            return Vec3(20 * a, 20 * b, 0.5 * std::sin(3 * a + b));
        });
        const Repaired r = repaired(sheet, {bounded(Kind::decimate, 0.05)});
        QVERIFY(r.mesh->facet_count() < sheet.facet_count() / 40);
        QVERIFY(brute_deviation(sheet, *r.mesh) <= 0.05);
        QVERIFY(brute_deviation(*r.mesh, sheet) <= 0.05);
    }

    void needles_go_within_the_bound() {
        Random rng(9);
        const DirtyScan scan = dirty_scan(16, 0.05, 0, 0, 5);
        Mesh mesh = scan.mesh;
        // A vertex of little offset on some edges: two needles each.
        for (int i = 0; i < 60; ++i) {
            const std::size_t f = std::size_t(whole(rng, 0, int(scan.mesh.facet_count()) - 1));
            const Facet facet = mesh.facets[f];
            const Index v = Index(mesh.vertices.size());
            mesh.vertices.push_back(rounded_to_float(0.4995 * mesh.vertices[facet[0]]
                                                     + 0.4995 * mesh.vertices[facet[1]]
                                                     + 0.001 * mesh.vertices[facet[2]]));
            mesh.facets[f] = {facet[0], facet[1], v};
            mesh.facets.push_back({facet[1], facet[2], v});
            mesh.facets.push_back({facet[2], facet[0], v});
        }
        const std::size_t before = count_needles(mesh);
        QVERIFY(before >= 50);
        const Repaired r = repaired(mesh, {bounded(Kind::needles, 0.05)});
        QCOMPARE(count_needles(*r.mesh), std::size_t(0));
        QVERIFY(report_of_mesh(*r.mesh).watertight);
        QVERIFY(r.steps[0].displacement <= 0.05);
        QVERIFY(brute_deviation(mesh, *r.mesh) <= r.steps[0].displacement + 1e-9);
        QVERIFY(brute_deviation(*r.mesh, mesh) <= r.steps[0].displacement + 1e-9);
        // Nothing to do: nothing done.
        const Repaired none = repaired(scan.mesh, {bounded(Kind::needles, 0.05)});
        QVERIFY(equal_meshes(*none.mesh, scan.mesh));
    }

    void a_cut_cube_has_the_volume_below_the_plane() {
        const Mesh cube = gridded_cube(4, 10);
        struct Case {
            Vec3 normal;
            double offset, volume;
        };
        for (const Case& c : {Case{{0, 0, 1}, 3, 300}, Case{{0, 0, -1}, -3, 700}, Case{{1, 0, 0}, 5, 500},
                              Case{Vec3(1, 1, 0).normalized(), 10 / std::sqrt(2.0), 500},
                              Case{Vec3(1, 1, 1).normalized(), 5 / std::sqrt(3.0), 125.0 / 6}}) {
            const Repaired r = repaired(cube, {plane(c.normal, c.offset)});
            const MeshReport report = report_of_mesh(*r.mesh);
            QVERIFY(report.watertight);
            QVERIFY2(std::abs(report.file_volume - c.volume) < 1e-3,
                     qPrintable(QString::number(report.file_volume)));
            QVERIFY(!report_of_mesh(*repaired(cube, {plane(c.normal, c.offset, false)}).mesh).watertight);
        }
        const Repaired beside = repaired(cube, {plane({0, 0, 1}, 10)});
        QVERIFY(equal_meshes(*beside.mesh, cube));
    }

    void a_cut_tube_has_a_ring_for_its_section() {
        // A ball within a ball: the section is a ring.
        Mesh mesh = ringed_sphere(20, 10), inner = ringed_sphere(14, 6);
        for (Facet& f : inner.facets)
            std::swap(f[0], f[1]);
        append_mesh(mesh, inner);
        for (const double at : {0.13, 1.7, -3.3}) {
            const Repaired r = repaired(mesh, {plane({0.1, 0.2, 1}, at)});
            QVERIFY(report_of_mesh(*r.mesh).watertight);
            const Repaired rest = repaired(mesh, {plane({-0.1, -0.2, -1}, -at)});
            QVERIFY(report_of_mesh(*rest.mesh).watertight);
            QVERIFY(std::abs(report_of_mesh(*r.mesh).file_volume + report_of_mesh(*rest.mesh).file_volume
                             - report_of_mesh(mesh).file_volume)
                    < 1e-4); // new vertices are floats
        }
    }

    void a_sheet_becomes_a_plate() {
        const Mesh sheet =
            grid_mesh(9, 7, false, false, 0.3, [](double a, double b) { return Vec3(10 * a, 5 * b, 1.0); });
        for (const double t : {2.0, -2.0}) {
            RepairStep step{.kind = Kind::thicken};
            step.thickness = t;
            const Repaired r = repaired(sheet, {step});
            const MeshReport report = report_of_mesh(*r.mesh);
            QVERIFY(report.watertight);
            QVERIFY(std::abs(report.file_volume - 100) < 1e-4);
            const Box3 box = r.mesh->box();
            QVERIFY(std::abs(box.lo.z() - (t > 0 ? -1 : 1)) < 1e-6
                    && std::abs(box.hi.z() - (t > 0 ? 1 : 3)) < 1e-6);
        }
    }

    void fins_go_and_the_surface_stays() {
        const Mesh ball = ringed_sphere(12, 10);
        Mesh mesh = ball;
        // Two facets that hang on an edge, a third on the tip of one of them; and one that hangs at both
        // ends.
        const Facet at = ball.facets[40], other = ball.facets[200];
        const Index tip = Index(mesh.vertices.size());
        mesh.vertices.push_back(1.3 * ball.vertices[at[0]]);
        mesh.vertices.push_back(1.4 * ball.vertices[at[1]]);
        mesh.facets.insert(mesh.facets.begin() + 7, {at[0], at[1], tip});
        mesh.facets.push_back({tip, at[1], tip + 1});
        mesh.facets.push_back({other[2], other[0], at[0]});
        RepairStep step{.kind = Kind::fins};
        step.size = 0.1;
        QVERIFY(equal_meshes(*repaired(mesh, {step}).mesh, mesh)); // they are larger
        step.size = 30;
        const Repaired r = repaired(mesh, {step});
        QCOMPARE(r.steps[0].count("facets_removed"), std::size_t(3));
        QVERIFY(equal_meshes(*r.mesh, ball));
        QVERIFY(equal_meshes(*repaired(ball, {step}).mesh, ball));
        // A sheet that ends in the open and hangs on nothing is no fin.
        const Mesh sheet =
            grid_mesh(3, 3, false, false, 0.2, [](double a, double b) { return Vec3(a, b, 0); });
        QVERIFY(equal_meshes(*repaired(sheet, {step}).mesh, sheet));
    }

    void spheres_that_cross_are_found() {
        Mesh mesh = ringed_sphere(12, 10);
        QVERIFY(crossing_facets(mesh, {}).empty());
        append_mesh(mesh, ringed_sphere(12, 10, Vec3(7.1, 0.3, 0.2)));
        const auto found = crossing_facets(mesh, {});
        QVERIFY(found.size() > 40);
        // Brute force: a side of one facet comes through the other.
        std::size_t brute = 0;
        const auto pierces = [&](const Vec3& p, const Vec3& q, std::size_t g) {
            const Vec3 &a = mesh.corner(g, 0), &b = mesh.corner(g, 1), &c = mesh.corner(g, 2);
            Mat3 m;
            m << q - p, a - b, a - c;
            const Vec3 x = m.inverse() * (a - p);
            return x[0] > 0 && x[0] < 1 && x[1] > 0 && x[2] > 0 && x[1] + x[2] < 1;
        };
        const std::size_t half = mesh.facet_count() / 2;
        for (std::size_t f = 0; f < half; ++f)
            for (std::size_t g = half; g < mesh.facet_count(); ++g) {
                bool any = false;
                for (int k = 0; k < 3; ++k)
                    any = any || pierces(mesh.corner(f, k), mesh.corner(f, (k + 1) % 3), g)
                          || pierces(mesh.corner(g, k), mesh.corner(g, (k + 1) % 3), f);
                brute += any;
            }
        QCOMPARE(found.size(), brute);
    }

    void a_vertex_pushed_through_is_made_anew() {
        Mesh mesh = ringed_sphere(30, 20);
        // One vertex at the equator comes through the surface beside it.
        const std::size_t v = 15 * 60 + 5;
        mesh.vertices[v] +=
            3.0 * (mesh.vertices[v + 3] - mesh.vertices[v]) + 0.3 * mesh.vertices[v].normalized();
        mesh.vertices[v + 1] -= 0.9 * mesh.vertices[v + 1].normalized();
        QVERIFY(!crossing_facets(mesh, {}).empty());
        RepairStep step{.kind = Kind::crossings};
        step.size = 25;
        const Repaired r = repaired(mesh, {step});
        QVERIFY(report_of_mesh(*r.mesh).watertight);
        QCOMPARE(r.steps[0].count("crossings_left"), crossing_facets(*r.mesh, {}).size());
        QCOMPARE(r.steps[0].count("crossings_left"), std::size_t(0));
    }
};

FACETMILL_TEST(TestRepairShape)
#include "test_repair_shape.moc"
