#include "core/cspace/contact_frame.h"

#include "core/base/error.h"
#include "core/base/tolerances.h"
#include "core/gouge/tool_lift.h"
#include "tests/support/error_code.h"
#include "tests/support/test_runner.h"
#include "tests/unit/cspace/cspace_cases.h"

#include <QTest>

using namespace facetmill;
using namespace facetmill::test;

namespace {

/// Height above the tangent plane of the lowest point of the cutter's lower surface, and how far from the
/// frame's point it is; over many points of the surface.
struct Lowest {
    double height = infinity, distance = infinity;
};
Lowest lowest(const AptCutter& shape, const ContactFrame& frame, const ToolPose& pose) {
    const BruteCutter cutter(shape);
    const Vec3 u = pose.axis.unitOrthogonal(), v = pose.axis.cross(u);
    Lowest found;
    for (int i = 0; i <= 1000; ++i)
        for (int k = 0; k < 360; ++k) {
            const double rho = double(cutter.radius()) * i / 1000, turn = radians(k);
            const Vec3 p = pose.tip + rho * (std::cos(turn) * u + std::sin(turn) * v)
                           + double(cutter.height(rho)) * pose.axis;
            const double height = (p - frame.point).dot(frame.normal);
            found.height = std::min(found.height, height);
            found.distance = std::min(found.distance, (p - frame.point).norm());
        }
    return found;
}

} // namespace

class TestContactFrame : public QObject {
    Q_OBJECT
private slots:
    void frames() {
        Random rng(1);
        for (int i = 0; i < 1000; ++i) {
            const Vec3 normal = random_unit(rng);
            const Vec3 travel = i % 3 == 0   ? Vec3(3 * normal)
                                : i % 3 == 1 ? Vec3(normal + 1e-9 * random_unit(rng))
                                             : random_unit(rng);
            const ContactFrame f = ContactFrame::at(Vec3(1, 2, 3), 7 * normal, travel);
            Mat3 m;
            m << f.feed, f.left, f.normal;
            QVERIFY((m.transpose() * m - Mat3::Identity()).cwiseAbs().maxCoeff() < 1e-15 * 10);
            QVERIFY(std::abs(m.determinant() - 1) < 1e-14);
            QVERIFY((f.normal - normal).norm() < 1e-15 * 4);
            if (i % 3 == 2) QVERIFY(f.feed.dot(travel) > 0 && std::abs(f.left.dot(travel)) < 1e-14);
        }
        QCOMPARE(code_of([] { ContactFrame::at(Vec3::Zero(), Vec3::Zero(), Vec3::UnitX()); }),
                 std::string("internal"));
        QCOMPARE(code_of([] { ContactFrame::at(Vec3::Zero(), Vec3::UnitX() * NAN, Vec3::UnitX()); }),
                 std::string("internal"));
    }

    void axis_by_hand() {
        const ContactFrame f = ContactFrame::at(Vec3::Zero(), Vec3::UnitZ(), Vec3::UnitX());
        const double h = std::sqrt(0.5);
        QVERIFY((posture_axis(f, radians(45), 0) - Vec3(h, 0, h)).norm() < 1e-15);
        QVERIFY((posture_axis(f, radians(45), radians(90)) - Vec3(0, h, h)).norm() < 1e-15); // to the left
        QVERIFY((posture_axis(f, radians(-45), 0) - Vec3(-h, 0, h)).norm() < 1e-15);
    }

    void axis_and_back() {
        Random rng(2);
        for (int i = 0; i < 10000; ++i) {
            const ContactFrame f = random_frame(rng);
            const double lead = i % 4 == 0 ? std::pow(10, uniform(rng, -7, 0)) : uniform(rng, 0.01, 3.13),
                         yaw = uniform(rng, -pi, pi);
            const Vec3 axis = posture_axis(f, lead, yaw);
            QVERIFY(std::abs(axis.norm() - 1) < 1e-14);
            const PostureValue back = posture_of_axis(f, axis);
            QVERIFY(std::abs(back.lead - lead) < 1e-14);
            const double turn = std::remainder(back.yaw - yaw, 2 * pi);
            QVERIFY(std::abs(turn) * std::sin(lead) < 1e-14);
            QVERIFY(back.yaw > -pi && back.yaw <= pi);
        }
        const ContactFrame f = random_frame(rng);
        QCOMPARE(posture_of_axis(f, f.normal).lead, 0.0);
        QCOMPARE(posture_of_axis(f, f.normal).yaw, 0.0);
        QCOMPARE(posture_of_axis(f, -f.normal).lead, pi);
    }

