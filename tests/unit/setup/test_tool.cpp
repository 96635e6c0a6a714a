// Tools: the cutter they make, their names, and what is refused.
#include "core/setup/tool.h"
#include "tests/support/test_runner.h"

#include <QTest>

#include <set>

using namespace facetmill;

namespace {

Tool tool(double diameter, double corner_radius, double bottom_deg = 0, double taper_deg = 0,
          double flute = 20) {
    Tool t;
    t.diameter = diameter;
    t.corner_radius = corner_radius;
    t.bottom_angle = radians(bottom_deg);
    t.taper_angle = radians(taper_deg);
    t.flute_length = flute;
    return t;
}

std::string refused_at(const Tool& t) {
    try {
        check_tool(t);
    } catch (const Error& e) {
        return e.code() == ErrorCode::out_of_range ? e.where() : std::string(code_name(e.code()));
    }
    return "";
}

} // namespace

class TestTool : public QObject {
    Q_OBJECT
private slots:
    void names() {
        QCOMPARE(tool(6, 0).shape_name(), "Flat end");
        QCOMPARE(tool(6, 3).shape_name(), "Ball end");
        QCOMPARE(tool(6, 1).shape_name(), "Bull nose");
        QCOMPARE(tool(6, 0, 0, 5).shape_name(), "Tapered flat");
        QCOMPARE(tool(6, 1, 0, 5).shape_name(), "Tapered bull nose");
        QCOMPARE(tool(6, 1, 10).shape_name(), "Cone-bottom bull nose");
        QCOMPARE(tool(6, 1, 10, 5).shape_name(), "Tapered cone-bottom bull nose");
        QCOMPARE(tool(6, 0, 60, 0, 3 * std::tan(radians(60))).shape_name(), "Cone");
        QCOMPARE(tool(6, 0, 31, 0, 20).shape_name(), "Drill point");
        QCOMPARE(tool(6, 0, 31, 5, 20).shape_name(), "Tapered drill point");
        QCOMPARE(tool(6, 0.5, 0, -10, 5).shape_name(), "Dovetail");
        const double d = AptCutter::tapered_ball(2, radians(5), 20).d;
        QCOMPARE(tool(d, 2, 0, 5).shape_name(), "Tapered ball");
        QCOMPARE(tool(AptCutter::tapered_ball(2, radians(-10), 5).d, 2, 0, -10, 5).shape_name(), "Lollipop");
        QCOMPARE(tool(6, 4).shape_name(), "Invalid");
    }

    void cutter_has_the_tools_values() {
        const AptCutter c = tool(10, 1, 5, 3, 25).cutter();
        QCOMPARE(c.d, 10.0);
        QCOMPARE(c.r, 1.0);
        QCOMPARE(c.alpha, radians(5));
        QCOMPARE(c.beta, radians(3));
        QCOMPARE(c.h, 25.0);
        QVERIFY(c == AptCutter::from_shape(10, 1, radians(5), radians(3), 25));
    }

    void refused_values_name_their_key() {
        QCOMPARE(refused_at(Tool{}), "");
        QCOMPARE(refused_at(tool(0, 0)), "diameter");
        QCOMPARE(refused_at(tool(-6, 0)), "diameter");
        QCOMPARE(refused_at(tool(std::nan(""), 0)), "diameter");
        QCOMPARE(refused_at(tool(1e9, 0)), "diameter");
        QCOMPARE(refused_at(tool(6, -1)), "corner_radius");
        QCOMPARE(refused_at(tool(6, 3.5)), "corner_radius");
        QCOMPARE(refused_at(tool(6, 0, 95)), "bottom_angle");
        QCOMPARE(refused_at(tool(6, 0, 60, 40)), "taper_angle");
        QCOMPARE(refused_at(tool(6, 0, 0, -45, 20)), "flute_length");
        QCOMPARE(refused_at(tool(6, 0, 0, 0, 0)), "flute_length");
        Tool t;
        t.number = 0;
        QCOMPARE(refused_at(t), "number");
        t = {};
        t.shank_diameter = 0;
        QCOMPARE(refused_at(t), "shank_diameter");
        t = {};
        t.shank_length = -1;
        QCOMPARE(refused_at(t), "shank_length");
        t = {};
        t.holder = {{40, 30}, {50, -1}};
        QCOMPARE(refused_at(t), "holder[1].length");
        t.holder = {{40, 30}, {infinity, 1}};
        QCOMPARE(refused_at(t), "holder[1].diameter");
        t.holder = {{5, 30}}; // the shank has 6
        QCOMPARE(refused_at(t), "holder[0].diameter");
        t.holder = {{40, 30}, {5, 10}};
        QCOMPARE(refused_at(t), "");
        // The remedy says what fits.
        try {
            check_tool(tool(6, 3.5));
            QFAIL("accepted");
        } catch (const Error& e) {
            QVERIFY2(e.remedy().find("3 mm") != std::string::npos, e.what());
        }
    }

    void every_parameter_is_described() {
        Tool t;
        ParameterView<Tool> view(t, tool_parameters());
        std::set<std::string> keys;
        for (const ParameterInfo* info : view.parameters()) {
            QVERIFY(keys.insert(info->key).second);
            QVERIFY(!info->label.empty() && !info->help.empty());
            info->check(view.get(info->key)); // the default is in range
        }
        QVERIFY((keys
                 == std::set<std::string>{"number", "name", "diameter", "corner_radius", "bottom_angle",
                                          "taper_angle", "flute_length", "shank_diameter", "shank_length",
                                          "holder", "flutes", "cutting"}));
        view.set("diameter", 8.0);
        QCOMPARE(t.diameter, 8.0);
    }
};

FACETMILL_TEST(TestTool)
#include "test_tool.moc"
