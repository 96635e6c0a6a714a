// What must not get into a project, and what a project must not be written over.
#include "core/base/file.h"
#include "core/job/project.h"
#include "tests/support/error_code.h"
#include "tests/support/test_runner.h"

#include <QTemporaryDir>
#include <QTest>

#include <filesystem>

using namespace facetmill;
using test::code_of;

namespace {

Project small_project() {
    return parse_project(R"({ "facetmill": 1, "units": "mm", "part": { "file": "part.stl" },
  "tools": [ { "number": 1, "name": "Ball", "diameter": 6, "corner_radius": 3 } ],
  "operations": [ { "kind": "finish3", "name": "Finish", "tool": 1, "tolerance": 0.1 } ] })",
                         "p.facetmill");
}

} // namespace

class TestProjectSafety : public QObject {
    Q_OBJECT
private slots:

    void no_text_comes_in_that_cannot_be_read_again() {
        Project p = small_project();
        const std::string before = project_to_json(p);
        for (const std::string& hidden : {std::string(1, '\0'), std::string("\x1B"), std::string("\xC2\x9B"),
                                          std::string("\xE2\x80\xAE"), std::string("\xE2\x80\xA8")}) {
            QCOMPARE(code_of([&] { apply_setting(p, "1.name=a" + hidden + "b"); }),
                     std::string("out_of_range"));
            // However it came to be there, it is not saved.
            for (std::string* text :
                 {&p.operations[0]->common().name, &p.tools[0].name, &p.part.file, &p.machine}) {
                const std::string good = *text;
                *text += hidden;
                QCOMPARE(code_of([&] { project_to_json(p); }), std::string("out_of_range"));
                *text = good;
            }
            QCOMPARE(project_to_json(p), before);
        }
        p.tools[0].name = "caf\xE9";
        std::string message;
        QCOMPARE(code_of([&] { project_to_json(p); }, &message), std::string("encoding"));
        QVERIFY2(message.starts_with("tools[0].name: "), message.c_str());
    }

    void a_project_is_not_saved_over_what_it_reads() {
        QTemporaryDir dir;
        const std::filesystem::path root = dir.path().toStdString();
        const auto put = [&](const char* name, std::string_view text) {
            OutputFile file(root / name);
            file.write(text);
            file.commit();
        };
        put("part.stl", "part");
        put("raw.stl", "raw");
        put("own.json", InputFile(test::data_path("../resources/machines/trunnion-ac.json")).bytes());
        std::filesystem::create_hard_link(root / "part.stl", root / "second.facetmill");
        Project p = small_project();
        p.path = root / "p.facetmill";
        p.stock.kind = StockSpec::Kind::mesh;
        p.stock.file = "raw.stl";
        p.machine = "own.json";
        for (const char* over : {"part.stl", "raw.stl", "own.json", "second.facetmill"})
            QCOMPARE(code_of([&] { save_project(p, root / over); }), std::string("unwritable"));
        QCOMPARE(std::string(InputFile(root / "part.stl").bytes()), std::string("part"));
        save_project(p, p.path);
        save_project(p, p.path); // over itself
    }
};

FACETMILL_TEST(TestProjectSafety)
#include "test_project_safety.moc"
