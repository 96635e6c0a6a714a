// Posted programs before the judge: what is read back is judged as the plan was, and faults are found.
#include "core/base/file.h"
#include "core/job/posting.h"
#include "core/job/program_files.h"
#include "core/job/setup_sheet.h"
#include "core/job/stock_solid.h"
#include "core/job/work_zero.h"
#include "core/mesh/mesh_io.h"
#include "tests/support/error_code.h"
#include "tests/support/test_runner.h"

#include <QTemporaryDir>
#include <QTest>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <fstream>
#include <functional>
#include <regex>

using namespace facetmill;
using facetmill::test::code_of;
namespace fs = std::filesystem;

namespace {

/// A sheet over 24 x 16 mm with this height, in steps of so many millimetres along X and Y.
std::string sheet_text(const std::function<double(double, double)>& height, double along, double across) {
    std::string text = "solid sheet\n";
    const auto corner = [&](int i, int k) {
        const double x = -12 + along * i, y = -8 + across * k;
        return " vertex " + std::to_string(x) + " " + std::to_string(y) + " " + std::to_string(height(x, y));
    };
    const auto facet = [&](const std::string& corners) {
        text += "facet normal 0 0 0 outer loop" + corners + " endloop endfacet\n";
    };
    for (int i = 0; i < int(24 / along); ++i)
        for (int k = 0; k < int(16 / across); ++k) {
            facet(corner(i, k) + corner(i + 1, k) + corner(i + 1, k + 1));
            facet(corner(i, k) + corner(i + 1, k + 1) + corner(i, k + 1));
        }
    return text + "endsolid sheet\n";
}
std::string saddle_text() {
    return sheet_text([](double x, double y) { return 0.01 * (x * x - y * y); }, 2, 2);
}
/// Part of a cylinder.
std::string trough_text() {
    return sheet_text([](double x, double) { return 30 - std::sqrt(900 - x * x); }, 0.5, 16);
}

/// A job that was planned once, and its verdict.
struct PostedJob {
    QTemporaryDir dir;
    Project project;
    Planner planner;
    std::shared_ptr<const PlanResult> plan;
    Verification planned;

    PostedJob(const std::string& machine, const std::string& operations,
              const std::string& part = saddle_text()) {
        const fs::path folder = dir.path().toStdString();
        std::ofstream(folder / "part.stl") << part;
        project =
            parse_project(R"({ "facetmill": 1, "units": "mm", "part": { "file": "part.stl" }, "machine": ")"
                              + machine + R"(", "post": "linuxcnc", "programs": "one", "arcs": false,
  "stock": { "kind": "box", "margin": [1, 1, 1] },
  "tools": [ { "number": 1, "name": "Ball", "diameter": 6, "corner_radius": 3, "flute_length": 20, "shank_diameter": 6,
               "shank_length": 20, "holder": [ { "diameter": 20, "length": 30 } ] } ],
  "operations": [ )" + operations
                              + "] }",
                          "p");
        project.path = folder / "p.facetmill";
        plan = planner.plan(project, "", {});
        planned = judge(verify_programs(project, plan), verify_settings(project, plan.get()));
    }
    std::string posted(const std::string& post = "linuxcnc", bool arcs = false) {
        project.programs.post = post;
        project.programs.arcs = arcs;
        const std::string text = post_plan(project, *plan, {}).at(0).program.text;
        project.programs.arcs = false;
        return text;
    }

    Verification judge(const std::vector<VerifyProgram>& programs, VerifySettings settings) const {
        settings.resolution = 0.7;
        return verify(*plan->part->mesh, stock_solid(project.stock, *plan->part), programs, settings, {});
    }
    Verification judge_text(const std::string& text) const {
        const Post post = project_post(project, project.programs.post);
        return judge(parse_posted(project, *plan->part, post, text, "p.ngc", {}).programs,
                     verify_settings(project, plan.get()));
    }
};

const char* const ball_rows =
    R"({ "kind": "finish3", "name": "Rows", "tool": 1, "tolerance": 0.05, "feed": 800, "clearance": 4 })";
const char* const trough_rows =
    R"({ "kind": "finish3", "name": "Rows", "tool": 1, "tolerance": 0.1, "direction": "x", "feed": 800,
         "clearance": 4 })";
const char* const ball_columns =
    R"({ "kind": "finish3", "name": "Columns", "tool": 1, "tolerance": 0.1, "direction": "y", "clearance": 4 })";
