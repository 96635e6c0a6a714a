// What an operation begins with that is added to a project: where it stands, its tool, tolerance and depth.
#include "core/job/new_operation.h"

#include "core/strategy/five_axis/finish5.h"
#include "tests/support/error_code.h"
#include "tests/support/test_runner.h"
#include "tests/unit/job/listed_tool.h"

#include <QTest>

#include <algorithm>

using namespace facetmill;
using namespace facetmill::test;

namespace {

/// A block with one finish, of the first of these tools.
Project project_with(std::vector<Tool> tools, double size = 100) {
    Box3 box;
    box.add(Vec3::Zero());
    box.add(Vec3(size, size, 0.2 * size));
    Project p = default_project("part.stl", LengthUnit::mm, box);
    p.tools = std::move(tools);
    OperationCommon& finish = p.operations.front()->common();
    finish.tool = p.tools.front().number;
    finish.tolerance = 0.02;
    finish.feed = 900;
    finish.clearance = 7;
    return p;
}

void insert(Project& p, NewOperation made) {
    if (made.tool) p.tools.push_back(*made.tool);
    p.operations.insert(p.operations.begin() + std::ptrdiff_t(made.place), std::move(made.operation));
}

std::string kinds(const Project& p) {
    std::string text;
    for (const auto& o : p.operations)
        text += (text.empty() ? "" : " ") + std::string(o->kind());
    return text;
}

} // namespace

class TestNewOperation : public QObject {
    Q_OBJECT
private slots:
    void roughing_comes_first_with_a_flat_tool_and_values_of_its_own() {
        const Project p = project_with(
            {listed_tool(1, 6, 3), listed_tool(2, 10, 1), listed_tool(4, 12, 0), listed_tool(3, 16, 8)});
        const NewOperation made = new_operation("rough", p);
        const OperationCommon& c = made.operation->common();
        QCOMPARE(made.place, std::size_t(0));
        QVERIFY(!made.tool);
        QCOMPARE(c.tool, 4L);
        QCOMPARE(c.name, std::string("Rough"));
        QCOMPARE(c.tolerance, 0.5);
        QCOMPARE(c.allowance, 0.5);
        QCOMPARE(number_of(*made.operation, "depth"), 2.0); // of 12 / 4 the round number below
        QCOMPARE(c.feed, 900.0);
        QCOMPARE(c.clearance, 7.0);
    }

    void where_the_list_has_balls_alone_roughing_brings_a_flat() {
        Project p = project_with({listed_tool(1, 3, 1.5), listed_tool(2, 4, 2)});
        NewOperation made = new_operation("rough", p);
        QVERIFY(made.tool.has_value());
        QCOMPARE(made.tool->name, std::string("Flat 8"));
        QCOMPARE(made.tool->number, 3L);
        QCOMPARE(made.operation->common().tool, 3L);
        QCOMPARE(made.operation->common().tolerance, 0.5);
        QCOMPARE(number_of(*made.operation, "depth"), 2.0);
        insert(p, std::move(made));
        check_project(p);
        QVERIFY(!new_operation("rough", p).tool);
        // What turns a part cuts with whatever there is.
        QVERIFY(!new_operation("lathe_rough", project_with({listed_tool(1, 3, 1.5)})).tool);
    }

    void layers_are_no_deeper_than_flutes() {
        Project p = project_with({listed_tool(1, 12, 0)});
        p.tools.front().flute_length = 1;
        QCOMPARE(number_of(*new_operation("rough", p).operation, "depth"), 1.0);
    }

    void clean_up_comes_last_with_the_next_smaller_tool() {
        Project p = project_with(
            {listed_tool(1, 6, 3), listed_tool(2, 12, 0), listed_tool(3, 2, 1), listed_tool(5, 4, 2)});
        p.operations.front()->common().allowance = 0.3;
        const NewOperation made = new_operation("cleanup", p);
        QCOMPARE(made.place, std::size_t(1));
        QVERIFY(!made.tool);
        QCOMPARE(made.operation->common().tool, 5L);
        QCOMPARE(std::get<long>(made.operation->get("previous_tool")), 1L);
        QCOMPARE(made.operation->common().tolerance, 0.02);
        QCOMPARE(made.operation->common().allowance, 0.3);
    }

