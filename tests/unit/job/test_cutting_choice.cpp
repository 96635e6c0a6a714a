// Feeds and speeds: what an operation takes over from its tool, and when it follows a change of tool.
#include "core/job/cutting_choice.h"
#include "core/job/new_operation.h"
#include "tests/support/error_code.h"
#include "tests/support/test_runner.h"
#include "tests/unit/job/listed_tool.h"

#include <QTest>

using namespace facetmill;
using namespace facetmill::test;

namespace {

Tool known_tool(long number, double diameter, std::vector<CuttingData> cutting, long flutes = 2) {
    Tool tool = listed_tool(number, diameter, 0);
    tool.flutes = flutes;
    tool.cutting = std::move(cutting);
    return tool;
}

CuttingData run(std::string material, double spindle, double feed) {
    CuttingData data;
    data.material = std::move(material);
    data.spindle = spindle;
    data.feed = feed;
    return data;
}

} // namespace

class TestCuttingChoice : public QObject {
    Q_OBJECT
private slots:
    void a_feed_is_said_or_follows_from_the_chip_load() {
        CuttingData data = run("Wood", 10000, 0);
        const Tool tool = known_tool(1, 6, {});
        QCOMPARE(cutting_feed(tool, data), 0.0);
        data.chip_load = 0.05;
        QCOMPARE(cutting_feed(tool, data), 1000.0); // 10 000 turns, two edges
        data.feed = 700;
        QCOMPARE(cutting_feed(tool, data), 700.0);
        QCOMPARE(cutting_feed(known_tool(1, 6, {}, 0), run("Wood", 10000, 0)), 0.0);
    }

    void data_are_found_by_their_material() {
        const Tool tool =
            known_tool(1, 6, {run("Foam", 0, 500), run("Wood", 9000, 800), run("Steel", 4000, 300)});
        QCOMPARE(cutting_for(tool)->material, std::string("Wood")); // the first that says enough
        QCOMPARE(cutting_for(tool, "Steel")->material, std::string("Steel"));
        QVERIFY(!cutting_for(tool, "Foam") && !cutting_for(tool, "Ice")); // never those of another material
        QVERIFY(!cutting_for(known_tool(1, 6, {run("Foam", 0, 500)})));
    }

    void an_operation_runs_as_its_tool_says() {
        CuttingData data = run("Wood", 9000, 800);
        data.plunge_feed = 150;
        data.depth = 1.5;
        data.stepover = 2.5;
        const Tool tool = known_tool(1, 6, {data});
        const auto rough = make_operation("rough");
        run_by(*rough, tool, data);
        QCOMPARE(rough->common().spindle, 9000.0);
        QCOMPARE(rough->common().feed, 800.0);
        QCOMPARE(rough->common().feed_of(MotionKind::approach), 150.0);
        QCOMPARE(number_of(*rough, "depth"), 1.5);
        QCOMPARE(number_of(*rough, "stepover"), 2.5);
        QCOMPARE(runs_by(*rough, tool), &tool.cutting.front());
        // What is left to finish decides its step-over.
        const auto finish = make_operation("finish3");
        const ParameterValue stepover = finish->get("stepover");
        run_by(*finish, tool, data);
        QVERIFY(finish->get("stepover") == stepover);
        // Where nobody says how fast it plunges, it is not as fast as before.
        run_by(*finish, tool, run("Steel", 4000, 300));
        QCOMPARE(finish->common().feed_of(MotionKind::approach), 150.0);
        QVERIFY(!runs_by(*finish, tool));
        // No operation may have this: what it had stays.
        run_by(*finish, tool, run("Ice", 5e6, 100));
        QCOMPARE(finish->common().spindle, 4000.0);
        QCOMPARE(finish->common().feed, 100.0);
    }

