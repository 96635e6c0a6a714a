// Lines of the surface along drive planes: on planes and boxes with known answers, on random sheets against
// facets taken one by one, and what a slice says of the surface near a place against all of its points.
#include "core/strategy/surface/surface_lines.h"
#include "tests/property/shapes.h"
#include "tests/support/random_meshes.h"
#include "tests/support/test_runner.h"
#include "tests/support/trials.h"
#include "tests/unit/strategy/surface/slice_length.h"

#include <QTest>

#include <functional>

using namespace facetmill;
using namespace facetmill::test;

namespace {

/// Lines keep a reference to mesh and geometry.
struct Lines {
    Mesh mesh;
    std::shared_ptr<const MeshGeometry> geometry;
    std::unique_ptr<SurfaceLines> lines;

    explicit Lines(Mesh part, double angle = 0, double spacing = 1, const SurfaceSlice::Options& options = {})
        : mesh(std::move(part)), geometry(compute_geometry(mesh, Progress())),
          lines(std::make_unique<SurfaceLines>(mesh, *geometry, DriveFrame(angle), spacing, options,
                                               Progress())) {}
    const SurfaceLines* operator->() const { return lines.get(); }
    SurfaceLines* operator->() { return lines.get(); }
};

std::shared_ptr<Mesh> random_sheet(Random& rng, std::uint64_t seed) {
    const double a = uniform(rng, 0.5, 3), b = uniform(rng, 0.2, 0.8), c = uniform(rng, 0.2, 0.8);
    return field(
        24, 30, [=](double x, double y) { return a * std::sin(b * x) * std::cos(c * y); }, 0.3, seed);
}

Mesh flipped(Mesh mesh) {
    for (Facet& f : mesh.facets)
        std::swap(f[1], f[2]);
    return mesh;
}

/// Distance of p to a polyline.
double distance_to(const std::vector<Vec3>& points, const Vec3& p) {
    double least = infinity;
    for (std::size_t i = 1; i < points.size(); ++i)
        least = std::min(least, distance_to_segment(p, points[i - 1], points[i]));
    return least;
}

} // namespace

class TestSurfaceLines : public QObject {
    Q_OBJECT
private slots:
    void distance_to_a_segment() {
        const Vec3 a(1, 0, 0), b(4, 0, 0);
        QCOMPARE(distance_to_segment(Vec3(2, 3, 4), a, b), 5.0);
        QCOMPARE(distance_to_segment(Vec3(-2, 4, 0), a, b), 5.0);
        QCOMPARE(distance_to_segment(Vec3(8, 0, 3), a, b), 5.0);
        QCOMPARE(distance_to_segment(Vec3(1, 0, 7), a, a), 7.0);
    }

    void a_tilted_plane_has_one_line_whichever_way_it_is_wound() {
        const Mesh plane = height_field([](double x, double y) { return 0.75 * x + 0.2 * y; }, Vec2(-8, -6),
                                        Vec2(8, 6), 5, 7);
        const Vec3 up = Vec3(-0.75, -0.2, 1).normalized(), along = Vec3(1, 0, 0.75).normalized();
        for (const Mesh& mesh : {plane, flipped(plane)}) {
            const Lines part(mesh);
            const auto lines = part->lines(1.3);
            QCOMPARE(lines.size(), std::size_t(1));
            const SurfaceLine& line = lines.front();
            QVERIFY(std::abs(line.length() - 20) < 1e-12);
            // Also beyond the ends: the line goes on straight.
            for (const double s : {-3.0, 0.0, 4.7, 20.0, 26.0}) {
                const SlicePoint p = line.at(s);
                const Vec3 exact = Vec3(-8, 1.3, -6 + 0.26) + s * along;
                QVERIFY2((p.point - exact).norm() < 1e-12, qPrintable(QString::number(s)));
                QVERIFY((p.normal - up).norm() < 1e-12);
                QVERIFY(std::abs(p.u - p.point.x()) < 1e-12);
                QVERIFY((line.direction(s) - along).norm() < 1e-12);
            }
        }
    }

