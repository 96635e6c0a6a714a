// Posts: the data files, what is written for a control, and that it reads back as what was planned.
#include "core/base/plane_geometry.h"
#include "core/output/post/nc_text.h"
#include "core/output/post/tilted_plane.h"
#include "core/setup/kinematics.h"
#include "tests/support/error_code.h"
#include "tests/support/test_runner.h"
#include "tests/unit/output/posted_parts.h"

#include <QTest>

using namespace facetmill;
using namespace facetmill::test;

namespace {

std::string number_text(std::int64_t digits, int decimals, bool zeros, bool point) {
    Post p;
    p.trailing_zeros = zeros;
    p.point = point;
    std::string text;
    append_number(text, digits, decimals, p);
    return text;
}

} // namespace

class TestPosts : public QObject {
    Q_OBJECT
private slots:
    void numbers() {
        QCOMPARE(number_text(15000, 4, false, false), std::string("1.5"));
        QCOMPARE(number_text(15000, 4, true, false), std::string("1.5000"));
        QCOMPARE(number_text(-5, 4, false, true), std::string("-0.0005"));
        QCOMPARE(number_text(0, 4, false, true), std::string("0."));
        QCOMPARE(number_text(0, 4, true, true), std::string("0.0000"));
        QCOMPARE(number_text(30000, 4, false, false), std::string("3"));
        QCOMPARE(number_text(-30000, 4, false, true), std::string("-3."));
        std::string text;
        append_significant(text, 0.00123456789, 6, Post{});
        QCOMPARE(text, std::string("0.00123457"));
        text.clear();
        append_significant(text, 123456789.0, 6, Post{});
        QCOMPARE(text, std::string("123456789."));
    }

    void files_are_strict_data() {
        QTest::addColumn<std::string>("text");
        QTest::addColumn<std::string>("code");
        QTest::addColumn<std::string>("says");
        const auto row = [](const char* name, const std::string& text, const char* code, const char* says) {
            QTest::newRow(name) << text << std::string(code) << std::string(says);
        };
        row("unknown key", linuxcnc_with("\"largest_tool\"", "\"largest_tol\""), "unknown_key",
            "largest_tol");
        row("unknown inner key", linuxcnc_with("\"mm_decimals\"", "\"decimals\""), "unknown_key",
            "numbers.decimals");
        row("wrong type", linuxcnc_with("99999,", "\"many\","), "wrong_type", "largest_tool");
        row("template word", linuxcnc_with("{tool_name}", "{toolname}"), "out_of_range", "toolname");
        row("open brace", linuxcnc_with("{coolant}", "{coolant"), "out_of_range", "operation[2]");
        row("meaning", linuxcnc_with("\"rapid\"", "\"fast\""), "out_of_range", "codes.G0");
        row("no code", linuxcnc_with("\"G0\": \"rapid\", ", ""), "missing_key", "rapid");
        row("two meanings", linuxcnc_with("\"y\": \"Y\"", "\"y\": \"X\""), "out_of_range", "words.y");
        row("wcs", linuxcnc_with("\"G59.3\"", "\"G90\""), "out_of_range", "wcs[8]");
        const auto preset = [&](const char* name, const char* from, const char* to, const char* code,
                                const char* says) {
            row(name, changed_text(find_post("heidenhain").source, from, to), code, says);
        };
        preset("preset: no number", "Q339=+{wcs}", "Q339=+1", "out_of_range", "wcs.on");
        preset("preset: other words", "SETTING ~", "{tool} ~", "out_of_range", "wcs.on[0]");
        preset("preset: last", "\"last\": 65535", "\"last\": -1", "out_of_range", "wcs.last");
        preset("preset: key", "\"first\": 0, \"last\": 65535", "\"from\": 0", "unknown_key", "wcs.from");
        preset("preset: type", "\"first\": 0, \"last\": 65535", "\"first\": \"0\"", "wrong_type",
               "wcs.first");
        row("version", linuxcnc_with("\"facetmill_post\": 1", "\"facetmill_post\": 2"), "newer_version",
            "newer");
        row("no G93", linuxcnc_with("\"G93\": \"inverse_time\", ", ""), "out_of_range", "inverse_time");
        row("comment", linuxcnc_with("\"close\": \")\"", "\"close\": \"\""), "out_of_range", "comment.close");
        row("other comment", linuxcnc_with("\"also\": \";\"", "\"also\": \"(\""), "out_of_range",
            "comment.also");
        row("no comment", linuxcnc_with("\"also\": \";\"", "\"also\": \"#\""), "out_of_range",
            "comment.also");
        row("extension", linuxcnc_with(".ngc", "../x"), "out_of_range", "extension");
        row("decimals", linuxcnc_with("\"mm_decimals\": 4", "\"mm_decimals\": 40"), "out_of_range",
            "mm_decimals");
        row("twice", linuxcnc_with("\"wcs\": [", "\"coolant\": {}, \"wcs\": ["), "syntax", "twice");
    }
    void files_are_strict() {
        QFETCH(std::string, text);
        QFETCH(std::string, code);
        QFETCH(std::string, says);
        std::string message;
        QCOMPARE(code_of([&] { parse_post(text, "own.json"); }, &message), code);
        QVERIFY2(message.find("own.json") == 0 && message.find(says) != std::string::npos, message.c_str());
    }

