// Templates: what of a setup another part takes over, and what is said of what does not fit it.
#include "core/job/job_template.h"
#include "core/setup/tool_edit.h"
#include "core/strategy/lathe/lathe.h"
#include "tests/support/error_code.h"
#include "tests/support/test_runner.h"
#include "tests/unit/job/listed_tool.h"

#include <QTest>

#include <algorithm>

using namespace facetmill;
using namespace facetmill::test;

namespace {

Box3 box_of(double x, double y, double z) {
    Box3 box;
    box.add(Vec3::Zero());
    box.add(Vec3(x, y, z));
    return box;
}

/// Rough and finish with tools 4 and 7, on a machine and a stock of their own.
Project relief() {
    Project p = default_project("relief.stl", LengthUnit::mm, box_of(80, 60, 12));
    p.tools = {listed_tool(4, 8, 0), listed_tool(7, 3, 1.5), listed_tool(9, 1, 0)};
    p.machine = "trunnion-ac";
    p.programs.post = "haas";
    p.stock.margin = {3, 3, 1};
    p.limits.uncut_limit = 0.05;
    p.operations.clear();
    p.operations.push_back(make_operation("rough"));
    p.operations.push_back(make_operation("finish3"));
    for (const auto& [i, tool] : {std::pair(0, 4L), {1, 7L}}) {
        p.operations[std::size_t(i)]->common().name = i == 0 ? "Rough" : "Fine";
        p.operations[std::size_t(i)]->common().tool = tool;
        p.operations[std::size_t(i)]->common().feed = 1234 + i;
    }
    return p;
}

Project other_part() {
    return default_project("other.stl", LengthUnit::inch, box_of(200, 150, 40));
}

bool says(const AppliedTemplate& applied, const std::string& what) {
    return std::any_of(applied.remarks.begin(), applied.remarks.end(),
                       [&](const std::string& r) { return r.find(what) != std::string::npos; });
}

std::string all_said(const AppliedTemplate& applied) {
    std::string all;
    for (const std::string& r : applied.remarks)
        all += r + "\n";
    return all;
}

} // namespace

class TestJobTemplate : public QObject {
    Q_OBJECT
private slots:
    void another_part_takes_operations_tools_and_settings_over() {
        Project from = relief(), to = other_part();
        from.programs.zero = {37, 12, 8};
        from.programs.wcs = "G57";
        from.programs.number = 40;
        to.programs.zero_from = ProgramSpec::ZeroFrom::stock;
        to.programs.zero = {1, 2, 3};
        to.programs.number = 7;
        const std::string text = template_text(from);
        QCOMPARE(template_summary(text, "t"), std::string("2 operations, 2 tools"));
        QVERIFY(text.find("relief") == std::string::npos);
        const AppliedTemplate applied = apply_template(text, "t", to);
        QVERIFY2(applied.remarks.empty(), all_said(applied).c_str());
        const Project& p = applied.project;
        QCOMPARE(p.part.file, to.part.file);
        QVERIFY(p.unit == LengthUnit::inch);
        QCOMPARE(p.machine, from.machine);
        QCOMPARE(p.programs.post, from.programs.post);
        // Where the part is clamped, and what its programs are called, is its own.
        QVERIFY(p.programs.zero_from == to.programs.zero_from && p.programs.zero == to.programs.zero);
        QVERIFY(p.programs.wcs == to.programs.wcs && p.programs.number == 7);
        QCOMPARE(p.limits, from.limits);
        for (std::size_t k = 0; k < 3; ++k)
            QVERIFY(std::abs(p.stock.margin[k] - from.stock.margin[k]) < 1e-12);
        QCOMPARE(p.operations.size(), std::size_t(2)); // in place of the finish there was
        QCOMPARE(p.operations[1]->common().name, std::string("Fine"));
        QCOMPARE(p.operations[1]->common().feed, 1235.0);
        // The tool of the finish that is gone is gone with it.
        QCOMPARE(p.tools.size(), std::size_t(2));
        QCOMPARE(p.operations[0]->common().tool, 4L);
        QVERIFY(find_tool(p.tools, 4)->diameter == 8 && find_tool(p.tools, 7)->diameter == 3);
        check_project(p);
        QCOMPARE(project_to_json(parse_project(project_to_json(p), "p")), project_to_json(p));
    }

