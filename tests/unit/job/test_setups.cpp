// Several setups in one project: the file of version 2, which setup the project is the view on, and what of a
// file is refused.
#include "core/base/file.h"
#include "core/job/program_files.h"
#include "core/job/project.h"
#include "core/job/project_inputs.h"
#include "core/job/setting_remarks.h"
#include "tests/support/test_runner.h"

#include <QTemporaryDir>
#include <QTest>

#include <cmath>
#include <fstream>

using namespace facetmill;

namespace {

const char* const two_setups = R"({ "facetmill": 2, "units": "mm",
  "part": { "file": "part.stl", "rotate": [0, 0, 90], "translate": [10, 0, 0] },
  "machine": "generic-3-axis", "post": "linuxcnc",
  "tools": [ { "number": 1, "diameter": 6 }, { "number": 2, "diameter": 3 } ],
  "setups": [
    { "name": "Top", "stock": { "kind": "box", "margin": [1, 1, 2] }, "wcs": "G54",
      "operations": [ { "kind": "rough", "name": "Rough", "tool": 1 }, { "kind": "finish3", "name": "Finish", "tool": 2 } ] },
    { "name": "Bottom", "place": { "rotate": [180, 0, 0], "translate": [0, 0, 30] }, "wcs": "G55", "post": "fanuc",
      "program_number": 20,
      "operations": [ { "kind": "finish3", "name": "Finish below", "tool": 2 } ] } ] })";

Project project_of(const std::string& text) {
    return parse_project(text, "p.facetmill");
}

std::string two_with(const std::string& from, const std::string& to) {
    std::string text = two_setups;
    const std::size_t at = text.find(from);
    if (at == std::string::npos) qFatal("the test's text is not in the project");
    return text.replace(at, from.size(), to);
}

} // namespace

class TestSetups : public QObject {
    Q_OBJECT
private slots:

    void a_file_of_two_reads() {
        Project p = project_of(two_setups);
        QCOMPARE(setup_count(p), std::size_t(2));
        QCOMPARE(chosen_setup(p), std::size_t(0));
        QCOMPARE(p.name, std::string("Top"));
        QCOMPARE(p.operations.size(), std::size_t(2));
        QCOMPARE(p.programs.post, std::string("linuxcnc")); // the file's
        choose_setup(p, 1);
        QCOMPARE(p.name, std::string("Bottom"));
        QCOMPARE(p.programs.post, std::string("fanuc")); // its own
        QCOMPARE(p.programs.wcs, std::string("G55"));
        QCOMPARE(p.programs.number, 20L);
        QVERIFY(p.stock.kind == StockSpec::Kind::rest); // after the first that is usual
        QCOMPARE(operations_before(p), std::size_t(2));
        QCOMPARE(find_setup(p, "Top"), std::size_t(0));
        QCOMPARE(setup_of_operation(p, "Finish below"), std::size_t(1));
        QCOMPARE(all_operations(p).size(), std::size_t(3));
        QCOMPARE(all_operations(p)[2]->common().name, std::string("Finish below"));
        QCOMPARE(free_operation_name(p, "Rough"), std::string("Rough 2"));
    }

    void places_add_up() {
        Project p = project_of(two_setups);
        QVERIFY(p.placed_part().rotate == p.part.rotate && p.placed_part().translate == p.part.translate);
        choose_setup(p, 1);
        const PartSpec placed = p.placed_part();
        const auto at = [](const PartSpec& spec, const Vec3& q) {
            return Vec3(rotation_of(spec.rotate) * q
                        + Vec3(spec.translate[0], spec.translate[1], spec.translate[2]));
        };
        for (const Vec3& q : {Vec3(0, 0, 0), Vec3(1, 2, 3), Vec3(-4, 0.5, 7)}) {
            const Vec3 first = at(p.part, q);
            QVERIFY((at(placed, q) - Vec3(first.x(), -first.y(), 30 - first.z())).norm() < 1e-9);
        }
        // Frames of half turns have no rounding, so that boxes stay boxes; there and back is nothing.
        const SetupFrame frame = frame_of(p.place);
        QVERIFY(frame.turn == Mat3(Vec3(1, -1, -1).asDiagonal()));
        QVERIFY(frame.inverse().after(frame).is_identity());
        QVERIFY(frame_of(place_of(frame)).turn == frame.turn);
        QVERIFY(std::abs(place_of(frame).translate[2] - 30) < 1e-9);
        SetupPlace skew{{0.3, -0.2, 1}, {1, 2, 3}};
        const SetupFrame f = frame_of(skew);
        const Vec3 q(5, 6, 7);
        QVERIFY((f.inverse()(f(q)) - q).norm() < 1e-12);
        QVERIFY((frame_of(place_of(f))(q) - f(q)).norm() < 1e-8);
    }

