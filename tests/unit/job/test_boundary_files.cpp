// Boundaries in a project: the file, what of it is refused, and what a change of one makes stale.
#include "core/job/planner.h"
#include "core/job/verification.h"
#include "core/mesh/mesh_io.h"
#include "tests/support/error_code.h"
#include "tests/support/part_meshes.h"
#include "tests/support/test_runner.h"

#include <QTemporaryDir>
#include <QTest>

using namespace facetmill;

namespace {

const char* const bounded = R"({ "facetmill": 2, "units": "in", "part": { "file": "part.stl" },
  "tools": [ { "number": 1, "diameter": 0.25 } ],
  "setups": [ { "name": "Top",
    "boundaries": [ { "name": "Pad", "kind": "facets", "facets": "0-3, 7", "of_facets": 12, "invert": true },
                    { "name": "Flats", "kind": "slope", "slope": [0, 30] },
                    { "name": "Drawn", "kind": "curve", "offset": 0.5,
                      "curve": [ { "at": [0, 0, 1] }, { "at": [1, 0, 1] }, { "at": [0, 1, 1] } ] },
                    { "name": "Outline", "kind": "silhouette", "offset": -0.25 },
                    { "name": "Corners", "kind": "rest", "tool": 1, "more_than": 0.002 } ],
    "operations": [ { "kind": "finish3", "name": "Finish", "tool": 1, "boundary": "Flats", "contain": "tip",
                      "avoid": "Pad", "avoid_distance": 0.1 } ] } ] })";

Project bounded_project(const std::string& text) {
    return parse_project(text, "p.facetmill");
}

std::string bounded_with(const std::string& from, const std::string& to) {
    std::string text = bounded;
    const std::size_t at = text.find(from);
    if (at == std::string::npos) qFatal("the test's text is not in the project");
    return text.replace(at, from.size(), to);
}

} // namespace

class TestBoundaryFiles : public QObject {
    Q_OBJECT
private slots:

    void the_file_keeps_them() {
        const Project p = bounded_project(bounded);
        QCOMPARE(p.boundaries.size(), std::size_t(5));
        QCOMPARE(p.boundaries[0].facets, std::string("0-3, 7"));
        QVERIFY(p.boundaries[0].invert && p.boundaries[0].of_facets == 12);
        QCOMPARE(p.boundaries[1].slope[1], radians(30));
        QCOMPARE(p.boundaries[2].curve.at(1).at[0], 25.4);
        QCOMPARE(p.boundaries[3].offset, -6.35);
        QVERIFY(p.boundaries[4].tool == 1 && p.boundaries[4].more_than == 0.0508);
        QCOMPARE(p.cutter_of(p.boundaries[4])->d, 6.35);
        QVERIFY(!p.cutter_of(p.boundaries[3]));
        const OperationCommon& common = p.operations[0]->common();
        QVERIFY(common.boundary == "Flats" && common.contain == Containment::tip && common.avoid == "Pad");
        QCOMPARE(common.avoid_distance, 2.54);
        const std::string text = project_to_json(p);
        QCOMPARE(project_to_json(bounded_project(text)), text);
        // What names no boundary says nothing of them, and is a project of version 1.
        Project single = p;
        single.name = usual_setup_name(0);
        QVERIFY(project_to_json(single).starts_with("{\n  \"facetmill\": 2,"));
        single.boundaries.clear();
        single.operations[0]->common() = OperationCommon();
        const std::string plain = project_to_json(single);
        QVERIFY(plain.starts_with("{\n  \"facetmill\": 1,") && plain.find("avoid") == std::string::npos
                && plain.find("contain") == std::string::npos);
    }

