// Jobs, machines and controls, one with another: LinuxCNC's interpreter accepts what is posted, and every
// place of the program is where the joints are. With FACETMILL_POSTS_TABLE=1 each is judged as well, and the
// table of core/output/README.md is printed.
#include "core/base/file.h"
#include "core/job/chain_verification.h"
#include "core/job/posting.h"
#include "core/job/stock_solid.h"
#include "core/job/verification.h"
#include "core/mesh/mesh_io.h"
#include "core/mesh/sample.h"
#include "core/output/motion_time.h"
#include "core/output/post/tilted_plane.h"
#include "tests/support/rs274.h"
#include "tests/support/test_runner.h"
#include "tests/support/trials.h"
#include "tests/unit/job/block_job.h"

#include <QTest>

#include <cmath>
#include <cstdio>
#include <fstream>
#include <regex>

using namespace facetmill;
using namespace facetmill::test;
namespace fs = std::filesystem;

namespace {

const char* const ball =
    R"([ { "number": 1, "name": "Ball", "diameter": 8, "corner_radius": 4, "flute_length": 30,
  "shank_diameter": 8, "shank_length": 30, "holder": [ { "diameter": 30, "length": 30 } ] } ])";

/// A job in a folder of its own, planned for a machine when first asked for.
class MachinedJob {
public:
    MachinedJob(const std::string& sample, double tolerance, const std::string& rest, double scale = 1) {
        const fs::path folder = dir_.path().toStdString();
        OutputFile file(folder / "part.stl");
        write_stl(*make_sample(sample, tolerance / scale, {}), file, LengthUnit::mm, {});
        file.commit();
        project_ = parse_project(
            R"({ "facetmill": 1, "units": "mm", "part": { "file": "part.stl", "units": "mm", "scale": )"
                + std::to_string(scale) + " }, " + rest + R"(, "tools": )" + ball + " }",
            "p");
        project_.path = folder / "p.facetmill";
    }
    /// A golden job that has its part beside it.
    explicit MachinedJob(const char* job) { project_ = load_project(data_path(job)); }
    /// One whose part is a sample in inches.
    MachinedJob(const char* job, const char* sample, double tolerance) {
        const fs::path folder = dir_.path().toStdString();
        OutputFile file(folder / "part.stl");
        write_stl(*make_sample(sample, tolerance * mm_per_inch, {}), file, LengthUnit::inch, {});
        file.commit();
        project_ = load_project(data_path(job));
        project_.path = folder / "job.facetmill";
    }
    /// A face of 40 x 30 mm that leans by 25 degrees, in inches.
    struct Face {};
    explicit MachinedJob(Face) {
        const fs::path folder = dir_.path().toStdString();
        std::ofstream(folder / "part.stl") << face();
        project_ = parse_project(
            R"({ "facetmill": 1, "units": "in", "part": { "file": "part.stl", "units": "mm" },
  "stock": { "kind": "box", "margin": [0.1, 0.1, 0.1] }, "tools": [ { "number": 1, "name": "Ball", "diameter": 0.3,
      "corner_radius": 0.15, "flute_length": 1.2, "shank_diameter": 0.3, "shank_length": 1.2,
      "holder": [ { "diameter": 1, "length": 1 } ] } ],
  "operations": [ { "kind": "finish5", "name": "Face", "tool": 1, "tolerance": 0.02, "direction": "x", "posture": "cm2", "grid_degrees": 15,
                    "clearance": 0.3, "feed": 40 } ] })",
            "p");
        project_.path = folder / "p.facetmill";
    }
    const Project& project(const std::string& machine, const std::string& post, bool one, bool arcs) {
        project_.machine = machine;
        project_.programs.post = post;
        project_.programs.arcs = arcs;
        project_.programs.files = one ? ProgramSpec::Files::one : ProgramSpec::Files::each;
        return project_;
    }
    /// Three axes go anywhere as they were planned first.
    std::shared_ptr<const PlanResult> plan() {
        if (!plan_ || plan_->operations.front()->program.multi_axis) plan_ = planner_.plan(project_, "", {});
        return plan_;
    }