    void feeds_follow_a_change_of_tool_until_somebody_sets_them() {
        const std::vector<Tool> tools = {known_tool(1, 6, {run("Wood", 9000, 800), run("Steel", 4000, 300)}),
                                         known_tool(2, 3, {run("Wood", 18000, 500), run("Steel", 8000, 200)}),
                                         known_tool(3, 2, {})};
        const auto operation = make_operation("finish3");
        change_tool(*operation, tools, 1); // as operations begin
        QCOMPARE(operation->common().feed, 800.0);
        run_by(*operation, tools[0], tools[0].cutting[1]);
        change_tool(*operation, tools, 2); // for the same material
        QCOMPARE(operation->common().spindle, 8000.0);
        QCOMPARE(operation->common().feed, 200.0);
        change_tool(*operation, tools, 3); // knows none
        QCOMPARE(operation->common().feed, 200.0);
        change_tool(*operation, tools, 1);
        QCOMPARE(operation->common().feed, 200.0); // it ran by no data of the one before
        // Feeds for another material are not taken in silence.
        run_by(*operation, tools[0], tools[0].cutting[1]);
        const std::vector<Tool> more = {tools[0], known_tool(4, 5, {run("Foam", 24000, 6000)})};
        change_tool(*operation, more, 4);
        QCOMPARE(operation->common().feed, 300.0);
        // What a project in inches begins with is a beginning, too.
        change_tool(*operation, tools, 1);
        operation->set("feed", 40 * 25.4);
        operation->set("spindle", operation->parameter("spindle").default_value);
        change_tool(*operation, more, 4);
        QCOMPARE(operation->common().feed, 6000.0);
        change_tool(*operation, tools, 1);
        operation->set("feed", 777.0);
        change_tool(*operation, tools, 2);
        QCOMPARE(operation->common().feed, 777.0);
        QCOMPARE(code_of([&] { change_tool(*operation, tools, 0); }), std::string("out_of_range"));
        change_tool(*operation, tools, 9); // of no list: the project's check says so
        QCOMPARE(operation->common().tool, 9L);
    }

    void a_new_operation_runs_as_its_tool_says() {
        Box3 box;
        box.add(Vec3::Zero());
        box.add(Vec3(100, 100, 20));
        Project p = default_project("part.stl", LengthUnit::mm, box);
        CuttingData wood = run("Wood", 9000, 800);
        wood.depth = 1.25;
        Tool ball = listed_tool(1, 6, 3);
        ball.cutting = {run("Steel", 5000, 222), run("Wood", 12000, 640)};
        p.tools = {ball, known_tool(2, 12, {run("Steel", 2000, 250), wood})};
        OperationCommon& finish = p.operations.front()->common();
        finish.tool = 1;
        finish.feed = 640;
        finish.spindle = 12000;
        const NewOperation made = new_operation("rough", p);
        QCOMPARE(made.operation->common().tool, 2L);
        QCOMPARE(made.operation->common().feed, 800.0); // of the neighbour's material
        QCOMPARE(number_of(*made.operation, "depth"), 1.25);
        const NewOperation cleans = new_operation("cleanup", p);
        QVERIFY(cleans.tool && cleans.tool->cutting.empty()); // half as large: nobody knows
        QCOMPARE(cleans.operation->common().feed, 640.0);
    }

    void projects_keep_what_tools_know() {
        Box3 box;
        box.add(Vec3::Zero());
        box.add(Vec3(4, 4, 1));
        Project p = default_project("part.stl", LengthUnit::inch, box);
        QVERIFY(project_to_json(p).find("cutting") == std::string::npos);
        QVERIFY(project_to_json(p).find("flutes") == std::string::npos);
        CuttingData data = run("Wood", 9000, 800);
        data.name = "Gentle";
        data.chip_load = 0.04;
        p.tools.front().cutting = {data};
        p.tools.front().flutes = 3;
        const Project read = parse_project(project_to_json(p), "job.facetmill");
        QCOMPARE(read.tools.front().flutes, 3L);
        const CuttingData& back = read.tools.front().cutting.at(0);
        QCOMPARE(back.name, data.name);
        QCOMPARE(back.material, data.material);
        QVERIFY(std::abs(back.feed - 800) < 1e-9 && std::abs(back.chip_load - 0.04) < 1e-12);
    }
};

FACETMILL_TEST(TestCuttingChoice)
#include "test_cutting_choice.moc"
