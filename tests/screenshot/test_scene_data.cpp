// What is handed to the graphics card: parts, paths and tools as flat arrays.
#include "core/tools/tool_library.h"
#include "tests/screenshot/scene_parts.h"
#include "tests/support/test_runner.h"
#include "viz/part_display.h"
#include "viz/path_display.h"
#include "viz/sight_tree.h"
#include "viz/tool_shape.h"

#include <QTest>

#include "core/base/parallel.h"

#include <limits>
#include <random>
#include <set>

using namespace facetmill;
using namespace facetmill::test;

namespace {

Vec3 vec(const std::vector<float>& values, std::size_t i) {
    return {double(values[3 * i]), double(values[3 * i + 1]), double(values[3 * i + 2])};
}

MeshPtr sphere(double radius, int rows, int columns) {
    auto mesh = std::make_shared<Mesh>();
    for (int i = 0; i <= rows; ++i)
        for (int k = 0; k < columns; ++k) {
            const double a = pi * i / rows, b = 2 * pi * k / columns;
            mesh->vertices.push_back(
                radius * Vec3(std::sin(a) * std::cos(b), std::sin(a) * std::sin(b), std::cos(a)));
        }
    const auto at = [&](int i, int k) { // one vertex at either pole
        return Index(i == 0 ? 0 : i == rows ? rows * columns : i * columns + k % columns);
    };
    for (int i = 0; i < rows; ++i)
        for (int k = 0; k < columns; ++k) {
            if (i + 1 < rows) mesh->facets.push_back({at(i, k), at(i + 1, k), at(i + 1, k + 1)});
            if (i > 0) mesh->facets.push_back({at(i, k), at(i + 1, k + 1), at(i, k + 1)});
        }
    return mesh;
}

/// What SightTree must find, by looking at every facet.
SightHit first_of_all(const Mesh& mesh, const Vec3& origin, const Vec3& direction) {
    SightHit best;
    for (std::size_t f = 0; f < mesh.facets.size(); ++f) {
        const Vec3 a = mesh.corner(f, 0), e1 = mesh.corner(f, 1) - a, e2 = mesh.corner(f, 2) - a;
        Mat3 m;
        m << e1, e2, -direction;
        if (m.determinant() == 0) continue;
        const Vec3 x = m.inverse() * (origin - a);
        if (x.x() < 0 || x.y() < 0 || x.x() + x.y() > 1) continue;
        if (x.z() < best.distance) best = {x.z(), f};
    }
    return best;
}

/// Signed volume and the largest angle between a facet and the normals of its corners.
struct ShapeCheck {
    double volume = 0, min_dot = 1, min_z = infinity, largest_z = -infinity, largest_radius = 0;
};
ShapeCheck examine(const RevolvedShape& s) {
    ShapeCheck c;
    for (std::size_t t = 0; t < s.triangles.size(); t += 3) {
        const auto corner = [&](std::size_t k) { return vec(s.points, std::size_t(s.triangles[t + k])); };
        const Vec3 cross = (corner(1) - corner(0)).cross(corner(2) - corner(0));
        c.volume += corner(0).dot(corner(1).cross(corner(2))) / 6;
        for (std::size_t k = 0; k < 3; ++k) {
            c.min_dot =
                std::min(c.min_dot, cross.normalized().dot(vec(s.normals, std::size_t(s.triangles[t + k]))));
            c.min_z = std::min(c.min_z, corner(k).z());
            c.largest_z = std::max(c.largest_z, corner(k).z());
            c.largest_radius = std::max(c.largest_radius, std::hypot(corner(k).x(), corner(k).y()));
        }
    }
    return c;
}

} // namespace

