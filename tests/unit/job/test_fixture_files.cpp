// Fixtures in a project: the file, what of it is refused, files of theirs, what a change of one makes stale,
// and a second setup's in the coordinates of the first.
#include "core/job/fixtures.h"
#include "core/job/planner.h"
#include "core/job/project_inputs.h"
#include "core/job/setup_plan.h"
#include "core/job/verification.h"
#include "core/mesh/mesh_io.h"
#include "core/verify/verify.h"
#include "tests/support/error_code.h"
#include "tests/support/part_meshes.h"
#include "tests/support/test_runner.h"

#include <QTemporaryDir>
#include <QTest>

#include <fstream>

using namespace facetmill;

namespace {

const char* const held = R"({ "facetmill": 2, "units": "in", "part": { "file": "part.stl" },
  "tools": [ { "number": 1, "diameter": 0.25 } ],
  "setups": [ { "name": "Top",
    "fixtures": [ { "name": "Jaw", "kind": "box", "size": [2, 1, 0.5], "translate": [1, 0, 0], "clearance": 0.1 },
                  { "name": "Bolt", "kind": "cylinder", "diameter": 0.5, "height": 1, "rotate": [0, 90, 0] },
                  { "name": "Vice", "kind": "mesh", "file": "vice.stl", "scale": 2 } ],
    "operations": [ { "kind": "finish3", "name": "Finish", "tool": 1 } ] } ] })";

Project held_project(const std::string& text) {
    return parse_project(text, "p.facetmill");
}

std::string held_with(const std::string& from, const std::string& to) {
    std::string text = held;
    const std::size_t at = text.find(from);
    if (at == std::string::npos) qFatal("the test's text is not in the project");
    return text.replace(at, from.size(), to);
}

/// A block 40 x 30 x 10 that lies on z = 0, finished with a ball; a clamp on its top.
struct ClampedBlock {
    ClampedBlock() {
        const std::filesystem::path root(dir.path().toStdString());
        save_stl(test::box(Vec3(0, 0, 0), Vec3(40, 30, 10)), root / "block.stl", LengthUnit::mm, {});
        project = parse_project(
            R"({ "facetmill": 2, "units": "mm", "part": { "file": "block.stl" },
              "tools": [ { "number": 1, "diameter": 6, "corner_radius": 3, "flute_length": 20, "shank_length": 30 } ],
              "setups": [ { "name": "Top", "stock": { "kind": "box", "margin": [0, 0, 1] },
                "fixtures": [ { "name": "Clamp", "kind": "box", "size": [8, 6, 10], "translate": [4, 15, 10],
                                "clearance": 1 } ],
                "operations": [ { "kind": "finish3", "name": "Finish", "tool": 1, "tolerance": 0.1 } ] },
              { "name": "Bottom", "place": { "rotate": [180, 0, 0], "translate": [0, 30, 10] },
                "fixtures": [ { "name": "Bolt", "kind": "cylinder", "diameter": 4, "height": 9,
                                "translate": [30, 15, 10], "clearance": 1 } ],
                "operations": [ { "kind": "finish3", "name": "Below", "tool": 1, "tolerance": 0.1 } ] } ] })",
            "block");
        project.path = root / "block.facetmill";
    }
    QTemporaryDir dir;
    Project project;
};

} // namespace

class TestFixtureFiles : public QObject {
    Q_OBJECT
private slots:

    void the_file_keeps_them() {
        const Project p = held_project(held);
        QCOMPARE(p.fixtures.size(), std::size_t(3));
        QCOMPARE(p.fixtures[0].size[0], 50.8);
        QCOMPARE(p.fixtures[0].clearance, 2.54);
        QVERIFY(p.fixtures[1].kind == Fixture::Kind::cylinder);
        QCOMPARE(p.fixtures[1].rotate[1], radians(90));
        QVERIFY(p.fixtures[2].unit == LengthUnit::inch && p.fixtures[2].scale == 2);
        const std::string text = project_to_json(p);
        QCOMPARE(project_to_json(held_project(text)), text);
        // A fixture says nothing of other kinds, and a project with one nothing that version 1 knows.
        QCOMPARE(text.find("\"diameter\": 0.5"), text.rfind("\"diameter\": 0.5"));
        Project single = p;
        single.name = usual_setup_name(0);
        QVERIFY(project_to_json(single).starts_with("{\n  \"facetmill\": 2,"));
        single.fixtures.clear();
        QVERIFY(project_to_json(single).starts_with("{\n  \"facetmill\": 1,"));
    }

