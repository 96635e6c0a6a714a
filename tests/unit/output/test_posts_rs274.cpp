// Posted programs in front of somebody else's interpreter: rs274 of LinuxCNC (Debian's linuxcnc-uspace).
#include "tests/support/rs274.h"
#include "tests/support/test_runner.h"
#include "tests/unit/output/posted_parts.h"

#include <QTest>

using namespace facetmill;
using namespace facetmill::test;

class TestPostsRs274 : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() {
        if (rs274_program().isEmpty())
            QSKIP(
                "SKIPPED: no rs274 on this machine (Debian: linuxcnc-uspace), posted programs were not shown "
                "to LinuxCNC's interpreter");
    }

    void programs_are_accepted_data() {
        QTest::addColumn<QString>("post");
        QTest::addColumn<QString>("machine");
        QTest::addColumn<bool>("leans");
        QTest::newRow("grbl") << "grbl"
                              << "generic-3-axis" << false;
        QTest::newRow("linuxcnc") << "linuxcnc"
                                  << "generic-3-axis" << false;
        for (const char* machine : {"trunnion-ac", "trunnion-bc", "head-b-table-c", "tarus-tpi-2000"})
            QTest::addRow("linuxcnc, %s", machine) << "linuxcnc" << machine << true;
        for (const char* machine : {"trunnion-ac", "trunnion-bc"})
            QTest::addRow("linuxcnc-tcp, %s", machine) << "linuxcnc-tcp" << machine << true;
    }
    /// Status 0, and every place of the program to half a digit of what the interpreter prints.
    void programs_are_accepted() {
        QFETCH(QString, post);
        QFETCH(QString, machine);
        QFETCH(bool, leans);
        std::vector<ClSection> sections = {leans ? leaning_section("One", 1) : upright_section("One (1)", 1)};
        if (post != "grbl") sections.push_back(upright_section("Two", 2, 5));
        const ClProgram program = joined_program(sections);
        const PostSetup setup = setup_for(program, machine.toStdString());
        const Post& control = find_post(post.toStdString());
        const Interpreted seen = interpret(post_program(program, control, setup, {}).text, program);
        QVERIFY2(seen.status == 0, seen.message.constData());
        QVERIFY2(all_places_seen(program, setup, control, seen), "a place is missing");
        if (leans && control.multi_axis == Post::MultiAxis::joints)
            QVERIFY(seen.places.size() > wanted_places(program, setup).size());
    }

    /// The interpreter reads what stands in brackets of its own: a name with one must not come through.
    void a_name_moves_nothing() {
        ClSection section = upright_section("a", 1);
        section.motions.motions.resize(4);
        const ClProgram plain = joined_program({section});
        const PostSetup setup = setup_for(plain, "generic-3-axis");
        const auto places = [&](const ClProgram& p) {
            const Interpreted seen = interpret(post_program(p, find_post("linuxcnc"), setup, {}).text, p);
            return seen.status == 0 ? seen.places.size() : 0;
        };
        section.operation_name = "(part bracket) G0 Z-50 (x)";
        section.tool_name = "a)\nG0 Z-40\n(";
        ClProgram hostile = joined_program({section});
        hostile.part_name = "%\nM2";
        QVERIFY(places(plain) > 0);
        QCOMPARE(places(hostile), places(plain));
    }
};

FACETMILL_TEST(TestPostsRs274)
#include "test_posts_rs274.moc"
