// APT out and in: what is written reads back, what is odd is refused, nothing is guessed.
#include "core/base/tolerances.h"
#include "core/output/apt.h"
#include "core/output/motion_time.h"
#include "tests/support/error_code.h"
#include "tests/support/test_runner.h"

#include <QTemporaryDir>
#include <QTest>

#include <chrono>
#include <cmath>
#include <fstream>
#include <random>
#include <sstream>

using namespace facetmill;
using facetmill::test::code_of;

namespace {

ClSection sample_section(std::size_t motions, bool multi_axis, unsigned seed) {
    std::mt19937_64 rng(seed);
    std::uniform_real_distribution<double> xy(-500, 500), z(-50, 50), tilt(-0.4, 0.4);
    ClSection p;
    p.operation_name = "Finish";
    p.tool_number = 7;
    p.tool_name = "Ball 12";
    p.cutter = AptCutter::ball(12, 40);
    p.feed_mm_per_min = 1270;
    p.spindle_rpm = 6000;
    p.multi_axis = multi_axis;
    for (std::size_t i = 0; i < motions; ++i) {
        Motion m;
        m.kind = i == 0 || i % 7 == 3 ? MotionKind::rapid : MotionKind::cut;
        m.to.tip = Vec3(xy(rng), xy(rng), z(rng));
        m.to.axis = multi_axis ? Vec3(tilt(rng), tilt(rng), 1).normalized() : Vec3::UnitZ();
        p.motions.motions.push_back(m);
    }
    return p;
}

/// A program of these sections.
ClProgram program_of(const std::vector<ClSection>& sections, LengthUnit unit = LengthUnit::mm) {
    ClProgram program;
    program.part_name = "bracket";
    program.unit = unit;
    for (const ClSection& s : sections)
        program.sections.push_back(std::make_shared<const ClSection>(s));
    return program;
}

std::string written(const ClProgram& program) {
    QTemporaryDir dir;
    const std::filesystem::path path = std::filesystem::path(dir.path().toStdString()) / "p.apt";
    OutputFile file(path);
    write_apt(program, file, {});
    file.commit();
    return std::string(InputFile(path).bytes());
}

std::string written(const ClSection& section, LengthUnit unit = LengthUnit::mm) {
    return written(program_of({section}, unit));
}

/// The section of a file that has one.
const ClSection& only(const AptReadResult& read) {
    if (read.program.sections.size() != 1) qFatal("not one section");
    return *read.program.sections.front();
}

AptReadResult parsed(std::string_view text, LengthUnit unit = LengthUnit::mm) {
    return parse_apt(text, "p.apt", unit, {});
}

std::string code_of_text(const std::string& text) {
    return code_of([&] { parsed(text); });
}

std::string message_of_text(const std::string& text) {
    try {
        parsed(text);
    } catch (const Error& e) {
        return e.what();
    }
    return {};
}

std::vector<std::string> lines_of(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);)
        lines.push_back(line);
    return lines;
}

/// Lu, Appendix B.
const char* const lu_sample = R"($$ -----
$$      Generated on Monday, September 04, 2006 6:16:27 PM
$$      CATIA APT VERSION 1.0
$$ -----
$$ Manufacturing Program.1
$$ Part Operation.1
$$*CATIAO
$$      1.00000      0.00000      0.00000      0.00000
PARTNO PART TO BE MACHINED
COOLNT/ON
CUTCOM/OFF
$$ OPERATION NAME : Tool Change.1
$$ Start generation of : Tool Change.1
TLAXIS/ 0.000000, 0.000000, 1.000000
$$ TOOLCHANGEBEGINNING
CUTTER/  1,  0.5,  0.000000,  0.5,  0.000000,$
        0.000000,  1.969000
