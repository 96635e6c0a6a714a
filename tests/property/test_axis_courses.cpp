// Programs of five axes say where the tool is, and the control decides how the axis turns between two
// locations. Random plans are cut under each of the three ways that controls take, as dense poses that a
// check by brute force looks at, which shares nothing with planners and verifier: under none of them does a
// cutter come deeper into the part than the gouge limit, and no point of it leaves the others' path by more.
#include "core/job/planner.h"
#include "core/job/verification.h"
#include "core/mesh/mesh_io.h"
#include "core/setup/joint_course.h"
#include "tests/support/naive_check.h"
#include "tests/support/part_meshes.h"
#include "tests/support/random_meshes.h"
#include "tests/support/test_runner.h"

#include <QTemporaryDir>
#include <QTest>

#include <numeric>

using namespace facetmill;
using namespace facetmill::test;

namespace {

constexpr double course_tolerance = 0.2;

/// Where the axis is at a share of a motion, by the definition of each way.
Vec3 on_great_circle(const Vec3& a, const Vec3& b, double s) {
    const double angle = std::atan2(a.cross(b).norm(), a.dot(b));
    if (angle < 1e-9) return a;
    return (std::sin((1 - s) * angle) * a + std::sin(s * angle) * b) / std::sin(angle);
}
Vec3 on_chord(const Vec3& a, const Vec3& b, double s) {
    return ((1 - s) * a + s * b).normalized();
}

/// A wave, a dome, or a standing plate that is cut from both sides.
Mesh random_part(Random& rng, int form) {
    if (form == 0) return dome(uniform(rng, 6, 9), 12);
    if (form == 1) return box(Vec3(-7, -1.5, 0), Vec3(7, 1.5, uniform(rng, 6, 9)));
    const double a = uniform(rng, 0.3, 1.5), p = uniform(rng, 0.2, 0.4), q = uniform(rng, 0.2, 0.4);
    return height_field([&](double x, double y) { return a * std::sin(p * x) * std::cos(q * y); },
                        Vec2(-8, -6), Vec2(8, 6), 16, 12);
}

Tool random_tool(Random& rng) {
    Tool tool = std::array{ball_tool(5), flat_tool(4), bull_tool(5, 1)}[std::size_t(whole(rng, 0, 2))];
    tool.number = 1;
    tool.name = "T";
    tool.flute_length = 14;
    tool.shank_diameter = tool.diameter;
    return tool;
}

struct CourseJob {
    std::shared_ptr<const PlanResult> plan;
    std::vector<VerifyProgram> programs;
    double gouge_limit = 0;
    std::string about;
};

CourseJob random_course_job(std::uint64_t seed) {
    Random rng(seed);
    QTemporaryDir dir;
    const std::filesystem::path folder(dir.path().toStdString());
    const int form = int(seed % 3);
    save_stl(random_part(rng, form), folder / "part.stl", LengthUnit::mm, {});
    Project project;
    project.path = folder / "p.facetmill";
    project.part.file = "part.stl";
    project.part.rotate = {radians(uniform(rng, -20, 20)), radians(uniform(rng, -20, 20)),
                           radians(uniform(rng, 0, 360))};
    project.machine =
        std::array{"tarus-tpi-2000", "trunnion-ac", "trunnion-bc", "head-b-table-c"}[seed / 3 % 4];
    project.tools = {random_tool(rng)};
    auto op = make_operation("finish5");
    op->common().name = "F";
    op->common().tolerance = course_tolerance;
    op->set("grid_degrees", radians(9));
    op->set("posture", std::string(std::array{"cm2", "local", "global"}[std::size_t(whole(rng, 0, 2))]));
    if (whole(rng, 0, 1) == 1) op->set("turn_limit", radians(uniform(rng, 10, 60)));
    project.operations.push_back(std::move(op));
    CourseJob job;
    job.plan = Planner().plan(project, {}, Progress());
    job.programs = verify_programs(project, job.plan);
    job.gouge_limit = verify_settings(project, job.plan.get()).gouge_limit;
    job.about = "seed " + std::to_string(seed) + ", " + project.machine;
    return job;
}

/// The motions with the axis as one of the three ways has it, half a degree apart at most, and how far a
/// point of the cutter's end at most comes from where the great circle has it.
struct Course {
    std::vector<Motion> motions;
    double apart = 0;
};

enum class Way : std::uint8_t { great_circle, chord, joints };

Course course_of(const VerifyProgram& program, Way way) {
    const auto& motions = program.motions->motions;
    const Kinematics kinematics(*program.machine, 0, Vec3::Zero());
    JointCourse joints;
    if (program.joints) {
        joints.at = *program.joints;
        joints.held.assign(motions.size(), true);
    } else {
        joints = find_joint_course(motions, {}, kinematics, radians(1), Progress());
    }
    Course course;
    course.motions.push_back(motions.front());
    for (std::size_t i = 1; i < motions.size(); ++i) {
        const Vec3 &from = motions[i - 1].to.axis, &to = motions[i].to.axis;
        const int pieces = 1 + int(std::acos(std::clamp(from.dot(to), -1.0, 1.0)) / radians(0.5));
        for (int k = 1; k < pieces || (from != to && k < 4); ++k) {
            const double s = double(k) / std::max(pieces, from != to ? 4 : 1);
            const Vec3 circle = on_great_circle(from, to, s);
            Vec3 axis = circle;
            if (way == Way::chord) axis = on_chord(from, to, s);
            if (way == Way::joints && joints.held[i - 1] && joints.held[i]) {
                Joints at;
                for (std::size_t j = 0; j < 2; ++j)
                    at.rotary[j] = joints.at[i - 1].rotary[j]
                                   + s * (joints.at[i].rotary[j] - joints.at[i - 1].rotary[j]);
                axis = kinematics.forward(at).axis;
            }
            Motion m = motions[i];
            m.to = {motions[i - 1].to.tip + s * (motions[i].to.tip - motions[i - 1].to.tip), axis};
            course.motions.push_back(m);
            if (m.kind != MotionKind::rapid) course.apart = std::max(course.apart, (axis - circle).norm());
        }
        course.motions.push_back(motions[i]);
    }
    course.apart *= program.tool.cutter.max_radius();
    return course;
}

} // namespace