    void every_post_writes_what_it_reads_data() {
        QTest::addColumn<QString>("post");
        QTest::addColumn<bool>("inch");
        for (const Post& p : posts())
            for (const bool inch : {false, true})
                QTest::addRow("%s %s", p.name.c_str(), inch ? "in" : "mm")
                    << QString::fromStdString(p.name) << inch;
    }
    /// Three axes: every place to half a printed digit, every rapid a rapid, the time as the model has it.
    void every_post_writes_what_it_reads() {
        QFETCH(QString, post);
        QFETCH(bool, inch);
        const Post& control = find_post(post.toStdString());
        std::vector<ClSection> sections = {upright_section("One", 1)};
        if (control.has(NcCode::tool_change)) sections.push_back(upright_section("Two", 2, 7));
        if (!control.has(NcCode::tool_change)) sections.push_back(upright_section("Two", 1, 7));
        const ClProgram program = joined_program(sections, inch ? LengthUnit::inch : LengthUnit::mm);
        const PostSetup setup = setup_for(program, "generic-3-axis");
        const PostedProgram posted = post_program(program, control, setup, {});
        const NcProgram read = read_nc(posted.text, "p", control, reading(program, setup), {});
        QCOMPARE(read.blocks, posted.blocks);
        const double digit =
            inch ? 25.4 * std::pow(10, -control.inch_decimals) : std::pow(10, -control.mm_decimals);
        double seconds = 0;
        std::vector<Motion> all;
        for (const auto& s : read.sections)
            all.insert(all.end(), s->motions.motions.begin(), s->motions.motions.end());
        std::size_t at = 0;
        for (const ClSection& s : sections) {
            for (const Motion& m : s.motions.motions) {
                const bool rapid = m.kind == MotionKind::rapid;
                while (at < all.size()
                       && ((all[at].to.tip - m.to.tip).cwiseAbs().maxCoeff() > 0.5 * digit * 1.001
                           || (control.straight_rapids && rapid != (all[at].kind == MotionKind::rapid))))
                    ++at;
                QVERIFY2(at < all.size(), "a place is missing");
            }
            seconds += motion_totals(s, setup.machine).time_seconds;
        }
        // Over the top, where one tool does both, takes time as well; rapids told at feed have the file's
        // digits.
        QVERIFY(posted.seconds > 0.999 * seconds && posted.seconds < 1.05 * seconds);
        QVERIFY2(std::abs(read.seconds - posted.seconds) < 1e-3 * posted.seconds,
                 qPrintable(QString("%1 %2").arg(read.seconds).arg(posted.seconds)));
    }

