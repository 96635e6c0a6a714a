// Which files a project names, which of them are missing, and others in their place.
#include "core/base/file.h"
#include "core/job/project_inputs.h"
#include "tests/support/error_code.h"
#include "tests/support/test_runner.h"

#include <QTemporaryDir>
#include <QTest>

#include <filesystem>

using namespace facetmill;
using test::code_of;
using Kind = ProjectInput::Kind;
namespace fs = std::filesystem;

class TestProjectInputs : public QObject {
    Q_OBJECT
private slots:

    void files_are_those_that_the_project_names() {
        Project p;
        QVERIFY(project_inputs(p).empty());
        p.path = "/there/job.facetmill";
        p.part.file = "a.stl";
        QCOMPARE(project_inputs(p), (std::vector<ProjectInput>{{Kind::part, "/there/a.stl"}}));
        p.stock.file = "raw.stl"; // of a box
        p.machine = "tarus-tpi-2000";
        p.programs.post = "grbl";
        QCOMPARE(project_inputs(p).size(), std::size_t(1));
        p.stock.kind = StockSpec::Kind::mesh;
        p.machine = "own.json";
        p.programs.post = "/else/post.json";
        QCOMPARE(project_inputs(p), (std::vector<ProjectInput>{{Kind::part, "/there/a.stl"},
                                                               {Kind::stock, "/there/raw.stl"},
                                                               {Kind::machine, "/there/own.json"},
                                                               {Kind::post, "/else/post.json"}}));
    }

    void all_that_is_missing_is_told() {
        const Job job;
        Project p = job.project();
        std::string message;
        QCOMPARE(code_of([&] { check_inputs(p); }, &message), std::string("not_found"));
        const std::string here = (job.root / "job").string();
        QCOMPARE(message.substr(0, message.find(" (")),
                 "part.file, machine: there is no file " + here + "/meshes/a.stl, " + here + "/own.json");
        put(job.root / "job/meshes/a.stl");
        fs::create_directory(job.root / "job/own.json"); // another error, of whoever reads it
        QCOMPARE(missing_inputs(p), (std::vector<ProjectInput>{{Kind::post, job.root / "job/post.json"}}));
        check_inputs(p); // planning reads no post
    }

    void another_file_is_named_from_the_project() {
        const Job job;
        Project p = job.project();
        const auto named = [&](const fs::path& file) {
            set_input(p, {Kind::part, {}}, file);
            return p.part.file;
        };
        put(job.root / "job/b.stl");
        put(job.root / "c.stl");
        QCOMPARE(named(job.root / "job/b.stl"), std::string("b.stl"));
        QCOMPARE(named(job.root / "job/../c.stl"), std::string("../c.stl"));
        // Through a link "../c.stl" would lead to another folder than its name says.
        fs::create_directories(job.root / "deep/er");
        fs::create_directory_symlink(job.root / "deep/er", job.root / "link");
        p.path = job.root / "link/job.facetmill";
        QCOMPARE(named(job.root / "c.stl"), (job.root / "c.stl").string());
        p.path.clear(); // a project without a place
        QCOMPARE(named(job.root / "c.stl"), (job.root / "c.stl").string());
    }

    void what_lies_beside_a_located_file_is_found_too() {
        const Job job;
        const auto located = [&](const char* file) {
            Project p = job.project();
            const auto found = locate_input(p, {Kind::part, p.part_path()}, job.root / file);
            std::string all = p.part.file + " " + p.machine + " " + p.programs.post;
            for (const ProjectInput& input : found)
                all += " +" + std::string(input_name(input.kind)) + " "
                       + input.path.lexically_relative(job.root).string();
            return all;
        };
        put(job.root / "new/z.stl");
        QCOMPARE(located("new/z.stl"), std::string("../new/z.stl own.json post.json"));
        put(job.root / "new/own.json");
        fs::create_directory(job.root / "new/post.json"); // no file
        QCOMPARE(located("new/z.stl"),
                 std::string("../new/z.stl ../new/own.json post.json +machine new/own.json"));
        // Beside it as it was: one folder up.
        put(job.root / "own.json");
        put(job.root / "post.json");
        QCOMPARE(located("new/z.stl"), std::string("../new/z.stl ../own.json ../post.json +machine own.json "
                                                   "+post post.json"));
        // What is not missing stays.
        put(job.root / "job/own.json");
        QCOMPARE(located("new/z.stl"), std::string("../new/z.stl own.json ../post.json +post post.json"));
    }

private:
    /// A project in a folder of its own whose files are not there.
    struct Job {
        QTemporaryDir dir;
        fs::path root = fs::canonical(dir.path().toStdString());
        Job() { fs::create_directories(root / "job/meshes"); }
        Project project() const {
            Project p;
            p.path = root / "job/job.facetmill";
            p.part.file = "meshes/a.stl";
            p.machine = "own.json";
            p.programs.post = "post.json";
            return p;
        }
    };

    static void put(const fs::path& path) {
        fs::create_directories(path.parent_path());
        OutputFile file(path);
        file.write("something");
        file.commit();
    }
};

FACETMILL_TEST(TestProjectInputs)
#include "test_project_inputs.moc"
