// Programs of several operations, and the writers as a family.
#include "core/output/apt.h"
#include "core/output/motion_time.h"
#include "core/output/program_writer.h"
#include "tests/support/error_code.h"
#include "tests/support/test_runner.h"

#include <QTemporaryDir>
#include <QTest>

#include <cmath>
#include <random>
#include <set>

using namespace facetmill;
using facetmill::test::code_of;

namespace {

std::string bytes_of(const ClProgram& program, const ProgramWriter& writer, std::size_t file = 0) {
    QTemporaryDir dir;
    const std::filesystem::path path =
        std::filesystem::path(dir.path().toStdString()) / ("p" + writer.extension);
    OutputFile out(path);
    writer.write(program, file, out, {});
    out.commit();
    return std::string(InputFile(path).bytes());
}

std::string apt_of(const ClProgram& program) {
    return bytes_of(program, apt_writer());
}

AptReadResult read_back(const std::string& text) {
    return parse_apt(text, "p", LengthUnit::mm, {});
}

/// One to five operations with one to three tools, feeds that change or not, every coolant.
std::vector<ClSection> random_sections(std::mt19937_64& rng) {
    const auto pick = [&](int n) { return int(rng() % unsigned(n)); };
    std::uniform_real_distribution<double> place(-300, 300), tilt(-0.5, 0.5);
    std::vector<ClSection> sections(std::size_t(1 + pick(5)));
    for (std::size_t i = 0; i < sections.size(); ++i) {
        ClSection& s = sections[i];
        s.operation_name = "Operation " + std::to_string(i + 1);
        s.tool_number = 1 + pick(3);
        s.tool_name = s.tool_number == 2 ? "" : "Tool " + std::to_string(s.tool_number);
        s.cutter = AptCutter::ball(2.0 * double(s.tool_number), 30);
        s.feed_mm_per_min = 100 * (1 + pick(4));
        s.spindle_rpm = 1000 * (1 + pick(3));
        s.coolant = Coolant(pick(4));
        s.multi_axis = pick(2) == 0;
        const std::size_t n = std::size_t(2 + pick(30));
        for (std::size_t k = 0; k < n; ++k) {
            Motion m;
            // The last one cuts, so that one does.
            m.kind = k == 0 || (k + 1 < n && pick(4) == 0) ? MotionKind::rapid : MotionKind::cut;
            m.to.tip = Vec3(std::round(place(rng)), std::round(place(rng)), std::round(place(rng)));
            m.to.axis = s.multi_axis ? Vec3(tilt(rng), tilt(rng), 1).normalized() : Vec3::UnitZ();
            s.motions.motions.push_back(m);
        }
        if (pick(2) == 0)
            for (std::size_t k = 0; k < n; ++k)
                s.motion_feeds.push_back(50 * (1 + pick(3)));
    }
    return sections;
}

ClProgram program_with(const std::vector<ClSection>& sections) {
    ClProgram program;
    for (const ClSection& s : sections)
        program.sections.push_back(std::make_shared<const ClSection>(s));
    return program;
}

/// What the reader makes of a section that does not start the program, as the head of apt.h says.
ClSection after(const ClSection& before, ClSection s) {
    const Motion& end = before.motions.motions.back();
    const CutterLocation& start = s.motions.motions.front().to;
    if (!same_tool(before, s) || (start.tip == end.to.tip && start.axis == end.to.axis)) return s;
    s.motions.motions.insert(s.motions.motions.begin(), {.kind = MotionKind::rapid, .to = end.to});
    if (!s.motion_feeds.empty()) s.motion_feeds.insert(s.motion_feeds.begin(), s.motion_feeds.front());
    return s;
}

const std::string two_tools = "CUTTER/6,3\nLOADTL/1\nFEDRAT/100\nGOTO/0,0,0\nGOTO/1,0,0\n"
                              "CUTTER/4,2\nTPRINT/small\nLOADTL/2\nGOTO/5,0,0\nGOTO/6,0,0\nFINI\n";

} // namespace

class TestProgramWriters : public QObject {
    Q_OBJECT
private slots:

