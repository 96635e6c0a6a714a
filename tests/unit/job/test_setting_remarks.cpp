// What the form says of settings before anything is planned: nothing of those that are right, a line under
// the field of those that planning would refuse.
#include "core/job/setting_remarks.h"

#include "core/job/new_operation.h"
#include "tests/support/test_runner.h"
#include "tests/unit/job/listed_tool.h"

#include <QTest>

using namespace facetmill;
using namespace facetmill::test;

namespace {

/// One operation of a kind, with a flat of 12, a ball of 6 and a ball of 3 in the list.
Project project_for(const char* kind) {
    Box3 box;
    box.add(Vec3::Zero());
    box.add(Vec3(80, 80, 20));
    Project p = default_project("part.stl", LengthUnit::mm, box);
    p.tools = {listed_tool(1, 12, 0), listed_tool(2, 6, 3), listed_tool(3, 3, 1.5)};
    p.operations.clear();
    p.operations.push_back(new_operation(kind, p).operation);
    p.machine = std::string(kind).starts_with("lathe") ? "lathe-mill" : "tarus-tpi-2000";
    return p;
}

/// The remarks as "key: message", one a line.
std::string said(const Project& p) {
    std::string text;
    for (const SettingRemark& r : setting_remarks(p, 0))
        text += r.key + ": " + r.message + "\n";
    return text;
}

} // namespace

class TestSettingRemarks : public QObject {
    Q_OBJECT
private slots:
    void what_a_new_operation_begins_with_is_right() {
        for (const OperationKind& kind : operation_kinds())
            QCOMPARE(said(project_for(kind.kind.c_str())), std::string());
    }

    void lengths_are_held_against_the_tool() {
        Project p = project_for("rough");
        p.operations[0]->set("stepover", 12.0);
        p.operations[0]->set("depth", p.tools[0].flute_length);
        p.operations[0]->set("tolerance", 6.0);
        QCOMPARE(said(p), std::string());
        p.operations[0]->set("stepover", 50.0);
        QCOMPARE(said(p),
                 std::string("stepover: Wider than the tool, whose diameter is 12 mm: walls would stay "
                             "between the passes\n"));
        p.operations[0]->set("stepover", std::string("auto"));
        p.operations[0]->set("depth", p.tools[0].flute_length + 1);
        QVERIFY(said(p).starts_with("depth: Longer than the tool's flutes"));
        p.operations[0]->set("depth", std::string("from_tolerance"));
        p.operations[0]->set("tolerance", 6.1);
        QCOMPARE(said(p), std::string("tolerance: More than the tool's radius, which is 6 mm\n"));
    }

    void a_tool_does_not_come_after_itself_or_a_smaller_one() {
        Project p = project_for("cleanup");
        const long own = p.operations[0]->common().tool;
        for (const Tool& t : p.tools) {
            p.operations[0]->set("previous_tool", t.number);
            const std::string text = said(p);
            if (t.number == own)
                QVERIFY2(text.starts_with("previous_tool: The operation's own tool"), text.c_str());
            else if (t.diameter > 6 || own == 3)
                QVERIFY2(text.empty(), text.c_str());
        }
        p.operations[0]->common().tool = 2;
        p.operations[0]->set("previous_tool", 3l);
        QCOMPARE(said(p),
                 std::string("previous_tool: No larger than the tool that is to come in after it: T3 "
                             "and T2\n"));
        p = project_for("global_local");
        p.operations[0]->common().tool = 1;
        p.operations[0]->set("rework_tool", 1l);
        QVERIFY(said(p).starts_with("rework_tool: The operation's own tool"));
        p.operations[0]->set("rework_tool", 3l);
        QCOMPARE(said(p), std::string());
        p.operations[0]->set("rework_tool", 0l);
        QCOMPARE(said(p), std::string());
    }

    void five_axes_need_a_machine_that_has_them() {
        for (const char* kind : {"finish5", "global_local"}) {
            Project p = project_for(kind);
            for (const char* machine : {"generic-3-axis", "generic-4-axis-a"}) {
                p.machine = machine;
                QVERIFY2(said(p).starts_with(": The operation inclines the tool"), kind);
            }
            for (const char* machine : {"trunnion-ac", "trunnion-bc", "head-b-table-c"}) {
                p.machine = machine;
                QCOMPARE(said(p), std::string());
            }
        }
        Project p = project_for("cleanup");
        p.machine = "generic-3-axis";
        QCOMPARE(said(p), std::string());
        p.operations[0]->set("tilt_limit", 0.3);
        QVERIFY(said(p).starts_with(": The operation inclines the tool"));
        p = project_for("lathe_finish");
        p.machine = "generic-3-axis";
        QVERIFY(said(p).starts_with(": The machine has no rotary axis"));
    }

    void what_is_not_there_is_told_elsewhere() {
        Project p = project_for("finish5");
        p.machine = "no such machine";
        p.operations[0]->common().tool = 77;
        QCOMPARE(said(p), std::string());
    }
};

FACETMILL_TEST(TestSettingRemarks)
#include "test_setting_remarks.moc"