    /// No point of the cutter is below the plane, and the frame's point is on the cutter.
    void pose_touches_the_plane() {
        Random rng(3);
        int touched = 0;
        for (const auto& [name, shape] : cutters()) {
            const CutterProfile cutter(shape);
            for (int i = 0; i < 12; ++i) {
                const ContactFrame f = random_frame(rng);
                const PostureValue posture{i < 2 ? 0 : radians(uniform(rng, -89, 89)), uniform(rng, -pi, pi),
                                           0};
                if (!can_touch(cutter, posture.lead)) continue;
                ++touched;
                const ToolPose pose = posture_pose(cutter, f, posture);
                const Lowest low = lowest(shape, f, pose);
                QVERIFY2(low.height > -1e-9 && low.height < 0.1, name);
                QVERIFY2(low.distance < 0.1, name);
                if (posture.lead > 1e-3) { // where it has a direction, the pose of the kernel's own
                    const Vec3 tip = tip_at_contact(cutter, f.point, f.normal, pose.axis);
                    QVERIFY2((tip - pose.tip).norm() < 1e-9, name);
                }
                const ToolPose lifted = posture_pose(cutter, f, {posture.lead, posture.yaw, 2.5});
                QVERIFY((lifted.tip - pose.tip - 2.5 * pose.axis).norm() < 1e-13);
                QCOMPARE(lifted.axis, pose.axis);
            }
        }
        QVERIFY(touched > 60);
    }

    /// An upright flat end stands on its rim in the direction of the lean.
    void limit_at_no_lean() {
        const ContactFrame f = ContactFrame::at(Vec3(1, 2, 3), Vec3::UnitZ(), Vec3::UnitX());
        const ToolPose flat = posture_pose(CutterProfile(AptCutter::flat(12, 25)), f, {0, 0, 0});
        QVERIFY((flat.tip - Vec3(-5, 2, 3)).norm() < 1e-14);
        QCOMPARE(flat.axis, Vec3(0, 0, 1));
        const ToolPose left = posture_pose(CutterProfile(AptCutter::flat(12, 25)), f, {0, radians(90), 0});
        QVERIFY((left.tip - Vec3(1, -4, 3)).norm() < 1e-14);
        const ToolPose bull = posture_pose(CutterProfile(AptCutter::bull(12, 2, 25)), f, {0, 0, 0});
        QVERIFY((bull.tip - Vec3(-3, 2, 3)).norm() < 1e-14);
        const ToolPose ball = posture_pose(CutterProfile(AptCutter::ball(12, 25)), f, {0, 0, 0});
        QVERIFY((ball.tip - f.point).norm() < 1e-14);
    }

    void poses_are_continuous() {
        Random rng(4);
        for (const auto& [name, shape] : cutters()) {
            const CutterProfile cutter(shape);
            for (int i = 0; i < 200; ++i) {
                const ContactFrame f = random_frame(rng);
                const double yaw = uniform(rng, -pi, pi), step = 1e-7;
                const double lead = i % 2 == 0 ? 0 : radians(uniform(rng, 0, 85));
                // The straight pieces of these profiles.
                bool straight = false;
                for (const double angle : {0.0, shape.alpha, pi / 2 - shape.beta})
                    straight |= angle > 0 && std::abs(lead - angle) < 1e-3;
                if (straight) continue;
                const ToolPose here = posture_pose(cutter, f, {lead, yaw, 0});
                const ToolPose leaning = posture_pose(cutter, f, {lead + step, yaw, 0});
                const ToolPose turned = posture_pose(cutter, f, {lead, yaw + step, 0});
                QVERIFY2((here.tip - leaning.tip).norm() < 50 * step, name);
                QVERIFY2((here.tip - turned.tip).norm() < 50 * step, name);
                QVERIFY2((here.axis - leaning.axis).norm() < 2 * step, name);
            }
        }
    }

