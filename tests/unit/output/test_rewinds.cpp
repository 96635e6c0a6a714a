// Axes that end somewhere: they are wound back in the air, never while the tool cuts.
#include "core/link/link.h"
#include "core/output/motion_time.h"
#include "core/setup/joint_course.h"
#include "core/strategy/five_axis/even_motion.h"
#include "core/strategy/five_axis/posture_path.h"
#include "core/verify/verify.h"
#include "tests/property/shapes.h"
#include "tests/support/test_runner.h"
#include "tests/support/trials.h"

#include <QTest>

#include <random>

using namespace facetmill;
using namespace facetmill::test;

namespace {

constexpr double chord = 0.01;

/// A machine whose first rotary axis with this name has this travel, in degrees.
Machine with_travel(const char* machine, const char* axis, double lo, double hi) {
    Machine m = find_machine(machine);
    for (RotaryAxis& r : m.rotary)
        if (r.name == axis) r.travel = {radians(lo), radians(hi)};
    return m;
}

/// A ball that rolls over a level plate while its axis goes round the normal, to and fro at random.
Pass wandering(std::mt19937_64& random, double y, const EvenMotion& motion, double radius) {
    std::uniform_real_distribution<double> share(-1, 1);
    std::vector<CutterLocation> stops;
    double yaw = pi * share(random), lean = radians(6), turning = share(random) < 0 ? -1 : 1;
    for (int i = 0; i <= 40; ++i) {
        const Vec3 axis(std::sin(lean) * std::cos(yaw), std::sin(lean) * std::sin(yaw), std::cos(lean));
        stops.push_back({Vec3(0.25 * i - 5, y, radius) - radius * axis, axis});
        if (share(random) > 0.9) turning = -turning;
        yaw += turning * radians(15);
        lean = std::clamp(lean + radians(2) * share(random), radians(1), radians(12));
    }
    Pass pass;
    for (std::size_t i = 0; i < stops.size(); ++i) {
        if (i > 0)
            for (const double t : motion.cuts(stops[i - 1], stops[i]))
                pass.cl.push_back(location_on_route(stops[i - 1], stops[i], t));
        pass.cl.push_back(stops[i]);
    }
    for (const CutterLocation& c : pass.cl)
        pass.cc.push_back({c.tip, Vec3::UnitZ()});
    return pass;
}

VerifySettings plate_settings() {
    VerifySettings s;
    s.tolerance = 0.1;
    s.gouge_limit = 2 * chord;
    s.resolution = 0.5;
    s.sample_spacing = 0.5;
    s.motion_bound = 0.05;
    return s;
}

} // namespace