    void several_operations_round_trip() {
        std::mt19937_64 rng(24);
        std::size_t changes = 0, same = 0, feeds = 0;
        for (int round = 0; round < 300; ++round) {
            const std::vector<ClSection> sections = random_sections(rng);
            const std::string text = apt_of(program_with(sections));
            const AptReadResult back = read_back(text);
            QVERIFY2(back.ignored.empty(), text.c_str());
            QCOMPARE(back.program.sections.size(), sections.size());
            QCOMPARE(back.tools.size(), sections.size());
            for (std::size_t i = 0; i < sections.size(); ++i) {
                const ClSection& b = *back.program.sections[i];
                const ClSection a = i == 0 ? sections[i] : after(sections[i - 1], sections[i]);
                if (i > 0) ++(same_tool(sections[i - 1], a) ? same : changes);
                QVERIFY(back.tools[i].cutter && back.tools[i].number);
                QCOMPARE(b.operation_name, a.operation_name);
                QCOMPARE(b.tool_number, a.tool_number);
                QCOMPARE(b.tool_name, a.tool_name);
                QVERIFY(same_tool(a, b));
                QCOMPARE(b.spindle_rpm, a.spindle_rpm);
                QVERIFY(b.coolant == a.coolant);
                QCOMPARE(b.multi_axis, a.multi_axis);
                QCOMPARE(b.motions.motions.size(), a.motions.motions.size());
                for (std::size_t k = 0; k < a.motions.motions.size(); ++k) {
                    const Motion &m = a.motions.motions[k], &n = b.motions.motions[k];
                    QVERIFY2(n.kind == m.kind, text.c_str());
                    QVERIFY((n.to.tip - m.to.tip).norm() < 2e-6);
                    QVERIFY((n.to.axis - m.to.axis).norm() < 2e-8);
                    if (m.kind != MotionKind::rapid) QCOMPARE(b.feed(k), a.feed(k));
                }
                feeds += !b.motion_feeds.empty();
            }
        }
        QVERIFY(changes > 100 && same > 100 && feeds > 100);
    }

    void one_feed_is_one_record() {
        std::mt19937_64 rng(3);
        ClSection s = random_sections(rng).front();
        s.motion_feeds.clear();
        const std::string plain = apt_of(program_with({s}));
        s.motion_feeds.assign(s.motions.motions.size(), s.feed_mm_per_min);
        QVERIFY(apt_of(program_with({s})) == plain);
        s.motion_feeds.back() *= 2;
        const std::string changed = apt_of(program_with({s}));
        const auto records = [](const std::string& text) {
            std::size_t n = 0;
            for (std::size_t at = text.find("FEDRAT"); at != std::string::npos;
                 at = text.find("FEDRAT", at + 1))
                ++n;
            return n;
        };
        QCOMPARE(records(plain), std::size_t(1));
        QCOMPARE(records(changed), std::size_t(2));
    }

    void feeds_of_motions_are_timed() {
        ClSection s;
        s.feed_mm_per_min = 600;
        for (const double x : {0.0, 10.0, 30.0, 60.0})
            s.motions.motions.push_back(
                {.kind = x > 0 ? MotionKind::cut : MotionKind::rapid, .to = {Vec3(x, 0, 0), Vec3::UnitZ()}});
        const Machine machine;
        QCOMPARE(motion_totals(s, machine).time_seconds, 6.0);
        s.motion_feeds = {600, 600, 1200, 300};
        QCOMPARE(motion_totals(s, machine).time_seconds, 1.0 + 1.0 + 6.0);
        QCOMPARE(motion_seconds(s, machine), (std::vector<double>{0, 1, 1, 6}));
    }

    void unfit_programs_are_refused() {
        std::mt19937_64 rng(5);
        ClSection a = random_sections(rng).front(), b = a;
        QCOMPARE(code_of([] { check_writable({}); }), std::string("empty_result"));
        QCOMPARE(code_of([&] { check_writable(program_with({a, b})); }), std::string("none"));
        b.cutter = AptCutter::ball(9, 30);
        QCOMPARE(code_of([&] { check_writable(program_with({a, b})); }), std::string("out_of_range"));
        b.tool_number = a.tool_number + 1;
        QCOMPARE(code_of([&] { check_writable(program_with({a, b})); }), std::string("none"));
        b.motion_feeds.assign(b.motions.motions.size(), 0.0);
        QCOMPARE(code_of([&] { check_writable(program_with({a, b})); }), std::string("out_of_range"));
        b.motion_feeds = {100};
        QCOMPARE(code_of([&] { check_writable(program_with({a, b})); }), std::string("internal"));
        b.motion_feeds.clear();
        b.motions.motions.resize(1);
        QCOMPARE(code_of([&] { check_writable(program_with({a, b})); }), std::string("empty_result"));
    }

