// Normals and curvatures against surfaces where they are known.
#include "core/base/parallel.h"
#include "core/mesh/geometry.h"
#include "tests/support/test_runner.h"
#include "tests/support/trials.h"
#include "tests/unit/mesh/shapes.h"

#include <QTest>

#include <cstring>
#include <numbers>

using namespace facetmill;
using namespace facetmill::test;

namespace {

struct Known {
    Vec3 normal;
    double k1, k2;
    Vec3 direction1; ///< zero at umbilic points
};

/// Largest errors over the vertices that have a curvature.
struct Errors {
    double normal = 0, mean = 0, mean_rms = 0, gauss = 0, k1 = 0, k2 = 0, direction = 0;
    std::size_t vertices = 0;
};

template <class Truth>
Errors errors(const Mesh& mesh, Truth&& truth, NormalWeight weight = NormalWeight::angle) {
    const auto normals = vertex_normals(mesh, weight, {});
    const auto curvatures = vertex_curvatures(mesh, normals, {});
    Errors e;
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
        const VertexCurvature& c = curvatures[i];
        if (std::isnan(c.mean)) continue;
        const Known k = truth(i);
        ++e.vertices;
        const auto raise = [](double& worst, double error) { worst = std::max(worst, std::abs(error)); };
        raise(e.normal, (normals[i] - k.normal).norm());
        raise(e.mean, c.mean - 0.5 * (k.k1 + k.k2));
        e.mean_rms += std::pow(c.mean - 0.5 * (k.k1 + k.k2), 2);
        raise(e.gauss, c.gauss - k.k1 * k.k2);
        raise(e.k1, c.k1 - k.k1);
        raise(e.k2, c.k2 - k.k2);
        if (k.direction1.squaredNorm() > 0.0) raise(e.direction, c.direction1.cross(k.direction1).norm());
    }
    e.mean_rms = std::sqrt(e.mean_rms / double(e.vertices));
    return e;
}

constexpr double big = 30.0, small = 10.0;

Mesh torus(int n, double jitter, std::vector<Vec2>& parameters) {
    return grid_mesh(
        n, n / 2, true, true, jitter,
        [](double a, double b) {
            const double u = 2 * pi * a, v = 2 * pi * b, r = big + small * std::cos(v);
            return Vec3(r * std::cos(u), r * std::sin(u), small * std::sin(v));
        },
        &parameters);
}

Known on_torus(const Vec2& at) {
    const double u = 2 * pi * at.x(), v = 2 * pi * at.y();
    return {Vec3(std::cos(v) * std::cos(u), std::cos(v) * std::sin(u), std::sin(v)), 1.0 / small,
            std::cos(v) / (big + small * std::cos(v)),
            Vec3(-std::sin(v) * std::cos(u), -std::sin(v) * std::sin(u), std::cos(v))};
}

Errors torus_errors(int n, double jitter, NormalWeight weight = NormalWeight::angle) {
    std::vector<Vec2> at;
    const Mesh mesh = torus(n, jitter, at);
    return errors(
        mesh, [&at](std::size_t i) { return on_torus(at[i]); }, weight);
}

/// Saddle z = (x^2 - y^2) / (2 r) over [-1, 1]^2, 2 n cells a side, with its true values.
Mesh saddle(int n, double r) {
    return grid_mesh(2 * n, 2 * n, false, false, 0.0, [r](double a, double b) {
        const double x = 2 * a - 1, y = 2 * b - 1;
        return Vec3(x, y, (x * x - y * y) / (2 * r));
    });
}

Known on_saddle(const Vec3& p, double r) {
    const double hx = p.x() / r, hy = -p.y() / r, w2 = 1 + hx * hx + hy * hy, w = std::sqrt(w2);
    // Heights of a graph with upward normal: curvature is positive where it bends down.
    const double gauss = -1.0 / (r * r * w2 * w2);
    const double mean = -((1 + hy * hy) / r - (1 + hx * hx) / r) / (2 * w2 * w);
    const double root = std::sqrt(mean * mean - gauss);
    return {Vec3(-hx, -hy, 1) / w, mean + root, mean - root, Vec3::Zero()};
}