    void wrong_ones_are_named_data() {
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("code");
        QTest::addColumn<QString>("where");
        const auto row = [](const char* name, const std::string& text, const char* code, const char* where) {
            QTest::newRow(name) << QString::fromStdString(text) << code << "p.facetmill: " + QString(where);
        };
        row("another kind's key", bounded_with("\"slope\": [0, 30]", "\"offset\": 1"), "unknown_key",
            "setups[0].boundaries[1].offset");
        row("no such kind", bounded_with("\"silhouette\"", "\"shadow\""), "out_of_range",
            "setups[0].boundaries[3].kind");
        row("the rest of no tool", bounded_with("\"rest\", \"tool\": 1", "\"rest\", \"tool\": 7"),
            "missing_reference", "boundaries[4].tool");
        row("nothing is left", bounded_with("\"more_than\": 0.002", "\"more_than\": 0"), "out_of_range",
            "setups[0].boundaries[4].more_than");
        row("slopes turned round", bounded_with("[0, 30]", "[30, 0]"), "out_of_range",
            "setups[0].boundaries[1].slope");
        row("two of a name", bounded_with("\"name\": \"Flats\"", "\"name\": \"Pad\""), "out_of_range",
            "boundaries[1].name");
        row("no name", bounded_with("\"name\": \"Drawn\"", "\"name\": \" \""), "out_of_range",
            "boundaries[2].name");
        row("a curve of two corners", bounded_with(", { \"at\": [0, 1, 1] }", ""), "out_of_range",
            "boundaries[2].curve");
        row("not there", bounded_with("\"boundary\": \"Flats\"", "\"boundary\": \"Flat\""),
            "missing_reference", "operations[0].boundary");
        row("to avoid, not there", bounded_with("\"avoid\": \"Pad\"", "\"avoid\": \"Lid\""),
            "missing_reference", "operations[0].avoid");
        row("no distance", bounded_with("\"avoid_distance\": 0.1", "\"avoid_distance\": 0"), "out_of_range",
            "setups[0].operations[0].avoid_distance");
        row("a turning operation", bounded_with("finish3", "lathe_finish"), "out_of_range",
            "operations[0].boundary");
    }
    void wrong_ones_are_named() {
        QFETCH(QString, text);
        QFETCH(QString, code);
        QFETCH(QString, where);
        try {
            bounded_project(text.toStdString());
            QFAIL("it was read");
        } catch (const Error& e) {
            QCOMPARE(QString(code_name(e.code()).data()), code);
            QCOMPARE(QString::fromStdString(e.where()), where);
        }
    }

    void a_change_plans_anew() {
        QTemporaryDir dir;
        const std::filesystem::path root(dir.path().toStdString());
        save_stl(test::box(Vec3(0, 0, 0), Vec3(30, 20, 10)), root / "block.stl", LengthUnit::mm, {});
        Project project = parse_project(
            R"({ "facetmill": 2, "units": "mm", "part": { "file": "block.stl" },
              "tools": [ { "number": 1, "diameter": 6, "corner_radius": 3, "flute_length": 20 } ],
              "setups": [ { "name": "Top", "stock": { "kind": "box", "margin": [0, 0, 1] }, "boundaries": [
                  { "name": "Middle", "kind": "silhouette", "offset": -5 }, { "name": "Other", "kind": "slope" } ],
                "operations": [ { "kind": "finish3", "name": "Finish", "tool": 1, "tolerance": 0.1 } ] } ] })",
            "block");
        project.path = root / "block.facetmill";
        Planner planner;
        const auto box_of = [&] {
            Box3 tips;
            for (const Pass& pass : planner.plan(project, {}, {})->operations[0]->path.passes)
                for (const CutterLocation& c : pass.cl)
                    tips.add(c.tip);
            return tips;
        };
        const Box3 all = box_of();
        project.boundaries[1].offset = 3; // nobody names it
        box_of();
        QCOMPARE(planner.work().strategies, 1);
        project.operations[0]->common().boundary = "Middle";
        const Box3 middle = box_of();
        QCOMPARE(planner.work().strategies, 2);
        QVERIFY(middle.lo.x() > 4.99 && middle.lo.x() < 5.1 && middle.hi.x() < 25.01 && middle.hi.x() > 24.9);
        QVERIFY(all.lo.x() < 1);
        project.boundaries[0].offset = -6;
        QVERIFY(box_of().lo.x() > 5.99);
        // What the boundary leaves out stays uncut for that reason, and no other.
        const auto plan = planner.plan(project, {}, {});
        VerifySettings settings = verify_settings(project, plan.get());
        settings.resolution = 0.5;
        const Verification v =
            verify(*plan->part->mesh, plan->stock, verify_programs(project, plan), settings, {});
        double left = 0;
        for (const UncutReason& r : v.uncut)
            if (r.counts()) {
                QCOMPARE(int(r.why), int(UncutReason::Why::boundary));
                QCOMPARE(r.program, std::string("Finish"));
                left += r.area;
            }
        // The ball's side cuts a little beyond the contact.
        QVERIFY2(left > 400 && left < 30 * 20 - 18 * 8, qPrintable(QString::number(left)));

        project.boundaries[0].name = "Renamed";
        project.operations[0]->common().boundary = "Renamed";
        project.boundaries[0].offset = -50;
        std::string message;
        QCOMPARE(test::code_of([&] { box_of(); }, &message), std::string("empty_result"));
        QVERIFY2(message.find("boundary 'Renamed'") != std::string::npos, message.c_str());
    }
};

FACETMILL_TEST(TestBoundaryFiles)
#include "test_boundary_files.moc"
