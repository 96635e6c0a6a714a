// Jobs, machines and controls, one with another: LinuxCNC's interpreter accepts what is posted, and every
// place of the program is where the joints are.
#include "core/base/file.h"
#include "core/job/posting.h"
#include "core/mesh/mesh_io.h"
#include "core/mesh/sample.h"
#include "tests/support/rs274.h"
#include "tests/support/test_runner.h"
#include "tests/support/trials.h"

#include <QTest>

#include <cstdio>
#include <fstream>

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
    return name == "convex" ? convex : name == "rough" ? rough : name == "lathe" ? lathe : surface;
}

} // namespace

class TestPostedJobs : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() {
        if (rs274_program().isEmpty())
            QSKIP(
                "SKIPPED: no rs274 on this machine (Debian: linuxcnc-uspace), posted jobs were not shown to "
                "LinuxCNC's interpreter");
    }

    void jobs_are_accepted_data() {
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
        for (const char* machine : {"generic-3-axis", "trunnion-ac"})
            for (const char* post : {"linuxcnc", "grbl"})
                row("rough", machine, post);
        for (const char* machine : {"tarus-tpi-2000", "trunnion-ac", "trunnion-bc", "head-b-table-c"})
            row("surface", machine, "linuxcnc");
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
        const PostSetup setup = post_setup(project, *plan);
        const Post control = project_post(project, post.toStdString());
        for (const PostedFile& file : post_plan(project, *plan, {})) {
            ClProgram program;
            program.unit = project.unit;
            for (const std::size_t i : file.programs)
                program.sections.emplace_back(plan->operations[i], &plan->operations[i]->program);
            const Interpreted seen = interpret(file.program.text, program);
            QVERIFY2(seen.status == 0, seen.message.constData());
            // What an arc stands for is not told place by place (test_post_arcs).
            QCOMPARE(seen.arcs, file.program.arcs);
            QCOMPARE(file.program.arcs > 0, arcs);
            QVERIFY2(arcs || all_places_seen(program, setup, control, seen), "a place is missing");
            if (qEnvironmentVariableIsSet("FACETMILL_POSTS_TABLE"))
                std::printf("| %s | %s | %s | %zu | %zu |\n", qPrintable(job), qPrintable(machine),
                            qPrintable(post), file.program.blocks, seen.places.size());
        }
    }
};

FACETMILL_TEST(TestPostedJobs)
#include "test_posted_jobs.moc"
