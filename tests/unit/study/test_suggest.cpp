// Suggestions of operations for a little roof: which kinds are tried, what is best, and that nothing is left
// behind.
#include "core/study/suggest.h"

#include "core/job/new_operation.h"
#include "core/mesh/mesh_io.h"
#include "tests/support/cancel_at.h"
#include "tests/support/error_code.h"
#include "tests/support/part_meshes.h"
#include "tests/support/test_runner.h"

#include <QTemporaryDir>
#include <QTest>

#include <set>

using namespace facetmill;
using namespace facetmill::test;

namespace {

/// Hills, two balls and a coarse tolerance: each candidate takes a moment.
class SuggestJob {
    QTemporaryDir dir_;

public:
    Project project;
    std::shared_ptr<const PreparedPart> part;

    SuggestJob() {
        const std::filesystem::path file = std::filesystem::path(dir_.path().toStdString()) / "hills.stl";
        const Mesh mesh =
            height_field([](double x, double y) { return 1.2 * std::sin(0.3 * x) * std::cos(0.3 * y); },
                         Vec2(-8, -6), Vec2(8, 6), 16, 12);
        save_stl(mesh, file, LengthUnit::mm, Progress());
        project = default_project(file, LengthUnit::mm, mesh.box());
        project.tools = {ball_tool(4), ball_tool(6)};
        for (std::size_t i = 0; i < project.tools.size(); ++i)
            project.tools[i].number = long(i) + 1;
        project.operations.front()->common().tool = 1;
        project.operations.front()->common().tolerance = 0.3;
        part = Planner().prepare(project, Progress());
    }
};

std::set<std::string> kinds_of(const std::vector<std::shared_ptr<const Operation>>& all) {
    std::set<std::string> kinds;
    for (const auto& o : all)
        kinds.insert(std::string(o->kind()));
    return kinds;
}

} // namespace

class TestSuggest : public QObject {
    Q_OBJECT
private slots:
    void finishing_that_the_machine_can_run_is_tried_with_two_tools() {
        SuggestJob job;
        const auto all = suggestable(job.project);
        const std::set<std::string> kinds = kinds_of(all);
        for (const char* kind :
             {"finish3", "waterline", "steep_shallow", "scallop", "radial", "spiral", "morph"})
            QVERIFY2(kinds.contains(kind), kind);
        for (const char* kind : {"rough", "cleanup", "pencil", "along_curve", "lathe_finish", "lathe_rough"})
            QVERIFY2(!kinds.contains(kind), kind);
        std::set<long> tools;
        for (const auto& o : all) {
            if (o->kind() == "finish3") tools.insert(o->common().tool);
            QCOMPARE(o->common().tolerance, 0.3);
        }
        QCOMPARE(tools, std::set<long>({1, 2}));
        // No machine of three axes leans a tool.
        job.project.machine = "three-axis";
        for (const Machine& machine : machines())
            if (machine.rotary.empty()) job.project.machine = machine.name;
        QVERIFY(!kinds_of(suggestable(job.project)).contains("finish5"));
    }

    void three_are_best_and_none_of_them_is_surpassed_by_the_first() {
        const SuggestJob job;
        const Suggestions found = suggest(job.project, *job.part, Progress());
        QCOMPARE(found.best.size(), std::size_t(3));
        QCOMPARE(found.looked_at, suggestable(job.project).size());
        QCOMPARE(found.part.allowed, 0.3);
        for (const Suggestion& s : found.best) {
            QVERIFY(s.seconds > 0);
            QVERIFY(s.result.measures[Measure::excess_p99].has_value());
            QVERIFY(s.result.measures[Measure::gouge_max].value_or(1) < 0.05);
            QVERIFY(!s.tool.empty());
        }
        // Of those that are verified the first is the quickest.
        for (const Suggestion& s : found.best)
            if (s.result.passed == found.best.front().result.passed)
                QVERIFY(found.best.front().seconds <= s.seconds || !s.result.passed);
    }

    void how_steep_the_part_is_is_measured() {
        SuggestJob job;
        auto part = std::make_shared<PreparedPart>(*job.part);
        // A block: its five sides but the bottom face up or stand upright, which is as steep as can be.
        part->mesh = std::make_shared<Mesh>(
            height_field([](double x, double) { return 2 * std::abs(x); }, Vec2(-8, -6), Vec2(8, 6), 16, 12));
        QVERIFY(std::abs(suggest(job.project, *part, Progress()).part.steep_share - 1) < 1e-9);
    }

    void nothing_is_suggested_where_nothing_can_be_made() {
        SuggestJob job;
        job.project.operations.front()->common().tolerance = 1e-9;
        job.project.part.tessellation_tolerance = {0.1, 0.1};
        QCOMPARE(code_of([&] { suggest(job.project, *job.part, Progress()); }),
                 std::string(code_name(ErrorCode::empty_result)));
        job.project.tools.clear();
        QCOMPARE(code_of([&] { suggest(job.project, *job.part, Progress()); }),
                 std::string(code_name(ErrorCode::empty_result)));
    }

    void looking_can_be_cancelled() {
        const SuggestJob job;
        for (const double at : {0.05, 0.3, 0.8}) {
            Job work;
            QVERIFY(cancelled_at(work, at, [&](const Progress& p) { suggest(job.project, *job.part, p); }));
        }
    }
};

FACETMILL_TEST(TestSuggest)
#include "test_suggest.moc"