const char* const leaning_rows =
    R"({ "kind": "finish5", "name": "Lean", "tool": 1, "tolerance": 0.1, "direction": "x", "clearance": 4 })";

/// Planned when first asked for.
PostedJob& upright_job() {
    static PostedJob job("generic-3-axis", ball_rows);
    return job;
}
PostedJob& trough_job() {
    static PostedJob job("generic-3-axis", trough_rows, trough_text());
    return job;
}
PostedJob& leaning_job() {
    static PostedJob job("trunnion-ac", leaning_rows);
    return job;
}
/// The tool leans one way all along.
PostedJob& face_job() {
    static PostedJob job(
        "trunnion-ac",
        R"({ "kind": "finish5", "name": "Face", "tool": 1, "tolerance": 0.1, "posture": "cm2", "grid_degrees": 15,
                              "direction": "x", "clearance": 4 })",
        sheet_text([](double, double y) { return 0.4 * y; }, 24, 16));
    return job;
}
PostedJob& head_job() {
    static PostedJob job("tarus-tpi-2000", leaning_rows);
    return job;
}

using Edit = std::function<void(std::string&)>;

/// Replaces the first place behind `after`; a test that finds none is wrong.
Edit swap_text(const std::string& from, const std::string& to, const std::string& after = "") {
    return [=](std::string& text) {
        const auto at = text.find(from, after.empty() ? 0 : text.find(after));
        if (at == std::string::npos) qFatal("the program has no '%s'", from.c_str());
        text.replace(at, from.size(), to);
    };
}

/// Changes every number of a word.
Edit change_numbers(char word, const std::function<double(double)>& change) {
    return [=](std::string& text) {
        std::string out;
        std::size_t i = 0;
        bool comment = false;
        while (i < text.size()) {
            comment = text[i] == '(' || (comment && text[i] != '\n');
            out += text[i];
            if (text[i++] != word || comment || i >= text.size() || !std::strchr("-.0123456789", text[i]))
                continue;
            std::size_t used = 0;
            const double v = std::stod(text.substr(i, 24), &used);
            out += QString::number(change(v), 'f', 5).toStdString();
            i += used;
        }
        text = out;
    };
}

Edit exchange(char a, char b) {
    return [=](std::string& text) {
        bool comment = false;
        for (char& c : text) {
            comment = c == '(' || (comment && c != '\n');
            if (comment) continue;
            if (c == a)
                c = b;
            else if (c == b)
                c = a;
        }
    };
}

Edit exchange_texts(const std::string& a, const std::string& b) {
    return [=](std::string& text) {
        for (std::size_t at = 0; at + a.size() <= text.size(); ++at)
            if (text.compare(at, a.size(), a) == 0)
                text.replace(at, a.size(), b);
            else if (text.compare(at, b.size(), b) == 0)
                text.replace(at, b.size(), a);
    };
}

Edit lose_words(char word) {
    return [=](std::string& text) {
        for (std::size_t at = 0; (at = text.find(std::string(" ") + word, at)) != std::string::npos;)
            text.erase(at, text.find_first_of(" \n", at + 1) - at);
    };
}

/// The block of the n-th line that begins with `word` loses it, or goes.
Edit lose(const std::string& word, int n, bool whole) {
    return [=](std::string& text) {
        std::size_t at = 0;
        for (int k = 0; k < n; ++k) {
            at = text.find("\n" + word, at + 1);
            if (at == std::string::npos) qFatal("the program has no more '%s'", word.c_str());
        }
        const std::size_t end = whole ? text.find('\n', at + 1) : at + 1 + word.size();
        text.erase(at + 1, end - at - (whole ? 0 : 1));
    };
}

} // namespace

