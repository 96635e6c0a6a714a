// Sample parts: the published surfaces, true distances between surface and mesh, closed where they must be.
#include "core/base/parallel.h"
#include "core/mesh/bspline.h"
#include "core/mesh/geometry.h"
#include "core/mesh/sample.h"
#include "core/mesh/sample_mould.h"
#include "core/mesh/sample_surface.h"
#include "core/mesh/sample_tessellate.h"
#include "core/mesh/topology.h"
#include "tests/support/error_code.h"
#include "tests/support/test_runner.h"
#include "tests/support/trials.h"
#include "tests/unit/mesh/shapes.h"

#include <QTest>

#include <map>
#include <set>

using namespace facetmill;
using namespace facetmill::test;

namespace {

constexpr double inch = 25.4;

double random_unit(std::mt19937& rng) {
    return double(rng()) / double(std::mt19937::max());
}

double distance_to_facet(const Vec3& p, const Mesh& mesh, std::size_t f) {
    const Vec3 &a = mesh.corner(f, 0), &b = mesh.corner(f, 1), &c = mesh.corner(f, 2);
    const Vec3 n = mesh.facet_normal(f);
    const Vec3 foot = p - (p - a).dot(n) * n;
    if ((b - a).cross(foot - a).dot(n) >= 0 && (c - b).cross(foot - b).dot(n) >= 0
        && (a - c).cross(foot - c).dot(n) >= 0)
        return (p - foot).norm();
    double nearest = infinity;
    for (int k = 0; k < 3; ++k) {
        const Vec3 &s = mesh.corner(f, k), d = mesh.corner(f, (k + 1) % 3) - s;
        nearest =
            std::min(nearest, (p - s - std::clamp((p - s).dot(d) / d.squaredNorm(), 0.0, 1.0) * d).norm());
    }
    return nearest;
}

/// Facets by cells of the XY plane, to find the exact distance of points near the mesh.
class FacetFinder {
public:
    FacetFinder(const Mesh& mesh, double reach)
        : mesh_(mesh), reach_(reach), box_(mesh.box()), cells_(n * n) {
        for (std::size_t f = 0; f < mesh.facet_count(); ++f) {
            Box3 b;
            for (int k = 0; k < 3; ++k)
                b.add(mesh.corner(f, k));
            for (int i = cell(b.lo.x() - reach, 0); i <= cell(b.hi.x() + reach, 0); ++i)
                for (int j = cell(b.lo.y() - reach, 1); j <= cell(b.hi.y() + reach, 1); ++j)
                    cells_[std::size_t(i * n + j)].push_back(f);
        }
    }
    /// Exact when it is at most `reach`; more than that otherwise.
    double distance(const Vec3& p) const {
        double nearest = 2 * reach_;
        for (const std::size_t f : cells_[std::size_t(cell(p.x(), 0) * n + cell(p.y(), 1))])
            nearest = std::min(nearest, distance_to_facet(p, mesh_, f));
        return nearest;
    }

private:
    static constexpr int n = 100;
    int cell(double at, int axis) const {
        return std::clamp(int((at - box_.lo[axis]) / (box_.hi[axis] - box_.lo[axis]) * n), 0, n - 1);
    }
    const Mesh& mesh_;
    double reach_;
    Box3 box_;
    std::vector<std::vector<std::size_t>> cells_;
};

double signed_volume(const Mesh& mesh) {
    double volume = 0;
    for (std::size_t f = 0; f < mesh.facet_count(); ++f)
        volume += mesh.corner(f, 0).dot(mesh.corner(f, 1).cross(mesh.corner(f, 2))) / 6.0;
    return volume;
}

/// Vertices on border edges; empty for closed meshes. Fails the test on T-junctions or other breaks of
/// connectivity.
std::vector<Index> border(const Mesh& mesh, int& euler) {
    const auto t = build_topology(mesh, {});
    euler = t->left_out == 0 && t->vertex_of.size() == mesh.vertices.size()
                ? int(t->mesh.n_vertices()) - int(t->mesh.n_edges()) + int(t->mesh.n_faces())
                : -1;
    std::vector<Index> vertices;
    for (const auto h : t->mesh.halfedges())
        if (t->mesh.is_boundary(h)) vertices.push_back(Index(t->mesh.from_vertex_handle(h).idx()));
    return vertices;
}

double smallest_angle(const Mesh& mesh) {
    double smallest = pi;
    for (std::size_t f = 0; f < mesh.facet_count(); ++f)
        for (int k = 0; k < 3; ++k) {
            const Vec3 a = mesh.corner(f, (k + 1) % 3) - mesh.corner(f, k),
                       b = mesh.corner(f, (k + 2) % 3) - mesh.corner(f, k);
            smallest = std::min(smallest, std::atan2(a.cross(b).norm(), a.dot(b)));
        }
    return smallest;
}

void lu_names() {
    QTest::addColumn<QString>("name");
    for (const char* name : {"concave", "convex", "complex"})
        QTest::newRow(name) << name;
}

} // namespace