    void wrong_ones_are_named_data() {
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("code");
        QTest::addColumn<QString>("where");
        const auto row = [](const char* name, const std::string& text, const char* code, const char* where) {
            QTest::newRow(name) << QString::fromStdString(text) << code << "p.facetmill: " + QString(where);
        };
        row("unknown key", held_with("\"size\"", "\"sizes\""), "unknown_key", "setups[0].fixtures[0].sizes");
        row("another kind's key", held_with("\"size\": [2, 1, 0.5]", "\"height\": 1"), "unknown_key",
            "setups[0].fixtures[0].height");
        row("no such kind", held_with("\"box\"", "\"ball\""), "out_of_range", "setups[0].fixtures[0].kind");
        row("no size", held_with("[2, 1, 0.5]", "[2, 1, 0]"), "out_of_range", "setups[0].fixtures[0].size");
        row("two numbers", held_with("[2, 1, 0.5]", "[2, 1]"), "wrong_type", "setups[0].fixtures[0].size");
        row("no clearance", held_with("\"clearance\": 0.1", "\"clearance\": 0"), "out_of_range",
            "setups[0].fixtures[0].clearance");
        row("two of a name", held_with("\"Bolt\"", "\"Jaw\""), "out_of_range", "fixtures[1].name");
        row("no name", held_with("\"Bolt\"", "\"  \""), "out_of_range", "fixtures[1].name");
        row("no file", held_with("\"file\": \"vice.stl\", ", ""), "missing_key",
            "setups[0].fixtures[2].file");
        row("a project", held_with("vice.stl", "vice.facetmill"), "unsupported_format", "fixtures[2].file");
        row("no list",
            held_with("\"fixtures\": [ { \"name\": \"Jaw\"", "\"fixtures\": [ 7, { \"name\": \"Jaw\""),
            "wrong_type", "setups[0].fixtures[0]");
    }
    void wrong_ones_are_named() {
        QFETCH(QString, text);
        QFETCH(QString, code);
        QFETCH(QString, where);
        try {
            held_project(text.toStdString());
            QFAIL("it was read");
        } catch (const Error& e) {
            QCOMPARE(QString::fromUtf8(code_name(e.code()).data()), code);
            QCOMPARE(QString::fromStdString(e.where()), where);
            QVERIFY(!e.remedy().empty());
        }
    }

    /// Their meshes are inputs: missing ones are told, kept from being written over, and move along.
    void meshes_are_inputs() {
        QTemporaryDir dir;
        const std::filesystem::path root(dir.path().toStdString());
        std::filesystem::create_directories(root / "a");
        std::filesystem::create_directories(root / "b");
        Project p = held_project(held);
        p.path = root / "a" / "p.facetmill";
        std::ofstream(root / "a" / "part.stl") << "solid";
        QCOMPARE(missing_inputs(p),
                 (std::vector<ProjectInput>{{ProjectInput::Kind::fixture, root / "a" / "vice.stl", 2}}));
        std::string message;
        QCOMPARE(test::code_of([&] { check_inputs(p); }, &message), std::string("not_found"));
        QVERIFY2(message.find("fixtures[2].file") != std::string::npos, message.c_str());
        std::ofstream(root / "b" / "vice.stl") << "solid";
        Project located = p;
        locate_input(located, missing_inputs(p).front(), root / "b" / "vice.stl");
        QCOMPARE(located.fixtures[2].file, std::string("../b/vice.stl"));
        QVERIFY_EXCEPTION_THROWN(keep_inputs(located, root / "b" / "vice.stl"), Error);
        save_project(located, root / "b" / "q.facetmill");
        const Project moved = load_project(root / "b" / "q.facetmill");
        QCOMPARE(moved.fixtures[2].file, std::string("vice.stl"));
        Project taken = p;
        take_inputs(taken, moved);
        QCOMPARE(taken.fixtures[2].file, std::string("vice.stl"));
    }

    void a_mesh_has_to_be_closed() {
        QTemporaryDir dir;
        const std::filesystem::path root(dir.path().toStdString());
        Project p = held_project(held);
        p.path = root / "p.facetmill";
        const auto level = [](double, double) { return 0.0; };
        save_stl(test::height_field(level, Vec2(0, 0), Vec2(1, 1), 2, 2), root / "vice.stl", LengthUnit::mm,
                 {});
        std::string message;
        const std::string code = test::code_of([&] { load_fixtures(p, {}); }, &message);
        QVERIFY2(code == "out_of_range", (code + ": " + message).c_str());
        QVERIFY2(message.find("fixture 'Vice'") != std::string::npos, message.c_str());
        QVERIFY2(message.find("not closed") != std::string::npos, message.c_str());
        save_stl(test::box(Vec3(0, 0, 0), Vec3(1, 2, 3)), root / "vice.stl", LengthUnit::mm, {});
        const std::vector<FixtureSolid> solids = load_fixtures(p, {});
        QCOMPARE(solids.size(), std::size_t(3));
        QVERIFY((solids[2].mesh->box().hi - 50.8 * Vec3(1, 2, 3)).norm() < 1e-6);
        const std::string before = fixtures_key(p);
        p.fixtures[0].clearance = 1;
        QVERIFY(fixtures_key(p) != before);
    }

