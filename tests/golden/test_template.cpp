// Templates on the command line: what of a project serves other parts, and what is told of what does not fit.
#include "tests/golden/run_cli.h"
#include "tests/support/test_runner.h"

#include <QJsonArray>
#include <QTest>

using namespace facetmill;
using namespace facetmill::test;

namespace {

/// Three facets of a little roof.
const char* const roof = R"(solid roof
facet normal 0 0 1 outer loop vertex 0 0 0 vertex 20 0 0 vertex 20 10 4 endloop endfacet
facet normal 0 0 1 outer loop vertex 0 0 0 vertex 20 10 4 vertex 0 10 4 endloop endfacet
facet normal 0 0 1 outer loop vertex 0 10 4 vertex 20 10 4 vertex 10 20 0 endloop endfacet
endsolid roof
)";

} // namespace

class TestTemplateCommand : public QObject {
    Q_OBJECT
private slots:
    void templates_serve_other_parts() {
        Sandbox s;
        s.write("roof.stl", roof);
        s.write("job.facetmill", R"({ "facetmill": 2, "units": "mm", "part": { "file": "roof.stl" },
            "tools": [ { "number": 1, "diameter": 3, "corner_radius": 1.5, "flute_length": 10, "shank_length": 20 },
                       { "number": 7, "diameter": 30, "flute_length": 10, "shank_length": 20 },
                       { "number": 9, "diameter": 2, "flute_length": 10, "shank_length": 20 } ],
            "setups": [ { "name": "Top", "stock": { "kind": "box", "margin": [1, 2, 3] }, "operations": [
              { "kind": "rough", "name": "Rough", "tool": 7, "tolerance": 0.5, "depth": 2, "stepover": 50 },
              { "kind": "finish3", "name": "Fine", "tool": 1, "tolerance": 0.2, "feed": 777 } ] } ] })");
        const CliRun saved = run_cli({"template", "save", "job.facetmill", "-o", "t.fmtemplate"}, s.path());
        QVERIFY2(saved.status == 0, saved.err.constData());
        QCOMPARE(json(saved.out)["operations"].toArray().size(), 2);
        QVERIFY(!bytes_of(s.path() + "/" + "t.fmtemplate").contains("roof"));

        // For a mesh: a project that can be planned; what does not fit is told.
        const CliRun made =
            run_cli({"template", "apply", "t.fmtemplate", "roof.stl", "--units", "mm", "-o", "new.facetmill"},
                    s.path());
        QVERIFY2(made.status == 0, made.err.constData());
        QVERIFY2(made.err.contains("'Rough', Step-over: Wider than the tool"), made.err.constData());
        QCOMPARE(json(made.out)["remarks"].toArray().size(), 1);
        QCOMPARE(json(made.out)["tools"].toArray().size(), 2); // those that operations use
        const QByteArray project = bytes_of(s.path() + "/" + "new.facetmill");
        QVERIFY(project.contains("\"roof.stl\"") && project.contains("777")
                && !project.contains("\"number\": 9"));
        const CliRun plan = run_cli(
            {"plan", "new.facetmill", "-o", "plan", "--op", "Fine", "--set", "Rough.stepover=5"}, s.path());
        QVERIFY2(plan.status == 0, plan.err.constData());

        // In place of the operations of a project, which stays as it is.
        s.write("other.facetmill", R"({ "facetmill": 2, "units": "mm", "part": { "file": "roof.stl" },
            "tools": [ { "number": 1, "diameter": 1, "flute_length": 10, "shank_length": 20 } ],
            "setups": [ { "name": "Top", "operations": [
              { "kind": "finish3", "name": "Old", "tool": 1, "tolerance": 0.2 } ] } ] })");
        const QByteArray other = bytes_of(s.path() + "/" + "other.facetmill");
        const CliRun over = run_cli(
            {"template", "apply", "t.fmtemplate", "other.facetmill", "-o", "other.facetmill"}, s.path());
        QVERIFY(over.status == 1 && bytes_of(s.path() + "/" + "other.facetmill") == other);
        const CliRun applied = run_cli(
            {"template", "apply", "t.fmtemplate", "other.facetmill", "-o", "both.facetmill"}, s.path());
        QVERIFY2(applied.status == 0, applied.err.constData());
        const QByteArray both = bytes_of(s.path() + "/" + "both.facetmill");
        QVERIFY(both.contains("Fine") && !both.contains("Old"));
        // Never over what is read, and what is no template is an error without a file.
        QCOMPARE(run_cli({"template", "save", "job.facetmill", "-o", "roof.stl"}, s.path()).status, 1);
        QCOMPARE(run_cli({"template", "apply", "roof.stl", "other.facetmill", "-o", "no.facetmill"}, s.path())
                     .status,
                 1);
        QVERIFY(bytes_of(s.path() + "/" + "no.facetmill").isEmpty());
    }
};

FACETMILL_TEST(TestTemplateCommand)
#include "test_template.moc"