    void where_none_is_smaller_clean_up_brings_a_tool() {
        Project p = project_with({listed_tool(1, 6, 3), listed_tool(2, 12, 0)});
        NewOperation made = new_operation("cleanup", p);
        QVERIFY(made.tool.has_value());
        QCOMPARE(made.tool->number, 3L);
        QCOMPARE(made.tool->name, std::string("Ball 3"));
        QCOMPARE(made.tool->diameter, 3.0);
        QCOMPARE(made.tool->corner_radius, 1.5);
        QCOMPARE(made.operation->common().tool, 3L);
        insert(p, std::move(made));
        check_project(p);
    }

    /// As the flat is that roughing brings where the ball is as large as spindles hold.
    void a_flat_as_wide_as_the_ball_cleans_nothing_up() {
        const NewOperation made =
            new_operation("cleanup", project_with({listed_tool(1, 20, 10), listed_tool(2, 20, 0)}));
        QVERIFY(made.tool.has_value());
        QCOMPARE(made.tool->diameter, 10.0);
        // Into the corner of a floor it does come where one with round corners was.
        QCOMPARE(new_operation("cleanup", project_with({listed_tool(1, 20, 2), listed_tool(2, 20, 0)}))
                     .operation->common()
                     .tool,
                 2L);
    }

    /// A half that nobody sells is the next smaller one that somebody does, down to the smallest.
    void a_tool_that_clean_up_brings_is_sold() {
        const auto brought = [](double diameter) {
            return new_operation("cleanup", project_with({listed_tool(1, diameter, 0.5 * diameter)}))
                .tool->diameter;
        };
        QCOMPARE(brought(5), 2.0);
        QCOMPARE(brought(3), 1.5);
        QCOMPARE(brought(1.5), 0.5);
        QCOMPARE(brought(0.5), 0.25);
    }

    /// A tool that is known to fit, or the one that a smaller one comes after, wherever the operation comes
    /// from otherwise.
    void what_is_wished_comes_first() {
        Project p = project_with(
            {listed_tool(1, 6, 3), listed_tool(2, 12, 0), listed_tool(3, 4, 2), listed_tool(4, 1, 0.5)});
        const auto tools = [](const NewOperation& made) {
            return std::pair(made.operation->common().tool,
                             std::get<long>(made.operation->get("previous_tool")));
        };
        NewOperation flat = new_operation("cleanup", p, {2, {}});
        QVERIFY(tools(flat) == std::pair(2L, 1L));
        QVERIFY(!flat.tool);
        QCOMPARE(flat.operation->common().tolerance, 0.02);
        insert(p, std::move(flat));
        check_project(p);
        // Like the clean-up that is there already, but for the tool.
        p.operations.back()->common().tolerance = 0.03;
        NewOperation ball = new_operation("cleanup", p, {3, {}});
        QVERIFY(tools(ball) == std::pair(3L, 1L));
        QCOMPARE(ball.operation->common().tolerance, 0.03);
        insert(p, std::move(ball));
        NewOperation small = new_operation("cleanup", p, {{}, 3});
        QVERIFY(tools(small) == std::pair(4L, 3L));
        insert(p, std::move(small));
        const NewOperation smaller = new_operation("cleanup", p, {{}, 4});
        QVERIFY(tools(smaller) == std::pair(5L, 4L));
        QCOMPARE(smaller.tool->diameter, 0.5);
        QCOMPARE(new_operation("rough", p, {1, {}}).operation->common().tool, 1L);
        QCOMPARE(new_operation("finish3", p, {3, {}}).operation->common().tool, 3L);
        QCOMPARE(new_operation("pencil", p, {3, {}}).operation->common().tool, 3L);
        QCOMPARE(code_of([&] { new_operation("cleanup", p, {9, {}}); }), std::string("missing_reference"));
    }

