// Lines of programs: names and comments add nothing to them, words that are lost are missed, and what a post
// says itself is read back.
#include "tests/support/error_code.h"
#include "tests/support/test_runner.h"
#include "tests/unit/output/posted_parts.h"

#include <QTest>

using namespace facetmill;
using namespace facetmill::test;

class TestNcLines : public QObject {
    Q_OBJECT
private slots:
    /// No name becomes a word: the program without its comments is the same.
    void hostile_names() {
        std::mt19937_64 rng(4);
        const std::vector<std::string> seeds = {"(part bracket) G0 Z-50 (x)",
                                                "\nG0 Z-50\n",
                                                "%\n%",
                                                ";G1 X1",
                                                "$H",
                                                "O100 sub\nO100 endsub",
                                                "GOTO 10",
                                                "[1+2]#5=3",
                                                "\xC3\x84nd\xE2\x80\xA8\xE2\x80\xAE",
                                                "M30",
                                                ")",
                                                "(",
                                                std::string(10000, ')'),
                                                std::string("a\0b", 3),
                                                "MSG, DEBUG,",
                                                "\r\nM3 S9999"};
        const auto name = [&] {
            std::string text;
            for (int k = int(rng() % 4); k >= 0; --k)
                text += seeds[rng() % seeds.size()];
            for (int k = int(rng() % 20); k > 0; --k)
                text += char(rng() % 256);
            return text;
        };
        const auto lines_of = [](const std::string& text) {
            return std::count(text.begin(), text.end(), '\n');
        };
        for (const Post& control : posts()) {
            ClSection section = upright_section("a", 1);
            section.motions.motions.resize(4);
            ClProgram plain = joined_program({section});
            const PostSetup setup = setup_for(plain, "generic-3-axis");
            const NcSetup read = reading(plain, setup);
            const PostedProgram wanted = post_program(plain, control, setup, {});
            const auto lines = lines_of(wanted.text);
            const NcProgram expected = read_nc(wanted.text, "p", control, read, {});
            for (int i = 0; i < 1000; ++i) {
                section.operation_name = name();
                section.tool_name = name();
                ClProgram program = joined_program({section});
                program.part_name = name();
                const PostedProgram posted = post_program(program, control, setup, {});
                QCOMPARE(lines_of(posted.text), lines);
                const NcProgram back = read_nc(posted.text, "p", control, read, {});
                QCOMPARE(back.blocks, expected.blocks);
                QVERIFY(std::all_of(posted.text.begin(), posted.text.end(), [](unsigned char c) {
                    return c == '\n' || c == '\r' || (c >= 32 && c < 127);
                }));
            }
        }
    }

    void words_that_are_lost_data() {
        QTest::addColumn<QString>("post");
        QTest::addColumn<std::string>("from");
        QTest::addColumn<std::string>("to");
        QTest::addColumn<std::string>("says");
        const auto row = [](const char* post, const char* from, const char* to, const char* says) {
            QTest::addRow("%s: %s", post, from)
                << post << std::string(from) << std::string(to) << std::string(says);
        };
        row("heidenhain", " L X", " X", "a rapid without a motion");
        row("heidenhain", "L Z+0 R0", "Z+0 R0", "a rapid without a motion");
        row("heidenhain", "CALL 1 Z", "Z", "no number");
        row("heidenhain", "L A", "LN A", "LN");
        row("heidenhain-vectors", "M128", "M129", "nothing leads the tip");
        row("heidenhain-vectors", "LN X", "LX X", "LX");
        row("marlin", ";tool 1", "; tool", "no tool");
        row("marlin", ";tool 1", ";tool 9", "no tool 9");
        row("marlin", "M400", "M30", "M30");
        // The control forgets where the part is.
        row("siemens", "TRAORI\r\nN190 G54", "TRAORI\r\nN190 G17", "no work coordinate system is chosen");
        // The same without a sign of the machine's own, a height of the part.
        row("linuxcnc", "G53 G0 Z0", "G0 Z0", "no tool is in the spindle");
        row("siemens", "G0 SUPA Z0", "G0 Z0", "no tool is in the spindle");
        row("heidenhain", " FMAX M91", " FMAX", "no tool is in the spindle");
        // By way of a height of the part.
        row("fanuc", "G91 G28 Z0.", "G28 Z0.", "on its way home");
        row("linuxcnc", "S8000 M3", "M3", "no speed of the spindle");
        row("siemens", "S8000 M3", "M3", "no speed of the spindle");
        row("heidenhain", " S8000", "", "no speed of the spindle");
        row("marlin", "M3 S8000", "M3", "no speed of the spindle");
        // What stands behind an end of the tape is never run.
        row("linuxcnc", "G43 H1", "%\nG43 H1", "the tape ends here");
        row("linuxcnc", "\nG54", "\n%\nG54", "the tape ends here");
        // Hundreds of micrometres.
        row("fanuc", "F1200.", "F1200", "no decimal point");
        row("fanuc", "Z30.", "Z30", "no decimal point");
        row("haas", "X25. ", "X25 ", "no decimal point");
        // One axis after the other, and not along the line.
        row("haas", "G1 Z", "G0 Z", "do not arrive together");
        row("fanuc", "G1 Z", "G0 Z", "do not arrive together");
        row("fanuc-vectors", "G1 Z", "G0 Z", "do not arrive together");
        // A point: the table would turn for days.
        row("linuxcnc", "G53 G0 Z0\nM5\nM9\nM2", "G93 G1 C60146875 F1\nG53 G0 Z0\nM5\nM9\nM2",
            "turns in one block");
    }
    void words_that_are_lost() {
        QFETCH(QString, post);
        QFETCH(std::string, from);
        QFETCH(std::string, to);
        QFETCH(std::string, says);
        const Post& control = find_post(post.toStdString());
        const bool leans = control.multi_axis != Post::MultiAxis::none;
        const ClProgram program =
            joined_program({leans ? leaning_section("One", 1) : upright_section("One", 1)});
        const PostSetup setup = setup_for(program, leans ? "trunnion-ac" : "generic-3-axis");
        const std::string text = changed_text(post_program(program, control, setup, {}).text, from, to);
        std::string message;
        QVERIFY(code_of([&] { read_nc(text, "p", control, reading(program, setup), {}); }, &message)
                != "none");
        QVERIFY2(message.find("p:") == 0 && message.find(says) != std::string::npos, message.c_str());
    }