TOOLNO/1,  0.394000
TPRINT/T1 End Mill D 0.394
LOADTL/1
$$ TOOLCHANGEEND
$$ OPERATION NAME : Multi-Axis Sweeping.1
FEDRAT/ 1000.0000,MPPM
SPINDL/  70.0000,RPM,CLW
GOTO/ 0.000000,-5.250357,4.115815,0.000000,0.000000,1.000000
GOTO/ 0.000000,-5.250357,2.115815,0.000000,0.000000,1.000000
GOTO/ 0.277169,-5.250357,2.077252,0.000000,0.000000,1.000000
.....
GOTO/ 1.897385,5.039643,3.626777,0.000000,0.000000,1.000000
$$ End of generation of : Multi-Axis Sweeping.1
SPINDL/OFF
REWIND/0
END
)";

} // namespace

class TestApt : public QObject {
    Q_OBJECT
private slots:

    void programs_round_trip_data() {
        QTest::addColumn<bool>("multi");
        QTest::addColumn<bool>("inch");
        for (int i = 0; i < 4; ++i)
            QTest::addRow("%s %s", i & 1 ? "multi-axis" : "3-axis", i & 2 ? "inch" : "mm")
                << bool(i & 1) << bool(i & 2);
    }
    void programs_round_trip() {
        QFETCH(bool, multi);
        QFETCH(bool, inch);
        const LengthUnit unit = inch ? LengthUnit::inch : LengthUnit::mm;
        const ClSection p = sample_section(500, multi, 3);
        const std::string text = written(p, unit);
        // Read with the other unit as default: the file states its own.
        const AptReadResult back = parsed(text, inch ? LengthUnit::mm : LengthUnit::inch);
        QCOMPARE(back.program.unit, unit);
        QCOMPARE(only(back).multi_axis, multi);
        QCOMPARE(back.program.part_name, std::string("bracket"));
        QCOMPARE(only(back).operation_name, p.operation_name);
        QCOMPARE(only(back).tool_name, p.tool_name);
        QCOMPARE(only(back).tool_number, p.tool_number);
        QVERIFY(std::abs(only(back).feed_mm_per_min - p.feed_mm_per_min) < 1e-5 * mm_per(unit));
        QCOMPARE(only(back).spindle_rpm, p.spindle_rpm);
        QVERIFY(back.tools.at(0).cutter && back.tools.at(0).number);
        for (const auto& [a, b] : {std::pair(only(back).cutter.d, 12.0),
                                   {only(back).cutter.r, 6.0},
                                   {only(back).cutter.e, 0.0},
                                   {only(back).cutter.f, 6.0},
                                   {only(back).cutter.h, 40.0}})
            QVERIFY(std::abs(a - b) <= 1e-6 * mm_per(unit));
        QCOMPARE(only(back).motions.motions.size(), p.motions.motions.size());
        const double digit = 1e-6 * mm_per(unit);
        for (std::size_t i = 0; i < p.motions.motions.size(); ++i) {
            const Motion &a = p.motions.motions[i], &b = only(back).motions.motions[i];
            QCOMPARE(b.kind, a.kind);
            const Vec3 d = b.to.tip - a.to.tip;
            QVERIFY(std::abs(d.x()) <= 0.51 * digit && std::abs(d.y()) <= 0.51 * digit);
            if (multi)
                QVERIFY(std::abs(d.z()) <= 0.51 * digit);
            else // never lower
                QVERIFY(d.z() >= -0.02 * digit && d.z() <= 1.01 * digit);
            QVERIFY((b.to.axis - a.to.axis).norm() <= 2e-8);
        }
        // What was read writes the same text again: the rounding does not creep.
        if (!multi) QCOMPARE(written(back.program), text);
        QCOMPARE(written(p, unit), text);
    }