    void work_coordinates_are_chosen_data() {
        QTest::addColumn<QString>("post");
        QTest::addColumn<std::string>("wcs");
        QTest::addColumn<std::string>("says");
        const auto row = [](const char* post, const char* wcs, const char* says) {
            QTest::addRow("%s %s", post, wcs) << post << std::string(wcs) << std::string(says);
        };
        row("fanuc", "G57", "G57");
        row("siemens", "G55", "G55");
        row("linuxcnc", "G59.3", "G59.3");
        row("marlin", "G59.1", "\nG59.1\n");
        for (const char* post : {"heidenhain", "heidenhain-vectors"}) {
            row(post, "0", " CYCL DEF 247 DATUM SETTING ~\r\n    Q339=+0 ;DATUM NUMBER\r\n4 ");
            row(post, "407", " CYCL DEF 247 DATUM SETTING ~\r\n    Q339=+407 ;DATUM NUMBER\r\n4 ");
        }
    }
    /// Told once, and no other program is read as one for them.
    void work_coordinates_are_chosen() {
        QFETCH(QString, post);
        QFETCH(std::string, wcs);
        QFETCH(std::string, says);
        const Post& control = find_post(post.toStdString());
        const ClProgram program = joined_program({upright_section("One", 1)});
        PostSetup setup = setup_for(program, "generic-3-axis");
        setup.wcs = wcs;
        const std::string text = post_program(program, control, setup, {}).text;
        QVERIFY2(text.find(says) != std::string::npos, text.substr(0, 300).c_str());
        NcSetup read = reading(program, setup);
        const auto refusal = [&](const std::string& of, const std::string& wanted) {
            std::string message;
            read.wcs = wanted;
            const std::string code = code_of([&] { read_nc(of, "p", control, read, {}); }, &message);
            return code == "none" ? code : message;
        };
        QCOMPARE(refusal(text, wcs), std::string("none"));
        QVERIFY(refusal(text, "G54").find("the part stands in G54") != std::string::npos);
        setup.wcs.clear();
        const std::string plain = post_program(program, control, setup, {}).text;
        QCOMPARE(refusal(plain, ""), std::string("none"));
        QCOMPARE(plain.find("CYCL DEF 247"), std::string::npos);
        const std::string none =
            control.wcs_optional ? "no work coordinate system is chosen" : "stands in " + wcs;
        QVERIFY2(refusal(plain, wcs).find(none) != std::string::npos, refusal(plain, wcs).c_str());
        if (control.wcs_optional)
            QVERIFY(refusal(text, "").find("the project names none") != std::string::npos);
        if (control.wcs_lines.empty()) return;
        const std::string half = changed_text(text, "    Q339=+" + wcs + " ;DATUM NUMBER\r\n", "");
        QVERIFY(refusal(half, wcs).find("not whole") != std::string::npos);
        const std::string second = changed_text(text, "CYCL DEF 247 DATUM SETTING ~", "M9");
        QVERIFY(refusal(second, wcs).find("not whole") != std::string::npos);
    }

    void work_coordinates_that_are_not_there() {
        const auto refusal = [](const char* post, const char* wcs) {
            std::string message;
            const std::string code = code_of([&] { check_wcs(find_post(post), wcs); }, &message);
            return code == "none" ? std::string() : message;
        };
        for (const char* wcs : {"65536", "-1", "07", "7 ", "G54", "1.5", "99999999999999999999"})
            QVERIFY2(refusal("heidenhain", wcs).find("the numbers from 0 to 65535") != std::string::npos,
                     wcs);
        QVERIFY(refusal("marlin", "G59.4").find("G59.3") != std::string::npos);
        QVERIFY(refusal("fanuc", "G54.1").find("G54, G55") != std::string::npos);
        for (const char* wcs : {"", "0", "65535"})
            QVERIFY(refusal("heidenhain", wcs).empty());
    }

    void several_axes_keep_to_the_route_data() {
        QTest::addColumn<QString>("post");
        QTest::addColumn<QString>("machine");
        QTest::addColumn<double>("lean");
        QTest::addColumn<bool>("inch");
        for (const Post& p : posts())
            for (const char* machine : {"trunnion-ac", "trunnion-bc", "head-b-table-c", "tarus-tpi-2000"})
                for (const double lean : {0.2, 0.02})
                    if (p.multi_axis != Post::MultiAxis::none)
                        for (const bool inch : {false, true})
                            if (!inch || (lean == 0.2 && std::string_view(machine) == "trunnion-ac"))
                                QTest::addRow("%s %s %g%s", p.name.c_str(), machine, lean, inch ? " in" : "")
                                    << QString::fromStdString(p.name) << QString(machine) << lean << inch;
    }
    /// What the machine does between the blocks is as near to the verified route as was asked for; a program
    /// takes as long as the model says.
    void several_axes_keep_to_the_route() {
        QFETCH(QString, post);
        QFETCH(QString, machine);
        QFETCH(double, lean);
        QFETCH(bool, inch);
        const Post& control = find_post(post.toStdString());
        const ClProgram program =
            joined_program({leaning_section("Lean", 1, lean)}, inch ? LengthUnit::inch : LengthUnit::mm);
        const ClSection& section = *program.sections.front();
        const PostSetup setup = setup_for(program, machine.toStdString());
        const PostedProgram posted = post_program(program, control, setup, {});
        const NcProgram read = read_nc(posted.text, "p", control, reading(program, setup), {});
        QCOMPARE(read.sections.size(), std::size_t(1));
        const auto& motions = read.sections.front()->motions.motions;
        double farthest = 0;
        std::size_t first = 0, last = motions.size() - 1;
        while (motions[first].kind == MotionKind::rapid)
            ++first;
        while (motions[last].kind == MotionKind::rapid)
            --last;
        for (std::size_t i = first; i <= last; ++i)
            if (motions[i].kind != MotionKind::rapid)
                farthest = std::max(farthest, distance_to_route(motions[i].to.tip, section));
        QVERIFY2(farthest < setup.tip_tolerance + 0.001, qPrintable(QString::number(farthest)));
        // Every place of the program is there with its axis, in order.
        std::size_t at = 0;
        for (const Motion& m : section.motions.motions) {
            while (at < motions.size()
                   && ((motions[at].to.tip - m.to.tip).norm() > 0.001
                       || (motions[at].to.axis - m.to.axis).norm() > 1e-5))
                ++at;
            QVERIFY2(at < motions.size(), "a place is missing");
        }
        const double model = motion_totals(section, setup.machine).time_seconds;
        // How an axis is held that is told as a vector, the control chooses.
        const double share = control.multi_axis == Post::MultiAxis::vectors ? 0.05 : 1e-3;
        QVERIFY2(std::abs(read.seconds - posted.seconds) < share * model,
                 qPrintable(QString("%1 s, the post %2 s").arg(read.seconds).arg(posted.seconds)));
        QVERIFY2(posted.rewinds > 0 || std::abs(read.seconds - model) < share * model,
                 qPrintable(QString("%1 s, the model %2 s").arg(read.seconds).arg(model)));
    }