    /// Its sides stand upright: a line may begin and end on them, since normals turn over the edge, but not
    /// below.
    void a_box_is_passed_over_its_top_only() {
        const Lines part(box(Vec3(-5, -4, 0), Vec3(7, 4, 9)));
        for (const double v : {-3.5, 0.1, 2.0}) {
            const auto lines = part->lines(v);
            QCOMPARE(lines.size(), std::size_t(1));
            double from = infinity, to = -infinity;
            for (const SlicePoint& p : lines.front().points) {
                QVERIFY(p.point.z() > 1 && p.normal.z() > 0);
                if (p.point.z() < 9 - 1e-12) {
                    QVERIFY(p.point.x() == -5 || p.point.x() == 7);
                    continue;
                }
                from = std::min(from, p.point.x());
                to = std::max(to, p.point.x());
            }
            QCOMPARE(from, -5.0);
            QCOMPARE(to, 7.0);
        }
    }

    /// A hole ends a line, and another begins behind it.
    void a_hole_parts_the_line() {
        const Mesh plate =
            only(height_field([](double, double) { return 2.0; }, Vec2(0, 0), Vec2(9, 3), 9, 3),
                 [](const Vec3& p) { return std::abs(p.x() - 4.5) > 0.5; });
        const Lines part(plate);
        const auto lines = part->lines(1.4);
        QCOMPARE(lines.size(), std::size_t(2));
        QVERIFY(std::abs(lines[0].length() - 4) < 1e-12 && std::abs(lines[1].length() - 4) < 1e-12);
        const SurfaceSlice slice(lines, {});
        QCOMPARE(slice.ends().size(), std::size_t(4));
        QVERIFY(slice.ends()[0].first && std::abs(slice.ends()[0].u) < 1e-12);
        QVERIFY(!slice.ends()[1].first && std::abs(slice.ends()[1].u - 4) < 1e-12);
        QVERIFY(slice.covers(3, 4.2) && slice.covers(3.9, 6) && slice.covers(-5, 20));
        QVERIFY(!slice.covers(4.1, 4.9) && !slice.covers(9.1, 12) && !slice.covers(-2, -0.1));
    }

    /// Nothing is missed and nothing doubled: a sheet's lines are as long as the cuts of its facets.
    void random_sheets_against_facets_one_by_one() {
        Random rng(11);
        for (int trial = 0; trial < trials(20, 5); ++trial) {
            const double angle = uniform(rng, 0, 2 * pi);
            const Lines part(*random_sheet(rng, std::uint64_t(trial + 1)), angle);
            for (int k = 0; k < 5; ++k) {
                const double v = uniform(rng, part->lo(), part->hi());
                double sum = 0;
                for (const SurfaceLine& line : part->lines(v)) {
                    sum += line.length();
                    double measured = 0;
                    for (std::size_t i = 1; i < line.points.size(); ++i) {
                        measured += (line.points[i].point - line.points[i - 1].point).norm();
                        QVERIFY(std::abs(line.arc[i] - measured) < 1e-9);
                        QVERIFY((line.at(line.arc[i]).point - line.points[i].point).norm() < 1e-9);
                        QVERIFY(line.points[i].normal.z() > 0);
                    }
                    QVERIFY(line.points.back().u > line.points.front().u);
                }
                const double exact = length_by_facet(part.mesh, v, DriveFrame(angle));
                QVERIFY2(std::abs(sum - exact) < 1e-9, qPrintable(QString("%1 of %2").arg(sum).arg(exact)));
            }
        }
    }

    /// The raised piece of a thinned slice stands for the line itself, raised, near a place.
    void near_against_all_points_of_the_line() {
        Random rng(5);
        const SurfaceSlice::Options options{0.01, 0.5, 2};
        const double raise = 0.4, reach = 2;
        std::size_t found = 0, none = 0;
        for (int trial = 0; trial < trials(10, 5); ++trial) {
            const Lines part(*random_sheet(rng, std::uint64_t(trial + 50)), uniform(rng, 0, 2 * pi));
            for (int k = 0; k < 80; ++k) {
                const double v = uniform(rng, part->lo(), part->hi());
                const auto lines = part->lines(v);
                const SurfaceSlice slice(lines, options);
                // A place of the part, or some way off it.
                const auto f = std::size_t(whole(rng, 0, int(part.mesh.facet_count()) - 1));
                const Vec3 p = (part.mesh.corner(f, 0) + part.mesh.corner(f, 1) + part.mesh.corner(f, 2)) / 3,
                           n = part.mesh.facet_normal(f);
                double nearest = infinity, at_u = 0;
                for (const SurfaceLine& line : lines)
                    for (double s = 0; s <= line.length(); s += 0.01)
                        if (const SlicePoint q = line.at(s); (q.point - p).norm() < nearest) {
                            nearest = (q.point - p).norm();
                            at_u = q.u;
                        }
                std::vector<Vec3> raised;
                const bool is_near = slice.near(p, n, at_u, reach, raise, raised);
                if (nearest < reach - options.longest) QVERIFY(is_near);
                if (nearest > reach + options.extension) QVERIFY(!is_near);
                if (!is_near) {
                    ++none;
                    continue;
                }
                ++found;
                // Near the place the raised polyline passes where the raised line does.
                for (const SurfaceLine& line : lines)
                    for (double s = 0; s <= line.length(); s += 0.05) {
                        const SlicePoint q = line.at(s);
                        if ((q.point - p).norm() > 0.5 * reach || q.normal.dot(n) <= 0) continue;
                        const double off = distance_to(raised, q.point + raise * q.normal);
                        QVERIFY2(off < 0.1, qPrintable(QString::number(off)));
                    }
            }
        }
        QVERIFY2(found > trials(std::size_t(50)) && none > trials(std::size_t(50)),
                 qPrintable(QString("%1 %2").arg(found).arg(none)));
    }

