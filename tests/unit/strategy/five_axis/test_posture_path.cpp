// Motions between contact points against densely placed poses, with the safety of the constants they rest on.
#include "core/strategy/five_axis/even_motion.h"
#include "core/strategy/five_axis/posture_path.h"
#include "tests/property/shapes.h"
#include "tests/support/random_meshes.h"
#include "tests/support/test_runner.h"
#include "tests/support/trials.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <utility>

using namespace facetmill;
using namespace facetmill::test;

namespace {

constexpr double chord = 0.01;

/// How deep the tool cuts along its axis at the deepest of many poses of a motion.
double deepest(const ToolLift& lift, const CutterLocation& a, const CutterLocation& b) {
    constexpr int poses = 3000;
    ToolLift::Hint hint;
    double deepest = -infinity;
    for (int k = 0; k <= poses; ++k) {
        const CutterLocation at = location_on_route(a, b, double(k) / poses);
        deepest = std::max(deepest, lift.lift({at.tip, at.axis}, hint));
    }
    return deepest;
}

/// A pose at a place, lifted until it touches the part.
CutterLocation touching(const ToolLift& lift, Random& rng, const Vec2& near) {
    const Vec3 axis = Vec3(uniform(rng, -0.4, 0.4), uniform(rng, -0.4, 0.4), 1).normalized();
    const Vec3 tip(near.x(), near.y(), 0);
    ToolLift::Hint hint;
    return {tip + lift.lift({tip, axis}, hint) * axis, axis};
}

/// A motion between two places, and a little above them: just in touch on the way, cutting or clear.
std::pair<CutterLocation, CutterLocation> motion(const ToolLift& lift, Random& rng) {
    const Vec2 from(uniform(rng, -9, 9), uniform(rng, -9, 9)),
        to = from + Vec2(uniform(rng, -3, 3), uniform(rng, -3, 3));
    CutterLocation a = touching(lift, rng, from), b = touching(lift, rng, to);
    b.axis = (a.axis + 0.15 * (b.axis - a.axis)).normalized();
    ToolLift::Hint hint;
    b.tip += lift.lift({b.tip, b.axis}, hint) * b.axis;
    // What is deepest on the way is taken off, but for twice the chord tolerance.
    const double off = deepest(lift, a, b) - uniform(rng, -2, 2) * chord;
    a.tip += off * a.axis;
    b.tip += off * b.axis;
    return {a, b};
}

} // namespace

class TestPosturePath : public QObject {
    Q_OBJECT
private slots:
    /// Near the pole, over it and far from it, within the travel of the rotary axes.
    void divided_motions_turn_alike_by_every_interpolation() {
        Random rng(7);
        constexpr double radius = 3, limit = 0.0025;
        for (const char* name : {"trunnion-ac", "head-b-table-c", "tarus-tpi-2000"}) {
            const Kinematics kinematics(find_machine(name), 100, Vec3(0, 0, 200));
            const EvenMotion motion(kinematics, radius, limit);
            std::size_t divided = 0;
            for (int round = 0; round < 60; ++round) {
                const double near = round % 3 == 0 ? 0.02 : 0.35;
                const auto axis = [&] {
                    return Vec3(Vec3(uniform(rng, -near, near), uniform(rng, -near, near), 1).normalized());
                };
                CutterLocation a{Vec3(0, 0, 0), axis()}, b{Vec3(2, 0, 0), axis()};
                b.axis = (a.axis + 0.3 * (b.axis - a.axis)).normalized();
                if (round % 3 == 1) b.axis = Vec3(-a.axis.x(), -a.axis.y(), a.axis.z()); // over the pole
                std::vector<double> shares = motion.cuts(a, b);
                divided += shares.size();
                QVERIFY(std::is_sorted(shares.begin(), shares.end()));
                shares.push_back(1);
                CutterLocation from = a;
                for (const double share : shares) {
                    const CutterLocation to = share == 1 ? b : location_on_route(a, b, share);
                    const auto start = kinematics.nearest({from.tip, from.axis}, Joints{});
                    const auto end = start ? kinematics.nearest({to.tip, to.axis}, *start) : start;
                    for (double t = 0.1; t < 0.95; t += 0.1) {
                        const Vec3 circle = location_on_route(from, to, t).axis;
                        const Vec3 straight = (from.axis + t * (to.axis - from.axis)).normalized();
                        QVERIFY((straight - circle).norm() * 2 * radius < 1.3 * limit);
                        if (!end) continue;
                        Joints on = *start;
                        for (std::size_t r = 0; r < 2; ++r)
                            on.rotary[r] += t * (end->rotary[r] - on.rotary[r]);
                        const double off = (kinematics.forward(on).axis - circle).norm();
                        QVERIFY2(off * 2 * radius < 1.3 * limit, qPrintable(QString::number(off)));
                    }
                    from = to;
                }
            }
            QVERIFY(divided > 60);
        }
    }

    void locations_move_straight_and_turn_evenly() {
        const CutterLocation a{Vec3(0, 0, 0), Vec3(0, 0, 1)},
            b{Vec3(4, 2, 1), Vec3(std::sin(0.6), 0, std::cos(0.6))};
        for (const double t : {0.0, 0.25, 0.5, 1.0}) {
            const CutterLocation at = location_on_route(a, b, t);
            QVERIFY((at.tip - t * b.tip).norm() < 1e-12);
            QVERIFY((at.axis - Vec3(std::sin(0.6 * t), 0, std::cos(0.6 * t))).norm() < 1e-12);
        }
    }

    /// What is passed as clear cuts no deeper than the chord tolerance anywhere, looked at with the step that
    /// is used, with half of it and with twice as much. So it does when half the share of the chord tolerance
    /// is allowed at the looks; with twice the share the tolerance is exceeded, and this test sees it.
    void clear_motions_are_clear_between_looks() {
        const Mesh part =
            height_field([](double x, double y) { return 0.8 * std::sin(0.9 * x) * std::cos(0.7 * y); },
                         Vec2(-12, -12), Vec2(12, 12), 60, 60);
        const PlanContext context = context_of(part, flat_tool(4));
        const ToolLift lift(context.contact, context.tool);
        const double step = looking_step(2, chord);
        Random rng(7);
        int clear = 0, exceeded = 0;
        for (int i = 0; i < trials(300, 3); ++i) {
            const auto [a, b] = motion(lift, rng);
            const double depth = deepest(lift, a, b);
            const auto passed = [&, a = a, b = b](double steps, double share) {
                ToolLift::Hint hint;
                return keeps_clear_between(lift, a, b, steps * step, share * chord, hint);
            };
            for (const double steps : {0.5, 1.0, 2.0})
                for (const double share : {0.3, 0.6}) {
                    const bool keeps = passed(steps, share);
                    clear += keeps;
                    QVERIFY2(!keeps || depth <= chord,
                             qPrintable(QString("%1 deep, %2 steps, %3").arg(depth).arg(steps).arg(share)));
                }
            exceeded += passed(1, 1.2) && depth > chord;
            if (depth < -chord) QVERIFY(passed(1, 0.6)); // and what is clear is passed
        }
        QVERIFY2(clear > trials(300, 3), qPrintable(QString::number(clear)));
        QVERIFY(exceeded > 0);
    }
};

FACETMILL_TEST(TestPosturePath)
#include "test_posture_path.moc"