class TestPosting : public QObject {
    Q_OBJECT
private slots:
    void a_posted_program_is_judged_as_the_plan_data() {
        QTest::addColumn<QString>("post");
        QTest::addColumn<int>("job");
        QTest::addColumn<bool>("arcs");
        // One of each kind; every post reads back as it was written (test_posts).
        QTest::addRow("linuxcnc, three axes") << "linuxcnc" << 0 << false;
        QTest::addRow("grbl, three axes") << "grbl" << 0 << false;
        QTest::addRow("linuxcnc, three axes, arcs") << "linuxcnc" << 3 << true;
        for (const char* post : {"linuxcnc", "fanuc", "fanuc-vectors", "siemens"})
            QTest::addRow("%s, trunnion", post) << post << 1 << false;
        QTest::addRow("linuxcnc, head") << "linuxcnc" << 2 << false;
        for (const char* post : {"fanuc", "haas", "heidenhain", "siemens"})
            QTest::addRow("%s, tilted plane", post) << post << 4 << false;
    }
    void a_posted_program_is_judged_as_the_plan() {
        QFETCH(QString, post);
        QFETCH(int, job);
        QFETCH(bool, arcs);
        PostedJob& planned = job == 0   ? upright_job()
                             : job == 1 ? leaning_job()
                             : job == 2 ? head_job()
                             : job == 3 ? trough_job()
                                        : face_job();
        const std::string text = planned.posted(post.toStdString(), arcs);
        if (job == 4) QVERIFY(std::regex_search(text, std::regex("G68.2|G268|PLANE SPATIAL|CYCLE800")));
        QCOMPARE(text.find("G3 ") != std::string::npos, arcs);
        const Verification seen = planned.judge_text(text);
        const Verification& wanted = planned.planned;
        QCOMPARE(verdict_name(seen.verdict()), verdict_name(wanted.verdict()));
        QCOMPARE(verdict_name(seen.verdict()), std::string("verified"));
        QCOMPARE(seen.collisions.size(), wanted.collisions.size());
        // Half a digit of the program, and what the route may stray between two blocks.
        const double near = arcs ? 0.003 : 0.0015;
        QVERIFY2(std::abs(seen.figures.gouge_max - wanted.figures.gouge_max) < near,
                 qPrintable(QString("%1 %2").arg(seen.figures.gouge_max).arg(wanted.figures.gouge_max)));
        QVERIFY2(std::abs(seen.figures.excess_max - wanted.figures.excess_max) < 0.01,
                 qPrintable(QString("%1 %2").arg(seen.figures.excess_max).arg(wanted.figures.excess_max)));
    }

    /// Faults as they happen to posts and their users: each is refused with its line, or judged as what it
    /// is.
    void faults_are_found() {
        PostedJob &upright = upright_job(), &leaning = leaning_job(), &trough = trough_job();
        struct Fault {
            const char* name;
            PostedJob& job;
            Edit edit;
            bool arcs = false;
            const char* post = "linuxcnc";
        };
        const std::vector<Fault> faults = {
            {"tool length not called", upright, swap_text("G43 H1 ", "")},
            {"length of another tool", upright, swap_text("G43 H1 ", "G43 H2 ")},
            {"tool length counted twice", upright, change_numbers('Z', [](double z) { return z - 70; })},
            {"inches for mm", upright, swap_text("G21", "G20")},
            {"no unit", upright, swap_text("G21 ", "")},
            {"wrong work coordinates", upright, swap_text("G54", "G55")},
            {"no work coordinates", upright, swap_text("G54 ", "")},
            {"incremental", upright, swap_text("G90", "G91")},
            {"no feed", upright, lose_words('F')},
            {"G1 lost behind a rapid", upright, lose("G1 ", 1, false)},
            {"first retract lost", upright, lose("G53", 1, true)},
            {"spindle not started", upright, swap_text(" M3", "")},
            {"tool not changed", upright, swap_text(" M6", "")},
            {"unknown tool", upright, swap_text("T1 M6", "T7 M6")},
            {"X and Y exchanged", upright, exchange('X', 'Y')},
            {"Y mirrored", upright, change_numbers('Y', [](double y) { return 3 - y; })},
            {"decimal comma", upright, swap_text(".", ",", "G1")},
            {"cut short", upright, swap_text("M2\n", "")},
            {"a cycle", upright, swap_text("G1 Z", "G81 Z")},
            {"sign of A", leaning, change_numbers('A', [](double a) { return -a; })},
            {"sign of C", leaning, change_numbers('C', [](double c) { return -c; })},
            {"A and C exchanged", leaning, exchange('A', 'C')},
            {"a block without its time", leaning, swap_text(" F", " (", "G93")},
            {"rotary axes not brought to the start", leaning, lose("G0 A", 1, true)},
            {"arcs the other way round", trough, exchange_texts("G2 ", "G3 "), true},
            {"centre on the other side", trough, change_numbers('K', [](double k) { return -k; }), true},
            {"centre told as a place", trough, change_numbers('I', [](double i) { return i + 3; }), true},
            {"plane of arcs lost", trough, swap_text("G18 ", ""), true},
            {"tip not led, LinuxCNC", leaning, swap_text("M428", "M429"), false, "linuxcnc-tcp"},
            {"tip led without its length, LinuxCNC", leaning, swap_text("G43 H1", "G49"), false,
             "linuxcnc-tcp"},
            {"tip not led, Heidenhain", leaning, swap_text("M128", "M129"), false, "heidenhain"},
            {"tip not led, Fanuc", leaning, swap_text("G43.4 H1", "G43 H1"), false, "fanuc"},
            {"tip not led and no length, Fanuc", leaning, swap_text("G43.4 H1 ", ""), false, "fanuc"},
            {"tip not led, Haas", leaning, swap_text("G234 H1 ", ""), false, "haas"},
            {"vectors not switched on, Fanuc", leaning, swap_text("G43.5 H1", "G43.4 H1"), false,
             "fanuc-vectors"},
            {"tip not led, Siemens", leaning, swap_text("TRAORI", "TRAFOOF"), false, "siemens"},
            {"tip led too late, Heidenhain", leaning, swap_text("M129", "M128", "M128"), false, "heidenhain"},
            {"part off its place by 1 mm", leaning, change_numbers('Y', [](double y) { return y + 1; })},
        };
        QVERIFY(faults.size() >= 20);
        for (const Fault& f : faults) {
            QVERIFY(f.job.planned.passed());
            const std::string before = f.job.posted(f.post, f.arcs);
            std::string text = before;
            f.edit(text);
            QVERIFY2(text != before, f.name);
            bool passed = false;
            std::string message;
            const std::string code = code_of([&] { passed = f.job.judge_text(text).passed(); }, &message);
            QVERIFY2(code != "none" || !passed, f.name);
            if (code != "none")
                QVERIFY2(message.find("p.ngc") != std::string::npos, (f.name + (": " + message)).c_str());
        }
    }