class TestRewinds : public QObject {
    Q_OBJECT
private slots:
    /// Whatever the axes do, no joint turns over at feed, every place of every pass is there in its order,
    /// and the verifier, with joints as they are posted and as it finds them, sees no gouge.
    void axes_that_end_are_wound_back_in_the_air() {
        const Mesh plate = height_field([](double, double) { return 0.0; }, Vec2(-7, -3), Vec2(7, 3), 14, 6);
        const Tool tool = ball_tool(6);
        std::mt19937_64 random(5);
        int rewound = 0;
        for (const Machine& machine :
             {find_machine("tarus-tpi-2000"), with_travel("tarus-tpi-2000", "C", -180, 180),
              with_travel("tarus-tpi-2000", "C", 0, 360), with_travel("trunnion-ac", "C", 0, 360),
              with_travel("head-b-table-c", "C", -180, 180), find_machine("trunnion-ac")})
            for (int round = 0; round < trials(4, 2); ++round) {
                PlanContext context = context_of(plate, tool);
                context.machine = machine;
                const Kinematics kinematics(machine, gauge_length(tool),
                                            default_part_origin(machine, context.part_box));
                const EvenMotion motion(kinematics, 3, 0.25 * chord);
                StrategyResult path;
                path.chord_tolerance = chord;
                for (const double y : {-0.5, 0.5})
                    path.passes.push_back(wandering(random, y, motion, 3));
                LinkOptions options;
                options.link_distance = 2;
                options.chord_tolerance = chord;
                auto section = std::make_shared<ClSection>();
                section->multi_axis = true;
                section->feed_mm_per_min = 1000;
                section->gauge_length = gauge_length(tool);
                section->part_box = context.part_box;
                section->motions = link_five_axis(path, context, {}, options, Progress());
                const auto& motions = section->motions.motions;
                const MachineMotion run = machine_motion(*section, machine);
                QVERIFY2(run.findings.empty(), machine.label.c_str());
                std::pair<Index, Index> last{0, 0};
                auto joints = std::make_shared<std::vector<Joints>>();
                for (std::size_t i = 0; i < motions.size(); ++i) {
                    joints->push_back(run.motions[i].at);
                    if (motions[i].pass != no_index) {
                        const std::pair<Index, Index> now{motions[i].pass, motions[i].point};
                        QCOMPARE(motions[i].to.tip, path.passes[now.first].cl[now.second].tip);
                        QVERIFY(last <= now && (now.first > last.first || now.second <= last.second + 1));
                        last = now;
                    }
                    if (i == 0 || motions[i].kind == MotionKind::rapid) {
                        if (i > 0)
                            rewound +=
                                std::abs((*joints)[i].rotary[0] - (*joints)[i - 1].rotary[0]) > radians(90)
                                || std::abs((*joints)[i].rotary[1] - (*joints)[i - 1].rotary[1])
                                       > radians(90);
                        continue;
                    }
                    QVERIFY2(!turns_over((*joints)[i - 1], (*joints)[i]), machine.label.c_str());
                    QVERIFY(motion.even(motions[i - 1].to, motions[i].to, (*joints)[i - 1], (*joints)[i]));
                }
                QCOMPARE(last, (std::pair<Index, Index>(1, Index(path.passes[1].cl.size() - 1))));
                VerifyProgram program{"Wander", VerifyTool(tool), {section, &section->motions}, std::nullopt};
                program.machine = std::make_shared<const Machine>(machine);
                StockSolid stock;
                stock.box = plate.box();
                stock.box.hi.z() = 0.5;
                stock.box.lo.z() = -1;
                {
                    if (round % 2) program.joints = joints; // else the verifier finds them
                    const Verification v = verify(plate, stock, {&program, 1}, plate_settings(), Progress());
                    QVERIFY2(!v.gouged() && v.collisions.empty(),
                             qPrintable(QString("%1, round %2: %3, %4 collisions")
                                            .arg(machine.label.c_str())
                                            .arg(round)
                                            .arg(v.figures.gouge_max)
                                            .arg(v.collisions.size())));
                }
            }
        QVERIFY2(rewound >= trials(8, 2), qPrintable(QString::number(rewound)));
    }

    /// One pass alone that goes round farther than the axis can: out, wound back, and in again, once.
    void a_pass_that_turns_too_far_comes_out_once() {
        const Mesh plate =
            height_field([](double, double) { return 0.0; }, Vec2(-12, -6), Vec2(12, 6), 24, 12);
        const Tool tool = ball_tool(6);
        const auto runs = [&](const Machine& machine) {
            PlanContext context = context_of(plate, tool);
            context.machine = machine;
            StrategyResult path;
            Pass pass;
            for (int i = 0; i <= 5 * 180; ++i) { // two turns and a half
                const double yaw = radians(i);
                const Vec3 axis(std::sin(0.2) * std::cos(yaw), std::sin(0.2) * std::sin(yaw), std::cos(0.2));
                pass.cl.push_back({Vec3(0.01 * i - 4, 0, 3) - 3 * axis, axis});
                pass.cc.push_back({pass.cl.back().tip, Vec3::UnitZ()});
            }
            path.passes.push_back(std::move(pass));
            const ToolMotions m = link_five_axis(path, context, {}, LinkOptions(), Progress());
            int count = 0;
            for (std::size_t i = 1; i < m.motions.size(); ++i)
                count += m.motions[i].kind == MotionKind::cut && m.motions[i - 1].kind != MotionKind::cut;
            return count;
        };
        QCOMPARE(runs(find_machine("trunnion-ac")), 1);
        QCOMPARE(runs(find_machine("tarus-tpi-2000")), 2);
        QCOMPARE(runs(with_travel("tarus-tpi-2000", "C", -180, 180)), 3);
    }
};

FACETMILL_TEST(TestRewinds)
#include "test_rewinds.moc"