bool same_bits(const Vec3& a, const Vec3& b) {
    return std::memcmp(a.data(), b.data(), 3 * sizeof(double)) == 0;
}

double area_of(const Mesh& mesh) {
    double area = 0;
    for (std::size_t f = 0; f < mesh.facet_count(); ++f)
        area += 0.5 * mesh.facet_cross(f).norm();
    return area;
}

} // namespace

class TestGeometry : public QObject {
    Q_OBJECT
private slots:

    void normals_weigh_by_angle_or_area() {
        // At a cube's corner the sides have equal angles but the diagonals share them unevenly: only the
        // angle weight gives the space diagonal everywhere.
        const Mesh cube = cube_mesh(2.0);
        const auto by_angle = vertex_normals(cube, NormalWeight::angle, {});
        for (std::size_t v = 0; v < 8; ++v)
            QVERIFY((by_angle[v] - (cube.vertices[v] - Vec3::Ones()).normalized()).norm() < 1e-15);
        const auto by_area = vertex_normals(cube, NormalWeight::area, {});
        Vec3 expected =
            Vec3::Zero(); // three facets meet here with areas 2: two sides of two, one side of one
        for (const Facet& f : cube.facets)
            if (f[0] == 1 || f[1] == 1 || f[2] == 1)
                expected += (cube.vertices[f[1]] - cube.vertices[f[0]])
                                .cross(cube.vertices[f[2]] - cube.vertices[f[0]]);
        QVERIFY((by_area[1] - expected.normalized()).norm() < 1e-15);
        QVERIFY((by_area[1] - by_angle[1]).norm() > 0.05);
    }

    void normals_follow_the_winding() {
        Mesh mesh = sphere_mesh(3.0, 3);
        for (Facet& f : mesh.facets)
            std::swap(f[1], f[2]);
        const auto normals = vertex_normals(mesh, NormalWeight::angle, {});
        for (std::size_t v = 0; v < mesh.vertices.size(); ++v)
            QVERIFY(normals[v].dot(mesh.vertices[v]) < -2.9);
    }

    void normals_on_edges() {
        const Vec3 a(1, 0, 0), b(0, 1, 0);
        QCOMPARE(edge_normal(a, b, 0.0), a);
        QCOMPARE(edge_normal(a, b, 1.0), b);
        QVERIFY((edge_normal(a, b, 0.5) - Vec3(1, 1, 0).normalized()).norm() < 1e-15);
        QVERIFY((edge_normal(a, b, 0.25) - Vec3(3, 1, 0).normalized()).norm() < 1e-15);
        QCOMPARE(edge_normal(a, -a, 0.5), Vec3(Vec3::Zero()));
    }

    void sphere() {
        for (const double sign : {1.0, -1.0}) { // outward, then inward normals
            Mesh mesh = sphere_mesh(20.0, 5);
            if (sign < 0)
                for (Facet& f : mesh.facets)
                    std::swap(f[1], f[2]);
            const double k = sign / 20.0;
            const Errors e = errors(mesh, [&](std::size_t i) {
                return Known{sign * mesh.vertices[i].normalized(), k, k, Vec3::Zero()};
            });
            QCOMPARE(e.vertices, mesh.vertices.size());
            QVERIFY2(e.normal < 6e-3, qPrintable(QString::number(e.normal)));
            QVERIFY2(e.k1 < 1e-2 * std::abs(k) && e.k2 < 1e-2 * std::abs(k),
                     qPrintable(QString::number(e.k1)));
            QVERIFY2(e.mean_rms < 5e-3 * std::abs(k), qPrintable(QString::number(e.mean_rms)));
            QVERIFY2(e.gauss < 0.25 * k * k, qPrintable(QString::number(e.gauss)));
        }
    }