    void a_change_of_tool_is_read() {
        const AptReadResult r = read_back(two_tools);
        QCOMPARE(r.program.sections.size(), std::size_t(2));
        const ClSection &a = *r.program.sections[0], &b = *r.program.sections[1];
        QCOMPARE(a.cutter.d, 6.0);
        QCOMPARE(a.tool_name, std::string());
        QCOMPARE(b.cutter.d, 4.0);
        QCOMPARE(b.tool_number, 2L);
        QCOMPARE(b.tool_name, std::string("small"));
        // From nobody knows where, like the first of all.
        QVERIFY(b.motions.motions[0].kind == MotionKind::rapid && b.motions.motions.size() == 2);
        QCOMPARE(b.feed_mm_per_min, 100.0);
        // The other order, and a shape that two tools share.
        for (const char* change :
             {"LOADTL/2\nCUTTER/4,2\n", "CUTTER/6,3\nLOADTL/2\n", "TOOLNO/2\nCUTTER/6,3\n"}) {
            const AptReadResult o = read_back("CUTTER/6,3\nLOADTL/1\nGOTO/0,0,0\nGOTO/1,0,0\n"
                                              + std::string(change) + "GOTO/5,0,0\nGOTO/6,0,0\nFINI\n");
            QCOMPARE(o.program.sections.size(), std::size_t(2));
            QVERIFY(o.tools[1].cutter && o.tools[1].number);
        }
        // The cutter of another tool is not known by that of the first, nor its number by its cutter.
        const AptReadResult unknown = read_back(
            "CUTTER/6,3\nLOADTL/1\nGOTO/0,0,0\nGOTO/1,0,0\nLOADTL/2\nGOTO/5,0,0\nGOTO/6,0,0\nFINI\n");
        QVERIFY(unknown.tools.at(1).number && !unknown.tools.at(1).cutter);
        const AptReadResult nameless = read_back(
            "CUTTER/6,3\nLOADTL/1\nGOTO/0,0,0\nGOTO/1,0,0\nCUTTER/4,2\nGOTO/5,0,0\nGOTO/6,0,0\nFINI\n");
        QVERIFY(nameless.tools.at(1).cutter && !nameless.tools.at(1).number);
        // The same tool again changes nothing.
        QCOMPARE(read_back(
                     "CUTTER/6,3\nLOADTL/1\nGOTO/0,0,0\nGOTO/1,0,0\nCUTTER/6,3\nLOADTL/1\nGOTO/2,0,0\nFINI\n")
                     .program.sections.size(),
                 std::size_t(1));
    }

    void operations_of_one_tool_go_on_where_the_tool_is() {
        const AptReadResult r = read_back("$$ OPERATION NAME : a\nGOTO/0,0,0\nGOTO/1,0,0\n"
                                          "$$ OPERATION NAME : b\nGOTO/2,0,0\nFINI\n");
        QCOMPARE(r.program.sections.size(), std::size_t(2));
        const auto& m = r.program.sections[1]->motions.motions;
        QCOMPARE(r.program.sections[1]->operation_name, std::string("b"));
        // The motion between them cuts in the file, and so it does here.
        QCOMPARE(m.size(), std::size_t(2));
        QVERIFY(m[0].kind == MotionKind::rapid && m[0].to.tip == Vec3(1, 0, 0));
        QVERIFY(m[1].kind == MotionKind::cut && m[1].to.tip == Vec3(2, 0, 0));
    }

    void changes_within_an_operation_are_listed() {
        const std::string head = "SPINDL/500,RPM\nCOOLNT/MIST\nGOTO/0,0,0\nGOTO/1,0,0\n";
        const AptReadResult r =
            read_back(head + "SPINDL/600,RPM\nGOTO/2,0,0\nCOOLNT/OFF\nGOTO/3,0,0\nCOOLNT/AIR\nFINI\n");
        QVERIFY(r.program.sections.at(0)->coolant == Coolant::mist);
        QCOMPARE(r.program.sections.at(0)->spindle_rpm, 500.0);
        QCOMPARE(r.ignored, (std::vector<std::string>{"change of SPINDL (line 5)",
                                                      "change of COOLNT (line 7)", "COOLNT/AIR (line 9)"}));
        // At the end of a program coolant and spindle stop: no change while it cuts.
        QVERIFY(read_back(head + "COOLNT/OFF\nSPINDL/OFF\nFINI\n").ignored.empty());
        QVERIFY(read_back("GOTO/0,0,0\nGOTO/1,0,0\nFINI\n").program.sections.at(0)->coolant == Coolant::off);
        QCOMPARE(read_back("CUTTER/6,3\n" + head + "CUTTER/4,2\nFINI\n").ignored,
                 std::vector<std::string>{"a tool that makes no motion (line 7)"});
    }

