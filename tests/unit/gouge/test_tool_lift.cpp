// Lifts of whole tools at any posture against the brute-force reference: the mesh is turned into the tool's
// frame, where the axis is Z.
#include "core/gouge/tool_lift.h"

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/base/tolerances.h"
#include "core/gouge/axial_lift.h"
#include "tests/support/brute_lift.h"
#include "tests/support/test_runner.h"
#include "tests/support/trials.h"
#include "tests/unit/gouge/lift_cases.h"

#include <QTest>

#include <cstring>

using namespace facetmill;
using namespace facetmill::test;

namespace {

Vec3 random_axis(Random& rng, double min_z) {
    for (;;) {
        const Vec3 v(uniform(rng, -1, 1), uniform(rng, -1, 1), uniform(rng, -1, 1));
        if (v.norm() > 1 || v.norm() < 0.1 || v.normalized().z() < min_z) continue;
        return v.normalized();
    }
}

Mesh turned(const Mesh& mesh, const ToolPose& pose) {
    const Vec3 u = pose.axis.unitOrthogonal(), v = pose.axis.cross(u);
    Mesh out = mesh;
    for (Vec3& p : out.vertices) {
        const Vec3 d = p - pose.tip;
        p = Vec3(d.dot(u), d.dot(v), d.dot(pose.axis));
    }
    return out;
}

std::shared_ptr<Mesh> hills(int n, double size, std::uint64_t seed, double rough) {
    Random heights(seed + 100);
    return field(
        n, size,
        [&](double x, double y) {
            return 6 * std::sin(0.2 * x) * std::cos(0.17 * y) + uniform(heights, -rough, rough);
        },
        0.3, seed);
}

Tool some_tool() {
    Tool tool;
    tool.diameter = 6;
    tool.flute_length = 6;
    tool.shank_diameter = 12;
    tool.shank_length = 16;
    tool.holder = {{20, 10}, {14, 5}, {30, 12}};
    return tool;
}

/// Every body of the tool against every facet.
double reference(const Tool& tool, const Mesh& mesh, const ToolPose& pose) {
    const Mesh local = turned(mesh, pose);
    double best = brute_lift(BruteCutter(tool.cutter()), local, 0, 0);
    double height = tool.flute_length;
    const auto cylinder = [&](double diameter, double length) {
        const BruteCutter flat([](long double) { return 0.0L; }, diameter / 2);
        best = std::max(best, brute_lift(flat, local, 0, 0) - height);
        height += length;
    };
    cylinder(tool.shank_diameter, tool.shank_length);
    for (const HolderSection& section : tool.holder)
        cylinder(section.diameter, section.length);
    return best;
}

bool agree(double a, double b, double accuracy) {
    return a == b || std::abs(a - b) <= accuracy;
}

} // namespace

class TestToolLift : public QObject {
    Q_OBJECT
private slots:
    /// Single facets of all families, at any axis. Turning the mesh rounds: a case that hangs on the last
    /// digit is held against neighbours, as for upright axes.
    void single_facets_at_any_axis() {
        int touched = 0, borderline = 0;
        for (std::uint64_t i = 0; i < trials(40000u); ++i) {
            const LiftCase c = lift_case(i);
            Random rng(i + 77);
            ToolPose pose{Vec3(c.x, c.y, uniform(rng, -10, 10)), random_axis(rng, -1)};
            if (i % 5 == 0) pose.axis = Vec3::Unit(int(i / 5 % 3)) * (i % 2 ? 1 : -1);
            // Corners of the family, turned so that its axis is that of the pose.
            const auto mesh = std::make_shared<Mesh>();
            const Vec3 u = pose.axis.unitOrthogonal(), v = pose.axis.cross(u);
            for (const Vec3& p : c.corner)
                mesh->vertices.push_back(pose.tip + (p.x() - c.x) * u + (p.y() - c.y) * v
                                         + p.z() * pose.axis);
            mesh->facets = {{0, 1, 2}};
            const ToolLift lift(std::make_shared<ContactIndex>(mesh, Progress()), CutterProfile(c.cutter));
            const double got = lift.lift(pose);
            const BruteCutter brute(c.cutter);
            const Mesh local = turned(*mesh, pose);
            double lowest = brute_lift(brute, local, 0, 0), highest = lowest;
            touched += got > -infinity;
            const double accuracy = 10 * tolerance::lift_accuracy, digit = 1e-12;
            if (got == lowest || std::abs(got - lowest) <= accuracy) continue;
            // At the edge of what the cutter reaches the last digit of the place decides.
            ++borderline;
            for (const auto& [dx, dy] : {std::pair{digit, 0.0}, {-digit, 0.0}, {0.0, digit}, {0.0, -digit}}) {
                const double wanted = brute_lift(brute, local, dx, dy);
                lowest = std::min(lowest, wanted);
                highest = std::max(highest, wanted);
            }
            QVERIFY2(got >= lowest - accuracy && got <= highest + accuracy,
                     qPrintable(QString("case %1 (%2): %3, the reference says %4 to %5")
                                    .arg(i)
                                    .arg(c.family)
                                    .arg(got, 0, 'g', 17)
                                    .arg(lowest, 0, 'g', 17)
                                    .arg(highest, 0, 'g', 17)));
        }
        QVERIFY(touched > trials(30000));
        QVERIFY2(borderline < trials(4000), qPrintable(QString::number(borderline)));
    }