    void the_file_is_strict() {
        for (bool multi : {false, true}) {
            ClSection p = sample_section(200, multi, 5);
            p.motions.motions[7].to.tip *= 1e5; // long numbers
            p.cutter = AptCutter::from_shape(25.123456, 3.2, radians(12.345678), radians(7.5), 1000);
            p.operation_name = "a$b\r\nRAPID " + std::string(200, 'y');
            p.tool_name = std::string("t\0$", 3) + std::string(200, 'z');
            ClProgram program = program_of({p}, LengthUnit::inch);
            program.part_name = "caf\xc3\xa9 $12\nGOTO/0,0,0 " + std::string(200, 'x');
            const auto lines = lines_of(written(program));
            std::size_t rapids = 0, gotos = 0;
            for (std::size_t i = 0; i < lines.size(); ++i) {
                QVERIFY2(lines[i].size() <= 72, lines[i].c_str());
                for (char c : lines[i])
                    QVERIFY(c >= 0x20 && c < 0x7F);
                const bool comment = lines[i].starts_with("$$");
                const std::size_t dollar = lines[i].find('$');
                if (!comment && dollar != std::string::npos) QCOMPARE(dollar, lines[i].size() - 1);
                if (lines[i] == "RAPID") {
                    ++rapids;
                    QVERIFY(lines[i + 1].starts_with("GOTO/"));
                }
                if (lines[i].starts_with("GOTO/")) ++gotos;
            }
            const auto is_rapid = [](const Motion& m) { return m.kind == MotionKind::rapid; };
            QCOMPARE(rapids, std::size_t(std::count_if(p.motions.motions.begin(), p.motions.motions.end(),
                                                       is_rapid)));
            QCOMPARE(gotos, p.motions.motions.size());
            QCOMPARE(lines.back(), std::string("FINI"));
            const auto has = [&](const std::string& line) {
                return std::find(lines.begin(), lines.end(), line) != lines.end();
            };
            QVERIFY(has("UNITS/INCHES"));
            QVERIFY(has("LOADTL/7"));
            QVERIFY(has("SPINDL/6000.000000,RPM,CLW"));
            QVERIFY(has("FEDRAT/50.000000,IPM"));
            QVERIFY(has("COOLNT/ON"));
            QCOMPARE(has("MULTAX/ON"), multi);
            QCOMPARE(has("TLAXIS/0.000000,0.000000,1.000000"), !multi);
            const AptReadResult back = parsed(written(program));
            QCOMPARE(only(back).motions.motions.size(), p.motions.motions.size());
            QVERIFY(std::abs(only(back).cutter.alpha - radians(12.345678)) < 1e-8);
        }
        const auto mm = lines_of(written(sample_section(5, false, 1)));
        QVERIFY(std::find(mm.begin(), mm.end(), "FEDRAT/1270.000000,MMPM") != mm.end());
    }

    void nothing_unfit_is_written() {
        const auto refused = [](const std::function<void(ClSection&)>& change) {
            ClSection p = sample_section(20, false, 1);
            change(p);
            QTemporaryDir dir;
            const std::filesystem::path path = std::filesystem::path(dir.path().toStdString()) / "p.apt";
            const std::string code = code_of([&] {
                OutputFile file(path);
                write_apt(program_of({p}), file, {});
                file.commit();
            });
            return std::filesystem::exists(path) ? "written" : code;
        };
        const double nan = std::numeric_limits<double>::quiet_NaN();
        QCOMPARE(refused([](ClSection&) {}), std::string("written"));
        QCOMPARE(refused([](ClSection& p) { p.motions.motions.clear(); }), std::string("empty_result"));
        QCOMPARE(refused([](ClSection& p) { p.motions.motions.resize(1); }), std::string("empty_result"));
        QCOMPARE(refused([&](ClSection& p) { p.motions.motions[9].to.tip.y() = nan; }),
                 std::string("non_finite"));
        QCOMPARE(refused([&](ClSection& p) { p.motions.motions[9].to.tip.z() = infinity; }),
                 std::string("non_finite"));
        QCOMPARE(refused([&](ClSection& p) { p.motions.motions[9].to.tip.x() = 1e30; }),
                 std::string("coordinate_range"));
        QCOMPARE(refused([&](ClSection& p) { p.motions.motions[9].to.axis = Vec3(0.1, 0, 0.99); }),
                 std::string("internal"));
        QCOMPARE(refused([&](ClSection& p) {
                     p.multi_axis = true;
                     p.motions.motions[9].to.axis = Vec3(0, 0, 2);
                 }),
                 std::string("internal"));
        QCOMPARE(refused([&](ClSection& p) { p.feed_mm_per_min = nan; }), std::string("non_finite"));
        QCOMPARE(refused([](ClSection& p) { p.feed_mm_per_min = 0; }), std::string("out_of_range"));
        QCOMPARE(refused([](ClSection& p) { p.feed_mm_per_min = 1e-9; }), std::string("out_of_range"));
        QCOMPARE(refused([](ClSection& p) { p.spindle_rpm = -5; }), std::string("out_of_range"));
        QCOMPARE(refused([&](ClSection& p) { p.cutter.h = infinity; }), std::string("non_finite"));
    }