    void cylinder() {
        // Radius 5, axis along X; seen from outside bent round, straight along the axis.
        std::vector<Vec2> at;
        const Mesh mesh = grid_mesh(
            16, 64, false, true, 0.0,
            [](double a, double b) {
                return Vec3(8 * a, 5 * std::sin(2 * pi * b), 5 * std::cos(2 * pi * b));
            },
            &at);
        const Errors e = errors(mesh, [&](std::size_t i) {
            const Vec3& p = mesh.vertices[i];
            return Known{Vec3(0, p.y(), p.z()) / 5, 0.2, 0.0, Vec3(0, -p.z(), p.y()) / 5};
        });
        QCOMPARE(e.vertices, std::size_t(15 * 64)); // both rims are border
        QVERIFY2(e.normal < 1e-12, qPrintable(QString::number(e.normal)));
        QVERIFY2(e.k1 < 2e-3 && e.k2 < 1e-3, qPrintable(QString::number(e.k1)));
        QVERIFY2(e.mean < 1e-3 && e.gauss < 1e-12, qPrintable(QString::number(e.mean)));
        QVERIFY2(e.direction < 2e-3, qPrintable(QString::number(e.direction)));
    }

    void torus_converges() {
        // Errors fall by four when the facets halve: second order.
        const Errors coarse = torus_errors(64, 0.0), fine = torus_errors(128, 0.0);
        for (const auto member :
             {&Errors::normal, &Errors::mean, &Errors::gauss, &Errors::k1, &Errors::k2, &Errors::direction}) {
            const double rate = std::log2(coarse.*member / (fine.*member));
            QVERIFY2(rate > 1.8 && rate < 2.3, qPrintable(QString::number(rate)));
        }
        QVERIFY(fine.k1 < 1e-3 && fine.k2 < 2e-4 && fine.direction < 2e-3 && fine.normal < 1e-3);
        const double by_area = std::log2(torus_errors(64, 0.0, NormalWeight::area).normal
                                         / torus_errors(128, 0.0, NormalWeight::area).normal);
        QVERIFY2(by_area > 1.8, qPrintable(QString::number(by_area)));
    }

    void uneven_torus_converges() {
        // Fitted curvatures keep their order on a mesh with no symmetry at all; normals keep the first.
        const Errors coarse = torus_errors(64, 0.2), fine = torus_errors(128, 0.2);
        for (const auto member : {&Errors::k1, &Errors::k2, &Errors::direction}) {
            const double rate = std::log2(coarse.*member / (fine.*member));
            QVERIFY2(rate > 1.6, qPrintable(QString::number(rate)));
        }
        QVERIFY(std::log2(coarse.normal / fine.normal) > 0.6);
        // The operators do not converge point by point there, but they stay near on the whole.
        QVERIFY2(fine.mean_rms < 0.06 / small, qPrintable(QString::number(fine.mean_rms)));
    }

    void fit_forgives_a_tilted_normal() {
        // The slope is free, so a normal that is half a radian off changes neither curvatures nor directions
        // much.
        std::vector<Vec2> at;
        const Mesh mesh = torus(128, 0.0, at);
        auto normals = vertex_normals(mesh, NormalWeight::angle, {});
        std::mt19937 rng(4);
        for (Vec3& n : normals) {
            const Vec3 random(double(rng() % 201) - 100.0, double(rng() % 201) - 100.0,
                              double(rng() % 201) - 99.5);
            n = (n + 0.5 * (random - random.dot(n) * n).normalized()).normalized();
        }
        const auto curvatures = vertex_curvatures(mesh, normals, {});
        for (std::size_t v = 0; v < curvatures.size(); ++v) {
            const Known k = on_torus(at[v]);
            const VertexCurvature& c = curvatures[v];
            QVERIFY(std::abs(c.k1 - k.k1) < 0.02 * k.k1 && std::abs(c.k2 - k.k2) < 0.02 * k.k1);
            QVERIFY(c.direction1.cross(k.direction1).norm() < 0.02);
            QVERIFY(std::abs(c.direction1.dot(c.direction2)) < 1e-12
                    && std::abs(c.direction2.dot(k.normal)) < 0.02);
        }
    }

