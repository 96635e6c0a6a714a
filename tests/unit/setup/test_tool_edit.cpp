// What moves together when a tool is edited.
#include "core/setup/tool_edit.h"
#include "tests/support/test_runner.h"

#include <QTest>

#include <set>

using namespace facetmill;
using namespace facetmill::test;

namespace {

Tool ball() {
    Tool t;
    t.diameter = t.shank_diameter = 6;
    t.corner_radius = 3;
    t.name = "Ball 6";
    return t;
}

} // namespace

class TestToolEdit : public QObject {
    Q_OBJECT
private slots:
    void a_ball_stays_a_ball() {
        ToolEdit edit(ball(), LengthUnit::mm);
        QVERIFY(edit.shape() == CutterShape::ball && edit.name_follows());
        edit.set("diameter", 2.0);
        QCOMPARE(edit.tool().corner_radius, 1.0);
        QCOMPARE(edit.tool().shank_diameter, 2.0);
        QCOMPARE(edit.tool().name, std::string("Ball 2"));
        check_tool(edit.tool());
        // By its radius as well; a smaller one makes it a bull nose.
        edit.set("corner_radius", 4.0);
        QCOMPARE(edit.tool().diameter, 8.0);
        QCOMPARE(edit.tool().shank_diameter, 8.0);
        edit.set("diameter", 8.0);
        edit.set("corner_radius", 1.0);
        QVERIFY(edit.shape() == CutterShape::bull);
        QCOMPARE(edit.tool().diameter, 8.0);
        QCOMPARE(edit.tool().name, std::string("Bull 8 R1"));
    }

    void its_name_can_be_in_another_language() {
        const ToolNameStyle german{
            [](const std::string& word) {
                return word == "Ball" ? "Kugel" : word == "Tapered ball" ? "Konisch mit Kugel" : word;
            },
            ","};
        QCOMPARE(usual_tool_name(ball(), LengthUnit::mm, german), std::string("Kugel 6"));
        ToolEdit edit(ball(), LengthUnit::mm, german); // an English name is the program's own as well
        QVERIFY(edit.name_follows());
        edit.set("diameter", 2.0);
        QCOMPARE(edit.tool().name, std::string("Kugel 2"));
        ToolEdit again(edit.tool(), LengthUnit::mm, german);
        QVERIFY(again.name_follows());
        again.set_shape(CutterShape::tapered_ball);
        QCOMPARE(again.tool().name, std::string("Konisch mit Kugel 2 5°"));
        // Sizes have the mark of the language; a name from before they had it follows as well.
        edit.set("diameter", 2.5);
        QCOMPARE(edit.tool().name, std::string("Kugel 2,5"));
        edit.set_shape(CutterShape::bull);
        edit.set("corner_radius", 0.75);
        QCOMPARE(edit.tool().name, std::string("Bull 2,5 R0,75"));
        edit.set_shape(CutterShape::tapered_ball);
        edit.set("taper_angle", radians(2.5));
        QCOMPARE(edit.tool().name, std::string("Konisch mit Kugel 2,5 2,5°"));
        Tool before = ball();
        before.diameter = 4.5;
        before.corner_radius = 2.25;
        before.name = "Kugel 4.5";
        QVERIFY(ToolEdit(before, LengthUnit::mm, german).name_follows());
        // To somebody else it is a name that was written.
        QVERIFY(!ToolEdit(edit.tool(), LengthUnit::mm).name_follows());
    }

    /// Typed digit by digit, 12 passes 1: the corner of a bull nose comes back.
    void a_number_on_its_way_leaves_no_trace() {
        Tool tool = ball();
        tool.corner_radius = 1;
        tool.name = "Bull 6 R1";
        ToolEdit edit(tool, LengthUnit::mm);
        edit.set("diameter", 1.0);
        QCOMPARE(edit.tool().corner_radius, 0.125);
        edit.set("diameter", 12.0);
        QCOMPARE(edit.tool().corner_radius, 1.0);
        QCOMPARE(edit.tool().shank_diameter, 12.0);
        QCOMPARE(edit.tool().name, std::string("Bull 12 R1"));
        // Through a shape of another kind, too.
        ToolEdit round(ball(), LengthUnit::mm);
        round.set("corner_radius", 1.0);
        round.set("corner_radius", 12.0);
        QVERIFY(round.shape() == CutterShape::ball);
        QCOMPARE(round.tool().diameter, 24.0);
    }

    void a_shank_of_its_own_stays() {
        Tool tool = ball();
        tool.shank_diameter = 8;
        ToolEdit edit(tool, LengthUnit::mm);
        edit.set("diameter", 2.0);
        QCOMPARE(edit.tool().shank_diameter, 8.0);
    }

    void a_name_that_somebody_wrote_stays() {
        ToolEdit edit(ball(), LengthUnit::mm);
        edit.set("name", std::string("Old faithful"));
        edit.set("diameter", 2.0);
        edit.set_shape(CutterShape::flat);
        QCOMPARE(edit.tool().name, std::string("Old faithful"));
        edit.set("name", std::string());
        edit.set("diameter", 3.0);
        QCOMPARE(edit.tool().name, std::string("Flat 3"));
        Tool other = ball();
        other.name = "Ball 4";
        QVERIFY(!ToolEdit(other, LengthUnit::mm).name_follows());
        other.name = "Tool 2";
        QVERIFY(ToolEdit(other, LengthUnit::mm).name_follows());
        QVERIFY(!ToolEdit(ball(), LengthUnit::inch).name_follows());
    }

    /// Every shape makes a cutter at every size, is what it says, and has a name of its own.
    void shapes_are_what_they_say() {
        std::set<std::string> names;
        for (const CutterShape shape :
             {CutterShape::ball, CutterShape::flat, CutterShape::bull, CutterShape::tapered_flat,
              CutterShape::tapered_ball, CutterShape::drill_point, CutterShape::cone}) {
            ToolEdit edit(ball(), LengthUnit::mm);
            edit.set_shape(shape);
            QVERIFY2(shape_of(edit.tool()) == shape, edit.tool().shape_name().c_str());
            names.insert(edit.tool().name);
            for (const double diameter : {0.1, 1.0, 3.0, 25.0, 200.0}) {
                edit.set("diameter", diameter);
                check_tool(edit.tool());
                QVERIFY2(shape_of(edit.tool()) == shape, edit.tool().shape_name().c_str());
            }
        }
        QCOMPARE(names.size(), std::size_t(7));
        ToolEdit special(ball(), LengthUnit::mm);
        special.set("bottom_angle", 0.3);
        QVERIFY(special.shape() == CutterShape::special);
        const Tool before = special.tool();
        special.set_shape(CutterShape::special);
        QCOMPARE(special.tool().corner_radius, before.corner_radius);
    }

    /// What makes no cutter keeps shape and name, and what comes next goes on from there.
    void nonsense_is_no_shape() {
        ToolEdit edit(ball(), LengthUnit::mm);
        edit.set_shape(CutterShape::flat);
        edit.set("corner_radius", 7.0);
        QVERIFY(edit.shape() == CutterShape::flat);
        QCOMPARE(edit.tool().name, std::string("Flat 6"));
        edit.set("corner_radius", 0.0);
        check_tool(edit.tool());
        QVERIFY_THROWS_EXCEPTION(Error, edit.set("diameter", -1.0));
        QCOMPARE(edit.tool().diameter, 6.0);
    }
};

FACETMILL_TEST(TestToolEdit)
#include "test_tool_edit.moc"