    void writing_can_be_cancelled() {
        Job job;
        job.cancel();
        QTemporaryDir dir;
        OutputFile file(std::filesystem::path(dir.path().toStdString()) / "p.apt");
        QVERIFY_THROWS_EXCEPTION(Cancelled,
                                 write_apt(program_of({sample_section(20, false, 1)}), file, Progress(job)));
        QVERIFY_THROWS_EXCEPTION(
            Cancelled, parse_apt(written(sample_section(20, false, 1)), "p", LengthUnit::mm, Progress(job)));
    }

    void the_sample_of_the_thesis_reads() {
        const AptReadResult r = parsed(lu_sample, LengthUnit::inch);
        QCOMPARE(only(r).motions.motions.size(), std::size_t(4));
        QCOMPARE(only(r).motions.motions[0].kind, MotionKind::rapid); // from nobody knows where
        QCOMPARE(only(r).motions.motions[1].kind, MotionKind::cut);
        QVERIFY((only(r).motions.motions[2].to.tip - 25.4 * Vec3(0.277169, -5.250357, 2.077252)).norm()
                < 1e-9);
        QCOMPARE(only(r).multi_axis, false);
        QCOMPARE(only(r).feed_mm_per_min, 1000.0); // MPPM: millimetres, also in an inch file
        QCOMPARE(only(r).spindle_rpm, 70.0);
        QCOMPARE(only(r).tool_number, 1L);
        QCOMPARE(only(r).tool_name, std::string("T1 End Mill D 0.394"));
        QCOMPARE(r.program.part_name, std::string("PART TO BE MACHINED"));
        QCOMPARE(only(r).operation_name, std::string("Multi-Axis Sweeping.1"));
        QCOMPARE(only(r).cutter.d, 25.4);
        QCOMPARE(only(r).cutter.f, 12.7);
        QCOMPARE(only(r).cutter.h, 1.969 * 25.4);
        QVERIFY(std::abs(only(r).motions.clearance_z - 4.115815 * 25.4) < 1e-9);
        const std::vector<std::string> ignored = {"CUTCOM (line 11)", "..... (line 28)", "REWIND (line 32)"};
        QCOMPARE(r.ignored, ignored);
        // Other line ends, lower case, blanks: the same.
        for (const char* end : {"\r\n", "\r"}) {
            std::string other;
            for (const char* c = lu_sample; *c; ++c)
                other += *c == '\n' ? std::string(end) : std::string(1, char(std::tolower(*c)));
            const AptReadResult o = parsed(other, LengthUnit::inch);
            QCOMPARE(only(o).motions.motions.size(), std::size_t(4));
            QCOMPARE(only(o).cutter.h, only(r).cutter.h);
            QCOMPARE(o.ignored.size(), r.ignored.size());
        }
    }