    void saddle_and_plane() {
        const int n = 40;
        const double r = 4.0;
        const Mesh mesh = saddle(n, r);
        const Errors e = errors(mesh, [&](std::size_t i) { return on_saddle(mesh.vertices[i], r); });
        QVERIFY2(e.k1 < 2e-3 / r && e.k2 < 2e-3 / r, qPrintable(QString::number(e.k1)));
        QVERIFY2(e.mean < 2e-3 / r && e.gauss < 2e-2 / (r * r), qPrintable(QString::number(e.gauss)));
        // The middle is balanced: no mean curvature, yet bent by -1/r along x (up) and +1/r along y (down).
        const auto normals = vertex_normals(mesh, NormalWeight::angle, {});
        const VertexCurvature c = vertex_curvatures(mesh, normals, {})[std::size_t(n * (2 * n + 1) + n)];
        QVERIFY(std::abs(c.mean) < 1e-12);
        QVERIFY(std::abs(c.k1 - 1 / r) < 1e-3 && std::abs(c.k2 + 1 / r) < 1e-3);
        QVERIFY(std::abs(c.direction1.y()) > 0.9999 && std::abs(c.direction2.x()) > 0.9999);
        QVERIFY((normals[std::size_t(n * (2 * n + 1) + n)] - Vec3(0, 0, 1)).norm() < 1e-12);

        const Mesh plane = grid_mesh(9, 7, false, false, 0.2, [](double a, double b) {
            return Vec3(a, 2 * b, 1 + 3 * a - b); // tilted
        });
        for (const VertexCurvature& p :
             vertex_curvatures(plane, vertex_normals(plane, NormalWeight::angle, {}), {}))
            if (!std::isnan(p.mean)) {
                QVERIFY(std::abs(p.mean) < 1e-10 && std::abs(p.gauss) < 1e-10);
                QVERIFY(std::abs(p.k1) < 1e-10 && std::abs(p.k2) < 1e-10);
            }
    }

    void mixed_areas_share_the_surface_out() {
        // Stretched facets are mostly obtuse: the areas at their corners must still add up to the whole.
        Mesh mesh = sphere_mesh(1.0, 4);
        for (Vec3& p : mesh.vertices)
            p = Vec3(p.x() + 2.7 * p.y(), 9 * p.y(), p.z());
        std::size_t obtuse = 0;
        for (std::size_t f = 0; f < mesh.facet_count(); ++f)
            for (int k = 0; k < 3; ++k)
                obtuse += (mesh.corner(f, (k + 1) % 3) - mesh.corner(f, k))
                              .dot(mesh.corner(f, (k + 2) % 3) - mesh.corner(f, k))
                          < 0;
        QVERIFY(obtuse > mesh.facet_count() / 3 && obtuse < mesh.facet_count());
        double sum = 0;
        for (const VertexCurvature& c :
             vertex_curvatures(mesh, vertex_normals(mesh, NormalWeight::angle, {}), {}))
            sum += c.mixed_area;
        QVERIFY(std::abs(sum - area_of(mesh)) < 1e-12 * sum);
    }

    void angle_defect_adds_up() {
        // Gauss-Bonnet: 4 pi over a sphere, 0 over a torus, exactly, whatever the facets.
        const auto total = [](const Mesh& mesh) {
            double sum = 0;
            for (const VertexCurvature& c :
                 vertex_curvatures(mesh, vertex_normals(mesh, NormalWeight::angle, {}), {}))
                sum += c.gauss * c.mixed_area;
            return sum;
        };
        QVERIFY(std::abs(total(sphere_mesh(7.0, 3)) - 4 * pi) < 1e-10);
        std::vector<Vec2> at;
        QVERIFY(std::abs(total(torus(24, 0.2, at))) < 1e-10);
    }