    void leans_that_cannot_touch() {
        const CutterProfile cone(AptCutter::cone(12, radians(30)));
        QVERIFY(can_touch(cone, radians(59)) && !can_touch(cone, radians(60))
                && !can_touch(cone, radians(61)));
        QVERIFY(can_touch(cone, radians(-59)) && !can_touch(cone, radians(-61)));
        const CutterProfile flat(AptCutter::flat(12, 25));
        QVERIFY(can_touch(flat, 0) && can_touch(flat, radians(89.9)) && !can_touch(flat, radians(90)));
        const CutterProfile ball(AptCutter::ball(10, 25)); // at height 5 (1 - cos lead)
        QVERIFY(can_touch(ball, radians(59), 2.5) && !can_touch(ball, radians(61), 2.5));
        QVERIFY(can_touch(ball, radians(61)));
        for (const auto& [name, shape] : cutters())
            for (const double lead : {90.0, 100.0, 180.0, -135.0, 89.999999, 61.0}) {
                const ToolPose pose =
                    posture_pose(CutterProfile(shape), ContactFrame(), {radians(lead), 0.3, 1});
                QVERIFY2(pose.tip.allFinite() && std::abs(pose.axis.norm() - 1) < 1e-14, name);
            }
    }

    void grid() {
        const PostureGrid g = PostureGrid::make(0, radians(45), radians(-45), radians(45), radians(3));
        QCOMPARE(g.lead.size(), std::size_t(16));
        QCOMPARE(g.yaw.size(), std::size_t(31));
        QCOMPARE(g.size(), std::size_t(496));
        QCOMPARE(g.node(1, 2), std::size_t(33));
        QCOMPARE(g.lead.front(), 0.0);
        QCOMPARE(g.lead.back(), radians(45));
        QCOMPARE(g.yaw.front(), radians(-45));
        QCOMPARE(g.yaw.back(), radians(45));
        QVERIFY(std::abs(g.lead[1] - radians(3)) < 1e-15);
        const PostureGrid uneven = PostureGrid::make(0, 1, 0, 0, 0.3);
        QCOMPARE(uneven.lead.size(), std::size_t(5));
        QCOMPARE(uneven.yaw.size(), std::size_t(1));
        QCOMPARE(PostureGrid::make(0.2, 0.2, 0, 0, 1).size(), std::size_t(1));

        const auto key = [](double a, double b, double c, double d, double step) -> std::string {
            try {
                PostureGrid::make(a, b, c, d, step);
            } catch (const Error& e) {
                return e.code() == ErrorCode::out_of_range ? e.where() : "another error";
            }
            return "";
        };
        QCOMPARE(key(0.5, 0.4, 0, 1, 0.1), std::string("lead_limits"));
        QCOMPARE(key(0, 1.6, 0, 1, 0.1), std::string("lead_limits"));
        QCOMPARE(key(NAN, 1, 0, 1, 0.1), std::string("lead_limits"));
        QCOMPARE(key(0, 1, 1, 0, 0.1), std::string("yaw_limits"));
        QCOMPARE(key(0, 1, 0, infinity, 0.1), std::string("yaw_limits"));
        QCOMPARE(key(0, 1, 0, 1, 0), std::string("grid_degrees"));
        QCOMPARE(key(0, 1, 0, 1, -1), std::string("grid_degrees"));
        QCOMPARE(key(0, 1, 0, 1, NAN), std::string("grid_degrees"));
        QCOMPARE(key(0, 0, 0, 0, 0), std::string("grid_degrees"));
        QCOMPARE(key(0, 1, 0, 1, 1e-3), std::string("grid_degrees")); // 1001 by 1001
        QCOMPARE(key(0, 1, 0, 1, 1e-300), std::string("grid_degrees"));
    }
};

FACETMILL_TEST(TestContactFrame)
#include "test_contact_frame.moc"