    /// A control that knows no shorter blocks is given longer ones, and the time says so.
    void blocks_of_their_own_time_are_not_too_short() {
        const Post control = parse_post(
            linuxcnc_with("\"largest_tool\"", "\"largest_inverse_time\": 150, \"largest_tool\""), "own.json");
        const ClProgram program = joined_program({leaning_section("Lean", 1)});
        const PostSetup setup = setup_for(program, "trunnion-ac");
        const PostedProgram usual = post_program(program, find_post("linuxcnc"), setup, {}),
                            posted = post_program(program, control, setup, {});
        const auto largest = [](const std::string& text) {
            double most = 0;
            for (std::size_t at = 0; (at = text.find(" F", at)) != std::string::npos; ++at)
                most = std::max(most, std::atof(text.c_str() + at + 2));
            return most;
        };
        QVERIFY(largest(usual.text) > 200);
        QVERIFY(std::abs(largest(posted.text) - 150) < 1e-9);
        QVERIFY(posted.seconds > usual.seconds);
        const NcProgram read = read_nc(posted.text, "p", control, reading(program, setup), {});
        QVERIFY2(std::abs(read.seconds - posted.seconds) < 1e-3 * posted.seconds,
                 qPrintable(QString("%1 %2").arg(read.seconds).arg(posted.seconds)));
    }

    /// Two angles hold any axis, and a machine that is asked to hold the plane stands as it does for the
    /// axis; where a table's C and A do it, they are the angles themselves.
    void planes_are_what_the_machine_holds() {
        std::mt19937_64 rng(8);
        std::normal_distribution<double> any;
        for (const char* name : {"trunnion-ac", "trunnion-bc", "head-b-table-c", "tarus-tpi-2000"}) {
            const Kinematics kinematics(find_machine(name), 100, Vec3(3, 4, 5));
            for (int n = 0; n < 2000; ++n) {
                const Vec3 axis = Vec3(any(rng), any(rng), 0.5 + std::abs(any(rng))).normalized();
                const TiltedPlane plane = plane_across(axis);
                QVERIFY((plane.axis() - axis).norm() < 1e-12);
                QVERIFY((plane.frame() * plane.frame().transpose() - Mat3::Identity()).norm() < 1e-12);
                QVERIFY(std::abs(plane.frame().col(0).z()) == 0 && plane.frame().determinant() > 0);
                const auto asked = kinematics.inverse({Vec3::Zero(), axis}, {}),
                           held = kinematics.inverse({Vec3::Zero(), plane.axis()}, {});
                QCOMPARE(held.count, asked.count);
                for (int k = 0; k < held.count; ++k)
                    for (std::size_t r = 0; r < 2; ++r) {
                        const double a = held.at[std::size_t(k)].rotary[r];
                        QVERIFY(std::abs(std::remainder(a - asked.at[std::size_t(k)].rotary[r], 2 * pi))
                                < 1e-9);
                        if (std::string_view(name) != "trunnion-ac") continue;
                        const double angle = r == 0 ? plane.about_x : plane.about_z;
                        const double off = std::min(std::abs(std::remainder(a - angle, pi)),
                                                    std::abs(std::remainder(a + angle, pi)));
                        QVERIFY(off < 1e-9);
                    }
            }
        }
    }