    /// Slopes up to the upright are surface, and a line of two points is one.
    void steep_and_short_lines_count() {
        const auto slope = [](double rise) {
            return height_field([rise](double x, double) { return rise * x; }, Vec2(0, 0), Vec2(2, 2), 3, 3);
        };
        for (const double rise : {5.0, 50.0, 800.0}) {
            const Lines part(slope(rise));
            const auto lines = part->lines(0.9);
            QCOMPARE(lines.size(), std::size_t(1));
            QVERIFY(std::abs(lines[0].length() - 2 * std::hypot(1, rise)) < 1e-9 * rise);
        }
        QVERIFY(Lines(slope(2000))->lines(0.9).empty());
        Mesh one;
        one.vertices = {Vec3(0, 0, 0), Vec3(4, 0, 1), Vec3(0, 4, 0)};
        one.facets = {{0, 1, 2}};
        const auto lines = Lines(one)->lines(1.0);
        QCOMPARE(lines.size(), std::size_t(1));
        QCOMPARE(lines[0].points.size(), std::size_t(2));
        QVERIFY((lines[0].points.back().point - Vec3(3, 1, 0.75)).norm() < 1e-12);
    }

    /// A body like a spinning top: lines go over all of its lid, from rim to rim, wherever the cut
    /// begins; a little below the rim, too, since normals turn over it.
    void a_closed_body_is_passed_over_from_rim_to_rim() {
        Mesh top;
        constexpr int sides = 7;
        for (int k = 0; k < sides; ++k)
            top.vertices.emplace_back(5 * std::cos(2 * pi * k / sides), 5 * std::sin(2 * pi * k / sides), 0);
        top.vertices.emplace_back(0.3, 0.2, 1);
        top.vertices.emplace_back(0, 0, -9);
        Mesh lid = top;
        for (Index k = 0; k < sides; ++k) {
            const Index next = (k + 1) % sides;
            top.facets.push_back({k, next, sides});
            lid.facets.push_back(top.facets.back());
            top.facets.push_back({next, k, sides + 1});
        }
        for (int k = 0; k < 12; ++k) {
            const double angle = 2 * pi * k / 12 + 0.1;
            const Lines part(top, angle);
            for (const double v : {-2.1, 0.05, 1.7}) {
                double sum = 0;
                for (const SurfaceLine& line : part->lines(v))
                    for (std::size_t i = 1; i < line.points.size(); ++i)
                        if (std::min(line.points[i].point.z(), line.points[i - 1].point.z()) > -1e-9)
                            sum += line.arc[i] - line.arc[i - 1];
                const double exact = length_by_facet(lid, v, DriveFrame(angle));
                QVERIFY2(std::abs(sum - exact) < 1e-9, qPrintable(QString("%1 of %2").arg(sum).arg(exact)));
            }
        }
    }

    /// Between two points of a line the facet is that of the nearer one.
    void places_of_a_line_know_their_facet() {
        Random rng(4);
        const Lines part(*random_sheet(rng, 9), 0.4);
        for (const SurfaceLine& line : part->lines(0.5 * (part->lo() + part->hi())))
            for (std::size_t i = 1; i < line.points.size(); ++i) {
                const double from = line.arc[i - 1], piece = line.arc[i] - from;
                if (piece < 1e-6) continue;
                QCOMPARE(line.at(from + 0.3 * piece).facet, line.points[i - 1].facet);
                QCOMPARE(line.at(from + 0.7 * piece).facet, line.points[i].facet);
            }
    }