    void octahedron_by_hand() {
        // Four equilateral facets with edge s at each vertex: mixed area 4/3 of a facet, defect 2 pi / 3;
        // operator: the four edges add up to 4 cot 60 (4 * (0 0 1)) ... / (2 A), half of it along the axis.
        const Mesh mesh = sphere_mesh(1.0, 0);
        const double facet = std::numbers::sqrt3 / 2.0;
        const double area = 4.0 / 3.0 * facet;
        const auto c = vertex_curvatures(mesh, vertex_normals(mesh, NormalWeight::angle, {}), {});
        for (std::size_t v = 0; v < 6; ++v) {
            QVERIFY(std::abs(c[v].mixed_area - area) < 1e-14);
            QVERIFY(std::abs(c[v].gauss - 2 * pi / 3 / area) < 1e-13);
            QVERIFY(std::abs(c[v].mean - 4 * 2 / std::numbers::sqrt3 / (4 * area)) < 1e-13);
        }
    }

    void undefined_curvatures_are_nan() {
        const auto curvatures = [](const Mesh& mesh) {
            return vertex_curvatures(mesh, vertex_normals(mesh, NormalWeight::angle, {}), {});
        };
        const Mesh sheet =
            grid_mesh(4, 4, false, false, 0.0, [](double a, double b) { return Vec3(a, b, a * b); });
        const auto c = curvatures(sheet);
        for (std::size_t v = 0; v < 25; ++v) {
            const bool border = v % 5 == 0 || v % 5 == 4 || v < 5 || v >= 20;
            QCOMPARE(std::isnan(c[v].mean), border);
            QCOMPARE(std::isnan(c[v].gauss) && std::isnan(c[v].k1) && std::isnan(c[v].k2)
                         && std::isnan(c[v].mixed_area) && c[v].direction1.hasNaN()
                         && c[v].direction2.hasNaN(),
                     border);
        }
        // Two cubes at a vertex, two along an edge: undefined there, defined elsewhere.
        // The second one is sheared, so that the normals there do not cancel.
        Mesh sheared = cube_mesh(1.0, Vec3::Ones());
        for (Vec3& p : sheared.vertices)
            p += 0.5 * (p.x() - 1) * Vec3(0, 1, 2);
        const Mesh touching = welded(cube_mesh(), sheared);
        QVERIFY(vertex_normals(touching, NormalWeight::angle, {})[7].norm() > 0.5);
        const auto at_vertex = curvatures(touching);
        for (std::size_t v = 0; v < at_vertex.size(); ++v)
            QCOMPARE(std::isnan(at_vertex[v].mean), v == 7);
        const auto at_edge = curvatures(welded(cube_mesh(), cube_mesh(1.0, Vec3(1, 1, 0))));
        for (std::size_t v = 0; v < at_edge.size(); ++v)
            QCOMPARE(std::isnan(at_edge[v].mean), v == 3 || v == 7);
        // A facet wound against the others.
        Mesh turned = cube_mesh();
        std::swap(turned.facets[0][1], turned.facets[0][2]);
        const auto against = curvatures(turned);
        for (const Index v : turned.facets[0])
            QVERIFY(std::isnan(against[v].mean));
        QVERIFY(!std::isnan(against[7].mean));
        // Nobody's vertex.
        Mesh lonely = cube_mesh();
        lonely.vertices.push_back({5, 5, 5});
        QVERIFY(std::isnan(curvatures(lonely)[8].k1));
        QCOMPARE(vertex_normals(lonely, NormalWeight::angle, {})[8], Vec3(Vec3::Zero()));
    }