    void malformed_changes_are_refused() {
        const auto code = [&](const std::string& from, const std::string& to) {
            std::string text = two_tools;
            const std::size_t at = text.rfind(from);
            if (at == std::string::npos) qFatal("the text to replace is not there");
            return code_of([&] { read_back(text.replace(at, from.size(), to)); });
        };
        QCOMPARE(code("LOADTL/2", "LOADTL/2"), std::string("none"));
        QCOMPARE(code("LOADTL/2", "LOADTL"), std::string("syntax"));
        QCOMPARE(code("LOADTL/2", "LOADTL/2.5"), std::string("syntax"));
        QCOMPARE(code("LOADTL/2", "LOADTL/-1"), std::string("syntax"));
        QCOMPARE(code("CUTTER/4,2", "CUTTER/4,2,1"), std::string("syntax"));
        QCOMPARE(code("CUTTER/4,2", "CUTTER/-4"), std::string("out_of_range"));
        QCOMPARE(code("CUTTER/4,2", "UNITS/INCHES"), std::string("syntax"));
        // Nobody knows where another tool starts.
        QCOMPARE(code("GOTO/5,0,0", "GODLTA/1,0,0"), std::string("syntax"));
    }

    /// Cut anywhere, a program of several operations is refused or gives the same sections, the last one
    /// shorter.
    void truncation_never_moves_a_point_to_another_tool() {
        std::mt19937_64 rng(8);
        std::vector<ClSection> sections = random_sections(rng);
        while (sections.size() < 4)
            sections = random_sections(rng);
        const std::string text = apt_of(program_with(sections));
        const AptReadResult whole = read_back(text);
        std::size_t read = 0, refused = 0;
        for (std::size_t n = 0; n < text.size(); ++n) {
            AptReadResult r;
            try {
                r = read_back(text.substr(0, n));
            } catch (const Error&) {
                ++refused;
                continue;
            }
            ++read;
            QVERIFY(r.program.sections.size() <= whole.program.sections.size());
            for (std::size_t i = 0; i < r.program.sections.size(); ++i) {
                const ClSection &a = *whole.program.sections[i], &b = *r.program.sections[i];
                QVERIFY(same_tool(a, b));
                QVERIFY(b.motions.motions.size() <= a.motions.motions.size());
                for (std::size_t k = 0; k < b.motions.motions.size(); ++k)
                    QVERIFY(b.motions.motions[k].to.tip == a.motions.motions[k].to.tip
                            && b.motions.motions[k].kind == a.motions.motions[k].kind);
            }
        }
        QVERIFY(read > 50 && refused > 500);
    }

    void the_registry_is_consistent() {
        std::set<std::string> names, extensions;
        for (const ProgramWriter& writer : program_writers()) {
            QVERIFY(names.insert(writer.name).second && !writer.label.empty());
            QVERIFY(writer.extension.size() > 1 && writer.extension[0] == '.');
            QVERIFY(extensions.insert(writer.extension).second);
            QCOMPARE(&program_writer(writer.name), &writer);
        }
        QVERIFY(names.contains("apt") && names.contains("turning-table"));
        QCOMPARE(apt_writer().name, std::string("apt"));
        QCOMPARE(code_of([] { program_writer("none"); }), std::string("out_of_range"));
    }

    void tables_are_written_of_parts_that_turn() {
        const ProgramWriter& writer = program_writer("turning-table");
        ClSection s;
        s.operation_name = "Rough";
        for (const double angle : {0.0, 90.0, 180.0, 270.0, 360.0}) {
            const double a = radians(angle);
            const Vec3 out(0, std::sin(a), std::cos(a));
            s.motions.motions.push_back({.kind = angle > 0 ? MotionKind::cut : MotionKind::rapid,
                                         .to = {Vec3(7, 0, 0) + 10 * out, out}});
        }
        s.multi_axis = true;
        QVERIFY(writer.files(program_with({s})).empty());
        s.motions.turning = TurningAxis{Vec3::Zero(), Vec3::UnitX()};
        s.turning = ClTurning{Vec3::UnitZ(), AngleWinding::unwound, {{0, 0, 3}, {11, 3, 5}}};
        const std::vector<std::string> files = {"-pass-01", "-pass-12"};
        QCOMPARE(writer.files(program_with({s})), files);
        QVERIFY(writer.files(program_with({s, s})).empty());
        const std::string head = "# PART, Rough, pass 1\n# turning angle (degrees), Y along the axis, X from "
                                 "the axis (mm), tool tip\n";
        QCOMPARE(bytes_of(program_with({s}), writer),
                 head
                     + "0.000000 7.000000 10.000000\n-90.000000 7.000000 10.000000\n"
                       "-180.000000 7.000000 10.000000\n");
        s.turning->winding = AngleWinding::modulo;
        QVERIFY(bytes_of(program_with({s}), writer, 1).find("90.000000 7.000000") != std::string::npos);
        s.turning->ranges = {{-1, 0, 5}};
        QCOMPARE(writer.files(program_with({s})), std::vector<std::string>{""});
        s.motions.motions[2].to.tip.x() = std::nan("");
        QCOMPARE(code_of([&] { bytes_of(program_with({s}), writer); }), std::string("non_finite"));
    }
};

FACETMILL_TEST(TestProgramWriters)
#include "test_program_writers.moc"