class TestSamples : public QObject {
    Q_OBJECT
private slots:

    void spline_has_its_derivatives() {
        const CubicBSpline curve({{0, 0}, {1, 2}, {3, 1}, {4, -1}, {6, 0}, {7, 3}, {9, 1}});
        QCOMPARE(curve.point(0.0), Vec2(0, 0));
        QCOMPARE(curve.point(1.0), Vec2(9, 1));
        // At the middle knot the third inner pole has its neighbours' knots evenly round it, so its weight is
        // 4/6; the other two share the rest by symmetry.
        QVERIFY((curve.point(0.5) - (Vec2(3, 1) + 4 * Vec2(4, -1) + Vec2(6, 0)) / 6.0).norm() < 1e-14);
        const double h = 1e-5;
        for (double t = 0.01; t < 1.0; t += 0.0137) {
            const CurvePoint2 c = curve.evaluate(t);
            const Vec2 before = curve.point(t - h), after = curve.point(t + h);
            QCOMPARE(c.point, curve.point(t));
            QVERIFY((c.d1 - (after - before) / (2 * h)).norm() < 1e-6 * c.d1.norm());
            QVERIFY((c.d2 - (after - 2 * c.point + before) / (h * h)).norm() < 1e-3);
        }
        // Four poles: the Bezier curve.
        const CubicBSpline bezier({{0, 0}, {0, 8}, {8, 8}, {8, 0}});
        QVERIFY((bezier.point(0.5) - Vec2(4, 6)).norm() < 1e-15);
    }

    void surfaces_are_the_published_ones() {
        // First and last poles of the outer sections are corners of the surface.
        const auto corner = [](const char* name, double u, double v) {
            return Vec3(lu_surface(name).point(u, v) / inch);
        };
        QVERIFY((corner("concave", 0, 0) - Vec3(0, -5.31285703876, 2.12375344346)).norm() < 1e-12);
        QVERIFY((corner("concave", 1, 1) - Vec3(10, 3.8472741381, -0.01058633345)).norm() < 1e-12);
        QVERIFY((corner("convex", 0, 1) - Vec3(0, 5.20720866556, 0.51314611426)).norm() < 1e-12);
        QVERIFY((corner("convex", 1, 0) - Vec3(10, -4.79796934492, 0.3894087029)).norm() < 1e-12);
        // The complex surface goes through its inner sections as well.
        QVERIFY((corner("complex", 1.0 / 3.0, 0) - Vec3(3, -4.90234051572, 1.92682808671)).norm() < 1e-12);
        QVERIFY((corner("complex", 2.0 / 3.0, 1) - Vec3(6, 6.14637447872, 0.90265495062)).norm() < 1e-12);
        QVERIFY((corner("complex", 1, 1) - Vec3(9, 6.13659165562, 1.16023920978)).norm() < 1e-12);
        QCOMPARE(lu_surface("concave").sections()[0].curve.poles().size(), std::size_t(11));
        QCOMPARE(lu_surface("complex").sections()[3].curve.poles().size(), std::size_t(13));
        for (const auto& s : lu_surface("complex").sections())
            for (double v = 0; v <= 1; v += 0.1)
                QVERIFY((lu_surface("complex").point(s.x / (9 * inch), v)
                         - Vec3(s.x, s.curve.point(v).x(), s.curve.point(v).y()))
                            .norm()
                        < 1e-11);
        // Two sections: straight across.
        const LoftedSurface& convex = lu_surface("convex");
        QVERIFY((convex.point(0.3, 0.4) - (0.7 * convex.point(0, 0.4) + 0.3 * convex.point(1, 0.4))).norm()
                < 1e-12);
        QCOMPARE(code_of([] { lu_surface("torus"); }), std::string("out_of_range"));
    }