    void odd_but_clear_statements_read() {
        const AptReadResult r = parsed("\xEF\xBB\xBF  partno  x $ y\n"
                                       "UNITS / inches\n"
                                       "INTOL/0.001\nOUTTOL/0\nINTOL/0.002\n"
                                       "CUTTER/.5,.25 $$ a ball\n"
                                       "TLAXIS/0,1,1\n"
                                       "FEDRAT/IPM,10\nSPINDL/RPM,500,CCLW\n"
                                       "FROM/0,0,10\n"
                                       "A1) GOTO/ 1 , +2. , $ the rest of this line is nothing\n"
                                       "$$ nor is this\n"
                                       "   -3E0\n"
                                       "\n"
                                       "RAPID\nGODLTA/0,0,1\nGODLTA/2\n"
                                       "goto/1,1,1,0,0,3\nGOTO/2,2,2\n"
                                       "PPRINT GOTO/9,9,9 $$ text\n"
                                       "SOME VENDOR WORD\nCYCLE/OFF\nFINI\n\n");
        QCOMPARE(r.program.part_name, std::string("x $ y"));
        const auto& m = only(r).motions.motions;
        QCOMPARE(m.size(), std::size_t(6));
        const Vec3 slanted = Vec3(0, 1, 1).normalized();
        const double in = 25.4;
        const auto near = [](const Vec3& a, const Vec3& b) { return (a - b).norm() < 1e-9; };
        QVERIFY(m[0].kind == MotionKind::rapid && near(m[0].to.tip, in * Vec3(0, 0, 10))
                && near(m[0].to.axis, slanted));
        QVERIFY(m[1].kind == MotionKind::cut && near(m[1].to.tip, in * Vec3(1, 2, -3)));
        QVERIFY(m[2].kind == MotionKind::rapid && near(m[2].to.tip, in * Vec3(1, 2, -2)));
        QVERIFY(m[3].kind == MotionKind::cut && near(m[3].to.tip, in * (Vec3(1, 2, -2) + 2 * slanted)));
        QVERIFY(m[4].to.axis == Vec3::UnitZ());
        QVERIFY(m[5].to.axis == Vec3::UnitZ()); // the last axis stays
        QVERIFY(only(r).multi_axis);
        QCOMPARE(only(r).feed_mm_per_min, 254.0);
        QCOMPARE(only(r).spindle_rpm, 500.0);
        QCOMPARE(only(r).cutter.r, 0.25 * in);
        const std::vector<std::string> ignored = {"INTOL (line 3)", "OUTTOL (line 4)", "PPRINT (line 20)",
                                                  "SOME (line 21)", "CYCLE (line 22)"};
        QCOMPARE(r.ignored, ignored);
    }

    void feeds_are_understood() {
        const std::string move = "GOTO/0,0,0\nGOTO/1,0,0\n";
        const auto feed = [&](const std::string& head, LengthUnit unit = LengthUnit::mm) {
            return only(parsed(head + move + "FINI\n", unit)).feed_mm_per_min;
        };
        QCOMPARE(feed("FEDRAT/100\n"), 100.0);
        QCOMPARE(feed("FEDRAT/100\n", LengthUnit::inch), 2540.0);
        QCOMPARE(feed("FEDRAT/100,MMPM\n", LengthUnit::inch), 100.0);
        QCOMPARE(feed("FEDRAT/10,IPM\n"), 254.0);
        QCOMPARE(feed("FEDRAT/0.1,MMPR\nSPINDL/1000,RPM,CLW\n"), 100.0);
        QCOMPARE(feed("SPINDL/1000,RPM,CLW\nFEDRAT/0.01,IPR\n"), 254.0);
        QCOMPARE(feed("FEDRAT/5\nFEDRAT/7\n"), 7.0);
        const AptReadResult r = parsed("FEDRAT/5\n" + move + "FEDRAT/9\nGOTO/2,0,0\nFEDRAT/9\nFINI\n");
        QCOMPARE(only(r).feed_mm_per_min, 5.0);
        QCOMPARE(only(r).motion_feeds, (std::vector<double>{5, 5, 9}));
        QVERIFY(r.ignored.empty());
        // Per turn, with a speed that is named later; one that changes between rapids changes nothing.
        const AptReadResult t = parsed("FEDRAT/1,MMPR\n" + move
                                       + "FEDRAT/2,MMPR\nRAPID\nGOTO/3,0,0\nFEDRAT/3,MMPR\nGOTO/4,0,0\n"
                                         "SPINDL/10,RPM\nGOTO/5,0,0\nFINI\n");
        QCOMPARE(only(t).motion_feeds, (std::vector<double>{10, 10, 10, 30, 30}));
    }

