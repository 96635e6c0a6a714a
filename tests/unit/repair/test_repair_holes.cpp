// Pieces, facets turned to agree, holes: on bodies of known shape, and on random dirty ones.
#include "core/base/parallel.h"
#include "core/repair/holes.h"
#include "core/repair/survey.h"
#include "tests/support/cancel_at.h"
#include "tests/support/dirty_scan.h"
#include "tests/support/error_code.h"
#include "tests/support/test_runner.h"
#include "tests/unit/mesh/shapes.h"
#include "tests/unit/repair/repair_support.h"

#include <QTest>

using namespace facetmill;
using namespace facetmill::test;

namespace {

using Kind = RepairStep::Kind;

RepairStep holes_up_to(double size, RepairStep::Fill fill = RepairStep::Fill::smooth) {
    RepairStep step{.kind = Kind::holes};
    step.size = size;
    step.fill = fill;
    return step;
}

RepairStep pieces_below(double size) {
    RepairStep step{.kind = Kind::pieces};
    step.size = size;
    return step;
}

Mesh without_facets(const Mesh& mesh, const std::function<bool(const Vec3&)>& goes) {
    Mesh rest = mesh;
    rest.facets.clear();
    for (std::size_t f = 0; f < mesh.facet_count(); ++f)
        if (!goes((mesh.corner(f, 0) + mesh.corner(f, 1) + mesh.corner(f, 2)) / 3))
            rest.facets.push_back(mesh.facets[f]);
    return rest;
}

/// Turns some facets, doubles some, in either winding.
Mesh muddled(const Mesh& mesh, Random& rng, bool doubles) {
    Mesh result = mesh;
    for (Facet& f : result.facets)
        if (whole(rng, 0, 2) == 0) std::swap(f[1], f[2]);
    for (int i = 0; doubles && i < 20; ++i) {
        Facet f = result.facets[std::size_t(whole(rng, 0, int(mesh.facet_count()) - 1))];
        if (i % 2) std::swap(f[0], f[2]);
        result.facets.push_back(f);
    }
    return result;
}

} // namespace

class TestRepairHoles : public QObject {
    Q_OBJECT
private slots:
    void a_cube_without_a_facet_gets_its_volume_back() {
        for (std::size_t gone = 0; gone < 12; ++gone)
            for (const auto fill : {RepairStep::Fill::flat, RepairStep::Fill::smooth}) {
                Mesh cube = cube_mesh(10);
                cube.facets.erase(cube.facets.begin() + std::ptrdiff_t(gone));
                const Repaired r = repaired(cube, {holes_up_to(0, fill)});
                const MeshReport report = report_of_mesh(*r.mesh);
                QVERIFY(report.watertight);
                QVERIFY(std::abs(report.file_volume - 1000) < 1e-9);
                QVERIFY(stands_in_order(cube, *r.mesh));
                QCOMPARE(r.steps[0].displacement, 0.0);
            }
    }

    void a_lid_of_two_facets_is_laid_flat() {
        const Mesh open = without_facets(cube_mesh(10), [](const Vec3& c) { return c.z() > 9.9; });
        const Repaired r = repaired(open, {holes_up_to(0, RepairStep::Fill::flat)});
        const MeshReport report = report_of_mesh(*r.mesh);
        QVERIFY(report.watertight);
        QVERIFY(std::abs(report.file_volume - 1000) < 1e-9);
        QCOMPARE(r.steps[0].count("filled"), std::size_t(1));
        QCOMPARE(r.steps[0].count("facets_added"), std::size_t(2));
    }

    void a_hole_says_how_large_it_is() {
        const Mesh open = without_facets(cube_mesh(10), [](const Vec3& c) { return c.z() > 9.9; });
        const HoleList list = holes_of(open, {});
        QCOMPARE(list.holes.size(), std::size_t(1));
        QCOMPARE(list.holes[0].loop.size(), std::size_t(4));
        QVERIFY(std::abs(list.holes[0].perimeter - 40) < 1e-12);
        QVERIFY(std::abs(list.holes[0].diameter - std::sqrt(200.0)) < 1e-12);
        QVERIFY((list.holes[0].center - Vec3(5, 5, 10)).norm() < 1e-12);
    }