    void inclined_planes_are_tilted_data() {
        QTest::addColumn<QString>("post");
        QTest::addColumn<QString>("machine");
        for (const Post& p : posts())
            for (const char* machine : {"trunnion-ac", "trunnion-bc", "head-b-table-c", "tarus-tpi-2000"})
                if (p.has_planes())
                    QTest::addRow("%s %s", p.name.c_str(), machine)
                        << QString::fromStdString(p.name) << QString(machine);
    }
    /// Two operations that lean one way each, and one that does not: every place where it was, to the last
    /// digit, with its axis; a vector or an angle nowhere but on the way there.
    void inclined_planes_are_tilted() {
        QFETCH(QString, post);
        QFETCH(QString, machine);
        const Post& control = find_post(post.toStdString());
        ClSection left = indexed_section("Left", 1, Vec3(-0.4, 0.3, 1));
        // As a face of a mesh in single precision leans.
        for (std::size_t i = 0; i < left.motions.motions.size(); ++i)
            left.motions.motions[i].to.axis =
                (left.motions.motions[i].to.axis + 2e-7 * Vec3(double(i % 7), double(i % 5), 0)).normalized();
        const ClProgram program = joined_program(
            {left, indexed_section("Right", 2, Vec3(0.2, 0.6, 1)), leaning_section("Lean", 3)});
        const PostSetup setup = setup_for(program, machine.toStdString());
        const PostedProgram posted = post_program(program, control, setup, {});
        QCOMPARE(posted.planes, std::size_t(2));
        const NcProgram read = read_nc(posted.text, "p", control, reading(program, setup), {});
        QCOMPARE(read.blocks, posted.blocks);
        QCOMPARE(read.sections.size(), std::size_t(3));
        for (std::size_t i = 0; i < 2; ++i) {
            const auto& motions = read.sections[i]->motions.motions;
            std::size_t at = 0;
            for (const Motion& m : program.sections[i]->motions.motions) {
                while (at < motions.size()
                       && !((motions[at].to.tip - m.to.tip).cwiseAbs().maxCoeff() < 0.0001
                            && (motions[at].to.axis - m.to.axis).norm() < 5e-6))
                    ++at;
                QVERIFY2(at < motions.size(), "a place is missing");
            }
        }
    }

    void tilted_planes_that_are_refused_data() {
        QTest::addColumn<QString>("post");
        QTest::addColumn<std::string>("from");
        QTest::addColumn<std::string>("to");
        QTest::addColumn<std::string>("says");
        const auto row = [](const char* post, const char* from, const char* to, const char* says) {
            QTest::addRow("%s: %s", post, from)
                << post << std::string(from) << std::string(to) << std::string(says);
        };
        row("fanuc", "G53.1", "G17", "have not turned to it");
        row("fanuc", "G69", "G17", "in a tilted plane");
        row("fanuc", "J21.8", "J-21.8", "do not stand where");
        row("fanuc", "J21.8", "J20.8", "do not stand where");
        row("fanuc", "K0.", "K1.", "G68.2");
        row("fanuc", "G68.2", "G17 (", "there is none");
        row("fanuc", "G43 H1 ", "", "length is not called");
        row("fanuc", "G43 H1 ", "G43.4 H1 ", "led in a tilted plane");
        row("heidenhain", "PLANE SPATIAL", "PLANE EULER", "PLANE");
        row("heidenhain", "PLANE RESET STAY", "M9", "in a tilted plane");
        row("heidenhain", "SPA+", "SPA-", "do not stand where");
        row("siemens", "CYCLE800()", "M9", "in a tilted plane");
        row("siemens", "100000,27", "100000,57", "CYCLE");
    }
    void tilted_planes_that_are_refused() {
        QFETCH(QString, post);
        QFETCH(std::string, from);
        QFETCH(std::string, to);
        QFETCH(std::string, says);
        const Post& control = find_post(post.toStdString());
        const ClProgram program = joined_program({indexed_section("One", 1, Vec3(0, -0.4, 1))});
        const PostSetup setup = setup_for(program, "trunnion-ac");
        std::string text = post_program(program, control, setup, {}).text;
        // What ends a plane stands at the start, too.
        QVERIFY(text.find(from) != std::string::npos);
        text.replace(text.rfind(from), from.size(), to);
        if (to.back() == '(') text.insert(text.find(control.line_end, text.find(to)), ")");
        std::string message;
        QVERIFY(code_of([&] { read_nc(text, "p", control, reading(program, setup), {}); }, &message)
                != "none");
        QVERIFY2(message.find("p:") == 0 && message.find(says) != std::string::npos, message.c_str());
    }