class TestAxisCourses : public QObject {
    Q_OBJECT
private slots:
    void every_way_of_turning_is_safe_data() {
        QTest::addColumn<quint64>("seed");
        std::vector<quint64> seeds{0, 4, 8, 10}; // each machine, each form of the part
        const QStringList range = qEnvironmentVariable("FACETMILL_COURSES").split(',');
        if (range.size() == 2) {
            seeds.resize(range[1].toULongLong());
            std::iota(seeds.begin(), seeds.end(), range[0].toULongLong());
        }
        for (const quint64 seed : seeds)
            QTest::addRow("%d", int(seed)) << seed;
    }

    void every_way_of_turning_is_safe() {
        QFETCH(quint64, seed);
        const CourseJob job = random_course_job(seed);
        for (const VerifyProgram& program : job.programs) {
            QVERIFY(program.machine && program.motions->motions.size() > 10);
            for (const Way way : {Way::great_circle, Way::chord, Way::joints}) {
                const Course course = course_of(program, way);
                const NaiveProgram naive{program.tool.cutter.cutter(), course.motions};
                NaiveOptions options;
                options.spacing = 0.6;
                options.tolerance = course_tolerance;
                options.pose_share = 0.1;
                options.stock = job.plan->stock.box;
                const NaiveResult r = naive_check(*job.plan->part->mesh, {&naive, 1}, options);
                const QString said = QString("%1: way %2 gouges %3 of %4, %5 apart")
                                         .arg(job.about.c_str())
                                         .arg(int(way))
                                         .arg(r.gouge_max)
                                         .arg(job.gouge_limit)
                                         .arg(course.apart);
                if (qEnvironmentVariableIsSet("FACETMILL_COURSES")) qInfo() << said;
                QVERIFY2(r.gouge_max <= job.gouge_limit, qPrintable(said));
                QVERIFY2(course.apart <= job.gouge_limit, qPrintable(said));
            }
        }
    }
};

FACETMILL_TEST(TestAxisCourses)
#include "test_axis_courses.moc"