    void whole_tools() {
        const Tool tool = some_tool();
        for (const double rough : {0.0, 0.8}) {
            const auto mesh = hills(24, 60, 3, rough);
            const ToolLift lift(std::make_shared<ContactIndex>(mesh, Progress()), tool);
            Random rng(5);
            int bodies[4] = {};
            for (int i = 0; i < trials(600, 3); ++i) {
                const ToolPose pose{Vec3(uniform(rng, 0, 60), uniform(rng, 0, 60), uniform(rng, -5, 5)),
                                    random_axis(rng, i % 3 ? 0.3 : -1)};
                const double wanted = reference(tool, *mesh, pose), got = lift.lift(pose);
                QVERIFY2(agree(got, wanted, 1e-8),
                         qPrintable(QString("%1: %2 %3").arg(i).arg(got).arg(wanted)));
                const ToolContact contact = lift.contact(pose);
                QCOMPARE(contact.lift, got);
                ++bodies[int(contact.body)];
                ToolLift::Hint hint;
                if (std::isfinite(got)) {
                    QVERIFY(lift.is_deeper(pose, got - 1e-6, hint));
                    QVERIFY(lift.is_deeper(pose, got - 5, hint));
                }
                QVERIFY(!lift.is_deeper(pose, got, hint));
                QVERIFY(!lift.is_deeper(pose, got + 1e-6, hint));
            }
            QVERIFY2(std::min({bodies[1], bodies[2], bodies[3]}) > trials(20, 3),
                     qPrintable(QString("%1 %2 %3").arg(bodies[1]).arg(bodies[2]).arg(bodies[3])));
        }
    }

    /// Which way a facet is wound says nothing, and the bounds over many of them, whose normals then look
    /// either way, must hold: slopes with spikes of one height, all on one side, which a broad cutter meets
    /// two or three of.
    void winding_changes_nothing() {
        Random rng(31);
        const CutterProfile broad(AptCutter::bull(40, 1, 20));
        for (const double spike : {1.0, 2.0, -1.0}) {
            const auto mesh = field(
                48, 60,
                [&](double x, double y) { return 0.9 * x - 0.5 * y + (whole(rng, 0, 99) == 0 ? spike : 0); },
                0.2, 11);
            const auto wound = std::make_shared<Mesh>(*mesh);
            for (Facet& f : wound->facets)
                if (whole(rng, 0, 1)) std::swap(f[1], f[2]);
            const ToolLift one(std::make_shared<ContactIndex>(mesh, Progress()), broad),
                other(std::make_shared<ContactIndex>(wound, Progress()), broad);
            for (int i = 0; i < trials(1000, 2); ++i) {
                const Vec2 at(uniform(rng, 0, 60), uniform(rng, 0, 60));
                const ToolPose pose{
                    Vec3(at.x(), at.y(), 0.9 * at.x() - 0.5 * at.y()),
                    (Vec3(-0.9, 0.5, 1).normalized() + 0.01 * random_axis(rng, -1)).normalized()};
                const double wanted = one.lift(pose), got = other.lift(pose);
                QVERIFY2(agree(got, wanted, 1e-9),
                         qPrintable(QString("%1: %2, not %3").arg(i).arg(got).arg(wanted)));
                if (i % 400 == 0)
                    QVERIFY(
                        agree(got, brute_lift(BruteCutter(broad.cutter()), turned(*mesh, pose), 0, 0), 1e-8));
            }
        }
    }