    /// The axis passes the pole of the machine at 0.5 degrees, in one motion: C turns by half a turn
    /// meanwhile, the tool does not leave its route, and the program goes on from there.
    void beside_the_pole_data() {
        QTest::addColumn<QString>("post");
        QTest::newRow("joints") << "linuxcnc";
        QTest::newRow("tcp") << "fanuc";
    }
    void beside_the_pole() {
        QFETCH(QString, post);
        ClSection section = plain_section("Past", 1, true);
        section.motions.clearance_z = 30;
        const auto axis = [](double x) { return Vec3(0.02 * x, 0.009, 1); };
        add_motion(section, MotionKind::rapid, Vec3(-20, 0, 30), axis(-20));
        add_motion(section, MotionKind::approach, Vec3(-20, 0, 0), axis(-20));
        for (const double x : {-10.0, -5.0, 6.0, 10.0, 20.0})
            add_motion(section, MotionKind::cut, Vec3(x, 0, 0), axis(x));
        add_motion(section, MotionKind::retract, Vec3(20, 0, 30), axis(20));
        const ClProgram program = joined_program({section});
        const PostSetup setup = setup_for(program, "trunnion-ac");
        const Post& control = find_post(post.toStdString());
        const PostedProgram posted = post_program(program, control, setup, {});
        QCOMPARE(posted.rewinds, std::size_t(0));
        const NcProgram read = read_nc(posted.text, "p", control, reading(program, setup), {});
        for (const Motion& m : read.sections.front()->motions.motions)
            if (m.kind != MotionKind::rapid) {
                QVERIFY(distance_to_route(m.to.tip, section) < setup.tip_tolerance + 0.001);
                const double off = angle_between(m.to.axis, axis(m.to.tip.x()).normalized());
                QVERIFY2(off < 2 * control.axis_tolerance, qPrintable(QString::number(degrees(off))));
            }
    }

    void a_table_that_ends_is_rewound_data() {
        QTest::addColumn<QString>("post");
        for (const char* post : {"linuxcnc", "fanuc", "heidenhain"})
            QTest::newRow(post) << post;
    }
    /// Round and round a dome with a table that ends after a turn: the tool goes out along its axis, up,
    /// comes again with the table turned back, and goes on where it was. Nothing turns inside part and stock.
    void a_table_that_ends_is_rewound() {
        QFETCH(QString, post);
        ClSection section = plain_section("Round", 1, true);
        section.motions.clearance_z = 30;
        const auto axis = [](double a) { return Vec3(0.4 * std::cos(a), 0.4 * std::sin(a), 1); };
        const auto tip = [](double a) { return Vec3(15 * std::cos(a), 15 * std::sin(a), -0.1 * a); };
        add_motion(section, MotionKind::rapid, tip(0) + 40 * axis(0), axis(0));
        add_motion(section, MotionKind::approach, tip(0), axis(0));
        const double end = 5 * pi, step = 0.1;
        for (double a = step; a < end; a += step)
            add_motion(section, MotionKind::cut, tip(a), axis(a));
        add_motion(section, MotionKind::retract, tip(end) + 40 * axis(end), axis(end));
        const ClProgram program = joined_program({section});
        PostSetup setup = setup_for(program, "trunnion-ac");
        setup.keep_clear = section.part_box;
        setup.machine.rotary[1].travel = {-1.2 * pi, 1.2 * pi};
        const Post& control = find_post(post.toStdString());
        const PostedProgram posted = post_program(program, control, setup, {});
        QVERIFY(posted.rewinds >= 1 && posted.rewinds <= 4);
        const NcProgram read = read_nc(posted.text, "p", control, reading(program, setup), {});
        QCOMPARE(read.blocks, posted.blocks);
        // Out, up, over and in again are in the time, here and there.
        QVERIFY2(std::abs(read.seconds - posted.seconds) < 1e-3 * posted.seconds,
                 qPrintable(QString("%1 %2").arg(read.seconds).arg(posted.seconds)));
        QVERIFY(posted.seconds > motion_totals(section, setup.machine).time_seconds);
        const auto& motions = read.sections.front()->motions.motions;
        std::size_t at = 0;
        for (const Motion& m : section.motions.motions) {
            while (at < motions.size()
                   && ((motions[at].to.tip - m.to.tip).norm() > 0.001
                       || (motions[at].to.axis - m.to.axis).norm() > 1e-5))
                ++at;
            QVERIFY2(at < motions.size(), "a place is missing");
        }
        const auto in_stock = [&](const Vec3& p) {
            return (p - setup.keep_clear.lo).minCoeff() > 0 && (setup.keep_clear.hi - p).minCoeff() > 0;
        };
        for (std::size_t i = 1; i < motions.size(); ++i) {
            const CutterLocation &from = motions[i - 1].to, &to = motions[i].to;
            const bool inside = in_stock(from.tip) && in_stock(to.tip);
            if (motions[i].kind == MotionKind::rapid)
                QVERIFY2(!inside, qPrintable(QString("motion %1").arg(i)));
            else if (inside)
                QVERIFY(angle_between(from.axis, to.axis) < 1.5 * step * 0.4);
        }
    }