private:
    static std::string face() {
        const auto corner = [](double x, double y) {
            return " vertex " + std::to_string(x) + " " + std::to_string(y) + " "
                   + std::to_string(y * std::tan(radians(25)));
        };
        std::string text = "solid face\n";
        for (const bool far : {false, true})
            text += "facet normal 0 0 0 outer loop" + corner(-20, -15)
                    + (far ? corner(20, 15) + corner(-20, 15) : corner(20, -15) + corner(20, 15))
                    + " endloop endfacet\n";
        return text + "endsolid face\n";
    }

    QTemporaryDir dir_;
    Project project_;
    Planner planner_;
    std::shared_ptr<const PlanResult> plan_;
};

MachinedJob& job_named(const std::string& name) {
    static MachinedJob convex("golden/jobs/convex/job.facetmill");
    static MachinedJob rough("golden/jobs/rough.facetmill", "complex", 0.01);
    static MachinedJob lathe("square-prism", 0.1,
                             R"("stock": { "kind": "cylinder", "axis": "x", "margin": [0, 1, 1] },
      "operations": [ { "kind": "lathe_finish", "name": "Turn", "tool": 1, "tolerance": 0.5, "points_per_turn": 180,
                        "side_feed": 4 } ])");
    static MachinedJob surface("convex", 0.3, R"("stock": { "kind": "box", "margin": [3, 3, 3] },
      "operations": [ { "kind": "finish5", "name": "Lean", "tool": 1, "tolerance": 1, "posture": "cm2", "grid_degrees": 15,
                        "clearance": 6 } ])",
                               0.15);
    static MachinedJob face(MachinedJob::Face{});
    return name == "convex"  ? convex
           : name == "rough" ? rough
           : name == "lathe" ? lathe
           : name == "face"  ? face
                             : surface;
}

/// How far any planned place is from where the interpreter runs, arcs included; of three axes, mm.
double farthest_from_run(const ClProgram& program, const Interpreted& seen) {
    const double unit = mm_per(program.unit);
    std::vector<Vec3> run;
    for (const Place& p : seen.places)
        run.push_back(unit * Vec3(p[0], p[1], p[2]));
    double farthest = 0;
    for (const auto& s : program.sections)
        for (const Motion& m : s->motions.motions) {
            double least = infinity;
            for (std::size_t i = 1; i < run.size() && least > 1e-8; ++i) {
                const Vec3 step = run[i] - run[i - 1], off = m.to.tip - run[i - 1];
                const double square = step.squaredNorm();
                const double t = square > 0 ? std::clamp(off.dot(step) / square, 0.0, 1.0) : 0;
                least = std::min(least, (off - t * step).squaredNorm());
            }
            farthest = std::max(farthest, std::sqrt(least));
        }
    return farthest;
}

/// A row of the table of core/output/README.md: verdicts on the plan and on what was posted.
void print_row(const QString& job, const QString& machine, const Project& project,
               const std::vector<PostedFile>& files, double read_seconds, const Verification& planned,
               const Verification& posted) {
    double seconds = 0;
    std::string blocks;
    for (const PostedFile& f : files) {
        seconds += f.program.seconds;
        blocks += (blocks.empty() ? "" : " + ") + std::to_string(f.program.blocks);
    }
    const double unit = mm_per(project.unit);
    std::printf("| %s, %s | %s | `%s`%s | %s | yes | %s | %s, %s | %.5f, %.5f | %.4f, %.4f | %+.3f |\n",
                qPrintable(job), project.unit == LengthUnit::inch ? "in" : "mm", qPrintable(machine),
                project.programs.post.c_str(), project.programs.arcs ? ", arcs" : "", blocks.c_str(),
                project.programs.arcs ? "arcs within a quarter of the chord" : "equal",
                verdict_name(planned.verdict()).c_str(), verdict_name(posted.verdict()).c_str(),
                planned.figures.gouge_max / unit, posted.figures.gouge_max / unit,
                planned.figures.excess_max / unit, posted.figures.excess_max / unit,
                100 * (read_seconds / seconds - 1));
    std::fflush(stdout);
}

