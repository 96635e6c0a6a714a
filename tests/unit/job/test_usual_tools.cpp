// Tools that a project begins with: standard diameters for parts of any size, a flat for roughing, and what
// follows a part that is laid down.
#include "core/job/usual_tools.h"

#include "core/job/new_operation.h"
#include "tests/support/test_runner.h"
#include "tests/unit/job/listed_tool.h"

#include <QTest>

#include <cmath>

using namespace facetmill;
using namespace facetmill::test;

namespace {

constexpr double an_inch = 25.4;

Project new_project(const Vec3& size, LengthUnit unit) {
    Box3 box;
    box.add(Vec3::Zero());
    box.add(size);
    return default_project("part.stl", unit, box);
}

} // namespace

class TestUsualTools : public QObject {
    Q_OBJECT
private slots:
    void diameters_are_those_that_are_sold() {
        QCOMPARE(usual_diameter(9.9, LengthUnit::mm), 8.0);
        QCOMPARE(usual_diameter(10, LengthUnit::mm), 10.0);
        QCOMPARE(usual_diameter(700, LengthUnit::mm), 25.0);
        QCOMPARE(usual_diameter(0.3, LengthUnit::mm), 0.5);
        QCOMPARE(usual_diameter(0.24, LengthUnit::mm), 0.2); // for a part of 2 mm
        QCOMPARE(usual_diameter(0.09 * an_inch, LengthUnit::inch), an_inch / 16);
        QCOMPARE(usual_diameter(0.02 * an_inch, LengthUnit::inch), an_inch / 32);
    }

    /// A scan of 1 in began with a ball of 0.02 in, and was roughed with it for 43 minutes.
    void a_part_of_an_inch_begins_with_a_ball_that_a_workshop_has() {
        const Project p = new_project(Vec3(0.5, 1, 0.3) * an_inch, LengthUnit::inch);
        const Tool& ball = p.tools.front();
        QCOMPARE(ball.diameter, an_inch / 16);
        QCOMPARE(ball.name, std::string("Ball 0.0625"));
        QVERIFY(std::abs(p.operations.front()->common().tolerance - 0.0005 * an_inch) < 1e-12);
        const NewOperation rough = new_operation("rough", p);
        QVERIFY(rough.tool);
        QCOMPARE(rough.tool->diameter, an_inch / 8);
        QCOMPARE(rough.tool->corner_radius, 0.0);
        QVERIFY(rough.tool->shank_length >= ball.shank_length);
    }

    void roughing_is_twice_as_wide_as_far_as_spindles_go() {
        for (const auto& [ball, flat] : {std::pair(2.0, 4.0), {5.0, 10.0}, {12.0, 20.0}, {25.0, 25.0}}) {
            Project p = new_project(Vec3(100, 100, 50), LengthUnit::mm);
            p.tools = {listed_tool(7, ball, ball / 2)};
            const Tool tool = usual_roughing_tool(p);
            QCOMPARE(tool.diameter, flat);
            QCOMPARE(tool.number, 1L);
            QVERIFY(tool.flute_length >= tool.diameter && tool.shape_name() == "Flat end");
        }
    }

    void the_first_tool_follows_a_part_that_is_laid_down() {
        const Vec3 standing(10, 100, 100), lying(100, 100, 10);
        Project p = new_project(standing, LengthUnit::mm);
        QCOMPARE(p.tools.front().diameter, 1.0);
        follow_part_size(p, standing, lying);
        const Project as_new = new_project(lying, LengthUnit::mm);
        QCOMPARE(p.tools.front().name, std::string("Ball 12"));
        QCOMPARE(project_to_json(p), project_to_json(as_new));
    }

    void what_a_user_wrote_stays_as_it_is() {
        const Vec3 standing(10, 100, 100), lying(100, 100, 10);
        Project wider = new_project(standing, LengthUnit::mm);
        wider.tools.front().diameter = 1.2;
        wider.operations.front()->common().tolerance = 0.004;
        follow_part_size(wider, standing, lying);
        QCOMPARE(wider.tools.front().diameter, 1.2);
        QCOMPARE(wider.operations.front()->common().tolerance, 0.004);

        Project named = new_project(standing, LengthUnit::mm);
        named.tools.front().name = "Mine";
        named.operations.front()->common().tolerance = 0.004;
        follow_part_size(named, standing, lying);
        QCOMPARE(named.tools.front().name, std::string("Mine"));
        QCOMPARE(named.tools.front().diameter, 12.0);
        QCOMPARE(named.operations.front()->common().tolerance, 0.004);

        // Layers of roughing were made for the tools of then.
        Project rough = new_project(standing, LengthUnit::mm);
        NewOperation made = new_operation("rough", rough);
        made.operation->common().tool = 1;
        rough.operations.push_back(std::move(made.operation));
        follow_part_size(rough, standing, lying);
        QCOMPARE(rough.tools.front().diameter, 1.0);
    }
};

FACETMILL_TEST(TestUsualTools)
#include "test_usual_tools.moc"
