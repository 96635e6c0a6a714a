// Slips by some zeros are seen before the work; usual projects are not held up.
#include "core/job/work_estimate.h"
#include "tests/support/test_runner.h"

#include <QTest>

using namespace facetmill;

namespace {

Project project_with(const std::string& operation) {
    return parse_project(
        R"({ "facetmill": 1, "units": "mm", "part": { "file": "part.stl" }, "machine": "lathe-mill",
  "tools": [ { "number": 1, "name": "Ball", "diameter": 6, "corner_radius": 3 } ],
  "operations": [ { "name": "One", "tool": 1, )"
            + operation + "} ] }",
        "p.facetmill");
}

PreparedPart plate() {
    PreparedPart part;
    auto mesh = std::make_shared<Mesh>();
    mesh->vertices = {Vec3(0, 0, 0), Vec3(100, 0, 0), Vec3(100, 50, 20), Vec3(0, 50, 20)};
    mesh->facets = {{0, 1, 2}, {0, 2, 3}};
    part.box = mesh->box();
    part.mesh = mesh;
    return part;
}

} // namespace

class TestWorkEstimate : public QObject {
    Q_OBJECT
private slots:

    void slips_are_large_data() {
        QTest::addColumn<QString>("operation");
        QTest::addColumn<bool>("large");
        const auto row = [](const char* operation, bool large) {
            QTest::newRow(operation) << operation << large;
        };
        row(R"("kind": "finish3", "tolerance": 0.05)", false);
        row(R"("kind": "finish3", "tolerance": 0.001)", false);
        row(R"("kind": "finish3", "tolerance": 1e-9)", true);
        row(R"("kind": "finish3", "tolerance": 0.05, "stepover": 1e-6)", true);
        row(R"("kind": "finish5", "tolerance": 0.05)", false);
        row(R"("kind": "finish5", "tolerance": 1e-7)", true);
        row(R"("kind": "lathe_finish", "tolerance": 0.05)", false);
        row(R"("kind": "lathe_finish", "tolerance": 0.05, "points_per_turn": 3600)", false);
        row(R"("kind": "lathe_finish", "tolerance": 0.05, "points_per_turn": 1000000)", true);
        // A grid of 65 000 postures at each of 200 000 points.
        row(R"("kind": "finish5", "tolerance": 0.005)", false);
        row(R"("kind": "finish5", "tolerance": 0.005, "grid_degrees": 0.25)", true);
        row(R"("kind": "global_local", "tolerance": 0.05, "rework_tool": 1)", false);
        row(R"("kind": "rough", "tolerance": 1)", false);
        row(R"("kind": "rough", "tolerance": 1, "stepover": 1e-5)", true);
        row(R"("kind": "rough", "tolerance": 1, "depth": 1e-5)", true);
        row(R"("kind": "cleanup", "tolerance": 0.05, "previous_tool": 1)", false);
        row(R"("kind": "cleanup", "tolerance": 1e-8, "previous_tool": 1)", true);
    }
    void slips_are_large() {
        QFETCH(QString, operation);
        QFETCH(bool, large);
        const Project project = project_with(operation.toStdString());
        const auto estimates = estimate_plan(project, plate(), "");
        QCOMPARE(
            std::any_of(estimates.begin(), estimates.end(), [](const WorkEstimate& e) { return e.large(); }),
            large);
        QVERIFY(estimate_plan(project, plate(), "Another").empty());
        QCOMPARE(estimates.size(), project.operations.size()); // none goes without
        for (const WorkEstimate& e : estimates)
            QVERIFY(e.points > 0 && e.bytes > e.points && e.text().find(" GB") != std::string::npos);
    }

    void global_local_plans_more_than_one_path() {
        const auto seconds = [](const std::string& operation) {
            return estimate_plan(project_with(operation), plate(), "").at(0).seconds;
        };
        const double finishing = seconds(R"("kind": "finish5", "tolerance": 0.05)");
        const double kept =
            seconds(R"("kind": "global_local", "tolerance": 0.05, "raise_lead_limit": false)");
        QVERIFY(kept > 2 * finishing);
        QCOMPARE(seconds(R"("kind": "global_local", "tolerance": 0.05, "rework_tool": 1)"), 2 * kept);
    }

    void places_follow_the_area() {
        QVERIFY(estimate_places(plate(), 1) > 5000 && estimate_places(plate(), 1) < 20000);
        QVERIFY(estimate_places(plate(), 1e-9) > 1e20);
    }
};

FACETMILL_TEST(TestWorkEstimate)
#include "test_work_estimate.moc"
