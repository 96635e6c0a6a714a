// A recipe in a project: read and written, carried out when the part is read, and again when file or recipe
// change.
#include "core/job/planner.h"
#include "core/job/project_inputs.h"
#include "core/job/repaired_mesh.h"
#include "core/mesh/mesh_io.h"
#include "tests/support/dirty_scan.h"
#include "tests/support/error_code.h"
#include "tests/support/test_runner.h"

#include <QTemporaryDir>
#include <QTest>

#include <algorithm>
#include <fstream>

using namespace facetmill;
using facetmill::test::code_of;
using facetmill::test::dirty_scan;

namespace {

const char* const steps = R"([{"kind": "pieces", "size": 6}, {"kind": "holes", "size": 10, "fill": "flat"}])";

class ScanProject {
public:
    explicit ScanProject(std::uint64_t seed) { write_scan(seed); }

    void write_scan(std::uint64_t seed) const {
        save_stl(dirty_scan(30, 0.05, 4, 3, seed).mesh, at("scan.stl"), LengthUnit::mm, {});
    }
    std::string at(const char* name) const { return dir_.filePath(name).toStdString(); }
    Project project(const std::string& repair) const {
        std::ofstream(at("scan.facetmill"))
            << R"({"facetmill": 1, "units": "mm", "part": {"file": "scan.stl", "units": "mm", "repair": )"
            << repair << R"(}, "stock": {"kind": "box"}})";
        return load_project(at("scan.facetmill"));
    }

private:
    QTemporaryDir dir_;
};

} // namespace

class TestRepairedPart : public QObject {
    Q_OBJECT
private slots:
    void a_recipe_is_written_as_it_was_read() {
        const ScanProject files(1);
        const Project project = files.project(steps);
        QCOMPARE(project.part.repair.size(), std::size_t(2));
        QVERIFY(project.part.repair[1].fill == RepairStep::Fill::flat);
        std::ofstream(files.at("again.facetmill")) << project_to_json(project);
        const Project again = load_project(files.at("again.facetmill"));
        QVERIFY(again.part.repair == project.part.repair);
        // A step says what it reads, and nothing else.
        const std::string text = project_to_json(files.project(R"([{"kind": "turn"}])"));
        const std::size_t at = text.find("\"repair\"");
        QVERIFY(at != std::string::npos);
        const std::string list = text.substr(at, text.find(']', at) - at);
        QCOMPARE(std::count(list.begin(), list.end(), ':'), std::ptrdiff_t(2));
        QVERIFY(project_to_json(files.project("[]")).find("repair") == std::string::npos);
    }

    void a_joined_scan_is_a_file_of_the_project() {
        const ScanProject files(5);
        const char* const join = R"([{"kind": "join", "file": "more.stl", "size": 1}])";
        const Project project = files.project(join);
        const auto inputs = project_inputs(project);
        QCOMPARE(inputs.size(), std::size_t(2));
        QCOMPARE(input_key(inputs[1]), std::string("part.repair[0].file"));
        QVERIFY(inputs[1].path == files.at("more.stl"));
        Planner planner;
        QCOMPARE(code_of([&] { planner.prepare(project, {}); }), std::string("not_found"));
        save_stl(dirty_scan(30, 0, 0, 0, 1).mesh, files.at("more.stl"), LengthUnit::mm, {});
        const auto part = planner.prepare(project, {});
        QCOMPARE(part->repairs.size(), std::size_t(1));
        QVERIFY(part->repairs[0].count("facets_overlapping") > 1000);
        QCOMPARE(code_of([&] { keep_inputs(project, files.at("more.stl")); }), std::string("unwritable"));
        // Another scan in its place is another part.
        Mesh beside = dirty_scan(5, 0, 0, 0, 1).mesh;
        for (Vec3& p : beside.vertices)
            p.x() += 300;
        save_stl(beside, files.at("more.stl"), LengthUnit::mm, {});
        QVERIFY(planner.prepare(project, {})->box.hi.x() > 300);
    }