class TestSceneData : public QObject {
    Q_OBJECT
private slots:
    void lines_of_sight_meet_what_lies_first() {
        std::mt19937 random(7);
        std::uniform_real_distribution<double> unit(-1, 1);
        const auto any = [&] { return Vec3(unit(random), unit(random), unit(random)); };
        for (const std::size_t n : {1, 7, 8, 9, 64, 65, 700}) {
            const Vec3 middle = n == 64 ? Vec3(1e5, -2e5, 3e4) : Vec3(3, -2, 1); // also far away
            Mesh mesh;
            for (std::size_t f = 0; f < n; ++f) {
                const Vec3 at = middle + 20 * any();
                const double size = f % 5 == 0 ? 15 : 3;
                for (int k = 0; k < 3; ++k)
                    mesh.vertices.push_back(at + size * any());
                mesh.facets.push_back({Index(3 * f), Index(3 * f + 1), Index(3 * f + 2)});
            }
            mesh.facets.push_back({0, 0, 1}); // no area
            mesh.facets.push_back(mesh.facets.front());
            const SightTree tree(mesh, {});
            std::size_t met = 0;
            for (int i = 0; i < 400; ++i) {
                Vec3 direction = any().normalized();
                if (i % 3 == 0) direction = Vec3::Unit(i / 3 % 3) * (i % 2 ? 1 : -1);
                const Vec3 origin = middle + 15 * any() - (i % 4 == 0 ? 0 : 500) * direction;
                const SightHit hit = tree.first(mesh, origin, direction),
                               expected = first_of_all(mesh, origin, direction);
                QCOMPARE(hit.facet, expected.facet); // of the twins the first
                if (!hit.found()) continue;
                ++met;
                QVERIFY(std::abs(hit.distance - expected.distance) < 1e-6);
            }
            QVERIFY(n < 60 || met > 50);
        }
        // Level facets and lines along the axes: boxes without thickness.
        Mesh level;
        for (int j = 0; j <= 40; ++j)
            for (int i = 0; i <= 40; ++i)
                level.vertices.emplace_back(i, j, 0);
        for (Index j = 0; j < 40; ++j)
            for (Index i = 0; i < 40; ++i) {
                const Index a = 41 * j + i;
                level.facets.push_back({a, a + 1, a + 42});
                level.facets.push_back({a, a + 42, a + 41});
            }
        const SightTree tree(level, {});
        for (int i = 0; i <= 40; ++i) {
            const Vec3 origin(i, 40 - i, 9); // on borders, edges and corners
            const SightHit hit = tree.first(level, origin, Vec3(0, 0, -1));
            QCOMPARE(hit.facet, first_of_all(level, origin, Vec3(0, 0, -1)).facet);
            QCOMPARE(hit.distance, 9.0);
        }
        QVERIFY(!tree.first(level, Vec3(40.001, 5, 9), Vec3(0, 0, -1)).found());
        QVERIFY(!tree.first(level, Vec3(5, 5, 0), Vec3(1, 0, 0)).found());
        QVERIFY(!SightTree().first(level, Vec3(5, 5, 9), Vec3(0, 0, -1)).found());
        QVERIFY(!SightTree(Mesh(), {}).first(Mesh(), Vec3(5, 5, 9), Vec3(0, 0, -1)).found());
        Job job;
        job.cancel();
        bool cancelled = false;
        try {
            SightTree(level, Progress(job));
        } catch (const Cancelled&) {
            cancelled = true;
        }
        QVERIFY(cancelled);
    }

    void a_box_has_sharp_edges() {
        const auto d = prepare_part_display(box_part({10, 20, 30}, {14, 26, 38}), {});
        QCOMPARE(d->triangles.size(), std::size_t(36));
        QCOMPARE(d->points.size(), std::size_t(3 * 24)); // three normals at each corner
        QCOMPARE(d->lines.size(), std::size_t(2 * 12));  // no diagonal
        QCOMPARE(d->edges.size(), std::size_t(2 * 18));
        QVERIFY(!d->has_border);
        QCOMPARE(d->center, Vec3(12, 23, 34));
        const Mesh& mesh = *d->mesh;
        for (std::size_t f = 0; f < 12; ++f)
            for (std::size_t k = 0; k < 3; ++k) {
                const auto v = std::size_t(d->triangles[3 * f + k]);
                QCOMPARE(vec(d->points, v), Vec3(mesh.corner(f, int(k)) - d->center));
                QVERIFY((vec(d->normals, v) - mesh.facet_normal(f)).norm() < 1e-6);
            }
        for (std::size_t i = 0; i < d->lines.size(); i += 2) { // along an axis: an edge of the box
            const Vec3 along =
                vec(d->points, std::size_t(d->lines[i])) - vec(d->points, std::size_t(d->lines[i + 1]));
            QCOMPARE((along.array().abs() > 1e-6).count(), Eigen::Index(1));
        }
    }