    /// A machine whose pivot is elsewhere than the file says moves the tool off the part.
    void a_pivot_off_by_a_millimetre_is_found() {
        PostedJob& job = leaning_job();
        const std::string text = job.posted();
        std::string machine = find_machine("trunnion-ac").source;
        const std::string point = R"("point": [0, 0, 50])";
        machine.replace(machine.find(point), point.size(), R"("point": [0, 1, 51])");
        const fs::path folder = job.dir.path().toStdString();
        std::ofstream(folder / "own.json") << machine;
        job.project.machine = "own.json";
        const bool passed = job.judge_text(text).passed();
        job.project.machine = "trunnion-ac";
        QVERIFY(!passed);
    }

    void plans_write_posted_programs() {
        PostedJob& job = upright_job();
        job.project.programs.post = "grbl";
        const fs::path folder = fs::path(job.dir.path().toStdString()) / "out";
        job.project.programs.files = ProgramSpec::Files::each;
        write_plan(job.project, *job.plan, folder, {});
        QVERIFY(fs::exists(folder / "01-Rows.nc") && fs::exists(folder / "01-Rows.apt"));
        // What cannot be posted is told before anything is written.
        job.project.programs.wcs = "G99";
        std::string message;
        QCOMPARE(code_of([&] { write_plan(job.project, *job.plan, folder / "not", {}); }, &message),
                 std::string("out_of_range"));
        job.project.programs = {"linuxcnc", "", 1, ProgramSpec::Files::one};
        QVERIFY2(message.find("01-Rows.nc") == 0 && !fs::exists(folder / "not"), message.c_str());
    }