    void what_no_machine_could_run_data() {
        QTest::addColumn<int>("fault");
        QTest::addColumn<std::string>("says");
        QTest::newRow("several axes") << 0 << std::string("three axes");
        QTest::newRow("travel") << 1 << std::string("travel ends");
        QTest::newRow("feed") << 2 << std::string("feed");
        QTest::newRow("wcs") << 3 << std::string("G54");
        QTest::newRow("tool number") << 4 << std::string("tool 256");
        QTest::newRow("program number") << 5 << std::string("program number");
        QTest::newRow("two tools") << 6 << std::string("cannot change tools");
        QTest::newRow("no rotary axes") << 7 << std::string("no rotary axis");
        QTest::newRow("axis") << 8 << std::string("too early");
    }
    void what_no_machine_could_run() {
        QFETCH(int, fault);
        QFETCH(std::string, says);
        std::vector<ClSection> sections = {upright_section("One", 1)};
        std::string post = "grbl", machine = "generic-3-axis";
        if (fault == 0) sections = {leaning_section("One", 1)}, machine = "trunnion-ac";
        if (fault == 1) machine = "trunnion-ac";
        if (fault == 2) sections[0].feed_mm_per_min = 20000;
        if (fault == 4) sections[0].tool_number = 256;
        if (fault == 6) sections.push_back(upright_section("Two", 2));
        if (fault >= 7) sections = {leaning_section("One", 1)}, post = "linuxcnc";
        if (fault == 8) {
            machine = "trunnion-ac";
            for (Motion& m : sections[0].motions.motions)
                m.to.tip.x() += 400;
        }
        const ClProgram program = joined_program(sections);
        PostSetup setup = setup_for(program, machine);
        if (fault == 1) setup.part_origin.x() += 340;
        if (fault == 3) setup.wcs = "G60";
        if (fault == 5) setup.program_number = 100000;
        std::string message;
        QCOMPARE(code_of([&] { post_program(program, find_post(post), setup, {}); }, &message),
                 std::string("out_of_range"));
        QVERIFY2(message.find(says) != std::string::npos, message.c_str());
    }

    /// A program that was broken off may have left the tip led, or a plane tilted.
    void programs_begin_with_nothing_left_on_data() {
        QTest::addColumn<QString>("post");
        QTest::addColumn<std::string>("tip_off");
        QTest::addColumn<std::string>("plane_off");
        QTest::newRow("LinuxCNC") << "linuxcnc-tcp" << std::string("\nM429\n") << std::string();
        QTest::newRow("Fanuc") << "fanuc" << std::string(" G49\n") << std::string(" G69\n");
        QTest::newRow("Siemens") << "siemens" << std::string(" TRAFOOF\r") << std::string(" CYCLE800()\r");
        QTest::newRow("Heidenhain") << "heidenhain" << std::string(" M129\r")
                                    << std::string(" PLANE RESET STAY\r");
    }
    void programs_begin_with_nothing_left_on() {
        QFETCH(QString, post);
        QFETCH(std::string, tip_off);
        QFETCH(std::string, plane_off);
        const Post& control = find_post(post.toStdString());
        const auto start = [&](const ClSection& section, const char* machine) {
            const ClProgram program = joined_program({section});
            const std::string text = post_program(program, control, setup_for(program, machine), {}).text;
            return text.substr(0, text.find("tool 1"));
        };
        const std::string leaning = start(leaning_section("One", 1), "trunnion-ac"),
                          tilted = start(indexed_section("One", 1, Vec3(0, -0.4, 1)), "trunnion-ac"),
                          upright = start(upright_section("One", 1), "generic-3-axis");
        for (const std::string& text : {leaning, tilted})
            QVERIFY2(text.find(tip_off) != std::string::npos, text.c_str());
        QVERIFY2(upright.find(tip_off) == std::string::npos, upright.c_str());
        if (plane_off.empty()) return;
        QVERIFY2(tilted.find(plane_off) != std::string::npos, tilted.c_str());
        QVERIFY(leaning.find(plane_off) == std::string::npos);
    }