    void degenerate_facets_do_no_harm() {
        const Mesh good = sphere_mesh(10.0, 3);
        Mesh mesh = good;
        // A facet that is an edge, one that is a point, and a needle along an edge whose rounding turns it
        // over.
        const Index a = mesh.facets[0][0], b = mesh.facets[0][1];
        mesh.facets.push_back({a, a, b});
        mesh.facets.push_back({b, b, b});
        const Vec3 middle = 0.5 * (mesh.vertices[a] + mesh.vertices[b]);
        mesh.vertices.push_back(middle
                                - 1e-9 * middle.normalized().cross(mesh.vertices[a] - mesh.vertices[b]));
        mesh.facets.push_back({a, b, Index(mesh.vertices.size() - 1)});
        for (const NormalWeight weight : {NormalWeight::angle, NormalWeight::area}) {
            const auto expected = vertex_normals(good, weight, {}),
                       normals = vertex_normals(mesh, weight, {});
            for (std::size_t v = 0; v < good.vertices.size(); ++v)
                QVERIFY((normals[v] - expected[v]).norm() < 1e-12);
            QVERIFY(std::abs(normals.back().norm() - 1.0) < 1e-12); // its only facet is the needle
        }
        for (const VertexCurvature& c :
             vertex_curvatures(mesh, vertex_normals(mesh, NormalWeight::angle, {}), {}))
            QVERIFY(std::isnan(c.mean)
                    || (std::isfinite(c.mean) && std::isfinite(c.k1) && std::isfinite(c.gauss)));

        // Both sides of a sheet cancel: no normal rather than a random one.
        Mesh both = cube_mesh();
        for (const Facet f : cube_mesh().facets)
            both.facets.push_back({f[0], f[2], f[1]});
        for (const Vec3& n : vertex_normals(both, NormalWeight::angle, {}))
            QCOMPARE(n, Vec3(Vec3::Zero()));

        // A vertex in the middle of an edge, closed by a facet without area, as readers that keep T-junctions
        // do.
        Mesh split = cube_mesh();
        split.vertices.push_back({0.5, 0, 0});
        split.facets[4] = {0, 8, 5};
        split.facets.push_back({8, 1, 5});
        split.facets.push_back({0, 1, 8});
        const auto c = vertex_curvatures(split, vertex_normals(split, NormalWeight::angle, {}), {});
        for (const VertexCurvature& k : c)
            QVERIFY(std::isfinite(k.mean) && std::isfinite(k.gauss) && std::isfinite(k.k1)
                    && std::isfinite(k.k2));
    }

    void geometry_has_both_kinds_of_normals() {
        const Mesh mesh = sphere_mesh(2.0, 2);
        const auto g = compute_geometry(mesh, {});
        QCOMPARE(g->vertex_normals, vertex_normals(mesh, NormalWeight::angle, {}));
        QCOMPARE(g->facet_normals.size(), mesh.facet_count());
        for (std::size_t f = 0; f < mesh.facet_count(); ++f)
            QCOMPARE(g->facet_normals[f], mesh.facet_normal(f));
    }

    void same_bits_for_every_thread_count() {
        std::vector<Vec2> at;
        const Mesh mesh = torus(trials(400, 4), 0.2, at);
        std::vector<Vec3> normals;
        std::vector<VertexCurvature> curvatures;
        for (const int threads : {1, 2, 5}) {
            set_thread_count(threads);
            const auto n = vertex_normals(mesh, NormalWeight::angle, {});
            const auto c = vertex_curvatures(mesh, n, {});
            if (threads == 1) {
                normals = n;
                curvatures = c;
            }
            for (std::size_t v = 0; v < n.size(); ++v)
                QVERIFY(same_bits(n[v], normals[v]) && c[v].mean == curvatures[v].mean
                        && c[v].k1 == curvatures[v].k1
                        && same_bits(c[v].direction1, curvatures[v].direction1));
        }
        set_thread_count(0);
        Job job;
        job.cancel();
        QVERIFY_EXCEPTION_THROWN(vertex_normals(mesh, NormalWeight::area, Progress(job)), Cancelled);
        QVERIFY_EXCEPTION_THROWN(vertex_curvatures(mesh, normals, Progress(job)), Cancelled);
        QVERIFY_EXCEPTION_THROWN(compute_geometry(mesh, Progress(job)), Cancelled);
    }
};

FACETMILL_TEST(TestGeometry)
#include "test_geometry.moc"
