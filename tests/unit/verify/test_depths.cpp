// How deep points come to lie inside a moving tool, against a search over poses that knows nothing but the
// radius of the tool at a height.
#include "core/setup/kinematics.h"
#include "core/verify/motion_shadows.h"
#include "core/verify/probes.h"
#include "tests/support/part_meshes.h"
#include "tests/support/test_runner.h"
#include "tests/support/trials.h"

#include <QTest>

#include <random>

using namespace facetmill;
using namespace facetmill::test;

namespace {

Vec3 any_direction(std::mt19937& random) {
    std::normal_distribution<double> normal;
    return Vec3(normal(random), normal(random), normal(random)).normalized();
}

/// Signed depth of a point in a body of revolution: how far it is from points of the outline, which is walked
/// in small steps. Below 0 outside.
double depth_by_outline(const CutterProfile& cutter, const Vec3& point, const CutterLocation& at) {
    const Vec3 d = point - at.tip;
    const double z = d.dot(at.axis), rho = (d - z * at.axis).norm();
    const double top = cutter.height();
    std::vector<Vec2> outline{{0, 0}};
    constexpr int steps = 4000;
    for (int i = 0; i <= steps; ++i) {
        const double r = cutter.max_radius() * i / steps;
        outline.push_back({r, cutter.height_at(r)});
    }
    outline.push_back({cutter.max_radius(), top});
    outline.push_back({0, top});
    double nearest = infinity;
    for (std::size_t i = 1; i < outline.size(); ++i) {
        const Vec2 a = outline[i - 1], b = outline[i], p(rho, z);
        const double square = (b - a).squaredNorm();
        const double t = square > 0 ? std::clamp((p - a).dot(b - a) / square, 0.0, 1.0) : 0.0;
        nearest = std::min(nearest, (p - a - t * (b - a)).norm());
    }
    const bool inside = rho <= cutter.max_radius() && z <= top && z >= cutter.height_at(rho);
    return inside ? nearest : -nearest;
}

} // namespace

class TestDepths : public QObject {
    Q_OBJECT
private slots:
    void of_poses() {
        std::mt19937 random(5);
        std::uniform_real_distribution<double> share(-1, 1);
        for (const ShapedTool& shaped : tools_of_every_shape()) {
            const CutterProfile cutter(shaped.tool.cutter());
            const BodySupport body(cutter);
            for (int i = 0; i < 60; ++i) {
                const CutterLocation at{Vec3(share(random), share(random), share(random)),
                                        any_direction(random)};
                const double r = cutter.max_radius();
                const Vec3 side = at.axis.unitOrthogonal();
                const Vec3 p = at.tip + 1.2 * r * share(random) * side
                               + (0.5 + 0.7 * share(random)) * cutter.height() * at.axis;
                const double expected = depth_by_outline(cutter, p, at);
                QVERIFY2(std::abs(body.nearest(p - at.tip, at.axis).inside - expected) < 2e-3 * r,
                         qPrintable(QString("%1: %2 of %3")
                                        .arg(shaped.name)
                                        .arg(body.nearest(p - at.tip, at.axis).inside)
                                        .arg(expected)));
            }
        }
    }