    /// Told from a zero elsewhere, programs say the same: read back they are the plan's, in the part's
    /// coordinates.
    void programs_count_from_the_work_zero_data() {
        QTest::addColumn<QString>("post");
        QTest::addColumn<int>("job");
        QTest::addRow("three axes") << "linuxcnc" << 0;
        QTest::addRow("three axes, arcs") << "linuxcnc" << 3;
        QTest::addRow("joints of a trunnion") << "linuxcnc" << 1;
        QTest::addRow("tip of a trunnion") << "fanuc" << 1;
        QTest::addRow("joints of a head") << "linuxcnc" << 2;
    }
    void programs_count_from_the_work_zero() {
        QFETCH(QString, post);
        QFETCH(int, job);
        PostedJob& j = job == 0   ? upright_job()
                       : job == 1 ? leaning_job()
                       : job == 2 ? head_job()
                                  : trough_job();
        const std::string before = j.posted(post.toStdString(), job == 3);
        j.project.programs.zero_from = ProgramSpec::ZeroFrom::stock;
        j.project.programs.zero_place = {-1, 0, 1};
        j.project.programs.zero = {0.5, 0, 0};
        const Vec3 zero = work_zero(j.project, *j.plan->part);
        const Box3 stock = j.plan->stock.box;
        QVERIFY((zero - Vec3(stock.lo.x() + 0.5, stock.center().y(), stock.hi.z())).norm() < 1e-12);
        const std::string after = j.posted(post.toStdString(), job == 3);
        const Post control = project_post(j.project, j.project.programs.post);
        const auto read = parse_posted(j.project, *j.plan->part, control, after, "p.ngc", {});
        const Verification v = j.judge(read.programs, verify_settings(j.project, j.plan.get()));
        j.project.programs.zero_from = ProgramSpec::ZeroFrom::origin;
        j.project.programs.zero = {0, 0, 0};
        const auto same = parse_posted(j.project, *j.plan->part, control, before, "p.ngc", {});
        QCOMPARE(j.posted(post.toStdString(), job == 3), before);
        QVERIFY(after != before);
        QCOMPARE(v.passed(), j.planned.passed());
        QCOMPARE(v.gouges.empty(), j.planned.gouges.empty());
        QCOMPARE(v.collisions.size(), j.planned.collisions.size());
        // The places of the part that it goes to; who takes the zero to be elsewhere is off by it.
        const auto box = [](const NcFilePrograms& programs) {
            Box3 b;
            for (const Motion& m : programs.sections.front()->motions.motions)
                if (m.kind != MotionKind::rapid) b.add(m.to.tip);
            return b;
        };
        QVERIFY((box(read).lo - box(same).lo).norm() < 0.01);
        QVERIFY((box(read).hi - box(same).hi).norm() < 0.01);
        if (job == 1) return;
        const auto elsewhere = parse_posted(j.project, *j.plan->part, control, after, "p.ngc", {});
        QVERIFY((box(elsewhere).lo + zero - box(same).lo).norm() < 0.01);
    }