    void contact_is_on_part_and_tool() {
        const auto mesh = hills(24, 60, 4, 0.3);
        const Tool tool = some_tool();
        const ToolLift lift(std::make_shared<ContactIndex>(mesh, Progress()), tool);
        Random rng(6);
        for (int i = 0; i < 500; ++i) {
            const ToolPose pose{Vec3(uniform(rng, 5, 55), uniform(rng, 5, 55), 0), random_axis(rng, 0.4)};
            const ToolContact contact = lift.contact(pose);
            if (contact.body == ToolBody::none) continue;
            const Vec3 d = contact.point - pose.tip - contact.lift * pose.axis;
            const double up = d.dot(pose.axis), rho = (d - up * pose.axis).norm();
            // Its height on the tool is that of the body's lower surface there.
            double height = tool.flute_length, wanted = infinity, radius = 0;
            if (contact.body == ToolBody::cutter) {
                wanted = lift.cutter().height_at(std::min(rho, lift.cutter().max_radius()));
                radius = lift.cutter().max_radius();
            } else if (contact.body == ToolBody::shank) {
                wanted = height;
                radius = 0.5 * tool.shank_diameter;
            } else {
                height += tool.shank_length;
                for (int s = 0; s < contact.section; ++s)
                    height += tool.holder[std::size_t(s)].length;
                wanted = height;
                radius = 0.5 * tool.holder[std::size_t(contact.section)].diameter;
            }
            QVERIFY(rho <= radius + 1e-9);
            QVERIFY2(std::abs(up - wanted) <= 1e-8, qPrintable(QString("%1 %2").arg(up).arg(wanted)));
            // And it lies in the plane of the facet.
            const Vec3 n = mesh->facet_normal(contact.facet);
            QVERIFY(std::abs(n.dot(contact.point - mesh->corner(contact.facet, 0))) <= 1e-8);
        }
    }

    void upright_is_the_axial_lift() {
        const auto mesh = hills(20, 60, 9, 0.5);
        const auto index = std::make_shared<ContactIndex>(mesh, Progress());
        Random rng(2);
        for (int kind = 0; kind < 14; ++kind) {
            const CutterProfile profile(random_cutter(rng, kind, 7));
            const ToolLift tilted(index, profile, 0.2);
            const AxialLift upright(index, profile, 0.2);
            for (int i = 0; i < 200; ++i) {
                const Vec3 tip(uniform(rng, 0, 60), uniform(rng, 0, 60), uniform(rng, -3, 3));
                QVERIFY(agree(tip.z() + tilted.lift({tip, Vec3::UnitZ()}), upright.tip_z(tip.x(), tip.y()),
                              1e-9));
            }
        }
    }

    void batches_give_the_same_bits() {
        const auto mesh = hills(24, 60, 3, 0.4);
        const ToolLift lift(std::make_shared<ContactIndex>(mesh, Progress()), some_tool());
        Random rng(8);
        std::vector<ToolPose> poses;
        for (int i = 0; i < 3000; ++i)
            poses.push_back(
                {Vec3(0.02 * i, 30 + 0.003 * i, 0), Vec3(0.3 * std::sin(0.01 * i), 0.2, 1).normalized()});
        std::vector<double> many(poses.size()), other(poses.size());
        lift.lift(poses, many, Progress());
        set_thread_count(1);
        lift.lift(poses, other, Progress());
        set_thread_count(0);
        QVERIFY(std::memcmp(many.data(), other.data(), sizeof(double) * many.size()) == 0);
        for (std::size_t i = 0; i < poses.size(); ++i)
            QCOMPARE(lift.lift(poses[i]), many[i]);
        Job job;
        job.cancel();
        QVERIFY_THROWS_EXCEPTION(Cancelled, lift.lift(poses, many, Progress(job)));
    }

    void groups_give_the_same_bits() {
        Random rng(23);
        int met = 0, free = 0;
        for (const int n : {3, 20, 90}) {
            const auto mesh = hills(n, 60, 5, 0.2);
            const auto index = std::make_shared<ContactIndex>(mesh, Progress());
            for (int i = 0; i < trials(300); ++i) {
                const ToolLift lift(index, some_tool(), {.cutter = i % 3 == 0 ? 0.5 : 0});
                // From poses that are all but one to poses that have nothing in common.
                const double spread = std::pow(10.0, uniform(rng, -5, 0.3));
                const Vec3 axis = random_axis(rng, 0.1),
                           tip(uniform(rng, -5, 65), uniform(rng, -5, 65), uniform(rng, -8, 12));
                std::vector<ToolPose> poses;
                for (int k = whole(rng, 1, 20); k > 0; --k) {
                    const Vec3 lean(uniform(rng, -1, 1), uniform(rng, -1, 1), uniform(rng, -1, 1));
                    const Vec3 move(uniform(rng, -5, 5), uniform(rng, -5, 5), uniform(rng, -5, 5));
                    poses.push_back({tip + spread * move, (axis + spread * lean).normalized()});
                }
                const double depth = i % 5 == 0 ? -infinity : uniform(rng, -3, 3);
                ToolLift::Group group;
                lift.gather(poses, depth, group);
                ToolLift::Hint hint, hint_in_group;
                for (const ToolPose& pose : poses) {
                    const double above = depth + (i % 2 == 0 ? 0 : uniform(rng, 0, 2));
                    const ToolContact one = lift.contact_above(pose, above, hint),
                                      other = lift.contact_above(pose, above, hint_in_group, group);
                    QVERIFY2(std::memcmp(&one.lift, &other.lift, sizeof(double)) == 0,
                             qPrintable(QString("%1 %2").arg(one.lift).arg(other.lift)));
                    QCOMPARE(one.body, other.body);
                    met += one.body != ToolBody::none;
                    free += one.body == ToolBody::none;
                }
            }
        }
        QVERIFY(met > trials(2000) && free > trials(1000));
    }