    void a_smooth_fill_goes_on_as_the_sphere_does() {
        const Mesh sphere = ringed_sphere(40, 20);
        const Mesh open = without_facets(
            sphere, [](const Vec3& c) { return c.normalized().dot(Vec3(1, 0.2, 0.3).normalized()) > 0.96; });
        const Repaired smooth = repaired(open, {holes_up_to(0)});
        const Repaired flat = repaired(open, {holes_up_to(0, RepairStep::Fill::flat)});
        QVERIFY(report_of_mesh(*smooth.mesh).watertight);
        QVERIFY(report_of_mesh(*flat.mesh).watertight);
        double off = 0;
        for (const Vec3& p : smooth.mesh->vertices)
            off = std::max(off, std::abs(p.norm() - 20));
        // The lid is 0.8 mm high; 0.152 mm is what the least sum of squared Laplacians is off there.
        QVERIFY2(off < 0.16, qPrintable(QString::number(off)));
        const double whole_volume = report_of_mesh(sphere).file_volume;
        QVERIFY(whole_volume - report_of_mesh(*flat.mesh).file_volume
                > 2 * std::abs(whole_volume - report_of_mesh(*smooth.mesh).file_volume));
    }

    void larger_holes_are_left() {
        const Mesh sphere = ringed_sphere(30, 20);
        const Mesh open = without_facets(
            sphere, [](const Vec3& c) { return c.normalized().x() > 0.98 || c.normalized().x() < -0.9; });
        const Repaired r = repaired(open, {holes_up_to(17)});
        QCOMPARE(r.steps[0].count("filled"), std::size_t(1));
        QCOMPARE(r.steps[0].count("left_larger"), std::size_t(1));
        QVERIFY(stands_in_order(open, *r.mesh));
    }

    /// Each hole by itself: flat, smooth or left, whatever the step for the others says.
    void one_hole_is_chosen_by_its_place() {
        const Mesh sphere = ringed_sphere(30, 20);
        const auto at = [](const Vec3& c, const Vec3& way) { return c.normalized().dot(way) > 0.97; };
        const Mesh open = without_facets(sphere, [&](const Vec3& c) {
            return at(c, Vec3::UnitX()) || at(c, -Vec3::UnitX()) || at(c, Vec3::UnitY());
        });
        const auto one = [](const Vec3& place, RepairStep::Fill fill) {
            RepairStep step{.kind = RepairStep::Kind::hole};
            step.at = {place.x(), place.y(), place.z()};
            step.fill = fill;
            return step;
        };
        using enum RepairStep::Fill;
        const auto open_edges = [&](const Repaired& r) { return report_of_mesh(*r.mesh).open_edges; };
        const auto all = holes_of(open, {}).holes;
        QCOMPARE(all.size(), std::size_t(3));
        const std::size_t rim = report_of_mesh(open).open_edges;
        // One alone is filled, the others stay as they were.
        const Repaired filled = repaired(open, {one(Vec3(19, 0.5, 0), flat)});
        QCOMPARE(filled.steps[0].count("filled"), std::size_t(1));
        QVERIFY(stands_in_order(open, *filled.mesh));
        const auto rest = holes_of(*filled.mesh, {}).holes;
        QCOMPARE(rest.size(), std::size_t(2));
        for (const Hole& hole : rest)
            QVERIFY(std::abs(hole.center.x()) < 1 || hole.center.x() < -15);
        // Smooth bulges, flat does not.
        const auto volume = [&](const Repaired& r) { return report_of_mesh(*r.mesh).file_volume; };
        const RepairStep others = holes_up_to(0);
        QVERIFY(volume(repaired(open, {one(Vec3(19, 0, 0), smooth), others}))
                > volume(repaired(open, {one(Vec3(19, 0, 0), flat), others})) + 1);
        // Left, by the step for all that follows; filled, where it comes before.
        const Repaired left_open = repaired(open, {one(Vec3(0, 19, 0), left), others});
        QCOMPARE(left_open.steps[1].count("filled"), std::size_t(2));
        QCOMPARE(left_open.steps[1].count("left_as_asked"), std::size_t(1));
        QVERIFY(open_edges(left_open) > 0 && open_edges(left_open) < rim);
        QCOMPARE(open_edges(repaired(open, {others, one(Vec3(0, 19, 0), left)})), std::size_t(0));
        // The steps before are known though others have carried them out.
        const std::vector<RepairStep> recipe{one(Vec3(0, 19, 0), left), others};
        const Repaired second = run_recipe(std::make_shared<Mesh>(open), recipe, {}, {}, 1);
        QCOMPARE(second.steps.size(), std::size_t(1));
        QVERIFY(equal_meshes(*second.mesh, *left_open.mesh));
        // Where none is, none is filled; a step for all cannot leave them.
        QCOMPARE(repaired(open, {one(Vec3(0, 0, 19), flat)}).steps[0].count("not_found"), std::size_t(1));
        RepairStep wrong = others;
        wrong.fill = left;
        QVERIFY_EXCEPTION_THROWN(check_recipe({wrong}, "repair"), Error);
    }