    /// Through whole turns: a table whose display begins anew at 360 degrees must not go back for it.
    void heidenhain_takes_the_shorter_way() {
        for (const char* post : {"heidenhain", "heidenhain-vectors"}) {
            const ClProgram program = joined_program({leaning_section("One", 1)});
            const PostedProgram posted =
                post_program(program, find_post(post), setup_for(program, "trunnion-ac"), {});
            QVERIFY(posted.text.find(" M126\r\n") < posted.text.find(" L A"));
        }
    }

    /// One word of a led tip moves several axes of the machine: where these do not arrive together it is no
    /// rapid.
    void one_word_of_a_led_tip_can_move_all_axes() {
        ClSection section = leaning_section("One", 1);
        const CutterLocation last = section.motions.motions.back().to;
        add_motion(section, MotionKind::rapid, last.tip + Vec3(0, 0, 9), last.axis);
        const ClProgram program = joined_program({section});
        const PostSetup setup = setup_for(program, "trunnion-ac");
        const auto led = [&](const char* post) {
            const std::string text = post_program(program, find_post(post), setup, {}).text;
            read_nc(text, "p", find_post(post), reading(program, setup), {});
            const std::size_t at = text.rfind("Z39"), begin = text.rfind('\n', at) + 1;
            return text.substr(begin, text.find('\n', at) - begin);
        };
        QCOMPARE(led("haas").substr(0, 6), std::string("Z39. F"));
        QCOMPARE(led("linuxcnc-tcp"), std::string("G0 Z39"));
    }

    /// As the 30i has its format: the block that switches G43.5 on has places and no vector, those after it
    /// both.
    void fanuc_leads_by_vectors_from_the_second_block_on() {
        const ClProgram program = joined_program({leaning_section("One", 1)});
        const std::string text =
            post_program(program, find_post("fanuc-vectors"), setup_for(program, "trunnion-ac"), {}).text;
        const std::size_t on = text.find("G43.5"), next = text.find('\n', on),
                          after = text.find(" G1 ", next);
        QVERIFY(text.substr(on, next - on).find(" I") == std::string::npos);
        QVERIFY(text.substr(after, text.find('\n', after) - after).find(" K0.") != std::string::npos);
    }

    void the_program_number_stands_first() {
        const ClProgram program = joined_program({upright_section("One", 1)});
        const PostSetup setup = setup_for(program, "generic-3-axis");
        QCOMPARE(post_program(program, find_post("fanuc"), setup, {}).text.substr(0, 19),
                 std::string("%\nO1 (part)\nN10 G21"));
        QCOMPARE(post_program(program, find_post("heidenhain"), setup, {}).text.substr(0, 26),
                 std::string("0 BEGIN PGM P1 MM\r\n1 ; par"));
    }

    void a_rapid_never_combines_a_descent() {
        ClSection s = upright_section("One", 1);
        // Slanting down, as no operation of three axes does.
        add_motion(s, MotionKind::rapid, Vec3(0, 0, 12));
        add_motion(s, MotionKind::rapid, Vec3(5, 0, 8));
        add_motion(s, MotionKind::rapid, Vec3(9, 0, 12));
        const ClProgram program = joined_program({s});
        const PostSetup setup = setup_for(program, "generic-3-axis");
        const NcProgram read = read_nc(post_program(program, find_post("linuxcnc"), setup, {}).text, "p",
                                       find_post("linuxcnc"), reading(program, setup), {});
        const auto& motions = read.sections.front()->motions.motions;
        for (std::size_t i = 1; i < motions.size(); ++i) {
            const Vec3 step = motions[i].to.tip - motions[i - 1].to.tip;
            if (motions[i].kind == MotionKind::rapid && step.z() < -1e-9)
                QVERIFY(step.head<2>().norm() < 1e-9);
        }
        const double model = motion_totals(s, setup.machine).time_seconds;
        QVERIFY(std::abs(read.seconds - model) < 1e-3 * model);
    }
};

FACETMILL_TEST(TestPosts)
#include "test_posts.moc"