    void bodies_in_the_shadow_are_left_out_without_harm() {
        Tool tool = some_tool();
        tool.shank_diameter = 5; // never stops the tool: the cutter below is as wide
        tool.holder = {{6, 5}, {12, 5}, {10, 5}};
        const auto mesh = hills(20, 60, 1, 1);
        const ToolLift lift(std::make_shared<ContactIndex>(mesh, Progress()), tool);
        Random rng(3);
        for (int i = 0; i < 200; ++i) {
            const ToolPose pose{Vec3(uniform(rng, 0, 60), uniform(rng, 0, 60), 0), random_axis(rng, 0.2)};
            QVERIFY(agree(lift.lift(pose), reference(tool, *mesh, pose), 1e-8));
        }
    }

    /// A cutter put on a plane touches it and does not cut it, whatever its shape and the tilt.
    void touching_a_plane() {
        Random rng(12);
        for (int i = 0; i < trials(3000); ++i) {
            const CutterProfile profile(random_cutter(rng, i, 8));
            const Vec3 normal = random_axis(rng, -1);
            Vec3 axis = random_axis(rng, -1);
            if (axis.dot(normal) < 0.05) {
                QVERIFY_THROWS_EXCEPTION(Error, tip_at_contact(profile, Vec3::Zero(), normal, -normal));
                continue;
            }
            if (i % 7 == 0) axis = normal;
            const Vec3 at(uniform(rng, -5, 5), uniform(rng, -5, 5), uniform(rng, -5, 5));
            const Vec3 u = normal.unitOrthogonal(), v = normal.cross(u);
            const auto mesh = std::make_shared<Mesh>();
            mesh->vertices = {at + 3000 * u, at - 3000 * u + 5000 * v, at - 3000 * u - 5000 * v};
            mesh->facets = {{0, 1, 2}};
            const ToolLift lift(std::make_shared<ContactIndex>(mesh, Progress()), profile);
            const double error = lift.lift({tip_at_contact(profile, at, normal, axis), axis});
            QVERIFY2(std::abs(error) <= 1e-7, qPrintable(QString("%1: %2").arg(i).arg(error)));
        }
    }

    void causes() {
        ToolContact contact;
        QCOMPARE(block_cause(contact, Vec3::Zero(), 3), BlockCause::none);
        contact.body = ToolBody::cutter;
        contact.point = Vec3(2, 0, 0);
        QCOMPARE(block_cause(contact, Vec3::Zero(), 3), BlockCause::local);
        contact.point = Vec3(4, 0, 0);
        QCOMPARE(block_cause(contact, Vec3::Zero(), 3), BlockCause::global);
        contact.body = ToolBody::shank;
        QCOMPARE(block_cause(contact, Vec3::Zero(), 3), BlockCause::shank);
        contact.body = ToolBody::holder;
        QCOMPARE(block_cause(contact, Vec3::Zero(), 3), BlockCause::holder);
        QCOMPARE(QString(block_cause_name(BlockCause::global)), QString("global"));
    }

    void refuses_bad_poses() {
        const ToolLift lift(std::make_shared<ContactIndex>(hills(4, 20, 1, 0), Progress()), some_tool());
        QVERIFY_THROWS_EXCEPTION(Error, lift.lift({Vec3(0, 0, 0), Vec3(0, 0, 2)}));
        QVERIFY_THROWS_EXCEPTION(Error, lift.lift({Vec3(std::nan(""), 0, 0), Vec3(0, 0, 1)}));
        QVERIFY_THROWS_EXCEPTION(Error, lift.lift({Vec3(0, infinity, 0), Vec3(0, 0, 1)}));
        Tool tool = some_tool();
        tool.diameter = -1;
        const auto index = std::make_shared<ContactIndex>(hills(4, 20, 1, 0), Progress());
        QVERIFY_THROWS_EXCEPTION(Error, ToolLift(index, tool));
        QVERIFY_THROWS_EXCEPTION(Error, ToolLift(index, some_tool(), {.cutter = -1}));
    }
};

FACETMILL_TEST(TestToolLift)
#include "test_tool_lift.moc"