    /// What is switched off has cut nothing.
    void clean_up_comes_after_a_finish_that_is_on() {
        Project p = project_with({listed_tool(1, 6, 3), listed_tool(2, 12, 6), listed_tool(3, 2, 1)});
        insert(p, new_operation("finish5", p));
        p.operations.front()->common().tool = 2;
        p.operations.back()->common().off = true;
        QCOMPARE(std::get<long>(new_operation("cleanup", p).operation->get("previous_tool")), 2L);
        p.operations.front()->common().off = true;
        QCOMPARE(std::get<long>(new_operation("cleanup", p).operation->get("previous_tool")), 1L);
    }

    /// Pencil goes over the valleys that the finishing tool itself leaves.
    void every_kind_can_be_added() {
        for (const OperationKind& kind : operation_kinds()) {
            Project p = project_with({listed_tool(2, 12, 0), listed_tool(1, 6, 3), listed_tool(5, 4, 2)});
            const NewOperation made = new_operation(kind.kind, p);
            QCOMPARE(std::string(made.operation->kind()), kind.kind);
            QVERIFY2(made.tool || made.operation->common().tool > 0, kind.kind.c_str());
        }
        Project p = project_with({listed_tool(2, 12, 0), listed_tool(1, 6, 3), listed_tool(5, 4, 2)});
        QCOMPARE(new_operation("pencil", p).operation->common().tool, p.operations.front()->common().tool);
        QCOMPARE(new_operation("pencil", p).place, std::size_t(1));
    }

    void machining_order_holds_whatever_is_added_first() {
        Project p = project_with({listed_tool(1, 6, 3), listed_tool(2, 12, 0)});
        for (const char* kind : {"cleanup", "finish5", "rough", "finish3"})
            insert(p, new_operation(kind, p));
        QCOMPARE(kinds(p), std::string("rough finish3 finish5 finish3 cleanup"));
        insert(p, new_operation("rough", p));
        QCOMPARE(kinds(p), std::string("rough rough finish3 finish5 finish3 cleanup"));
        // Moved by hand, roughing in the middle is followed by the next one.
        std::swap(p.operations[1], p.operations[3]);
        QCOMPARE(new_operation("rough", p).place, std::size_t(4));
        QCOMPARE(new_operation("cleanup", p).place, std::size_t(6));
    }

    void one_of_its_kind_is_what_it_is_like() {
        Project p = project_with({listed_tool(1, 6, 3), listed_tool(2, 12, 0)});
        insert(p, new_operation("rough", p));
        p.operations.front()->common().tolerance = 0.7;
        p.operations.front()->set("depth", 0.9);
        const NewOperation rough = new_operation("rough", p);
        QCOMPARE(rough.operation->common().tolerance, 0.7);
        QCOMPARE(number_of(*rough.operation, "depth"), 0.9);
        insert(p, new_operation("finish5", p));
        Operation& five = *p.operations.back();
        manual_posture_list.set(five, {ManualPosture{}});
        QCOMPARE(manual_posture_list.of(five).size(), std::size_t(1));
        QVERIFY(manual_posture_list.of(*new_operation("finish5", p).operation).empty());
    }

    void finishing_alone_takes_the_largest_ball() {
        Project p = project_with({listed_tool(1, 12, 0), listed_tool(2, 5, 2.5), listed_tool(3, 8, 4)});
        p.operations.clear();
        const NewOperation made = new_operation("finish3", p);
        QCOMPARE(made.operation->common().tool, 3L);
        QCOMPARE(made.operation->common().tolerance, 0.05); // of 8 / 100 the round number below
    }