    void tools_that_others_use_keep_their_numbers() {
        Project to = other_part();
        to.tools = {listed_tool(4, 20, 0)};
        to.operations.front()->common().tool = 4;
        add_setup_after(to);
        const AppliedTemplate applied = apply_template(template_text(relief()), "t", to);
        const Project& p = applied.project;
        QCOMPARE(find_tool(p.tools, 4)->diameter, 20.0);
        const long rough = p.operations[0]->common().tool;
        QVERIFY(rough != 4 && find_tool(p.tools, rough)->diameter == 8);
        check_project(p);
    }

    void boundaries_of_any_part_come_along_and_others_are_missed() {
        Project from = relief();
        Boundary flat, drawn;
        flat.name = "Flat";
        flat.kind = Boundary::Kind::slope;
        flat.slope = {0, radians(12)};
        drawn.name = "Rim";
        drawn.kind = Boundary::Kind::curve;
        drawn.curve = {{{0, 0, 0}}, {{10, 0, 0}}, {{0, 10, 0}}};
        from.boundaries = {flat, drawn};
        from.operations[0]->common().boundary = "Rim";
        from.operations[1]->common().boundary = "Flat";
        AppliedTemplate applied = apply_template(template_text(from), "t", other_part());
        QCOMPARE(applied.project.boundaries.size(), std::size_t(1));
        QVERIFY(std::abs(applied.project.boundaries[0].slope[1] - radians(12)) < 1e-12);
        QCOMPARE(applied.project.operations[1]->common().boundary, std::string("Flat"));
        QVERIFY(applied.project.operations[0]->common().boundary.empty());
        QVERIFY2(says(applied, "'Rim'"), all_said(applied).c_str());
        // The other part has a rim of its own.
        Project to = other_part();
        drawn.curve = {{{0, 0, 0}}, {{50, 0, 0}}, {{0, 50, 0}}};
        to.boundaries = {drawn};
        applied = apply_template(template_text(from), "t", to);
        QVERIFY2(applied.remarks.empty(), all_said(applied).c_str());
        QCOMPARE(applied.project.operations[0]->common().boundary, std::string("Rim"));
        QCOMPARE(applied.project.boundaries[0].curve[1].at[0], 50.0);
    }

    void places_of_a_part_stay_with_it() {
        Project from = relief();
        from.operations.push_back(make_operation("lathe_finish"));
        Operation& turned = *from.operations.back();
        turned.common().name = "Turn";
        turned.common().tool = 7;
        turned.set("axis", std::string("points"));
        turned.set("axis_from", std::array<double, 3>{1, 2, 3});
        from.stock.kind = StockSpec::Kind::mesh;
        from.stock.file = "block.stl";
        const AppliedTemplate applied = apply_template(template_text(from), "t", other_part());
        const Operation& kept = *applied.project.operations.back();
        QVERIFY(kept.get("axis") == kept.parameter("axis").default_value);
        QVERIFY(kept.get("axis_from") == kept.parameter("axis_from").default_value);
        QVERIFY(applied.project.stock.kind == StockSpec::Kind::box);
    }

    void what_does_not_fit_is_said() {
        Project from = relief();
        from.machine = "generic-3-axis";
        from.programs.post.clear();
        from.operations.push_back(make_operation("finish5"));
        from.operations.back()->common().name = "Inclined";
        from.operations.back()->common().tool = 7;
        const AppliedTemplate applied = apply_template(template_text(from), "t", other_part());
        QVERIFY2(says(applied, "'Inclined'") && says(applied, "five axes"), all_said(applied).c_str());
    }

    void damaged_templates_are_errors_that_name_them() {
        const std::string text = template_text(relief());
        try {
            apply_template(text.substr(0, text.size() / 2), "wood.fmtemplate", other_part());
            QFAIL("half a template was taken");
        } catch (const Error& e) {
            QVERIFY2(e.where().find("wood.fmtemplate") != std::string::npos, e.what());
        }
        QCOMPARE(code_of([] { template_summary("{}", "t"); }), std::string("missing_key"));
    }

private:
    /// A second setup with a finish by the first one's tool.
    static void add_setup_after(Project& p) {
        std::vector<Setup> setups = take_setups(p);
        setups.push_back(setups.front());
        setups.back().name = "Setup 2";
        setups.back().operations.front()->common().name = "Finish below";
        put_setups(p, std::move(setups), 0);
    }
};

FACETMILL_TEST(TestJobTemplate)
#include "test_job_template.moc"