/// The interpreter accepts the programs and puts every place where the joints are, and their time is that of
/// the machine's model; what was read back is appended.
void show_to_interpreter(const Project& project, const PlanResult& plan, const std::vector<PostedFile>& files,
                         NcFilePrograms& all) {
    const PostSetup setup = post_setup(project, plan);
    const Post control = project_post(project, project.programs.post);
    const bool arcs = project.programs.arcs;
    for (const PostedFile& file : files) {
        ClProgram program;
        program.unit = project.unit;
        for (const std::size_t i : file.programs)
            program.sections.emplace_back(plan.operations[i], &plan.operations[i]->program);
        const Interpreted seen = interpret(file.program.text, program);
        QVERIFY2(seen.status == 0, seen.message.constData());
        QCOMPARE(seen.arcs, file.program.arcs);
        QCOMPARE(file.program.arcs > 0, arcs);
        QVERIFY2(arcs || all_places_seen(program, setup, control, seen), "a place is missing");
        if (arcs) {
            // A quarter of the chord tolerance, the digits here and there, and the points on an arc.
            double chord = infinity;
            for (const std::size_t i : file.programs)
                chord = std::min(chord, plan.operations[i]->path.chord_tolerance);
            const double digit = mm_per(project.unit) * std::pow(10, -control.inch_decimals);
            const double off = farthest_from_run(program, seen);
            QVERIFY2(off < 0.25 * chord + digit + 0.003,
                     qPrintable(QString("%1 mm, chord %2 mm").arg(off).arg(chord)));
        }
        NcFilePrograms read = parse_posted(project, *plan.part, control, file.program.text, file.name, {});
        QCOMPARE(read.blocks, file.program.blocks);
        QVERIFY2(std::abs(read.seconds - file.program.seconds) < 1e-3 * file.program.seconds,
                 qPrintable(QString("%1 s, the model %2 s").arg(read.seconds).arg(file.program.seconds)));
        std::move(read.programs.begin(), read.programs.end(), std::back_inserter(all.programs));
        all.seconds += read.seconds;
    }
}

/// Three setups, planned when first asked for: three axes go anywhere as they were planned.
const std::vector<SetupPlan>& planned_setups() {
    static BlockJob job(0.2);
    static SetupPlanners planners;
    static const std::vector<SetupPlan> setups = plan_setups(job.project, {}, planners, {});
    return setups;
}

Mat3 turned(double degrees, const Vec3& line) {
    return Eigen::AngleAxisd(radians(degrees), line).toRotationMatrix();
}

/// The plane that a control makes of a posted line, as its manual puts the turns together.
Mat3 told_plane(const std::string& post, const std::string& text) {
    const std::string number = "([-+0-9.]+)";
    const std::string line =
        post.starts_with("fanuc") ? "G68\\.2 X0\\. Y0\\. Z0\\. I" + number + " J" + number + " K" + number
        : post == "haas"    ? "G268 X0\\. Y0\\. Z0\\. I" + number + " J" + number + " K" + number + " Q123"
        : post == "siemens" ? "CYCLE800\\(0,\"\",100000,27,0,0,0," + number + "," + number + "," + number
                            : "PLANE SPATIAL SPA" + number + " SPB" + number + " SPC" + number;
    std::smatch found;
    if (!std::regex_search(text, found, std::regex(line))) qFatal("no tilted plane: %s", post.c_str());
    const double a = std::stod(found[1]), b = std::stod(found[2]), c = std::stod(found[3]);
    const Vec3 x = Vec3::UnitX(), y = Vec3::UnitY(), z = Vec3::UnitZ();
    // Euler's angles Z, X, Z; Z, then Y and X as they came; X, Y, Z that stay.
    if (post.starts_with("fanuc")) return turned(a, z) * turned(b, x) * turned(c, z);
    if (post == "siemens") return turned(a, z) * turned(b, y) * turned(c, x);
    return turned(c, z) * turned(b, y) * turned(a, x);
}

} // namespace