    void which_is_chosen_makes_no_difference_to_the_file() {
        Project p = project_of(two_setups);
        const std::string once = project_to_json(p);
        QVERIFY(once.starts_with("{\n  \"facetmill\": 2,"));
        QCOMPARE(project_to_json(project_of(once)), once);
        choose_setup(p, 1);
        QCOMPARE(project_to_json(p), once);
        QCOMPARE(project_to_json(Project(p)), once);
        choose_setup(p, 0);
        QCOMPARE(project_to_json(p), once);
        QCOMPARE(project_to_json(view_of_setup(p, 1)), once);
    }

    /// What version 1 can say is said as ever; nothing of a setup gets lost for it.
    void one_setup_is_version_1() {
        Project p = project_of(two_setups);
        p.after.clear();
        p.name = usual_setup_name(0);
        const std::string single = project_to_json(p);
        QVERIFY(single.starts_with("{\n  \"facetmill\": 1,"));
        QVERIFY(single.find("setups") == std::string::npos && single.find("place") == std::string::npos);
        QCOMPARE(project_to_json(project_of(single)), single);
        for (int what : {0, 1}) {
            Project other = p;
            if (what == 0)
                other.name = "Top";
            else
                other.place.translate[1] = 5;
            const std::string text = project_to_json(other);
            QVERIFY(text.starts_with("{\n  \"facetmill\": 2,"));
            const Project again = project_of(text);
            QVERIFY(again.name == other.name && again.place == other.place);
        }
    }

    void wrong_setups_are_named_data() {
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("code");
        QTest::addColumn<QString>("where");
        const auto row = [](const char* name, const std::string& text, const char* code, const char* where) {
            QTest::newRow(name) << QString::fromStdString(text) << code << where;
        };
        row("no setups", R"({"facetmill":2,"units":"mm","part":{"file":"a.stl"}})", "missing_key",
            "p.facetmill: setups");
        row("an empty list", R"({"facetmill":2,"units":"mm","part":{"file":"a.stl"},"setups":[]})",
            "missing_key", "p.facetmill: setups");
        row("no list", R"({"facetmill":2,"units":"mm","part":{"file":"a.stl"},"setups":{}})", "wrong_type",
            "p.facetmill: setups");
        row("no object", R"({"facetmill":2,"units":"mm","part":{"file":"a.stl"},"setups":[7]})", "wrong_type",
            "p.facetmill: setups[0]");
        row("setups in version 1", two_with("\"facetmill\": 2", "\"facetmill\": 1"), "unknown_key",
            "p.facetmill: setups");
        row("a stock of the file", two_with("\"machine\"", "\"stock\": { \"kind\": \"box\" }, \"machine\""),
            "unknown_key", "p.facetmill: stock");
        row("operations of the file", two_with("\"machine\"", "\"operations\": [], \"machine\""),
            "unknown_key", "p.facetmill: operations");
        row("unknown key", two_with("\"wcs\": \"G55\"", "\"wks\": \"G55\""), "unknown_key",
            "p.facetmill: setups[1].wks");
        row("unknown key of the place", two_with("\"translate\": [0, 0, 30]", "\"scale\": 2"), "unknown_key",
            "p.facetmill: setups[1].place.scale");
        row("place of two numbers", two_with("[180, 0, 0]", "[180, 0]"), "wrong_type",
            "p.facetmill: setups[1].place.rotate");
        row("a rest of nothing",
            two_with("{ \"kind\": \"box\", \"margin\": [1, 1, 2] }", "{ \"kind\": \"rest\" }"),
            "missing_reference", "p.facetmill: setups[0].stock.kind");
        row("a rest with a margin",
            two_with("\"program_number\"",
                     "\"stock\": { \"kind\": \"rest\", \"margin\": [1, 1, 1] }, \"program_number\""),
            "unknown_key", "p.facetmill: setups[1].stock.margin");
        row("two of a name", two_with("\"Bottom\"", "\"Top\""), "out_of_range",
            "p.facetmill: setups[1].name");
        row("an empty name", two_with("\"Bottom\"", "\" \""), "out_of_range", "p.facetmill: setups[1].name");
        row("name no text", two_with("\"Bottom\"", "7"), "wrong_type", "p.facetmill: setups[1].name");
        row("two operations of a name", two_with("Finish below", "Rough"), "out_of_range",
            "p.facetmill: setups[1].operations[0].name");
        row("a tool that is not there",
            two_with("\"Finish below\", \"tool\": 2", "\"Finish below\", \"tool\": 3"), "missing_reference",
            "p.facetmill: setups[1].operations[0].tool");
        row("unknown machine", two_with("\"program_number\"", "\"machine\": \"none\", \"program_number\""),
            "missing_reference", "p.facetmill: setups[1].machine");
        row("unknown post", two_with("fanuc", "fanuk"), "missing_reference", "p.facetmill: setups[1].post");
    }
    void wrong_setups_are_named() {
        QFETCH(QString, text);
        QFETCH(QString, code);
        QFETCH(QString, where);
        try {
            project_of(text.toStdString());
            QFAIL("it was read");
        } catch (const Error& e) {
            QCOMPARE(QString::fromUtf8(code_name(e.code()).data()), code);
            QCOMPARE(QString::fromStdString(e.where()), where);
            QVERIFY(!e.remedy().empty());
        }
    }