    void numbers_are_round_in_inches() {
        Project p = project_with({listed_tool(1, 0.25 * 25.4, 0.125 * 25.4), listed_tool(2, 0.5 * 25.4, 0)});
        p.unit = LengthUnit::inch;
        const NewOperation rough = new_operation("rough", p);
        QVERIFY(std::abs(rough.operation->common().tolerance / 25.4 - 0.01) < 1e-12); // 0.5 mm is 0.0197 in
        QVERIFY(std::abs(number_of(*rough.operation, "depth") / 25.4 - 0.1) < 1e-12);
        const NewOperation clean = new_operation("cleanup", p);
        QCOMPARE(clean.tool->name, std::string("Ball 0.125"));
    }

    void lengths_and_feeds_of_all_kinds_are_round_in_inches() {
        Box3 box;
        box.add(Vec3::Zero());
        box.add(Vec3(91.37, 45.83, 37.91));
        const auto check = [](const Parameterized& values) {
            for (const ParameterInfo* info : values.parameters()) {
                if (info->quantity != Quantity::length && info->quantity != Quantity::feed) continue;
                const std::string shown = info->value_text(values.get(info->key), LengthUnit::inch);
                // Three numbers have three digits; 3/16 in has four.
                const auto digits = std::ranges::count_if(shown, [](char c) { return c >= '1' && c <= '9'; });
                QVERIFY2(digits <= 4, (info->key + ": " + shown).c_str());
            }
        };
        for (const bool turned : {false, true}) {
            Project p = turned ? default_turned_project("part.stl", LengthUnit::inch, box)
                               : default_project("part.stl", LengthUnit::inch, box);
            for (const auto& operation : p.operations)
                check(*operation);
            check(ParameterView<Tool>(p.tools.front(), tool_parameters()));
            check(ParameterView<StockSpec>(p.stock, stock_parameters()));
            for (const OperationKind& kind : operation_kinds())
                check(*new_operation(kind.kind, p).operation);
        }
        const auto made = new_operation("global_local", default_project("part.stl", LengthUnit::inch, box));
        QVERIFY(std::abs(number_of(*made.operation, "avoid_distance") / 25.4 - 0.04) < 1e-12);
        QVERIFY(std::abs(number_of(*made.operation, "rework_offset") / 25.4 - 0.08) < 1e-12);
        // In mm they are what a file without them means.
        const auto metric = new_operation("global_local", default_project("part.stl", LengthUnit::mm, box));
        QCOMPARE(number_of(*metric.operation, "rework_offset"), 2.0);
        QCOMPARE(default_project("part.stl", LengthUnit::mm, box).tools.front().shank_length, 38.0);
    }

    void every_kind_fits_every_new_project() {
        for (const double size : {0.5, 3.0, 40.0, 700.0, 20000.0})
            for (const LengthUnit unit : {LengthUnit::mm, LengthUnit::inch})
                for (const bool turned : {false, true})
                    for (const OperationKind& kind : operation_kinds()) {
                        Box3 box;
                        box.add(Vec3::Zero());
                        box.add(Vec3(2 * size, size, size));
                        Project p = turned ? default_turned_project("part.stl", unit, box)
                                           : default_project("part.stl", unit, box);
                        insert(p, new_operation(kind.kind, p));
                        for (std::size_t i = 0; i < p.operations.size(); ++i)
                            p.operations[i]->common().name = "Operation " + std::to_string(i);
                        const auto again = parse_project(project_to_json(p), "again");
                        QCOMPARE(kinds(again), kinds(p));
                    }
    }

    void an_empty_list_and_an_unknown_kind() {
        Project p = project_with({listed_tool(1, 6, 3)});
        p.operations.clear();
        p.tools.clear();
        for (const OperationKind& kind : operation_kinds()) {
            const NewOperation made = new_operation(kind.kind, p);
            QCOMPARE(made.place, std::size_t(0));
            QVERIFY(!made.tool);
        }
        QCOMPARE(code_of([&] { new_operation("drill", p); }), std::string("out_of_range"));
    }
};

FACETMILL_TEST(TestNewOperation)
#include "test_new_operation.moc"