    void the_part_is_the_repaired_one() {
        const ScanProject files(2);
        Planner planner;
        const auto bare = planner.prepare(files.project("[]"), {});
        QVERIFY(!bare->report.watertight && bare->repairs.empty());
        const auto part = planner.prepare(files.project(steps), {});
        QVERIFY(part->report.watertight);
        QCOMPARE(part->report.shells, std::size_t(1));
        QCOMPARE(part->repairs.size(), std::size_t(2));
        QCOMPARE(part->repairs[0].count("pieces_removed"), std::size_t(3));
        QVERIFY(part->report.warnings.empty());
    }

    /// Those of a part of millions of facets are for operations that look at it from several sides.
    void its_normals_are_worked_out_where_an_operation_turns_its_axis() {
        const ScanProject files(2);
        Project project = files.project(steps);
        project.operations.push_back(make_operation("finish3"));
        Planner planner;
        const auto without = planner.prepare(project, {});
        QVERIFY(!without->geometry);
        project.operations.push_back(make_operation("finish5"));
        const auto with = planner.prepare(project, {});
        QVERIFY(with->geometry);
        QCOMPARE(with->geometry->vertex_normals.size(), with->mesh->vertices.size());
        QCOMPARE(with->mesh.get(), without->mesh.get());
        // Once they are there they stay.
        project.operations.pop_back();
        QCOMPARE(planner.prepare(project, {}).get(), with.get());
    }

    void it_runs_again_when_file_or_recipe_change_and_only_then() {
        const ScanProject files(3);
        Planner planner;
        const Project project = files.project(steps);
        const auto first = planner.prepare(project, {});
        planner.prepare(files.project(steps), {});
        QCOMPARE(planner.work().loads, 1);
        planner.prepare(files.project(R"([{"kind": "pieces", "size": 6}])"), {});
        QCOMPARE(planner.work().loads, 2);
        files.write_scan(4);
        std::filesystem::last_write_time(files.at("scan.stl"),
                                         std::filesystem::last_write_time(files.at("scan.stl"))
                                             + std::chrono::seconds(5));
        const auto second = planner.prepare(project, {});
        QCOMPARE(planner.work().loads, 3);
        QVERIFY(second->report.watertight);
        QVERIFY(second->mesh->vertices != first->mesh->vertices);
    }

    /// What one has read and repaired another one gets, as long as somebody holds it.
    void what_is_known_is_not_done_again() {
        const ScanProject files(6);
        const Project project = files.project(steps);
        const auto load = [&](const std::vector<RepairStep>& recipe, KnownMeshes* known) {
            return load_repaired(project.part_path(), project.part_reading(), recipe, {}, known);
        };
        Planner planner;
        KnownMeshes& known = *planner.meshes();
        std::optional<RepairedMesh> file = load({}, &known), fresh = load(project.part_recipe(), nullptr);
        RepairedMesh again = load({}, &known);
        QVERIFY(again.mesh == file->mesh);
        const auto part = planner.prepare(project, {});
        std::optional<RepairedMesh> repaired = load(project.part_recipe(), &known);
        QVERIFY(part->mesh == repaired->mesh && repaired->mesh != fresh->mesh);
        QVERIFY(repaired->mesh->vertices == fresh->mesh->vertices
                && repaired->mesh->facets == fresh->mesh->facets);
        QCOMPARE(repaired->report.warnings, fresh->report.warnings);
        QCOMPARE(repaired->repairs.size(), std::size_t(2));
        // Not what a file was before, nor what nobody has any more.
        const std::string key = repaired_key(project.part_path(), project.part_reading(), {});
        QVERIFY(known.find(key));
        file.reset();
        again = {};
        QVERIFY(!known.find(key));
        files.write_scan(7);
        QVERIFY(load(project.part_recipe(), &known).mesh != repaired->mesh);
    }

    void a_bad_recipe_names_its_place() {
        const ScanProject files(5);
        std::string message;
        QCOMPARE(code_of([&] { check_project(files.project(R"([{"kind": "smooth"}])")); }, &message),
                 std::string("missing_key"));
        QVERIFY2(message.find("part.repair[0].bound") != std::string::npos, message.c_str());
        QCOMPARE(code_of([&] { files.project(R"([{"kind": "polish"}])"); }), std::string("out_of_range"));
    }
};

FACETMILL_TEST(TestRepairedPart)
#include "test_repaired_part.moc"