    void surface_derivatives_data() { lu_names(); }
    void surface_derivatives() {
        QFETCH(QString, name);
        const LoftedSurface& s = lu_surface(name.toStdString());
        std::mt19937 rng(1);
        const double h = 1e-5;
        for (int i = 0; i < 300; ++i) {
            const double u = 0.01 + 0.98 * random_unit(rng), v = 0.01 + 0.98 * random_unit(rng);
            const SurfacePoint p = s.evaluate(u, v);
            QVERIFY((p.point - s.point(u, v)).norm() < 1e-11);
            const auto near = [&](const Vec3& derivative, const Vec3& difference, double scale) {
                return (derivative - difference).norm() < 1e-3 * scale;
            };
            QVERIFY(near(p.du, (s.point(u + h, v) - s.point(u - h, v)) / (2 * h), 1));
            QVERIFY(near(p.dv, (s.point(u, v + h) - s.point(u, v - h)) / (2 * h), 1));
            const SurfacePoint right = s.evaluate(u + h, v), left = s.evaluate(u - h, v);
            const SurfacePoint up = s.evaluate(u, v + h), down = s.evaluate(u, v - h);
            QVERIFY(near(p.duu, (right.du - left.du) / (2 * h), 100));
            QVERIFY(near(p.duv, (up.du - down.du) / (2 * h), 100));
            QVERIFY(near(p.dvv, (up.dv - down.dv) / (2 * h), 100));
            QVERIFY(std::abs(p.normal.norm() - 1) < 1e-14 && std::abs(p.normal.dot(p.du)) < 1e-9 * p.du.norm()
                    && std::abs(p.normal.dot(p.dv)) < 1e-9 * p.dv.norm());
            QVERIFY(p.normal.z() > 0.0);
            // And back from places to parameters.
            const auto uv = s.parameters_over(p.point.x(), p.point.y());
            QVERIFY(uv && (*uv - Vec2(u, v)).norm() < 1e-9);
            QVERIFY(std::abs(*s.height(p.point.x(), p.point.y()) - p.point.z()) < 1e-8);
            if (i < 30) {
                const Vec2 foot = s.nearest_parameters(p.point + 1.5 * p.normal);
                QVERIFY((s.point(foot.x(), foot.y()) - p.point).norm() < 1e-6);
            }
        }
        QVERIFY(!s.height(-0.001, 0) && !s.height(10, -200) && !s.height(10, 200)
                && !s.height(std::nan(""), 0));
        const Vec2 beyond = s.nearest_parameters(s.point(0, 0.5) - Vec3(40, 0, 0));
        QCOMPARE(beyond.x(), 0.0);
        // y grows with v everywhere: what parameters_over stands on.
        for (int i = 0; i <= 200; ++i)
            for (int j = 0; j <= 200; ++j)
                QVERIFY(s.evaluate(i / 200.0, j / 200.0).dv.y() > 0.0);
    }