    void the_work_zero_is_on_what_the_project_says() {
        Box3 part, stock;
        part.lo = Vec3(1, 2, 3);
        part.hi = Vec3(5, 4, 9);
        stock.lo = Vec3(0, 0, 3);
        stock.hi = Vec3(8, 8, 11);
        ProgramSpec spec;
        QCOMPARE(work_zero(spec, part, stock), Vec3(0, 0, 0));
        QCOMPARE(work_zero_text(spec, LengthUnit::mm), std::string("the part's origin"));
        spec.zero = {25.4, 0, -50.8};
        QCOMPARE(work_zero(spec, part, stock), Vec3(25.4, 0, -50.8));
        QCOMPARE(work_zero_text(spec, LengthUnit::inch), std::string("the part's origin + (1, 0, -2) in"));
        spec.zero = {0, 0, 0};
        spec.zero_place = {-1, 0, 1};
        spec.zero_from = ProgramSpec::ZeroFrom::part;
        QCOMPARE(work_zero(spec, part, stock), Vec3(1, 3, 9));
        spec.zero_from = ProgramSpec::ZeroFrom::stock;
        QCOMPARE(work_zero(spec, part, stock), Vec3(0, 4, 11));
        QCOMPARE(work_zero_text(spec, LengthUnit::mm), std::string("the stock's top, low X, middle of Y"));
        QCOMPARE(code_of([&] { work_zero(spec, part, Box3()); }), std::string("missing_reference"));
        const std::string file = R"({ "facetmill": 1, "units": "in", "part": { "file": "p.stl" },
            "zero_from": "stock", "zero_place": [-1, 0, 1], "zero": [0, 0, 0.5] })";
        const Project p = parse_project(file, "p");
        QCOMPARE(p.programs.zero[2], 12.7);
        QVERIFY(p.programs.zero_from == ProgramSpec::ZeroFrom::stock);
        QCOMPARE(project_to_json(parse_project(project_to_json(p), "p")), project_to_json(p));
    }

    /// One file for two operations with one tool: what is read back is theirs again, each motion named by the
    /// planned one that it is a piece of.
    void posted_programs_stand_for_those_of_the_plan() {
        PostedJob job("generic-3-axis", std::string(ball_rows) + "," + ball_columns);
        const PostedPrograms posted = posted_programs(job.project, job.plan, {});
        QCOMPARE(posted.programs.size(), std::size_t(2));
        QVERIFY(posted.remark.find("The posted program, ") == 0);
        for (std::size_t i = 0; i < 2; ++i) {
            const auto& read = posted.programs[i].motions->motions;
            const auto& planned = job.plan->operations[i]->program.motions.motions;
            QCOMPARE(posted.programs[i].name, job.plan->operations[i]->name);
            QCOMPARE(posted.planned[i].size(), read.size());
            QCOMPARE(posted.programs[i].lines.size(), read.size());
            QVERIFY(std::is_sorted(posted.planned[i].begin(), posted.planned[i].end()));
            QVERIFY(posted.planned[i].back() + 2 >= planned.size());
            for (std::size_t m = 0; m < read.size(); ++m)
                if (read[m].kind != MotionKind::rapid)
                    QVERIFY((planned[posted.planned[i][m]].to.tip - read[m].to.tip).norm() < 0.01);
        }
        QVERIFY(posted.programs[0].lines.back() < posted.programs[1].lines.front());
        Verification seen = job.judge(posted.programs, verify_settings(job.project, job.plan.get()));
        QVERIFY(seen.passed());
        seen.gouges.push_back({Vec3::Zero(), Vec3::UnitZ(), -1, {1, 5}});
        name_planned_motions(seen, posted);
        QCOMPARE(seen.gouges.back().by.motion, std::size_t(posted.planned[1][5]));
    }

    /// Told before hours are planned.
    void what_the_control_has_not_is_told_before_planning() {
        const auto message = [](const std::string& keys, const std::string& second = "") {
            const Project p = parse_project(
                R"({ "facetmill": 1, "units": "mm", "part": { "file": "p.stl" }, )" + keys
                    + R"(, "tools": [ { "number": 300, "name": "Ball", "diameter": 6, "corner_radius": 3 },
                                      { "number": 2, "name": "Flat", "diameter": 6 },
                                      { "number": 3, "name": "Flat 8", "diameter": 8 } ],
  "operations": [ { "kind": "finish3", "name": "Rows", "tool": 2 })"
                    + second + "] }",
                "p");
            std::string text;
            return code_of([&] { check_posting(p); }, &text) == "none" ? std::string() : text;
        };
        const std::string big = R"(, { "kind": "finish3", "name": "More", "tool": 300 })";
        QCOMPARE(message(R"("post": "grbl")"), std::string());
        QVERIFY(message(R"("post": "grbl", "wcs": "G60")").find("G60") != std::string::npos);
        QVERIFY(message(R"("post": "grbl", "program_number": 100000)").find("100000") != std::string::npos);
        QVERIFY(message(R"("post": "grbl")", big).find("tool 300") != std::string::npos);
        QVERIFY(message(R"("post": "grblhal", "programs": "one")", big).empty());
        QVERIFY(message(R"("post": "marlin", "wcs": "G54")").empty());
        QVERIFY(message(R"("post": "marlin", "wcs": "G60")").find("G59.3") != std::string::npos);
        QVERIFY(message(R"("post": "heidenhain", "wcs": "12")").empty());
        QVERIFY(message(R"("post": "heidenhain", "wcs": "G54")").find("numbers from 0 to 65535")
                != std::string::npos);
        QVERIFY(message(R"("post": "nowhere.json")").find("nowhere.json") != std::string::npos);
        QVERIFY(message(R"("post": "grbl")", R"(, { "kind": "finish5", "name": "Lean", "tool": 2 })")
                    .find("'Lean' inclines the tool, and the control has three axes")
                != std::string::npos);
        QVERIFY(message(R"("post": "grbl")",
                        R"(, { "kind": "finish3", "name": "Fast", "tool": 2, "feed": 99000 })")
                    .find("'Fast' has a feed of 99000 mm/min")
                != std::string::npos);
        QVERIFY(
            message(R"("post": "heidenhain")", R"(, { "kind": "lathe_finish", "name": "Turn", "tool": 2 })")
                .find("'Turn' turns the part, and the control has no inverse time feed")
            != std::string::npos);
        // The rework of an operation is a program of its own.
        const std::string two =
            R"(, { "kind": "global_local", "name": "GL", "tool": 2, "rework_tool": 3, "posture": "cm2" })";
        QVERIFY(message(R"("post": "haas", "program_number": 99997)", two).empty());
        QVERIFY(message(R"("post": "haas", "program_number": 99998)", two).find("100000")
                != std::string::npos);
        const std::string flat = R"(, { "kind": "finish3", "name": "More", "tool": 3 })";
        QVERIFY(message(R"("post": "grbl", "programs": "one")", flat).find("change tools")
                != std::string::npos);
    }

    /// What the person at the machine has to know before it starts: control, who leads the tip, zero, tools
    /// with their length, time, and how far each axis goes.
    void the_sheet_tells_of_each_program() {
        PostedJob& job = leaning_job();
        for (const bool tip : {true, false}) {
            const std::string text = job.posted(tip ? "fanuc" : "linuxcnc");
            const PostedProgram program = post_plan(job.project, *job.plan, {}).at(0).program;
            std::string sheet =
                setup_sheet(job.project, *job.plan, verify_programs(job.project, job.plan), job.planned, {});
            sheet = std::regex_replace(sheet, std::regex("<[^>]*>"), "|");
            const auto has = [&](const std::string& part) { return sheet.find(part) != std::string::npos; };
            QVERIFY(has(find_post(job.project.programs.post).label));
            QVERIFY(has(tip ? "|tip (TCP)|" : "|joints|") && has("G54, its zero in the part's origin"));
            QVERIFY(has("|T1 70 mm|") && has("|" + duration_text(program.seconds) + "|"));
            double low = infinity, high = -infinity;
            const std::regex word(" C(-?[0-9.]+)");
            for (std::sregex_iterator c(text.begin(), text.end(), word), end; c != end; ++c) {
                low = std::min(low, std::stod((*c)[1]));
                high = std::max(high, std::stod((*c)[1]));
            }
            std::smatch axes;
            QVERIFY(std::regex_search(
                sheet, axes,
                std::regex("X [-0-9.]+ \u2026 [^|]*, C ([-0-9.]+)\u00b0 \u2026 ([-0-9.]+)\u00b0")));
            QVERIFY(std::abs(std::stod(axes[1]) - low) < 0.06 && std::abs(std::stod(axes[2]) - high) < 0.06);
        }
    }

    void settings_reach_programs() {
        Project p = parse_project(
            R"({ "facetmill": 1, "units": "in", "part": { "file": "p.stl" }, "post": "linuxcnc" })", "p");
        apply_setting(p, "post=grbl");
        apply_setting(p, "zero=[0,0,1]");
        apply_setting(p, setup_at(p, 0).name + ".wcs=G55");
        QCOMPARE(p.programs.post, std::string("grbl"));
        QCOMPARE(p.programs.wcs, std::string("G55"));
        QCOMPARE(p.programs.zero[2], 25.4);
        const auto code = [&](const char* setting) { return code_of([&] { apply_setting(p, setting); }); };
        QCOMPARE(code("program_number=0"), std::string("out_of_range"));
        QCOMPARE(code("programs=some"), std::string("out_of_range"));
        QCOMPARE(code("post"), std::string("usage"));
        QCOMPARE(code("Below.post=grbl"), std::string("missing_reference"));
    }

    void the_project_file_has_its_keys() {
        const std::string start = R"({ "facetmill": 1, "units": "mm", "part": { "file": "p.stl" })";
        const Project p = parse_project(
            start
                + R"(, "post": "grbl", "wcs": "G55", "program_number": 7, "programs": "one", "arcs": false })",
            "p");
        QCOMPARE(p.programs, (ProgramSpec{"grbl", "G55", 7, ProgramSpec::Files::one, false}));
        QCOMPARE(project_to_json(parse_project(project_to_json(p), "p")), project_to_json(p));
        QVERIFY(project_to_json(parse_project(start + " }", "p")).find("post") == std::string::npos);
        QCOMPARE(code_of([&] { parse_project(start + R"(, "post": "nobody" })", "p"); }),
                 std::string("missing_reference"));
        QCOMPARE(code_of([&] { parse_project(start + R"(, "program_number": 0 })", "p"); }),
                 std::string("out_of_range"));
        QCOMPARE(code_of([&] { parse_project(start + R"(, "programs": "some" })", "p"); }),
                 std::string("out_of_range"));
    }
};

FACETMILL_TEST(TestPosting)
#include "test_posting.moc"