    void the_rim_of_a_flat_sheet_is_no_hole() {
        const Mesh sheet =
            grid_mesh(6, 6, false, false, 0.2, [](double a, double b) { return Vec3(10 * a, 10 * b, 1.0); });
        const Repaired r = repaired(sheet, {holes_up_to(0)});
        QCOMPARE(r.steps[0].count("left_without_fit"), std::size_t(1));
        QVERIFY(equal_meshes(*r.mesh, sheet));
    }

    void random_dirty_scans_become_whole() {
        for (std::uint64_t seed = 1; seed <= 8; ++seed) {
            const DirtyScan scan = dirty_scan(40, 0.1, 6, 5, seed);
            const Repaired r = repaired(scan.mesh, {pieces_below(6), holes_up_to(0)});
            const MeshReport report = report_of_mesh(*r.mesh);
            QVERIFY2(report.watertight, qPrintable(QString("%1: %2 open, %3 of more, %4 against, %5 unfit")
                                                       .arg(seed)
                                                       .arg(report.open_edges)
                                                       .arg(report.non_manifold_edges)
                                                       .arg(report.inconsistent_edges)
                                                       .arg(r.steps[1].count("left_without_fit"))));
            QCOMPARE(report.shells, std::size_t(1));
            QCOMPARE(r.steps[0].count("pieces_removed"), std::size_t(5));
            QVERIFY(r.steps[1].count("filled") >= 1 && r.steps[1].count("left_without_fit") == 0);
            const Repaired pieces = repaired(scan.mesh, {pieces_below(6)});
            QVERIFY(stands_in_order(*pieces.mesh, scan.mesh));
            QVERIFY(stands_in_order(*pieces.mesh, *r.mesh));
            const DirtyScan closed = dirty_scan(40, 0.1, 0, 0, seed);
            QVERIFY(std::abs(report.file_volume / report_of_mesh(closed.mesh).file_volume - 1) < 2e-3);
        }
    }

    void pieces_go_by_each_of_their_measures() {
        Mesh mesh = cube_mesh(10);
        append_mesh(mesh, cube_mesh(1, Vec3(20, 0, 0)));
        append_mesh(mesh, ringed_sphere(3, 2, Vec3(0, 30, 0)));
        RepairStep facets{.kind = Kind::pieces}, area = facets, keep = facets;
        facets.facets = 13;
        area.area = 7;
        keep.keep = 1;
        QCOMPARE(repaired(mesh, {facets}).mesh->facet_count(), ringed_sphere(3, 2).facet_count());
        QCOMPARE(repaired(mesh, {area}).steps[0].count("pieces_removed"), std::size_t(1));
        QCOMPARE(repaired(mesh, {keep}).mesh->facet_count(), std::size_t(12));
        QCOMPARE(repaired(mesh, {pieces_below(2)}).steps[0].count("pieces_left"), std::size_t(2));
        QVERIFY(repaired(mesh, {pieces_below(0.1)}).mesh->facets == mesh.facets);
        QCOMPARE(code_of([&] { repaired(mesh, {pieces_below(1000)}); }), std::string("empty_result"));
    }

    void muddled_bodies_are_turned_back() {
        Random rng(7);
        for (int i = 0; i < 10; ++i) {
            const Mesh sphere = ringed_sphere(10, 20);
            const Mesh mesh = muddled(sphere, rng, i % 2);
            const Repaired r = repaired(mesh, {{.kind = Kind::turn}});
            const MeshReport report = report_of_mesh(*r.mesh);
            QVERIFY(report.watertight);
            QVERIFY(std::abs(report.file_volume - report_of_mesh(sphere).file_volume) < 1e-6);
            QCOMPARE(r.steps[0].count("doubles_removed"), std::size_t(i % 2 ? 20 : 0));
            // Whatever faced outward already has kept its corners in their order.
            for (std::size_t f = 0; f < sphere.facet_count(); ++f)
                if (mesh.facets[f] == sphere.facets[f]) QVERIFY(r.mesh->facets[f] == mesh.facets[f]);
        }
    }