class TestPostedJobs : public QObject {
    Q_OBJECT
private slots:
    void jobs_are_accepted_data() {
        if (rs274_program().isEmpty())
            QSKIP(
                "SKIPPED: no rs274 on this machine (Debian: linuxcnc-uspace), posted jobs were not shown to "
                "LinuxCNC's interpreter");
        QTest::addColumn<QString>("job");
        QTest::addColumn<QString>("machine");
        QTest::addColumn<QString>("post");
        QTest::addColumn<bool>("arcs");
        const auto row = [](const char* job, const char* machine, const char* post, bool arcs = false) {
            // Under sanitizers one job of each sort: what differs between machines is the interpreter's.
            if (under_sanitizer
                && !(std::string_view(job) == "lathe"
                     || (std::string_view(machine) == "trunnion-ac" && std::string_view(job) != "rough")))
                return;
            QTest::addRow("%s, %s, %s%s", job, machine, post, arcs ? ", arcs" : "")
                << job << machine << post << arcs;
        };
        for (const Machine& m : machines())
            for (const char* post : {"linuxcnc", "grbl"})
                if (m.name != "lathe-mill") row("convex", m.name.c_str(), post);
        for (const char* post : {"linuxcnc", "grbl"})
            row("convex", "generic-3-axis", post, true);
        for (const Machine& m : machines())
            for (const char* post : {"linuxcnc", "grbl"})
                if (m.name != "lathe-mill") row("rough", m.name.c_str(), post);
        for (const char* job : {"surface", "face"})
            for (const char* machine : {"tarus-tpi-2000", "trunnion-ac", "trunnion-bc", "head-b-table-c"})
                row(job, machine, "linuxcnc");
        for (const char* machine : {"trunnion-ac", "trunnion-bc"})
            row("surface", machine, "linuxcnc-tcp");
        row("lathe", "lathe-mill", "linuxcnc");
    }
    void jobs_are_accepted() {
        QFETCH(QString, job);
        QFETCH(QString, machine);
        QFETCH(QString, post);
        QFETCH(bool, arcs);
        MachinedJob& asked = job_named(job.toStdString());
        const Project& project = asked.project(machine.toStdString(), post.toStdString(),
                                               post == QStringLiteral("linuxcnc"), arcs);
        const auto plan = asked.plan();
        const std::vector<PostedFile> files = post_plan(project, *plan, {});
        NcFilePrograms all;
        show_to_interpreter(project, *plan, files, all);
        if (QTest::currentTestFailed() || !qEnvironmentVariableIsSet("FACETMILL_POSTS_TABLE")) return;
        const auto judge = [&](const std::vector<VerifyProgram>& programs) {
            return verify(*plan->part->mesh, stock_solid(project.stock, *plan->part), programs,
                          verify_settings(project, plan.get()), {});
        };
        print_row(job, machine, project, files, all.seconds, judge(verify_programs(project, plan)),
                  judge(all.programs));
    }

    void setups_are_accepted_data() {
        if (rs274_program().isEmpty())
            QSKIP("SKIPPED: no rs274 on this machine (Debian: linuxcnc-uspace), programs of several setups "
                  "were not shown to LinuxCNC's interpreter");
        QTest::addColumn<QString>("machine");
        QTest::addColumn<QString>("post");
        for (const Machine& m : machines())
            for (const char* post : {"linuxcnc", "grbl"})
                if (m.name != "lathe-mill"
                    && (!under_sanitizer || (m.name == "trunnion-ac" && post == std::string_view("grbl"))))
                    QTest::addRow("%s, %s", m.name.c_str(), post)
                        << QString::fromStdString(m.name) << QString(post);
    }
    /// A part that is turned over twice: each setup's programs in its own work coordinates.
    void setups_are_accepted() {
        QFETCH(QString, machine);
        QFETCH(QString, post);
        std::vector<SetupPlan> setups = planned_setups();
        QCOMPARE(setups.size(), std::size_t(3));
        std::vector<std::vector<VerifyProgram>> posted;
        std::vector<PostedFile> files;
        double seconds = 0;
        const std::array<const char*, 3> wcs = {"G54", "G55", "G56"};
        for (std::size_t i = 0; i < setups.size(); ++i) {
            Project& project = setups[i].project;
            project.machine = machine.toStdString();
            project.programs.post = post.toStdString();
            project.programs.wcs = wcs[i];
            project.programs.arcs = false;
            std::vector<PostedFile> own = post_plan(project, *setups[i].plan, {});
            QVERIFY(own.size() == 1 && own[0].program.text.find(wcs[i]) != std::string::npos);
            NcFilePrograms all;
            show_to_interpreter(project, *setups[i].plan, own, all);
            if (QTest::currentTestFailed()) return;
            posted.push_back(std::move(all.programs));
            seconds += all.seconds;
            files.push_back(std::move(own[0]));
        }
        if (!qEnvironmentVariableIsSet("FACETMILL_POSTS_TABLE")) return;
        const VerifySettings settings = chain_settings(setups);
        print_row("block, three setups", machine, setups[0].project, files, seconds,
                  *judge_chain(setups, planned_programs(setups), settings, {}).result,
                  *judge_chain(setups, posted, settings, {}).result);
    }

