// Parts from STEP files in projects: how closely they are tessellated, what planning makes of the deviation,
// boundaries of faces.
#include "core/job/bounds.h"
#include "core/job/packed_project.h"
#include "core/job/planner.h"
#include "core/job/report.h"
#include "core/mesh/mesh_io.h"
#include "tests/support/error_code.h"
#include "tests/support/part_meshes.h"
#include "tests/support/surface_files.h"
#include "tests/support/test_runner.h"

#include <QTemporaryDir>
#include <QTest>

#include <fstream>

using namespace facetmill;
using namespace facetmill::test;

namespace {

const char* const job = R"({ "facetmill": 2, "units": "mm", "part": { "file": "part.step" },
  "tools": [ { "number": 1, "diameter": 6, "corner_radius": 3 } ],
  "setups": [ { "name": "Top",
    "boundaries": [ { "name": "Some", "kind": "faces", "faces": "0-1" } ],
    "operations": [ { "kind": "finish3", "name": "Finish", "tool": 1, "tolerance": 0.2 } ] },
              { "name": "Below", "place": { "rotate": [180, 0, 0] },
    "operations": [ { "kind": "finish3", "name": "Finer", "tool": 1, "tolerance": 0.1 } ] } ] })";

struct SurfaceJob {
    QTemporaryDir dir;
    Project project = parse_project(job, "job");

    SurfaceJob() {
        const std::filesystem::path root(dir.path().toStdString());
        std::ofstream(root / "part.step", std::ios::binary) << step_block_with_hole(20);
        project.path = root / "job.facetmill";
    }
};

} // namespace

class TestSurfaceParts : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() {
#ifdef FACETMILL_STEP_PROGRAM
        qputenv("FACETMILL_STEP", FACETMILL_STEP_PROGRAM);
#endif
    }

    void facets_follow_the_finest_operation() {
        Project p = parse_project(job, "job");
        QVERIFY(std::abs(p.part_reading().chord - 0.01) < 1e-12);
        QVERIFY(p.part_reading().chord
                == view_of_setup(p, 1).part_reading().chord); // all setups have one part
        p.operations[0]->common().tolerance = 0.02;
        QVERIFY(std::abs(p.part_reading().chord - 0.002) < 1e-12);
        p.part.chord_tolerance.number = 0.3;
        p.part.chord_tolerance.word.clear();
        QVERIFY(p.part_reading().chord == 0.3);
        const Project again = parse_project(project_to_json(p), "again");
        QVERIFY(again.part.chord_tolerance == p.part.chord_tolerance);
        // What operations say changes nothing of a mesh.
        p = parse_project(job, "job");
        p.part.file = "part.stl";
        const std::string before = reading_key(p.part_reading());
        p.operations[0]->common().tolerance = 0.02;
        QCOMPARE(reading_key(p.part_reading()), before);
    }

    void planning_allows_for_the_deviation() {
        if (no_surface_files()) QSKIP(no_surface_files());
        SurfaceJob w;
        w.project.part.scale = 2;
        Planner planner;
        const auto part = planner.prepare(w.project, {});
        QVERIFY(part->report.watertight && part->faces->size() == part->mesh->facet_count());
        // The hole is smaller in the mesh: the surface lies inside it, by twice what was measured in the
        // file.
        QVERIFY(part->surface_deviation[0] < 1e-6 && part->surface_deviation[1] > 1e-3);
        QVERIFY(part->surface_deviation[1] == 2 * part->report.surfaces->in);
        const auto plan = planner.plan(w.project, "", {});
        const std::string text = report_json(w.project, *plan);
        QVERIFY(text.find("\"deviation_in\"") != std::string::npos);
        w.project.part.chord_tolerance = {1.0, ""};
        w.project.operations[0]->common().tolerance = 0.01;
        const std::string code = code_of([&] { planner.plan(w.project, "", {}); });
        QCOMPARE(code, std::string("out_of_range")); // nothing is left of the tolerance
    }

    void a_boundary_of_faces() {
        if (no_surface_files()) QSKIP(no_surface_files());
        SurfaceJob w;
        Planner planner;
        const auto part = planner.prepare(w.project, {});
        Boundary some = w.project.boundaries[0];
        const Boundary made = with_facets_of_faces(some, *part);
        QVERIFY(made.kind == Boundary::Kind::facets
                && std::size_t(made.of_facets) == part->mesh->facet_count());
        const auto facets = facet_ranges(made.facets, part->mesh->facet_count());
        QVERIFY(!facets.empty());
        for (std::size_t f = 0, i = 0; f < part->faces->size(); ++f) {
            const bool in = i < facets.size() && facets[i] == f;
            QCOMPARE(in, part->faces->at(f) <= 1);
            i += in;
        }
        // Other facets, the same faces.
        w.project.part.chord_tolerance = {0.2, ""};
        const auto coarse = planner.prepare(w.project, {});
        QVERIFY(coarse->mesh->facet_count() < part->mesh->facet_count());
        const auto area = [](const Boundary& b, const PreparedPart& p) {
            double sum = 0;
            for (const Index f : facet_ranges(b.facets, p.mesh->facet_count()))
                sum += 0.5 * p.mesh->facet_cross(f).norm();
            return sum;
        };
        const double fine = area(made, *part);
        QVERIFY(std::abs(area(with_facets_of_faces(some, *coarse), *coarse) - fine) < 0.01 * fine);
        some.faces = "7";
        QCOMPARE(code_of([&] { with_facets_of_faces(some, *part); }), std::string("out_of_range"));
        some.faces = "x";
        QCOMPARE(code_of([&] { with_facets_of_faces(some, *part); }), std::string("syntax"));
        PreparedPart none = *part;
        none.faces = nullptr;
        QCOMPARE(code_of([&] { with_facets_of_faces(w.project.boundaries[0], none); }),
                 std::string("missing_reference"));
    }

    void operations_keep_within_faces() {
        if (no_surface_files()) QSKIP(no_surface_files());
        SurfaceJob w;
        Planner planner;
        const auto part = planner.prepare(w.project, {});
        // The top has the hole in it; its face is the one whose facets lie at Z 20.
        std::string top;
        for (std::size_t f = 0; f < part->mesh->facet_count() && top.empty(); ++f)
            if (part->mesh->facet_normal(f).z() > 0.999) top = std::to_string(part->faces->at(f));
        QVERIFY(!top.empty());
        w.project.boundaries[0].faces = top;
        w.project.operations[0]->common().boundary = "Some";
        const auto plan = planner.plan(w.project, "", {});
        QCOMPARE(plan->operations.size(), std::size_t(1));
        std::size_t points = 0;
        for (const auto& pass : plan->operations[0]->path.passes)
            for (const CutterContact& cc : pass.cc) {
                ++points;
                QVERIFY(cc.point.z() > 19.9);
            }
        QVERIFY(points > 100);
    }

    void a_packed_project_has_it() {
        if (no_surface_files()) QSKIP(no_surface_files());
        SurfaceJob w;
        const std::filesystem::path root(w.dir.path().toStdString());
        pack_project(w.project, "sent", root / "sent.facetmill");
        const Project sent = load_project(root / "sent.facetmill");
        Planner planner;
        QVERIFY(planner.prepare(sent, {})->report.watertight);
    }
};

FACETMILL_TEST(TestSurfaceParts)
#include "test_surface_parts.moc"