    void an_inside_out_shell_is_turned_and_a_hollow_stays() {
        Mesh mesh = ringed_sphere(12, 20);
        for (Facet& f : mesh.facets)
            std::swap(f[0], f[1]);
        Mesh hollow = ringed_sphere(8, 5);
        for (Facet& f : hollow.facets)
            std::swap(f[0], f[1]);
        const double wanted =
            report_of_mesh(ringed_sphere(12, 20)).file_volume + report_of_mesh(hollow).file_volume; // below 0
        append_mesh(mesh, hollow);
        const Repaired r = repaired(mesh, {{.kind = Kind::turn}});
        QVERIFY(std::abs(report_of_mesh(*r.mesh).file_volume - wanted) < 1e-6);
    }

    void a_strip_with_one_side_says_so() {
        const Mesh strip = grid_mesh(40, 3, false, false, 0, [](double a, double b) {
            const double u = 2 * pi * a, w = 6 * (b - 0.5);
            return Vec3((20 + w * std::cos(u / 2)) * std::cos(u), (20 + w * std::cos(u / 2)) * std::sin(u),
                        w * std::sin(u / 2));
        });
        // Joined end to end: the last column is the first one upside down.
        Mesh joined = strip;
        const Index columns = 41;
        for (Facet& f : joined.facets)
            for (Index& v : f)
                if (v % columns == 40) v = (3 - v / columns) * columns;
        const Repaired r = repaired(joined, {{.kind = Kind::turn}});
        QVERIFY(r.steps[0].count("edges_left_against") > 0);
    }

    void what_half_edges_cannot_hold_is_left_and_told() {
        // Three sheets on one edge, and a hole beside it.
        Mesh mesh = cube_mesh(10);
        mesh.vertices.push_back(Vec3(-5, -5, 15));
        mesh.facets.push_back({4, 5, 8}); // a fin on an edge of the cube
        mesh.facets.erase(mesh.facets.begin() + 7);
        const Repaired r = repaired(mesh, {holes_up_to(0)});
        QVERIFY(stands_in_order(mesh, *r.mesh));
        QVERIFY(r.steps[0].count("filled") >= 1);
        QVERIFY(r.steps[0].count("facets_in_no_sheet") >= 1);
    }

    void a_survey_finds_what_was_put_in() {
        const DirtyScan scan = dirty_scan(40, 0.05, 5, 4, 11);
        Mesh mesh = scan.mesh;
        mesh.facets.push_back(mesh.facets[7]);
        const Survey s = survey_mesh(mesh, {});
        QVERIFY(s.holes.holes.size() >= 3 && s.holes.holes.size() <= scan.holes);
        QCOMPARE(s.shells.all.size(), std::size_t(5));
        QCOMPARE(s.doubles, std::size_t(1));
        QCOMPARE(s.non_manifold, std::size_t(3));
    }

    void threads_and_cancel() {
        const DirtyScan scan = dirty_scan(30, 0.1, 8, 5, 3);
        RepairStep smooth{.kind = Kind::smooth}, decimate{.kind = Kind::decimate};
        smooth.bound = 0.15;
        decimate.bound = 0.2;
        decimate.share = 0.5;
        const std::vector<RepairStep> recipe{
            pieces_below(6), {.kind = Kind::turn}, holes_up_to(0), smooth, decimate};
        set_thread_count(1);
        const Repaired one = repaired(scan.mesh, recipe);
        set_thread_count(4);
        const Repaired four = repaired(scan.mesh, recipe);
        set_thread_count(0);
        QVERIFY(equal_meshes(*one.mesh, *four.mesh));
        for (std::size_t i = 0; i < recipe.size(); ++i)
            QCOMPARE(one.steps[i].displacement, four.steps[i].displacement);
        const auto mesh = std::make_shared<Mesh>(scan.mesh);
        for (double at : {0.0, 0.1, 0.3, 0.5, 0.65, 0.85}) {
            Job job;
            QVERIFY(cancelled_at(job, at, [&](const Progress& p) { run_recipe(mesh, recipe, p); }));
        }
    }
};

FACETMILL_TEST(TestRepairHoles)
#include "test_repair_holes.moc"