    /// What is thinned stays as near to the line as is asked, and so does its raised copy.
    void a_thinned_slice_keeps_to_the_line() {
        const auto line_of = [](const std::function<double(double)>& height,
                                const std::function<double(double)>& lean) {
            SurfaceLine line;
            for (double x = 0; x < 20; x += 0.125) {
                SlicePoint p;
                p.point = Vec3(x, 0, height(x));
                p.normal = Vec3(std::sin(lean(x)), 0, std::cos(lean(x)));
                p.u = x;
                line.arc.push_back(
                    line.points.empty() ? 0 : line.arc.back() + (p.point - line.points.back().point).norm());
                line.points.push_back(p);
            }
            return line;
        };
        const auto level = [](double) { return 0.0; };
        const auto wavy = [](double x) { return 0.04 * std::sin(1.5 * x); };
        const SurfaceSlice::Options options{0.005, 3, 0};
        for (const bool leans : {false, true}) {
            const SurfaceLine line =
                leans ? line_of(level, [&](double x) { return 5 * wavy(x); }) : line_of(wavy, level);
            const SurfaceSlice slice({line}, options);
            std::vector<Vec3> raised;
            // Leaning normals count at the tip of the longest piece, by twenty times as much.
            const double raise = leans ? options.longest : 0,
                         allowed = leans ? 20 * options.deviation : options.deviation;
            QVERIFY(slice.near(Vec3(10, 0, 0), Vec3::UnitZ(), 10, 40, raise, raised));
            QVERIFY(raised.size() < line.points.size() / 2);
            for (const SlicePoint& p : line.points) {
                const double off = distance_to(raised, p.point + raise * p.normal);
                QVERIFY2(off <= allowed + 1e-9, qPrintable(QString("%1 at %2").arg(off).arg(p.u)));
            }
            for (std::size_t i = 1; i < raised.size(); ++i)
                QVERIFY(leans || (raised[i] - raised[i - 1]).norm() <= options.longest + 1e-9);
        }
    }

    /// Beyond both of its ends a slice goes on by the extension, and no farther.
    void a_slice_goes_on_beyond_its_ends() {
        const Lines part(
            height_field([](double x, double) { return 0.5 * x; }, Vec2(-8, -2), Vec2(8, 2), 4, 2));
        const auto lines = part->lines(0.3);
        const Vec3 along = Vec3(1, 0, 0.5).normalized(), up = Vec3(-0.5, 0, 1).normalized();
        const SurfaceSlice plain(lines, {0.01, 1, 0}), extended(lines, {0.01, 1, 2});
        std::vector<Vec3> raised;
        for (const double side : {-1.0, 1.0}) {
            const Vec3 end = side * 8 * Vec3(1, 0, 0.5) + Vec3(0, 0.3, 0), p = end + side * 3 * along;
            QVERIFY(!plain.near(p, up, p.x(), 1.5, 0, raised));
            QVERIFY(extended.near(p, up, p.x(), 1.5, 0, raised));
            QVERIFY(distance_to(raised, end + side * 2 * along) < 1e-9);
            QVERIFY(!extended.near(end + side * 4 * along, up, p.x() + side, 1.5, 0, raised));
        }
    }

    void planes_of_the_lattice_are_kept_until_forgotten() {
        Lines part(height_field([](double, double) { return 0.0; }, Vec2(0, 1), Vec2(4, 6), 2, 2), 0, 0.5);
        QCOMPARE(part->v(3), 1 + 1.5);
        QCOMPARE(part->beyond(2.2, 1.9), 3L); // upwards: the next above
        QCOMPARE(part->beyond(2.2, 4.0), 2L); // downwards: the next below
        QCOMPARE(part->beyond(2.5, 1.0), 3L); // on a plane: that one, from either side
        QCOMPARE(part->beyond(2.5, 4.0), 3L);
        const auto slice = part->slice(4);
        QVERIFY(!slice->empty());
        QCOMPARE(part->slice(4), slice);
        part->forget(4);
        QCOMPARE(part->slice(4), slice);
        part->forget(5);
        QVERIFY(part->slice(4) != slice);
        QVERIFY(part->slice(40)->empty());
    }
};

FACETMILL_TEST(TestSurfaceLines)
#include "test_surface_lines.moc"