    void a_sphere_is_smooth() {
        const auto mesh = sphere(5, 24, 48);
        const auto d = prepare_part_display(mesh, {});
        QVERIFY(d->lines.empty());
        std::set<Index> used;
        for (const Facet& f : mesh->facets)
            used.insert(f.begin(), f.end());
        QCOMPARE(d->points.size(), 3 * used.size()); // every vertex once; those no facet uses are left out
        for (std::size_t v = 0; v < used.size(); ++v)
            QVERIFY((vec(d->normals, v) - vec(d->points, v).normalized()).norm() < 0.02);
    }

    /// A level disc, divided into few long facets, with a rim that is round in narrow ones: the disc is not
    /// shaded as a cushion.
    void a_level_face_beside_a_rounded_rim_stays_level() {
        constexpr int around = 24, steps = 6;
        constexpr double radius = 50, rounding = 2;
        auto mesh = std::make_shared<Mesh>();
        for (int i = 0; i <= steps; ++i)
            for (int k = 0; k < around; ++k) {
                const double a = 0.5 * pi * i / steps, b = 2 * pi * k / around,
                             r = radius + rounding * std::sin(a);
                mesh->vertices.push_back(Vec3(r * std::cos(b), r * std::sin(b), rounding * std::cos(a)));
            }
        for (Index k = 1; k + 1 < around; ++k)
            mesh->facets.push_back({0, k, k + 1});
        const std::size_t level = mesh->facets.size();
        for (Index i = 0; i < steps; ++i)
            for (Index k = 0; k < around; ++k) {
                const Index a = i * around + k, b = i * around + (k + 1) % around;
                mesh->facets.push_back({a, a + around, b + around});
                mesh->facets.push_back({a, b + around, b});
            }
        const auto d = prepare_part_display(mesh, {});
        for (std::size_t c = 0; c < 3 * level; ++c) {
            const double z = vec(d->normals, std::size_t(d->triangles[c])).z();
            QVERIFY2(z > std::cos(radians(3)), qPrintable(QString::number(degrees(std::acos(z)))));
        }
    }

    void an_open_sheet_has_a_border() {
        const auto d =
            prepare_part_display(sheet_part({0, 0}, {10, 10}, 5, [](double, double) { return 0.0; }), {});
        QVERIFY(d->has_border);
        QCOMPARE(d->lines.size(), std::size_t(2 * 20));
        QCOMPARE(d->points.size(), std::size_t(3 * 36));
    }

    void odd_meshes_are_drawn() {
        // A third facet on an edge, a facet turned over, a vertex of no facet, a facet without area, two
        // equal ones.
        auto mesh = std::make_shared<Mesh>();
        mesh->vertices = {{0, 0, 0},  {1, 0, 0}, {0, 1, 0}, {0, 0, 1},
                          {0, -1, 0}, {5, 5, 5}, {2, 0, 0}, {1, 1, 0}};
        mesh->facets = {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}, {0, 1, 6}, {1, 2, 7}, {1, 2, 7}, {0, 0, 1}};
        const auto d = prepare_part_display(mesh, {});
        QCOMPARE(d->triangles.size(), 3 * mesh->facets.size());
        QCOMPARE(d->points.size(), d->normals.size());
        for (const auto v : d->triangles)
            QVERIFY(v >= 0 && 3 * std::size_t(v) < d->points.size());
        for (const auto v : d->lines)
            QVERIFY(v >= 0 && 3 * std::size_t(v) < d->points.size());
        for (const float n : d->normals)
            QVERIFY(std::isfinite(n));
        QVERIFY(d->has_border);