    void what_changes_the_path_is_refused_data() {
        QTest::addColumn<QString>("statement");
        QTest::addColumn<QString>("code");
        const auto row = [](const char* statement, const char* code) {
            QTest::newRow(statement) << statement << code;
        };
        for (const char* s : {"CIRCLE/0,0,0,0,0,1,5",
                              "MOVARC/1,2,3",
                              "GOFWD/L1",
                              "GO/TO,P1",
                              "GOHOME",
                              "TLLFT",
                              "PSIS/PL",
                              "CUTCOM/LEFT",
                              "CUTCOM/ON",
                              "CYCLE/DRILL,5",
                              "COPY/1",
                              "TRACUT/M1",
                              "P1=POINT/1,2,3",
                              "A=5",
                              "LOOPST",
                              "MACRO",
                              "ROTABL/ATANGL,90",
                              "TRANS/1,2,3",
                              "ORIGIN/0,0,0",
                              "goto1,2,3",
                              "INDEX/1",
                              "UNITS/CM"})
            row(s, "unsupported_format");
        for (const char* s : {"GOTO/1,2",
                              "GOTO/1,2,3,4",
                              "GOTO/1,2,x",
                              "GOTO/1,,3",
                              "GOTO/1 5,2,3",
                              "GOTO/P1",
                              "GOTO",
                              "GOTO/",
                              "GOTO 1,2,3",
                              "GOTO/nan,0,0",
                              "GOTO/1e999,0,0",
                              "GOTO/1,2,3,0,0,0",
                              "GOTO/0x10,0,0",
                              "GODLTA/1,2",
                              "TLAXIS/0,0,0",
                              "TLAXIS/0,0",
                              "1,2,3",
                              "FEDRAT/abc",
                              "CUTTER/1,2,3",
                              "CUTTER/a",
                              "UNITS",
                              "UNITS/INCHES",
                              "GOTO/1,2,3,4,5,6,7,8,9",
                              "LOADTL/1.5"})
            row(s, "syntax");
        row("GOTO/1e9,0,0", "coordinate_range");
        row("GODLTA/1e8,0,0", "coordinate_range");
        row("FEDRAT/0", "out_of_range");
        row("FEDRAT/-5", "out_of_range");
        row("CUTTER/-1", "out_of_range");
        row("CUTTER/10,20,0,0,0,0,0", "out_of_range");
    }
    void what_changes_the_path_is_refused() {
        QFETCH(QString, statement);
        QFETCH(QString, code);
        const std::string text =
            "CUTTER/6,3\nLOADTL/1\nGOTO/0,0,0\nGOTO/1,0,0\n" + statement.toStdString() + "\nFINI\n";
        QCOMPARE(QString::fromStdString(code_of_text(text)), code);
        // The place is the file and the line.
        QVERIFY(message_of_text(text).starts_with("p.apt:5: "));
    }