    void mesh_keeps_the_chord_tolerance_data() {
        QTest::addColumn<QString>("name");
        QTest::addColumn<double>("tolerance");
        for (const char* name : {"concave", "convex", "complex"})
            for (const double tolerance : {0.002, 0.0005, 0.03}) {
                if (under_sanitizer && tolerance < 0.001) continue; // slow there
                QTest::newRow(qPrintable(QString("%1 %2 in").arg(name).arg(tolerance)))
                    << name << tolerance * inch;
            }
    }
    void mesh_keeps_the_chord_tolerance() {
        QFETCH(QString, name);
        QFETCH(double, tolerance);
        const LoftedSurface& s = lu_surface(name.toStdString());
        const auto mesh = make_sample(name.toStdString(), tolerance, {});
        // Surface to mesh, exactly, at random places and denser along the borders.
        const FacetFinder finder(*mesh, tolerance);
        std::mt19937 rng(2);
        double worst = 0;
        for (int i = 0; i < 40000; ++i) {
            double u = random_unit(rng), v = random_unit(rng);
            if (i % 8 == 0) (i % 16 ? u : v) = i % 32 < 16 ? 0.0 : 1.0;
            worst = std::max(worst, finder.distance(s.point(u, v)));
        }
        QVERIFY2(worst <= tolerance, qPrintable(QString::number(worst / tolerance)));
        QVERIFY2(tolerance > 0.1 || worst > 0.8 * tolerance, qPrintable(QString::number(worst / tolerance)));
        // Mesh to surface: inside facets, on edges, at vertices.
        double back = 0, at_vertices = 0;
        for (int i = 0; i < trials(450, 5); ++i) {
            const std::size_t f = rng() % mesh->facet_count();
            double a = random_unit(rng), b = i % 3 == 0 ? 0.0 : random_unit(rng);
            if (a + b > 1) a = 1 - a, b = 1 - b;
            const bool vertex = i % 9 == 1;
            if (vertex) a = b = 0;
            const Vec3 p = mesh->corner(f, 0) + a * (mesh->corner(f, 1) - mesh->corner(f, 0))
                           + b * (mesh->corner(f, 2) - mesh->corner(f, 0));
            const Vec2 uv = s.nearest_parameters(p);
            const double d = (s.point(uv.x(), uv.y()) - p).norm();
            (vertex ? at_vertices : back) = std::max(vertex ? at_vertices : back, d);
        }
        QVERIFY2(back <= tolerance, qPrintable(QString::number(back / tolerance)));
        QVERIFY2(at_vertices < 1e-7, qPrintable(QString::number(at_vertices)));
    }

    void mesh_is_an_open_sheet_of_good_facets_data() { lu_names(); }
    void mesh_is_an_open_sheet_of_good_facets() {
        QFETCH(QString, name);
        const LoftedSurface& s = lu_surface(name.toStdString());
        const double tolerance = default_sample_tolerance;
        const auto mesh = make_sample(name.toStdString(), tolerance, {});
        int euler = 0;
        const auto rim = border(*mesh, euler);
        QCOMPARE(euler, 1); // one sheet, no holes
        const double x1 = s.sections().back().x;
        for (const Index v : rim) { // a crack would open inside
            const Vec3& p = mesh->vertices[v];
            const double u = p.x() / x1;
            QVERIFY(p.x() == 0.0 || p.x() == x1 || (p - s.point(u, 0)).norm() < 1e-9
                    || (p - s.point(u, 1)).norm() < 1e-9);
        }
        for (const double u : {0.0, 1.0})
            for (const double v : {0.0, 1.0})
                QVERIFY(std::find(mesh->vertices.begin(), mesh->vertices.end(), s.point(u, v))
                        != mesh->vertices.end());
        for (std::size_t f = 0; f < mesh->facet_count(); ++f)
            QVERIFY(mesh->facet_normal(f).z() > 0.0);
        QVERIFY2(degrees(smallest_angle(*mesh)) > 15.0,
                 qPrintable(QString::number(degrees(smallest_angle(*mesh)))));
        // Equilateral facets with their edges bent by the larger curvature: area sqrt(3)/4 * 8 tolerance /
        // curvature.
        double needed = 0;
        const int n = 200;
        for (int i = 0; i < n; ++i)
            for (int j = 0; j < n; ++j) {
                const SurfacePoint p = s.evaluate((i + 0.5) / n, (j + 0.5) / n);
                Eigen::Matrix2d first, second;
                first << p.du.dot(p.du), p.du.dot(p.dv), p.du.dot(p.dv), p.dv.dot(p.dv);
                second << p.duu.dot(p.normal), p.duv.dot(p.normal), p.duv.dot(p.normal), p.dvv.dot(p.normal);
                const Eigen::Matrix2d shape = first.inverse() * second;
                const double half = 0.5 * shape.trace();
                const double curvature =
                    std::abs(half) + std::sqrt(std::max(0.0, half * half - shape.determinant()));
                needed += curvature * p.du.cross(p.dv).norm() / (n * n) / (2 * std::sqrt(3.0) * tolerance);
            }
        QVERIFY2(double(mesh->facet_count()) < 2.5 * needed && double(mesh->facet_count()) > needed,
                 qPrintable(QString::number(double(mesh->facet_count()) / needed)));
    }