    void of_programs_data() {
        QTest::addColumn<bool>("turning");
        QTest::newRow("straight") << false;
        QTest::newRow("turning") << true;
    }
    /// The deepest of all poses on random walks, a hundred to a motion.
    void of_programs() {
        QFETCH(bool, turning);
        std::mt19937 random(turning ? 11 : 3);
        std::uniform_real_distribution<double> share(-1, 1);
        constexpr double bound = 1e-3;
        std::size_t inside = 0, left_out = 0, shortened = 0, shadowed = 0;
        for (const ShapedTool& shaped : tools_of_every_shape())
            for (int round = 0; round < trials(6); ++round) {
                const CutterProfile cutter(shaped.tool.cutter());
                auto motions = std::make_shared<ToolMotions>();
                Vec3 axis = any_direction(random), tip(0, 0, 0);
                for (int i = 0; i < 12; ++i) {
                    if (turning && i % 3 != 0) axis = (axis + 0.3 * any_direction(random)).normalized();
                    tip += Vec3(share(random), share(random), share(random)) * 2;
                    motions->motions.push_back({MotionKind::cut, {tip, axis}, no_index, no_index});
                }
                const VerifyProgram program{"P", VerifyTool(shaped.tool), motions, std::nullopt};
                const auto tree = std::make_shared<const MotionTree>(
                    program, [](MotionKind) { return true; }, Progress());
                const MotionProbes probes{TurnedBody(cutter), BodySupport(cutter), tree, bound};
                const BodySupport body(cutter);
                const MotionShadows shadows(probes, Progress());
                RecentSweeps recent;
                for (int k = 0; k < 40; ++k) {
                    const Vec3 p = 6 * Vec3(share(random), share(random), share(random));
                    double expected = 0;
                    for (std::size_t m = 1; m < motions->motions.size(); ++m)
                        for (int s = 0; s <= 100; ++s) {
                            const CutterLocation at = location_between(
                                motions->motions[m - 1].to, motions->motions[m].to, std::nullopt, 0.01 * s);
                            expected = std::max(expected, body.nearest(p - at.tip, at.axis).inside);
                        }
                    DepthProbe probe;
                    const bool deeper = probes.deepen(p, no_index, probe);
                    QCOMPARE(deeper, probe.depth > 0);
                    QVERIFY2(
                        probe.depth >= expected - bound && probe.depth <= expected + 0.05,
                        qPrintable(QString("%1: %2 of %3").arg(shaped.name).arg(probe.depth).arg(expected)));
                    inside += expected > 0.05;
                    // Nor does it matter whether all motions are asked or those that may be near.
                    const Vec3 center = p + share(random) * any_direction(random);
                    const double least = k % 2 == 0 ? 0 : 0.2 * share(random);
                    const std::vector<Index> nearby = probes.near(center, (p - center).norm(), least);
                    DepthProbe among{least, no_index}, of_all{least, no_index};
                    QCOMPARE(probes.deepen(p, no_index, among, nearby), probes.deepen(p, no_index, of_all));
                    QCOMPARE(among.depth, of_all.depth);
                    // The same of a line that begins here.
                    const Vec3 n = any_direction(random);
                    LineProbe line{1, no_index}, line_of_all{1, no_index};
                    probes.lower(p, n, no_index, line, probes.near(center, (p - center).norm() + 1, 0));
                    probes.lower(p, n, no_index, line_of_all);
                    QVERIFY(std::abs(std::max(line.value, 0.0) - std::max(line_of_all.value, 0.0))
                            <= (turning ? 0.02 : 1e-7));
                    shortened += line.value < 1;
                    left_out += nearby.empty();
                    // Nor whether those whose shadows a long line runs over.
                    const double length = 8 + 4 * share(random);
                    const Vec3 below = p - 4 * axis,
                               aim = motions->motions[random() % motions->motions.size()].to.tip + 2 * axis,
                               up = (aim - below).normalized();
                    LineProbe by_shadows{length, no_index}, by_tree{length, no_index};
                    if (shadows.know(below, up, length)) {
                        const bool lowered = shadows.lower(probes, below, up, by_shadows, recent);
                        QCOMPARE(lowered, probes.lower(below, up, no_index, by_tree));
                        QVERIFY(std::abs(std::max(by_shadows.value, 0.0) - std::max(by_tree.value, 0.0))
                                <= 1e-7);
                        shadowed += lowered && by_tree.value > 0;
                    }
                    if (!deeper) continue;
                    // A hint changes nothing, and the first motion as deep is as deep.
                    DepthProbe hinted;
                    probes.deepen(p, Index(random() % motions->motions.size()), hinted);
                    QVERIFY(std::abs(hinted.depth - probe.depth) <= (turning ? bound : 1e-8));
                    QVERIFY(probes.first_as_deep(p, probe) <= probe.motion);
                }
            }
        QVERIFY(inside > trials(std::size_t(100)));
        QVERIFY(left_out > trials(std::size_t(50)));
        QVERIFY(shortened > trials(std::size_t(50)));
        QVERIFY(turning ? shadowed == 0 : shadowed > trials(std::size_t(100)));
    }