    void ends_are_checked() {
        const std::string body = "GOTO/0,0,0\nGOTO/1,0,0\n";
        QCOMPARE(code_of_text(body + "FINI"), std::string("none"));
        QCOMPARE(code_of_text(body + "FINI\n\n$$ done\n"), std::string("none"));
        QCOMPARE(code_of_text(body + "END\nFINI\n"), std::string("none"));
        QCOMPARE(code_of_text(body + "END\nGOTO/2,0,0\nFINI\n"), std::string("syntax"));
        QCOMPARE(code_of_text(body + "FINI\n" + body + "FINI\n"), std::string("syntax"));
        QCOMPARE(code_of_text(body + "GOTO/2,0,1.2"), std::string("truncated"));
        QCOMPARE(code_of_text(body + "GOTO/2,0,$\n"), std::string("truncated"));
        QCOMPARE(parsed(body).ignored,
                 std::vector<std::string>{"no FINI or END: the file may be cut short (line 2)"});
        QCOMPARE(code_of_text("GOTO/0,0,0\nFINI\n"), std::string("empty_result"));
        QCOMPARE(code_of_text("RAPID\nGOTO/0,0,0\nRAPID\nGOTO/0,1,0\nFINI\n"), std::string("empty_result"));
        QCOMPARE(code_of_text("$$ nothing\n"), std::string("empty_result"));
        QCOMPARE(code_of_text("hello world\n"), std::string("empty_result"));
        QCOMPARE(code_of_text(std::string("G\0O\0", 4)), std::string("encoding"));
        QCOMPARE(code_of_text("\xFF\xFEG"), std::string("encoding"));
        QCOMPARE(code_of([] { read_apt("/nonexistent/p.apt", LengthUnit::mm, {}); }),
                 std::string("not_found"));
        QVERIFY(message_of_text(body + "GOTO/2,0,1.2").starts_with("p.apt:3: "));
    }

    /// Cut anywhere, the file is refused or gives a shorter path of the same points.
    void truncation_never_changes_a_point() {
        const ClSection p = sample_section(12, true, 9);
        const std::string text = written(p);
        const auto whole = only(parsed(text)).motions.motions;
        std::size_t read = 0, refused = 0;
        for (std::size_t n = 0; n < text.size(); ++n) {
            try {
                const auto r = parsed(text.substr(0, n));
                ++read;
                const auto& motions = only(r).motions.motions;
                QVERIFY(motions.size() <= whole.size());
                for (std::size_t i = 0; i < motions.size(); ++i) {
                    QVERIFY(motions[i].to.tip == whole[i].to.tip);
                    QVERIFY(motions[i].to.axis == whole[i].to.axis);
                    QCOMPARE(motions[i].kind, whole[i].kind);
                }
                const bool ended = n + 1 == text.size() || text.find("\nEND\n") + 4 <= n;
                if (!ended) QVERIFY(!r.ignored.empty() && r.ignored.back().starts_with("no FINI"));
            } catch (const Error& e) {
                ++refused;
                QVERIFY(std::string(e.what()).find("p.apt") == 0);
                QVERIFY(std::string(e.what()).find('\n') == std::string::npos);
            }
        }
        QVERIFY(read > 5 && refused > 500);
    }

    /// Any bytes: an Error of one line, or a program whose every number is finite.
    void mutations_are_refused_or_consistent() {
        std::mt19937_64 rng(17);
        const std::string sources[] = {written(sample_section(8, true, 2)), lu_sample};
        static constexpr char alphabet[] = "0123456789.,-+/$=eEGOTOFINI \n\r\t\"'()";
        int ok = 0, bad = 0;
        for (int round = 0; round < 6000; ++round) {
            std::string text = sources[round % 2];
            const int changes = 1 + int(rng() % 6);
            for (int c = 0; c < changes; ++c) {
                const std::size_t at = rng() % text.size();
                switch (rng() % 4) {
                case 0:
                    text[at] = char(rng());
                    break;
                case 1:
                    text[at] = alphabet[rng() % (sizeof alphabet - 1)];
                    break;
                case 2:
                    text.erase(at, 1 + rng() % 20);
                    break;
                default:
                    text.insert(at, text.substr(rng() % text.size(), 1 + rng() % 40));
                }
                if (text.empty()) text = "x";
            }
            try {
                const auto r = parsed(text);
                ++ok;
                bool fit = true;
                for (const auto& s : r.program.sections) {
                    for (const Motion& m : s->motions.motions) {
                        QVERIFY(m.to.tip.allFinite()
                                && m.to.tip.cwiseAbs().maxCoeff() <= tolerance::largest_program_coordinate);
                        QVERIFY(std::abs(m.to.axis.norm() - 1) < 1e-12);
                    }
                    QVERIFY(std::isfinite(s->feed_mm_per_min) && s->feed_mm_per_min > 0);
                    fit = fit && s->spindle_rpm >= 1e-6 && s->feed_mm_per_min >= 1e-6;
                }
                // What was read as one operation can be written.
                if (round % 20 == 0 && fit && r.program.sections.size() == 1) written(r.program);
            } catch (const Error& e) {
                ++bad;
                QVERIFY2(e.code() != ErrorCode::internal, e.what());
                QVERIFY(std::string(e.what()).find('\n') == std::string::npos);
            }
        }
        QVERIFY(ok > 300 && bad > 300);
    }