        QVERIFY(prepare_part_display(std::make_shared<Mesh>(), {})->triangles.empty());
    }

    void a_fan_of_many_facets_is_fast_and_right() {
        // The tip of a flat-sided cone: 40 000 facets at one vertex, no two neighbours smooth with all
        // others.
        auto mesh = std::make_shared<Mesh>();
        const int n = 40'000;
        mesh->vertices.emplace_back(0, 0, 10);
        for (int k = 0; k < n; ++k)
            mesh->vertices.emplace_back(std::cos(2 * pi * k / n), std::sin(2 * pi * k / n), 0);
        for (int k = 0; k < n; ++k)
            mesh->facets.push_back({0, Index(1 + k), Index(1 + (k + 1) % n)});
        const auto d = prepare_part_display(mesh, {});
        for (std::size_t f = 0; f < mesh->facets.size(); f += 997)
            QVERIFY((vec(d->normals, std::size_t(d->triangles[3 * f])) - mesh->facet_normal(f)).norm()
                    < 1e-6);
    }

    void the_same_for_every_thread_count() {
        const auto mesh = sheet_part({0, 0}, {hill_length, hill_width}, 150, hill);
        set_thread_count(1);
        const auto one = prepare_part_display(mesh, {});
        set_thread_count(0);
        const auto all = prepare_part_display(mesh, {});
        QVERIFY(one->points == all->points && one->normals == all->normals && one->triangles == all->triangles
                && one->lines == all->lines);
    }

    void preparing_can_be_cancelled() {
        Job job;
        job.cancel();
        QVERIFY_EXCEPTION_THROWN(
            prepare_part_display(sheet_part({0, 0}, {hill_length, hill_width}, 20, hill), Progress(job)),
            Cancelled);
        QVERIFY_EXCEPTION_THROWN(prepare_path_display({hill_path(300, 300, 3)}, Progress(job)), Cancelled);
    }

    void large_parts_have_a_preview() {
        QVERIFY(prepare_part_display(sheet_part({0, 0}, {hill_length, hill_width}, 50, hill), {})
                    ->preview.triangles.empty());
        const auto sheet = prepare_part_display(sheet_part({0, 0}, {hill_length, hill_width}, 300, hill), {});
        const PartPreview& p = sheet->preview;
        const std::size_t facets = p.triangles.size() / 3;
        QVERIFY2(facets > 10'000 && facets < 40'000, qPrintable(QString::number(facets)));
        QCOMPARE(p.points.size(), p.normals.size());
        double area = 0; // its shadow covers the part's, but for half a cell at the border
        for (std::size_t t = 0; t < p.triangles.size(); t += 3) {
            const auto corner = [&](std::size_t k) { return vec(p.points, std::size_t(p.triangles[t + k])); };
            area += (corner(1) - corner(0)).cross(corner(2) - corner(0)).z() / 2;
        }
        QVERIFY2(std::abs(area / (hill_length * hill_width) - 1) < 0.03, qPrintable(QString::number(area)));
        for (std::size_t v = 0; v < p.points.size() / 3; ++v) {
            const Vec3 at = vec(p.points, v) + sheet->center;
            QVERIFY(std::abs(at.z() - hill(at.x(), at.y())) < 0.3); // a fraction of a cell of 1 mm
            QVERIFY(std::abs(vec(p.normals, v).norm() - 1) < 1e-5);
        }
        // The corners of a box keep a normal for each side.
        const auto box = prepare_part_display(box_part({0, 0, 0}, {4, 4, 4}), {});
        QCOMPARE(make_preview(*box, {}).points.size(), std::size_t(3 * 24));
        QCOMPARE(make_preview(*box, {}).triangles.size(), std::size_t(36));
        Mesh flat;
        flat.vertices = {{1, 1, 1}};
        flat.facets = {{0, 0, 0}};
        QVERIFY(make_preview(*prepare_part_display(std::make_shared<Mesh>(flat), {}), {}).triangles.empty());
    }

    void long_paths_have_a_preview() {
        const auto few = prepare_path_display({hill_path(40, 40, 3)}, {});
        QVERIFY(few->contacts_preview.empty() && few->motions_preview[std::size_t(MotionKind::cut)].empty());
        const auto many = prepare_path_display({hill_path(400, 1000, 3)}, {});
        const Polylines &all = many->contacts, &thin = many->contacts_preview;
        QCOMPARE(thin.offsets.size(), all.offsets.size());
        QVERIFY(thin.points.size() / 3 > 30'000 && thin.points.size() / 3 < 70'000);
        for (std::size_t i = 0; i + 1 < all.offsets.size(); ++i) { // the ends stay
            QCOMPARE(vec(thin.points, std::size_t(thin.offsets[i])),
                     vec(all.points, std::size_t(all.offsets[i])));
            QCOMPARE(vec(thin.points, std::size_t(thin.offsets[i + 1]) - 1),
                     vec(all.points, std::size_t(all.offsets[i + 1]) - 1));
        }
        // Many short lines: whole ones are left out.
        const auto shorts = prepare_path_display({hill_path(60'000, 3, 3)}, {});
        const Polylines& cut = shorts->motions_preview[std::size_t(MotionKind::cut)];
        QCOMPARE(cut.points.size(), 3 * 3 * (cut.offsets.size() - 1));
        QVERIFY(cut.offsets.size() > 10'000 && cut.offsets.size() < 30'000);
    }

    void a_path_becomes_polylines_by_kind() {
        const PathSource path = hill_path(6, 11, 4);
        const auto d = prepare_path_display({path, {}}, {});
        const auto lines = [&](MotionKind k) { return d->motions[std::size_t(k)].offsets.size() - 1; };
        QCOMPARE(d->contacts.offsets.size() - 1, std::size_t(6));
        QCOMPARE(d->contacts.points.size(), std::size_t(3 * 6 * 11));
        QCOMPARE(lines(MotionKind::cut), std::size_t(6));
        QCOMPARE(lines(MotionKind::link), std::size_t(4));
        QCOMPARE(lines(MotionKind::approach), std::size_t(2));
        QCOMPARE(lines(MotionKind::retract), std::size_t(2));
        const Polylines& cut = d->motions[std::size_t(MotionKind::cut)];
        QCOMPARE(cut.points.size(), std::size_t(3 * 6 * 11));
        const auto& cl = path.contacts->passes[1].cl;
        for (std::size_t j = 0; j < cl.size(); ++j)
            QVERIFY((vec(cut.points, 11 + j) + d->center - cl[j].tip).norm() < 1e-4);
        for (const auto& p : d->motions)
            QCOMPARE(std::size_t(p.offsets.back()) * 3, p.points.size());
        QVERIFY(d->box.hi.z() == 30);

        // Dashes cover 3/5 of the rapid moves, all on them.
        const Polylines& rapid = d->motions[std::size_t(MotionKind::rapid)];
        double dashes = 0, moves = 0;
        for (std::size_t i = 0; i + 1 < rapid.offsets.size(); ++i)
            dashes += (vec(rapid.points, 2 * i) - vec(rapid.points, 2 * i + 1)).norm();
        for (std::size_t i = 1; i < path.motions->motions.size(); ++i)
            if (path.motions->motions[i].kind == MotionKind::rapid)
                moves += (path.motions->motions[i].to.tip - path.motions->motions[i - 1].to.tip).norm();
        QVERIFY2(std::abs(dashes / moves - 0.6) < 0.05, qPrintable(QString::number(dashes / moves)));
    }

    void very_long_rapids_have_a_bounded_number_of_dashes() {
        auto motions = std::make_shared<ToolMotions>();
        for (int i = 0; i < 2000; ++i)
            motions->motions.push_back({MotionKind::rapid, {Vec3(i % 2 ? 1e6 : -1e6, 0, 0), Vec3(0, 0, 1)}});
        const auto d = prepare_path_display({{nullptr, motions}}, {});
        const auto dashes = d->motions[std::size_t(MotionKind::rapid)].offsets.size();
        QVERIFY(dashes > 50'000 && dashes < 300'000);
    }

    void nothing_and_nonsense_in_a_path() {
        QVERIFY(prepare_path_display({}, {})->box.empty());
        const double nan = std::numeric_limits<double>::quiet_NaN();
        const Vec3 axis(0, 0, 1);
        auto contacts = std::make_shared<StrategyResult>();
        contacts->passes.resize(3);
        contacts->passes[1].cc = {{Vec3(1, 2, 3), axis}}; // a pass of one point
        contacts->passes[2].cc = {{Vec3(nan, 0, 0), axis}, {Vec3(0, infinity, 0), axis}};
        auto motions = std::make_shared<ToolMotions>();
        motions->motions = {{MotionKind::cut, {Vec3(0, 0, 0), axis}},
                            {MotionKind::cut, {Vec3(1, 0, 0), axis}},
                            {MotionKind::cut, {Vec3(nan, 0, 0), axis}},
                            {MotionKind::cut, {Vec3(3, 0, 0), axis}},
                            {MotionKind::cut, {Vec3(4, 0, 0), axis}}};
        const auto d = prepare_path_display({{contacts, motions}}, {});
        QCOMPARE(d->contacts.points.size(), std::size_t(3));
        const Polylines& cut = d->motions[std::size_t(MotionKind::cut)];
        QCOMPARE(cut.offsets, (std::vector<std::int32_t>{0, 2, 4})); // broken at the point that is none
        QCOMPARE(d->box.hi, Vec3(4, 2, 3));
        QVERIFY(path_source(nullptr).contacts == nullptr);
    }

    void tools_are_closed_and_face_outward() {
        Tool tool;
        tool.diameter = 10;
        tool.corner_radius = 5;
        tool.flute_length = 30;
        tool.shank_diameter = 8;
        tool.shank_length = 12;
        tool.holder = {{20, 10}, {40, 5}};
        const ToolShape ball = make_tool_shape(tool);
        const auto near = [](double a, double b, double relative) {
            return std::abs(a - b) < relative * std::abs(b);
        };
        const ShapeCheck c = examine(ball.cutter), s = examine(ball.shank), h = examine(ball.holder);
        QVERIFY(near(c.volume, pi * 25 * 25 + 2.0 / 3 * pi * 125, 0.005)); // cylinder and half a ball
        QVERIFY(near(s.volume, pi * 16 * 12, 0.005));
        QVERIFY(near(h.volume, pi * 100 * 10 + pi * 400 * 5, 0.005));
        for (const ShapeCheck& x : {c, s, h})
            QVERIFY2(x.min_dot > 0.95, qPrintable(QString::number(x.min_dot)));
        QCOMPARE(c.min_z, 0.0);
        QVERIFY(near(c.largest_z, 30, 1e-6) && near(s.min_z, 30, 1e-6) && near(h.min_z, 42, 1e-6));
        QVERIFY(near(h.largest_z, 57, 1e-6) && near(h.largest_radius, 20, 1e-6));
        QCOMPARE(ball.length, 57.0);
        QCOMPARE(ball.radius, 20.0);

        tool.corner_radius = 0;
        tool.shank_length = 0;
        tool.holder.clear();
        const ToolShape flat = make_tool_shape(tool);
        QVERIFY(near(examine(flat.cutter).volume, pi * 25 * 30, 0.005));
        QVERIFY(flat.shank.triangles.empty() && flat.holder.triangles.empty());
        QCOMPARE(flat.cutter.rings.size(), std::size_t(2 * 2 * 96)); // at the bottom and the top

        tool.corner_radius = 2;
        tool.taper_angle = radians(10);
        QVERIFY(examine(make_tool_shape(tool).cutter).min_dot > 0.95);
        tool.diameter = -1;
        QVERIFY_EXCEPTION_THROWN(make_tool_shape(tool), Error);
    }

    /// What the library of tools made steps of is drawn as the cones that it was.
    void holders_have_their_cones_again() {
        const std::vector<HolderCone> outline{
            {6, 20, 20}, {10, 20, 28}, {5, 28, 28}, {12, 40, 40}, {9, 40, 32}};
        Tool tool;
        tool.diameter = 10;
        tool.flute_length = 20;
        tool.shank_length = 0;
        tool.holder = holder_steps(outline);
        QVERIFY(tool.holder.size() > outline.size());
        const auto pieces = holder_pieces(tool.holder);
        QCOMPARE(pieces.size(), outline.size());
        double volume = 0;
        for (std::size_t i = 0; i < pieces.size(); ++i) {
            QVERIFY(std::abs(pieces[i].lower - outline[i].lower_diameter) < 1e-9);
            QVERIFY(std::abs(pieces[i].upper - outline[i].upper_diameter) < 1e-9);
            QVERIFY(std::abs(pieces[i].length - outline[i].length) < 1e-9);
            const double a = pieces[i].lower / 2, b = pieces[i].upper / 2;
            volume += pi * pieces[i].length * (a * a + a * b + b * b) / 3;
        }
        const ShapeCheck drawn = examine(make_tool_shape(tool).holder);
        QVERIFY2(std::abs(drawn.volume - volume) < 0.005 * volume, qPrintable(QString::number(drawn.volume)));
        QVERIFY(drawn.min_dot > 0.95);
        // Two steps may be anything, and so may high ones.
        QCOMPARE(holder_pieces({{20, 5}, {21, 5}}).size(), std::size_t(2));
        QCOMPARE(holder_pieces({{20, 10}, {30, 10}, {40, 10}}).size(), std::size_t(3));
        QCOMPARE(holder_pieces({{20, 10}, {0, 10}, {20, 0}}).size(), std::size_t(1));
    }
};

FACETMILL_TEST(TestSceneData)
#include "test_scene_data.moc"