    void one_of_one_setup_says_nothing_of_setups() {
        Project p = project_of(two_setups);
        p.after.clear();
        p.operations[0]->common().tolerance = -1;
        try {
            check_project(p);
            QFAIL("it was taken");
        } catch (const Error& e) {
            QCOMPARE(e.where(), std::string("operations[0].tolerance"));
        }
    }

    void settings_reach_all_setups() {
        Project p = project_of(two_setups);
        apply_setting(p, "Finish below.tolerance=0.03");
        apply_setting(p, "3.feed=123");
        apply_setting(p, "program_number=7");
        apply_setting(p, setup_at(p, 1).name + ".post=grbl");
        QVERIFY(setup_at(p, 0).programs.post != "grbl" && setup_at(p, 0).programs.number == 7);
        choose_setup(p, 1);
        QCOMPARE(p.programs.post, std::string("grbl"));
        QCOMPARE(p.programs.number, 7L);
        QCOMPARE(p.operations[0]->common().tolerance, 0.03);
        QCOMPARE(p.operations[0]->common().feed, 123.0);
        QVERIFY_EXCEPTION_THROWN(apply_setting(p, "4.feed=1"), Error);
    }

    /// A program of one operation and one of a whole setup may ask for the same name.
    void two_programs_of_one_name_are_refused() {
        Project p = project_of(two_setups);
        QCOMPARE(program_file_names(p).size(),
                 std::size_t(7)); // of three operations, each also posted, and the report
        p.part.file = "02.stl";
        p.operations[1]->common().name = "2-Bottom";
        p.after.front().programs.post = p.programs.post;
        p.after.front().programs.files = ProgramSpec::Files::one;
        try {
            program_file_names(p);
            QFAIL("not refused");
        } catch (const Error& e) {
            QCOMPARE(e.code(), ErrorCode::out_of_range);
            QVERIFY2(e.message().find("'02-2-Bottom.ngc'") != std::string::npos, e.message().c_str());
        }
        p.after.front().name = "Below";
        QCOMPARE(program_file_names(p).size(), std::size_t(7));
    }

    /// Files of the other setups move with the project, and nothing is written over them.
    void files_of_all_setups_are_kept() {
        QTemporaryDir dir;
        const std::filesystem::path root(dir.path().toStdString());
        std::filesystem::create_directories(root / "a");
        std::filesystem::create_directories(root / "b");
        std::ofstream(root / "a" / "rest.stl") << "solid";
        Project p = project_of(
            two_with("\"program_number\"",
                     "\"stock\": { \"kind\": \"mesh\", \"file\": \"rest.stl\" }, \"program_number\""));
        p.path = root / "a" / "p.facetmill";
        QVERIFY_EXCEPTION_THROWN(keep_inputs(p, root / "a" / "rest.stl"), Error);
        save_project(p, root / "b" / "q.facetmill");
        Project moved = load_project(root / "b" / "q.facetmill");
        choose_setup(moved, 1);
        QVERIFY(std::filesystem::equivalent(moved.stock_path(), root / "a" / "rest.stl"));
        Project taken = p;
        take_inputs(taken, load_project(root / "b" / "q.facetmill"));
        QCOMPARE(setup_at(taken, 1).stock.file, moved.stock.file);
    }
};

FACETMILL_TEST(TestSetups)
#include "test_setups.moc"
