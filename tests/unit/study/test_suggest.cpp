// Suggestions of operations for a little roof: which kinds are tried, what is best, and that nothing is left
// behind.
#include "core/study/suggest.h"

#include "core/job/new_operation.h"
#include "core/mesh/mesh_io.h"
#include "core/study/evaluation.h"
#include "core/study/previewed.h"
#include "tests/support/cancel_at.h"
#include "tests/support/error_code.h"
#include "tests/support/part_meshes.h"
#include "tests/support/test_runner.h"

#include <QTemporaryDir>
#include <QTest>

#include <algorithm>
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

    explicit SuggestJob(double high = 1.2)
        : SuggestJob(
            height_field([high](double x, double y) { return high * std::sin(0.3 * x) * std::cos(0.3 * y); },
                         Vec2(-8, -6), Vec2(8, 6), 16, 12)) {}
    explicit SuggestJob(const Mesh& mesh) {
        const std::filesystem::path file = std::filesystem::path(dir_.path().toStdString()) / "part.stl";
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

    /// Previews order the same candidates, and take a fraction of a second however much planning takes.
    void what_would_take_long_to_plan_is_previewed() {
        SuggestJob job;
        const Suggestions planned = suggest(job.project, *job.part, Progress());
        QVERIFY(std::ranges::none_of(planned.best, &Suggestion::previewed));
        job.project.operations.front()->common().tolerance = 1e-4;
        const Suggestions found = suggest(job.project, *job.part, Progress());
        QCOMPARE(found.best.size(), std::size_t(3));
        QCOMPARE(found.looked_at, planned.looked_at);
        for (const Suggestion& s : found.best) {
            QVERIFY(s.previewed && s.result.passed && s.seconds > 0);
            QVERIFY(s.planning_seconds > 1); // others together are no 15 s
            QVERIFY(!s.result.measures[Measure::excess_p99].has_value());
            QVERIFY(s.seconds >= found.best.front().seconds);
            // Levels leave what is nearly level.
            QVERIFY(s.operation->kind() != "waterline");
        }
    }

    /// Short flutes in a block: something has to rough before whatever is suggested, and is part of it.
    void stock_that_is_too_deep_is_roughed_first() {
        SuggestJob job;
        QVERIFY(!suggest(job.project, *job.part, Progress()).rough);
        for (Tool& tool : job.project.tools)
            tool.flute_length = 1.5;
        const Suggestions found = suggest(job.project, *job.part, Progress());
        QVERIFY(found.rough);
        QCOMPARE(std::string(found.rough->operation->kind()), std::string("rough"));
        QVERIFY(found.unroughed.highest > found.unroughed.reach && found.unroughed.share > 0.02);
        QCOMPARE(found.best.size(), std::size_t(3));
        QVERIFY(found.rough->tool);
        job.project.tools.push_back(*found.rough->tool);
        job.project.operations.push_back(new_operation("rough", job.project).operation);
        QVERIFY(!suggest(job.project, *job.part, Progress()).rough);
    }

    void previews_tell_times_and_what_stays() {
        const SuggestJob job(4);
        PassPreviewer previewer;
        double left_by_levels = 0;
        for (const auto& operation : suggestable(job.project)) {
            if (!operation->keeps_axis()) continue;
            Project with = job.project;
            with.operations.clear();
            with.operations.push_back(operation->clone());
            const PreviewedOperation p = previewed_operation(previewer, with, 0, *job.part, Progress());
            const RungResult r = evaluate(with, with, Rung::estimate, Progress());
            const double seconds = r.measures[Measure::machining_time].value_or(0);
            const std::string told = std::string(operation->kind()) + ": " + std::to_string(p.seconds)
                                     + " s of " + std::to_string(seconds) + ", "
                                     + std::to_string(p.uncut_share);
            QVERIFY2(p.seconds > seconds / 2.5 && p.seconds < 2.5 * seconds, told.c_str());
            QVERIFY(p.planning_seconds > 0);
            if (operation->kind() == "waterline")
                left_by_levels = p.uncut_share;
            else if (operation->kind() != "scallop")
                QVERIFY2(p.uncut_share < 0.05, told.c_str());
        }
        QVERIFY(left_by_levels > 0.05);
    }

    /// Of a dome a third is steeper than the 70 degrees of constant scallop, which is little from above.
    void what_lies_beyond_the_limits_of_slope_is_left() {
        const SuggestJob job(dome(10, 40));
        PassPreviewer previewer;
        const auto left_by = [&](const char* kind) {
            Project with = job.project;
            with.operations.clear();
            with.operations.push_back(new_operation(kind, job.project).operation);
            return previewed_operation(previewer, with, 0, *job.part, Progress()).uncut_share;
        };
        QVERIFY2(std::abs(left_by("scallop") - std::cos(radians(70))) < 0.03,
                 std::to_string(left_by("scallop")).c_str());
        QVERIFY(left_by("finish3") < 0.03 && left_by("steep_shallow") < 0.03);
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