    /// A control may turn the axis on a great circle, along its ends' chord or joint by joint: the deepest of
    /// all counts, and is named. Without a machine nobody knows what its joints do.
    void under_every_course() {
        std::mt19937 random(8);
        std::uniform_real_distribution<double> share(-1, 1);
        constexpr double bound = 1e-3;
        const auto machine = std::make_shared<const Machine>(find_machine("trunnion-ac"));
        const Kinematics kinematics(*machine, 0, Vec3::Zero());
        const Tool tool = ball_tool(4);
        const CutterProfile cutter(tool.cutter());
        const BodySupport body(cutter);
        std::array<int, 3> deepest{0, 0, 0};
        for (int round = 0; round < 12; ++round) {
            std::vector<Joints> joints;
            auto motions = std::make_shared<ToolMotions>();
            double turn = 0;
            for (int i = 0; i < 6; ++i) {
                Joints at;
                turn += radians(100) * share(random);
                // The other solution lies beyond the travel of A.
                at.rotary = {radians(-65 + 25 * share(random)), turn};
                joints.push_back(at);
                const Vec3 tip = 3 * Vec3(share(random), share(random), share(random));
                motions->motions.push_back(
                    {MotionKind::cut, {tip, kinematics.forward(at).axis}, no_index, no_index});
            }
            for (const bool known : {true, false}) {
                const VerifyProgram program{"P", VerifyTool(tool),         motions, std::nullopt,
                                            {},  known ? machine : nullptr};
                const auto tree = std::make_shared<const MotionTree>(
                    program, [](MotionKind) { return true; }, Progress());
                const MotionProbes probes{TurnedBody(cutter), BodySupport(cutter), tree, bound};
                for (int k = 0; k < 20; ++k) {
                    const Vec3 p = Vec3(9 * share(random), 9 * share(random), 6 + 6 * share(random));
                    std::array<double, 3> expected{0, 0, 0};
                    for (std::size_t m = 1; m < joints.size(); ++m)
                        for (int i = 0; i <= 400; ++i) {
                            const double t = i / 400.0;
                            const CutterLocation &a = motions->motions[m - 1].to, &b = motions->motions[m].to;
                            const CutterLocation at = location_between(a, b, std::nullopt, t);
                            Joints between;
                            for (std::size_t r = 0; r < 2; ++r)
                                between.rotary[r] =
                                    (1 - t) * joints[m - 1].rotary[r] + t * joints[m].rotary[r];
                            const Vec3 chord = ((1 - t) * a.axis + t * b.axis).normalized();
                            const std::array<Vec3, 3> axes{at.axis, chord, kinematics.forward(between).axis};
                            for (std::size_t c = 0; c < 3; ++c)
                                expected[c] = std::max(expected[c], body.nearest(p - at.tip, axes[c]).inside);
                        }
                    if (!known) expected[2] = 0;
                    const auto most = std::max_element(expected.begin(), expected.end());
                    DepthProbe probe;
                    probes.deepen(p, no_index, probe);
                    QVERIFY2(std::abs(probe.depth - *most) < 0.03,
                             qPrintable(QString("%1 of %2").arg(probe.depth).arg(*most)));
                    const auto course = std::size_t(most - expected.begin());
                    bool clear = true;
                    for (std::size_t c = 0; c < 3; ++c)
                        clear = clear && (c == course || *most - expected[c] > 0.05);
                    if (!clear) continue;
                    ++deepest[course];
                    QCOMPARE(std::size_t(probe.course), course);
                }
            }
        }
        for (const int times : deepest)
            QVERIFY(times >= 3);
    }
};

FACETMILL_TEST(TestDepths)
#include "test_depths.moc"