    /// A clamp ends the passes, moving it plans again, and one that covers the part is an error.
    void passes_end_beside_a_clamp() {
        ClampedBlock job;
        job.project.after.clear();
        Planner planner;
        const auto with = planner.plan(job.project, {}, {});
        const auto strategies = planner.work().strategies;
        QVERIFY(with->operations[0]->path.warnings.back().find("'Clamp'") != std::string::npos);
        for (const Motion& m : with->operations[0]->program.motions.motions) {
            const Vec3 d = ((m.to.tip - Vec3(4, 15, 10)).cwiseAbs() - Vec3(4, 3, 0)).cwiseMax(0);
            QVERIFY(m.to.tip.z() >= 21 || d.head<2>().norm() > 4); // radius and clearance
        }
        planner.plan(job.project, {}, {});
        QCOMPARE(planner.work().strategies, strategies);
        job.project.fixtures[0].translate[0] = 36;
        const auto moved = planner.plan(job.project, {}, {});
        QCOMPARE(planner.work().strategies, strategies + 1);
        QCOMPARE(planner.work().indexes, 1); // the part is the same
        QVERIFY(moved->operations[0]->program.motions.motions.size()
                    != with->operations[0]->program.motions.motions.size()
                || moved->operations[0]->totals.cut_length != with->operations[0]->totals.cut_length);
        QVERIFY(moved->stock_warnings.empty());
        // Through a side, where no corner of either is in the other, and right through.
        for (const std::array<double, 3>& size : {std::array<double, 3>{8, 6, 10}, {90, 4, 4}}) {
            job.project.fixtures[0].size = size;
            job.project.fixtures[0].translate = {2, 15, 3};
            const auto sunk = planner.plan(job.project, {}, {});
            QCOMPARE(sunk->stock_warnings.size(), std::size_t(1));
            QVERIFY2(sunk->stock_warnings[0].find("'Clamp'") != std::string::npos,
                     sunk->stock_warnings[0].c_str());
        }
        job.project.fixtures[0].translate = {20, 15, 10};
        job.project.fixtures[0].size = {60, 60, 10};
        job.project.fixtures[0].translate = {20, 15, 10};
        std::string message;
        QCOMPARE(test::code_of([&] { planner.plan(job.project, {}, {}); }, &message),
                 std::string("empty_result"));
        QVERIFY2(message.find("'Clamp'") != std::string::npos, message.c_str());
        job.project.fixtures.clear();
        const auto without = planner.plan(job.project, {}, {});
        QVERIFY(without->operations[0]->path.warnings.empty());
    }

    /// In a chain of setups every setup's programs meet its own fixtures alone, where they are then.
    void each_setup_has_its_own() {
        ClampedBlock job;
        SetupPlanners planners;
        const std::vector<SetupPlan> setups = plan_setups(job.project, {}, planners, {});
        const ChainPrograms chain = chain_programs(setups, planned_programs(setups));
        QCOMPARE(chain.programs.size(), std::size_t(2));
        QCOMPARE(chain.programs[0].fixtures->front().name, std::string("Clamp"));
        QCOMPARE(chain.programs[1].fixtures->size(), std::size_t(1));
        QCOMPARE(chain.programs[1].fixtures->front().name, std::string("Bolt"));
        // Turned over about X: 10 above the second setup's zero is the bottom, z = 0, and it reaches down.
        const Box3 bolt = chain.programs[1].fixtures->front().mesh->box();
        QVERIFY(std::abs(bolt.hi.z()) < 1e-9 && std::abs(bolt.lo.z() + 9) < 1e-9);
        QVERIFY(std::abs(bolt.center().x() - 30) < 1e-9 && std::abs(bolt.center().y() - 15) < 1e-9);
        const Verification v = verify(*setups[0].plan->part->mesh, setups[0].plan->stock, chain.programs,
                                      chain_settings(setups), {});
        QVERIFY(v.collisions.empty());
        const auto reason = std::find_if(v.uncut.begin(), v.uncut.end(), [](const UncutReason& r) {
            return r.why == UncutReason::Why::fixture;
        });
        QVERIFY(reason != v.uncut.end());
        // Under the clamp with what it keeps: 13 x 14 at most, less the rounding of the ball.
        QVERIFY2(reason->area > 60 && reason->area < 300, qPrintable(QString::number(reason->area)));
    }
};

FACETMILL_TEST(TestFixtureFiles)
#include "test_fixture_files.moc"
