// Operations from one project to another: units, tools with other numbers, boundaries and places that stay.
#include "core/job/copied_operations.h"
#include "tests/support/error_code.h"
#include "tests/support/test_runner.h"

#include <QTest>

#include <cmath>

using namespace facetmill;

namespace {

Tool tool(long number, const char* name, double diameter) {
    Tool t;
    t.number = number;
    t.name = name;
    t.diameter = t.shank_diameter = diameter;
    return t;
}

/// A finish by tool 1 and a clean-up by tool 2 after it.
Project from() {
    Project p;
    p.unit = LengthUnit::inch;
    p.path = "/shop/a.facetmill";
    p.part.file = "a.stl";
    p.tools = {tool(1, "Wide", 12), tool(2, "Narrow", 3), tool(7, "Idle", 5)};
    for (const char* kind : {"finish3", "cleanup"}) {
        p.operations.push_back(make_operation(kind));
        p.operations.back()->common().name = kind;
        p.operations.back()->common().tolerance = 0.0254;
    }
    p.operations[1]->common().tool = 2;
    p.operations[1]->set("previous_tool", 1L);
    return p;
}

Project to() {
    Project p;
    p.path = "/shop/b.facetmill";
    p.part.file = "b.stl";
    p.tools = {tool(1, "Narrow", 3), tool(2, "Another", 8)};
    p.operations.push_back(make_operation("finish3"));
    p.operations.back()->common().name = "cleanup";
    return p;
}

} // namespace

class TestCopiedOperations : public QObject {
    Q_OBJECT
private slots:
    /// Numbers that cross: the narrow tool is 1 there, and the wide one gets a free number.
    void tools_go_along() {
        const Project source = from(), there = to();
        const std::string text = copied_operation(source, 1);
        QVERIFY(may_be_operations(text));
        QVERIFY(text.find("Idle") == std::string::npos);
        const PastedOperations pasted = pasted_operations(text, there);
        QCOMPARE(pasted.operations.size(), std::size_t(1));
        const Operation& made = *pasted.operations[0];
        QCOMPARE(made.common().name, std::string("cleanup 2"));
        QCOMPARE(made.common().tool, 1L);
        QCOMPARE(std::get<long>(made.get("previous_tool")), 3L);
        QCOMPARE(pasted.tools.size(), std::size_t(1));
        QCOMPARE(pasted.tools[0].number, 3L);
        QCOMPARE(pasted.tools[0].name, std::string("Wide"));
        QVERIFY(std::abs(pasted.tools[0].diameter - 12) < 1e-12);
        QVERIFY(std::abs(made.common().tolerance - 0.0254) < 1e-12);
        QVERIFY(pasted.remarks.empty());
    }

    void into_the_same_project_nothing_is_added() {
        const Project source = from();
        const PastedOperations pasted = pasted_operations(copied_operation(source, 0), source);
        QVERIFY(pasted.tools.empty() && pasted.remarks.empty());
        QCOMPARE(pasted.operations[0]->common().name, std::string("finish3 2"));
        QCOMPARE(pasted.operations[0]->common().tool, 1L);
    }

    void boundaries_by_their_names() {
        Project source = from(), there = to();
        Boundary steep;
        steep.name = "Steep";
        steep.kind = Boundary::Kind::slope;
        source.boundaries.push_back(steep);
        source.operations[0]->common().boundary = "Steep";
        const std::string text = copied_operation(source, 0);
        const PastedOperations lost = pasted_operations(text, there);
        QVERIFY(lost.operations[0]->common().boundary.empty());
        QCOMPARE(lost.remarks.size(), std::size_t(1));
        QVERIFY(lost.remarks[0].find("'Steep'") != std::string::npos);
        there.boundaries.push_back(steep);
        const PastedOperations kept = pasted_operations(text, there);
        QCOMPARE(kept.operations[0]->common().boundary, std::string("Steep"));
        QVERIFY(kept.remarks.empty());
    }

    void other_texts_are_refused() {
        QVERIFY(!may_be_operations("G0 X1"));
        QVERIFY(!may_be_operations("{}"));
        const Project there = to();
        std::string text = copied_operation(from(), 0);
        text.replace(text.find("\"feed\""), 6, "\"fead\"");
        try {
            pasted_operations(text, there);
            QFAIL("taken");
        } catch (const Error& e) {
            QVERIFY2(std::string(e.what()).find("clipboard: operations[0].fead") == 0, e.what());
        }
    }
};

FACETMILL_TEST(TestCopiedOperations)
#include "test_copied_operations.moc"