    /// What the controls of several setups will run is judged as one job; findings name planned motions.
    void setups_are_judged_as_posted() {
        std::vector<SetupPlan> setups = planned_setups();
        VerifySettings settings = chain_settings(setups);
        settings.gouge_limit = 1e-6; // what rounding leaves is found
        const auto planned = judge_chain(setups, planned_programs(setups), settings, {});
        QCOMPARE(planned.posted_blocks, std::size_t(0));
        QCOMPARE(judge_posted_chain(setups, settings, {}).posted_blocks, std::size_t(0)); // no control
        std::size_t blocks = 0;
        for (SetupPlan& setup : setups) {
            setup.project.machine = "generic-3-axis";
            setup.project.programs.post = "linuxcnc";
            blocks += posted_programs(setup.project, setup.plan, {}).blocks;
        }
        const JudgedChain posted = judge_posted_chain(setups, settings, {});
        QCOMPARE(posted.posted_blocks, blocks);
        QVERIFY(blocks > 0 && posted.programs.programs.size() == planned.programs.programs.size());
        const Verification &a = *planned.result, &b = *posted.result;
        QVERIFY(std::abs(a.figures.gouge_max - b.figures.gouge_max) < 0.002);
        QVERIFY(std::abs(a.uncut_share - b.uncut_share) < 1e-3);
        for (std::size_t k = 0; k < setups.size(); ++k) // in order
            QVERIFY(b.remarks[k].starts_with("Setup '" + setups[k].project.name + "': The posted program, "));
        QVERIFY(!b.gouges.empty());
        for (const DeviationExtreme& e : b.gouges) {
            const auto& motions = planned.programs.programs[e.by.program].motions->motions;
            QVERIFY(e.by.motion < motions.size());
            const double step =
                e.by.motion > 0 ? (motions[e.by.motion].to.tip - motions[e.by.motion - 1].to.tip).norm() : 0;
            QVERIFY((motions[e.by.motion].to.tip - e.point).norm()
                    < step + 10); // within the tool and its way
        }
    }

    void a_leaning_face_is_cut_in_a_tilted_plane_data() {
        QTest::addColumn<QString>("post");
        QTest::addColumn<QString>("machine");
        for (const Post& p : posts())
            for (const char* machine : {"tarus-tpi-2000", "trunnion-ac", "trunnion-bc", "head-b-table-c"})
                if (p.has_planes())
                    QTest::addRow("%s, %s", p.name.c_str(), machine)
                        << QString::fromStdString(p.name) << QString(machine);
    }
    /// The plane is that which the machine's axes hold: as it is, to 1e-9, and as it is printed, to its
    /// digits.
    void a_leaning_face_is_cut_in_a_tilted_plane() {
        QFETCH(QString, post);
        QFETCH(QString, machine);
        MachinedJob& asked = job_named("face");
        const Project& project = asked.project(machine.toStdString(), post.toStdString(), true, true);
        const auto plan = asked.plan();
        const PostSetup setup = post_setup(project, *plan);
        const ClSection& section = plan->operations.front()->program;
        const MachineMotion found =
            machine_motion(section, setup.machine, {.part_origin = setup.part_origin});
        const Kinematics kinematics(setup.machine, section.gauge_length, setup.part_origin);
        const TiltedPlane plane = plane_across(section.motions.motions.front().to.axis);
        QVERIFY(plane.about_x > radians(20));
        for (const MotionJoints& m : found.motions)
            QVERIFY((kinematics.forward(m.at).axis - plane.axis()).norm() < 1e-9);
        const auto files = post_plan(project, *plan, {});
        QCOMPARE(files.front().program.planes, std::size_t(1));
        const Mat3 told = told_plane(post.toStdString(), files.front().program.text);
        QVERIFY((told - plane.frame()).norm() < 3e-6);
        QVERIFY((told.col(2) - kinematics.forward(found.motions.front().at).axis).norm() < 3e-6);
    }
};

FACETMILL_TEST(TestPostedJobs)
#include "test_posted_jobs.moc"