    void stand_ins_data() {
        QTest::addColumn<QString>("name");
        QTest::addColumn<double>("steepest_min"); // degrees; what makes the part hard
        QTest::addColumn<double>("steepest_max");
        QTest::addColumn<double>("tightest_min"); // mm, radius of its hollows
        QTest::newRow("pillar") << "pillar" << 60.0 << 75.0 << 0.05 * inch;
        QTest::newRow("gap") << "gap" << 75.0 << 88.0 << 0.05 * inch;
        // The ball that Wang reworks with, D 6.35 mm, fits.
        QTest::newRow("shell") << "shell" << 60.0 << 75.0 << 3.3;
    }
    void stand_ins() {
        QFETCH(QString, name);
        QFETCH(double, steepest_min);
        QFETCH(double, steepest_max);
        QFETCH(double, tightest_min);
        const double tolerance = (under_sanitizer ? 4 : 1) * default_sample_tolerance;
        const auto mesh = make_sample(name.toStdString(), tolerance, {});
        int euler = 0;
        const auto rim = border(*mesh, euler);
        QCOMPARE(euler, 1);
        const Box3 box = mesh->box();
        double steepest = 0;
        for (std::size_t f = 0; f < mesh->facet_count(); ++f)
            steepest = std::max(steepest, degrees(std::acos(mesh->facet_normal(f).z())));
        QVERIFY2(steepest > steepest_min && steepest < steepest_max, qPrintable(QString::number(steepest)));
        QVERIFY(degrees(smallest_angle(*mesh)) > 12.0);
        QVERIFY2(mesh->facet_count() < 60'000, qPrintable(QString::number(mesh->facet_count())));
        // Border only at the ends in x or at the outermost y of its station (within the sway of the sides).
        for (const Index v : rim) {
            const Vec3& p = mesh->vertices[v];
            const bool end = p.x() == box.lo.x() || p.x() == box.hi.x();
            bool inside = false;
            if (!end && name != "pillar") inside = p.y() != box.lo.y() && p.y() != box.hi.y();
            QVERIFY(!inside);
        }
        // A much finer mesh stands for the surface.
        const FacetFinder finder(*mesh, tolerance);
        const auto fine = make_sample(name.toStdString(), tolerance / 8, {});
        QVERIFY(fine->facet_count() > 3 * mesh->facet_count());
        double worst = 0;
        for (std::size_t v = 0; v < fine->vertices.size(); v += 3)
            worst = std::max(worst, finder.distance(fine->vertices[v]));
        QVERIFY2(worst <= tolerance && worst > 0.5 * tolerance,
                 qPrintable(QString::number(worst / tolerance)));
        // Both ways bent: concave blends are the point of all three, smaller than the ball of a 1 in cutter.
        const auto curvatures = vertex_curvatures(*fine, compute_geometry(*fine, {})->vertex_normals, {});
        double hollow = 0, bulge = 0;
        for (const VertexCurvature& c : curvatures)
            if (!std::isnan(c.mean)) {
                hollow = std::min(hollow, c.k2);
                bulge = std::max(bulge, c.k1);
            }
        QVERIFY2(-1.0 / hollow < 0.5 * inch && -1.0 / hollow > tightest_min,
                 qPrintable(QString::number(-1 / hollow)));
        QVERIFY(bulge > 0.0);
    }

    void turned_parts_are_closed() {
        const auto prism = make_sample("square-prism", default_sample_tolerance, {});
        QCOMPARE(prism->facet_count(), std::size_t(12));
        QCOMPARE(prism->box().lo, Vec3(0, -25, -25));
        QCOMPARE(prism->box().hi, Vec3(40, 25, 25));
        QVERIFY(std::abs(signed_volume(*prism) - 100'000.0) < 1e-9);

        for (const double tolerance : {0.05, 0.001, 30.0}) {
            const auto cylinder = make_sample("cylinder", tolerance, {});
            QCOMPARE(cylinder->box().lo, Vec3(0, -20, -20));
            QCOMPARE(cylinder->box().hi, Vec3(25, 20, 20));
            std::size_t n = 0;
            for (const Vec3& p : cylinder->vertices)
                if (p.x() == 0.0 && p.y() * p.y() + p.z() * p.z() > 1.0) {
                    ++n;
                    QVERIFY(std::abs(std::hypot(p.y(), p.z()) - 20.0) < 1e-13);
                }
            const double sagitta = 20.0 * (1.0 - std::cos(pi / double(n)));
            QVERIFY(sagitta <= tolerance && cylinder->facet_count() == 4 * n);
            QVERIFY(20.0 * (1.0 - std::cos(pi / double(n - 4))) > tolerance || n == 12);
            QVERIFY(
                std::abs(signed_volume(*cylinder) / (25 * 200.0 * double(n) * std::sin(2 * pi / double(n)))
                         - 1)
                < 1e-12);
        }

        const auto twisted = make_sample("twisted-prism", default_sample_tolerance, {});
        // Every section is the 45 mm square, turned.
        QVERIFY(std::abs(signed_volume(*twisted) / (45.0 * 45.0 * 60.0) - 1) < 2e-3);
        for (const Vec3& p : twisted->vertices) {
            const double angle = -0.5 * pi * p.x() / 60.0;
            const double y = std::cos(angle) * p.y() - std::sin(angle) * p.z(),
                         z = std::sin(angle) * p.y() + std::cos(angle) * p.z();
            const double out = std::max(std::abs(y), std::abs(z));
            QVERIFY(std::abs(out - 22.5) < 1e-9 || (out < 1e-9 && (p.x() == 0.0 || p.x() == 60.0)));
        }
        // The corner helix of the first side, and the middle of each side, lie within the tolerance of the
        // mesh.
        for (double x = 0; x <= 60; x += under_sanitizer ? 3.7 : 0.37)
            for (int k = 0; k < 8; ++k) {
                const double angle = 0.5 * pi * x / 60 + k * pi / 4, r = k % 2 ? 22.5 * std::sqrt(2.0) : 22.5;
                const Vec3 p(x, r * std::cos(angle), r * std::sin(angle));
                double nearest = infinity;
                for (std::size_t f = 0; f < twisted->facet_count(); ++f)
                    nearest = std::min(nearest, distance_to_facet(p, *twisted, f));
                QVERIFY(nearest <= default_sample_tolerance);
            }
        // Raised by no more than said, on a cylinder of radius 20; flanks and hollows rounder than the ball
        // of radius 1.5875 that cuts them.
        for (const auto& [name, raised] :
             {std::pair("extruded-pattern", 1.0), std::pair("swept-pattern", 1.5)}) {
            const auto mesh = make_sample(name, default_sample_tolerance, {});
            double least = infinity, most = 0;
            for (const Vec3& p : mesh->vertices) {
                const double r = std::hypot(p.y(), p.z());
                if (r > 0) least = std::min(least, r);
                most = std::max(most, r);
            }
            QVERIFY(std::abs(least - 20) < 1e-9 && most <= 20 + raised + 1e-9 && most > 20 + 0.98 * raised);
        }
        for (const char* name :
             {"square-prism", "cylinder", "twisted-prism", "extruded-pattern", "swept-pattern"}) {
            const auto mesh = make_sample(name, default_sample_tolerance, {});
            int euler = 0;
            QVERIFY(border(*mesh, euler).empty());
            QCOMPARE(euler, 2);
            // Outward everywhere: star-shaped about the middle of the axis.
            const Vec3 inside(0.5 * mesh->box().hi.x(), 0, 0);
            for (std::size_t f = 0; f < mesh->facet_count(); ++f)
                QVERIFY(mesh->facet_normal(f).dot(mesh->corner(f, 0) - inside) > 0.0);
        }
    }

    void the_mould_has_the_valleys_that_it_names() {
        const auto mesh = make_sample("mould", 0.1, {});
        int euler = 0;
        border(*mesh, euler);
        QCOMPARE(euler, 1);
        // Every edge that two facets make a valley of lies on one of them, and they are covered by such
        // edges.
        std::map<std::array<Index, 2>, Index> over;
        for (std::size_t f = 0; f < mesh->facet_count(); ++f)
            for (std::size_t k = 0; k < 3; ++k)
                over[{mesh->facets[f][k], mesh->facets[f][(k + 1) % 3]}] = Index(f);
        double named = 0, found = 0;
        for (const auto& valley : sample::mould_valleys())
            for (std::size_t i = 1; i < valley.size(); ++i)
                named += (valley[i] - valley[i - 1]).norm();
        for (const auto& [edge, f] : over) {
            const auto other = over.find({edge[1], edge[0]});
            if (other == over.end() || edge[0] > edge[1]) continue;
            const Vec3 &a = mesh->vertices[edge[0]], &b = mesh->vertices[edge[1]];
            const Vec3 n = mesh->facet_normal(f), m = mesh->facet_normal(other->second);
            if (n.cross(m).dot(b - a) >= 0 || n.dot(m) > 0.999) continue; // ridge, or flat
            double nearest = infinity;
            const Vec3 mid = 0.5 * (a + b);
            for (const auto& valley : sample::mould_valleys())
                for (std::size_t i = 1; i < valley.size(); ++i) {
                    const Vec3 d = valley[i] - valley[i - 1];
                    const double t = std::clamp((mid - valley[i - 1]).dot(d) / d.squaredNorm(), 0.0, 1.0);
                    nearest = std::min(nearest, (mid - valley[i - 1] - t * d).norm());
                }
            QVERIFY2(nearest < 1e-9, qPrintable(QString::number(nearest)));
            found += (b - a).norm();
        }
        QVERIFY2(std::abs(found - named) < 1e-6, qPrintable(QString("%1 of %2").arg(found).arg(named)));
    }

    void kinds_can_all_be_made() {
        std::set<std::string> names;
        for (const SampleKind& k : sample_kinds()) {
            QVERIFY(names.insert(k.name).second);
            QVERIFY(!k.label.empty() && !k.help.empty());
            const auto mesh = make_sample(k.name, 1.0, {});
            QVERIFY(mesh->facet_count() > 0);
            QCOMPARE(k.natural_unit, k.name.find("prism") != std::string::npos || k.name == "cylinder"
                                             || k.name == "mould"
                                             || k.name.find("pattern") != std::string::npos
                                         ? LengthUnit::mm
                                         : LengthUnit::inch);
        }
        QCOMPARE(names, (std::set<std::string>{"concave", "convex", "complex", "pillar", "gap", "shell",
                                               "mould", "square-prism", "cylinder", "twisted-prism",
                                               "extruded-pattern", "swept-pattern"}));
    }

    void bad_requests_are_refused() {
        const double nan = std::nan("");
        for (const double tolerance : {0.0, -1.0, nan, infinity, -infinity})
            QCOMPARE(code_of([&] { make_sample("complex", tolerance, {}); }), std::string("out_of_range"));
        QCOMPARE(code_of([] { make_sample("", 0.1, {}); }), std::string("out_of_range"));
        QCOMPARE(code_of([] { make_sample("Concave", 0.1, {}); }), std::string("out_of_range"));
        for (const SampleKind& k : sample_kinds())
            if (k.name != "square-prism")
                QCOMPARE(code_of([&] { make_sample(k.name, 1e-15, {}); }), std::string("out_of_range"));
        QVERIFY(make_sample("complex", 1e300, {})->facet_count() > 100);
        try {
            make_sample("knocave\n", 0.1, {});
            QFAIL("no error");
        } catch (const Error& e) {
            QVERIFY2(std::string(e.what()).find("twisted-prism") != std::string::npos, e.what());
            QVERIFY(std::string(e.what()).find('\n') == std::string::npos);
        }
    }

    void same_mesh_for_every_thread_count() {
        set_thread_count(1);
        const auto one = make_sample("complex", 0.02, {});
        set_thread_count(3);
        const auto three = make_sample("complex", 0.02, {});
        set_thread_count(0);
        QCOMPARE(one->facets, three->facets);
        QCOMPARE(one->vertices, three->vertices);
        Job job;
        job.cancel();
        QVERIFY_EXCEPTION_THROWN(make_sample("complex", 0.02, Progress(job)), Cancelled);
    }
};

FACETMILL_TEST(TestSamples)
#include "test_samples.moc"