    /// A line of a post that nobody could read back is told before there is a program.
    void lines_that_would_not_be_read() {
        const ClProgram program = joined_program({upright_section("One", 1)});
        const PostSetup setup = setup_for(program, "generic-3-axis");
        for (const char* line : {"G61.1", "{coolant} #1=2", "X"}) {
            const Post own =
                parse_post(linuxcnc_with("\"{coolant}\"", '"' + std::string(line) + '"'), "own.json");
            std::string message;
            QCOMPARE(code_of([&] { post_program(program, own, setup, {}); }, &message),
                     std::string("syntax"));
            QVERIFY2(message.find("the line '") != std::string::npos, message.c_str());
        }
    }

    void comments_of_people_are_read_over_data() {
        QTest::addColumn<QString>("post");
        QTest::addColumn<bool>("reads");
        for (const Post& p : posts())
            QTest::addRow("%s", p.name.c_str()) << QString::fromStdString(p.name) << p.reads_comment(";");
        QCOMPARE(find_post("linuxcnc").comment_also, std::string(";"));
        QCOMPARE(find_post("fanuc").comment_also, std::string());
    }
    /// Somebody notes down what a line does, behind it and on lines of its own.
    void comments_of_people_are_read_over() {
        QFETCH(QString, post);
        QFETCH(bool, reads);
        const Post& control = find_post(post.toStdString());
        const ClProgram program = joined_program({upright_section("One", 1)});
        const PostSetup setup = setup_for(program, "generic-3-axis");
        const PostedProgram posted = post_program(program, control, setup, {});
        const auto with = [&](const std::string& comment) {
            // Behind the last block that moves, and below it.
            const std::size_t at = posted.text.rfind(control.line_end, posted.text.find("M30") - 3);
            return posted.text.substr(0, at) + comment + control.line_end + comment + posted.text.substr(at);
        };
        for (const char* comment : {" ; G1 Z-50 (x", " ;G0 X1 (G0 X1) Z-9", ";;"}) {
            std::string message;
            NcProgram read;
            const std::string code = code_of(
                [&] { read = read_nc(with(comment), "p", control, reading(program, setup), {}); }, &message);
            QVERIFY2((code == "none") == reads, message.c_str());
            if (reads) QCOMPARE(read.blocks, posted.blocks);
        }
        for (const char* comment : {" (G1 Z-50)", "(;G1)"})
            QCOMPARE(code_of([&] { read_nc(with(comment), "p", control, reading(program, setup), {}); })
                         == "none",
                     control.reads_comment("("));
    }

    /// A lathe-mill whose control calls the turning part C.
    void an_axis_is_called_as_the_control_calls_it() {
        ClSection section = plain_section("Turn", 1, true);
        section.motions.turning = TurningAxis{Vec3::Zero(), Vec3::UnitX()};
        const auto place = [](MotionKind kind, double turned, double out, ClSection& to) {
            const Vec3 axis(0, -std::sin(turned), std::cos(turned));
            add_motion(to, kind, out * axis + Vec3(3 * turned, 0, 0), axis);
        };
        place(MotionKind::rapid, 0, 40, section);
        place(MotionKind::approach, 0, 12, section);
        for (double turned = 0; turned < 9; turned += 0.1)
            place(MotionKind::cut, turned, 12 + 0.2 * std::sin(3 * turned), section);
        const ClProgram program = joined_program({section});
        const PostSetup setup = setup_for(program, "lathe-mill");
        NcSetup read = reading(program, setup);
        read.turning = section.motions.turning;
        const Post own =
            parse_post(linuxcnc_with(R"("a": "A", "b": "B", "c": "C")", R"("a": "C")"), "own.json");
        const PostedProgram posted = post_program(program, own, setup, {}),
                            usual = post_program(program, find_post("linuxcnc"), setup, {});
        std::string renamed = usual.text;
        std::size_t words = 0;
        for (std::size_t at = 0; (at = renamed.find(" A", at)) != std::string::npos; ++words)
            renamed[at + 1] = 'C';
        QVERIFY(words > 90);
        QCOMPARE(posted.text, renamed);
        const NcProgram back = read_nc(posted.text, "p", own, read, {});
        QCOMPARE(back.blocks, posted.blocks);
        QVERIFY(std::abs(back.seconds - posted.seconds) < 1e-3 * posted.seconds);
        std::string message;
        code_of([&] { read_nc(posted.text, "p", find_post("linuxcnc"), read, {}); }, &message);
        QVERIFY2(message.find("no axis C") != std::string::npos, message.c_str());
    }
};

FACETMILL_TEST(TestNcLines)
#include "test_nc_lines.moc"