    void hostile_shapes_end() {
        QCOMPARE(code_of_text(std::string(2'000'000, 'A') + "\n"), std::string("empty_result"));
        std::string labels;
        for (int i = 0; i < 500'000; ++i)
            labels += "A)";
        QCOMPARE(code_of_text(labels + "\n"), std::string("empty_result"));
        std::string continued = "GOTO/1";
        for (int i = 0; i < 500'000; ++i)
            continued += ",$\n1";
        QCOMPARE(code_of_text(continued + "\n"), std::string("syntax"));
        std::string words;
        for (int i = 0; i < 100'000; ++i)
            words += "W" + std::to_string(i) + "\n";
        QCOMPARE(parsed(words + "GOTO/0,0,0\nGOTO/1,0,0\nFINI\n").ignored.size(), std::size_t(1000));
    }

    void large_programs_read_back() {
        const ClSection p = sample_section(200'000, false, 4);
        const AptReadResult back = parsed(written(p));
        QCOMPARE(only(back).motions.motions.size(), p.motions.motions.size());
        QVERIFY((only(back).motions.motions.back().to.tip - p.motions.motions.back().to.tip).norm() < 2e-6);
    }

    void times_and_lengths_add_up() {
        ClSection p;
        p.feed_mm_per_min = 600; // 10 mm/s
        const auto add = [&](MotionKind kind, double x, double y, double z) {
            p.motions.motions.push_back({.kind = kind, .to = {Vec3(x, y, z), Vec3::UnitZ()}});
        };
        add(MotionKind::rapid, 1000, 1000, 1000); // from nobody knows where: no length
        add(MotionKind::rapid, 1030, 1040, 1000); // 50 mm
        add(MotionKind::approach, 1030, 1040, 990);
        add(MotionKind::cut, 1033, 1044, 990);
        add(MotionKind::link, 1033, 1045, 990);
        add(MotionKind::retract, 1033, 1045, 1000);
        Machine machine;
        machine.rapid_mm_per_s = Vec3(10, 20, 5);
        const MotionTotals t = motion_totals(p, machine);
        QCOMPARE(t.rapid_length, 50.0);
        QCOMPARE(t.cut_length, 26.0);
        QCOMPARE(t.time_seconds, 2.6 + 3.0); // x: 30 mm at 10 mm/s is the slowest axis
        add(MotionKind::rapid, 1033, 1045, 1020);
        QCOMPARE(motion_totals(p, machine).time_seconds, 2.6 + 3.0 + 4.0);
        const std::vector<double> each = motion_seconds(p, machine), expected{0, 3, 1, 0.5, 0.1, 1, 4};
        QCOMPARE(each.size(), expected.size());
        for (std::size_t i = 0; i < each.size(); ++i)
            QVERIFY(std::abs(each[i] - expected[i]) < 1e-12);
    }
};

FACETMILL_TEST(TestApt)
#include "test_apt.moc"
