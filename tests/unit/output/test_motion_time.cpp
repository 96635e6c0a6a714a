// Programs of several axes on a machine: times, turns, findings.
#include "core/base/turn.h"
#include "core/output/motion_time.h"
#include "core/setup/joint_course.h"
#include "tests/support/test_runner.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>

using namespace facetmill;

namespace {

ClSection timed_section(bool multi_axis) {
    ClSection p;
    p.multi_axis = multi_axis;
    p.feed_mm_per_min = 600; // 10 mm/s
    p.gauge_length = 100;
    p.part_box.add(Vec3(-50, -50, -50));
    p.part_box.add(Vec3(50, 50, 0));
    return p;
}

void add(ClSection& p, MotionKind kind, const Vec3& tip, const Vec3& axis = Vec3::UnitZ()) {
    p.motions.motions.push_back({.kind = kind, .to = {tip, axis}});
}

Vec3 leaning(double azimuth, double lean) {
    return {std::sin(lean) * std::cos(azimuth), std::sin(lean) * std::sin(azimuth), std::cos(lean)};
}

/// Round a cone, the tool leaning outward.
ClSection round_and_round(double turns, double lean, int steps = 36) {
    ClSection p = timed_section(true);
    add(p, MotionKind::rapid, Vec3(10, 0, 5), leaning(0, lean));
    for (int i = 0; i <= int(turns * steps); ++i)
        add(p, MotionKind::cut, leaning(2 * pi * i / steps, pi / 2) * 10, leaning(2 * pi * i / steps, lean));
    return p;
}

bool near(double a, double b, double tolerance = 1e-9) {
    return std::abs(a - b) <= tolerance * (1 + std::abs(b));
}

} // namespace

class TestMotionTime : public QObject {
    Q_OBJECT
private slots:

    void the_slowest_joint_or_the_feed() {
        const Machine& tarus = find_machine("tarus-tpi-2000");
        ClSection p = timed_section(true);
        const Vec3 leant = leaning(-pi / 2, 0.1); // A 0.1: towards -Y
        add(p, MotionKind::rapid, Vec3::Zero());
        add(p, MotionKind::cut, Vec3::Zero(), leant);               // A alone: 0.1 at 0.5 rad/s
        add(p, MotionKind::cut, Vec3(5, 0, 0), leant);              // 5 mm at feed
        add(p, MotionKind::rapid, Vec3(5, 0, 24), leant);           // 24 mm at 240 mm/s
        add(p, MotionKind::rapid, Vec3(5, 0, 24), leaning(0, 0.1)); // C a quarter turn at 0.3 rad/s
        add(p, MotionKind::approach, Vec3(5, 0, 23),
            leaning(pi / 2, 0.1)); // C again, though the way takes 0.1 s
        const std::vector<double> seconds = motion_seconds(p, tarus);
        const std::vector<double> expected{0, 0.2, 0.5, 0.1, pi / 2 / 0.3, pi / 2 / 0.3};
        for (std::size_t i = 0; i < expected.size(); ++i)
            QVERIFY2(near(seconds[i], expected[i]), qPrintable(QString::number(i)));
        const MotionTotals t = motion_totals(p, tarus);
        QVERIFY(near(t.time_seconds, 0.8 + pi / 0.3));
        QCOMPARE(t.cut_length, 6.0);
        QCOMPARE(t.rapid_length, 24.0);
        const MachineMotion m = machine_motion(p, tarus);
        QVERIFY(m.findings.empty());
        QVERIFY(near(m.motions[1].rates[4], 0.5));
        QVERIFY(near(m.motions[1].rates[1],
                     -100 * std::sin(0.1) / 0.2)); // the nose, 100 above the tip, goes to -Y
        QVERIFY(near(m.largest_angular_rate, 0.5));
        QCOMPARE(m.fastest_turn, std::size_t(1));
        QVERIFY(near(m.time_seconds, t.time_seconds));
    }

    void three_axes_are_timed_as_ever() {
        std::mt19937_64 rng(3);
        std::uniform_real_distribution<double> xyz(-50, 50);
        ClSection p = timed_section(false);
        for (int i = 0; i < 500; ++i)
            add(p, i % 5 ? MotionKind::cut : MotionKind::rapid, Vec3(xyz(rng), xyz(rng), xyz(rng)));
        for (const Machine& m : machines()) {
            double expected = 0;
            for (std::size_t i = 1; i < 500; ++i) {
                const Vec3 step = p.motions.motions[i].to.tip - p.motions.motions[i - 1].to.tip;
                expected +=
                    i % 5 ? step.norm() / 10 : (step.array().abs() / m.rapid_mm_per_s.array()).maxCoeff();
            }
            QVERIFY(near(motion_totals(p, m).time_seconds, expected));
            const MachineMotion all = machine_motion(p, m);
            QVERIFY2(near(all.time_seconds, expected), m.name.c_str());
            QVERIFY2(all.findings.empty(), m.name.c_str());
            QCOMPARE(all.largest_angular_rate, 0.0);
            // The same program as one of several axes: cuts at feed take no less, rapids the same.
            ClSection five = p;
            five.multi_axis = true;
            QVERIFY2(near(motion_totals(five, m).time_seconds, expected), m.name.c_str());
        }
    }

    void joints_lead_back_to_the_program() {
        const ClSection p = round_and_round(3, radians(25));
        for (const char* name : {"tarus-tpi-2000", "trunnion-ac", "trunnion-bc", "head-b-table-c"}) {
            const Machine& machine = find_machine(name);
            const Kinematics k(machine, p.gauge_length, default_part_origin(machine, p.part_box));
            const MachineMotion m = machine_motion(p, machine);
            double sum = 0;
            for (std::size_t i = 0; i < m.motions.size(); ++i) {
                QVERIFY2(m.motions[i].held, name);
                const ToolPose there = k.forward(m.motions[i].at);
                QVERIFY((there.tip - p.motions.motions[i].to.tip).norm() < 1e-9);
                QVERIFY((there.axis - p.motions.motions[i].to.axis).norm() < 1e-12);
                sum += m.motions[i].seconds;
                for (int j = 0; j < machine.joints(); ++j)
                    QVERIFY(std::abs(m.motions[i].rates[std::size_t(j)]) <= machine.speed(j) * (1 + 1e-12));
            }
            QVERIFY(near(sum, motion_totals(p, machine).time_seconds));
        }
    }

    void turns_go_on_until_travel_ends() {
        // C of this table has no limits: three turns in one way, nothing to report.
        const ClSection p = round_and_round(3, radians(25));
        const MachineMotion free = machine_motion(p, find_machine("head-b-table-c"));
        QVERIFY(free.findings.empty());
        QCOMPARE(free.reversals[4], std::size_t(0));
        QVERIFY(near(std::abs(free.motions.back().at[4] - free.motions.front().at[4]), 6 * pi));
        QVERIFY(free.reversals[0] >= 4 || free.reversals[1] >= 4 || free.reversals[3] == 0);
        // That of the fork has 720 degrees: it must go back once, and swings the tool while it cuts.
        const MachineMotion bound = machine_motion(p, find_machine("tarus-tpi-2000"));
        QVERIFY(!bound.findings.empty());
        for (const MotionFinding& f : bound.findings) {
            QVERIFY(f.kind == MotionFinding::Kind::swing);
            QCOMPARE(f.joint, 3);
            QVERIFY(f.amount > radians(10) && f.amount < radians(60));
        }
        QVERIFY(bound.reversals[3] >= 1);
        QVERIFY(finding_text(bound.findings[0], find_machine("tarus-tpi-2000"), LengthUnit::mm)
                    .find("C swings the tool")
                != std::string::npos);
        // Once round is within travel.
        QVERIFY(
            machine_motion(round_and_round(1, radians(25)), find_machine("tarus-tpi-2000")).findings.empty());
    }

    void what_cannot_be_held_is_found() {
        using Kind = MotionFinding::Kind;
        ClSection p = timed_section(true);
        add(p, MotionKind::rapid, Vec3(0, 0, 5));
        add(p, MotionKind::cut, Vec3(0, 0, 0), leaning(pi / 2, radians(30)));
        add(p, MotionKind::cut, Vec3(0, 0, 0), -Vec3::UnitZ());
        add(p, MotionKind::cut, Vec3(1, 0, 0));
        add(p, MotionKind::rapid, Vec3(371, 0, 5));
        const MachineMotion ac = machine_motion(p, find_machine("trunnion-ac"));
        QCOMPARE(ac.findings.size(), std::size_t(2));
        QVERIFY(ac.findings[0].kind == Kind::rotary_travel && ac.findings[0].motion == 2
                && ac.findings[0].joint == 3);
        QVERIFY(near(ac.findings[0].amount, radians(60)));
        QVERIFY(ac.findings[1].kind == Kind::linear_travel && ac.findings[1].motion == 4);
        QVERIFY(!ac.motions[2].held && ac.motions[3].held && !ac.motions[4].held);
        QCOMPARE(finding_text(ac.findings[0], find_machine("trunnion-ac"), LengthUnit::mm),
                 std::string("motion 3: A ends 60° too early"));
        QCOMPARE(
            finding_text({Kind::linear_travel, 4, 0, 25.4}, find_machine("trunnion-ac"), LengthUnit::inch),
            std::string("motion 5: X ends 1 in too early"));
        const MachineMotion three = machine_motion(p, find_machine("generic-3-axis"));
        QCOMPARE(three.findings.size(), std::size_t(2));
        QVERIFY(three.findings[0].kind == Kind::axis && three.findings[1].kind == Kind::axis);
        QVERIFY(finding_text(three.findings[0], find_machine("generic-3-axis"), LengthUnit::mm)
                    .starts_with("motion 2: "));
        // Times stay finite.
        QVERIFY(std::isfinite(three.time_seconds) && std::isfinite(ac.time_seconds));
    }

    void the_beginning_is_chosen_for_the_whole() {
        // A +20 would end at +30: the program must begin with A -20.
        ClSection p = timed_section(true);
        for (int i = 0; i <= 60; ++i)
            add(p, i ? MotionKind::cut : MotionKind::rapid, Vec3(0, 0, 0), leaning(-pi / 2, radians(20 + i)));
        const MachineMotion m = machine_motion(p, find_machine("trunnion-ac"));
        QVERIFY(m.findings.empty());
        QVERIFY(near(m.motions.front().at[3], radians(-20)));
        QVERIFY(near(m.motions.back().at[3], radians(-80)));
    }

    void a_turn_above_the_part_saves_one_in_it() {
        // Upright, then above the part to a lean that A +20 holds sooner; but it grows, and A ends at +30.
        ClSection p = timed_section(true);
        add(p, MotionKind::rapid, Vec3(0, 0, 9));
        for (int i = 0; i <= 60; ++i)
            add(p, i ? MotionKind::cut : MotionKind::rapid, Vec3(0, 0, 0), leaning(-pi / 2, radians(20 + i)));
        const MachineMotion m = machine_motion(p, find_machine("trunnion-ac"));
        QVERIFY(m.findings.empty());
        QVERIFY(near(m.motions[1].at[3], radians(-20)));
        QVERIFY(near(m.motions.back().at[3], radians(-80)));
        // While it cuts the way back by two whole turns is no way either, though half of it ends at one.
        const MachineMotion bound =
            machine_motion(round_and_round(2.5, radians(25)), find_machine("tarus-tpi-2000"));
        QCOMPARE(bound.findings.size(), std::size_t(1));
    }

    /// Against every combination of solutions and turns: none strays less, and of those that stray as little
    /// none is sooner.
    void no_other_course_is_sooner() {
        std::mt19937_64 rng(11);
        std::uniform_real_distribution<double> at(-1, 1);
        for (const char* name : {"tarus-tpi-2000", "trunnion-ac", "trunnion-bc", "head-b-table-c"}) {
            const Machine& machine = find_machine(name);
            for (int trial = 0; trial < 12; ++trial) {
                ClSection p = timed_section(true);
                for (int i = 0; i < 4; ++i)
                    add(p, i % 3 ? MotionKind::cut : MotionKind::rapid, 20 * Vec3(at(rng), at(rng), at(rng)),
                        leaning(pi * at(rng), radians(trial % 2 ? 4 : 50) * std::abs(at(rng))));
                const auto& motions = p.motions.motions;
                const Kinematics k(machine, p.gauge_length, default_part_origin(machine, p.part_box));
                std::vector<std::vector<Joints>> routes;
                for (const Motion& m : motions) {
                    routes.emplace_back();
                    for (const double a : {0.0, 2 * pi, -2 * pi})
                        for (const double b : {0.0, 2 * pi, -2 * pi}) {
                            const auto held =
                                k.within_travel({m.to.tip, m.to.axis}, Joints{Vec3::Zero(), {a, b}});
                            for (int w = 0; w < held.count; ++w) {
                                const Joints& j = held.at[std::size_t(w)];
                                const auto same = [&](const Joints& o) {
                                    return near(o.rotary[0], j.rotary[0]) && near(o.rotary[1], j.rotary[1]);
                                };
                                if (std::none_of(routes.back().begin(), routes.back().end(), same))
                                    routes.back().push_back(j);
                            }
                        }
                }
                const auto step = [&](std::size_t i, const Joints& from, const Joints& to) {
                    const bool rapid = motions[i].kind == MotionKind::rapid;
                    const double feed =
                        rapid ? 0 : (motions[i].to.tip - motions[i - 1].to.tip).norm() / 10; // 10 mm/s
                    const double time = std::max(feed, k.time(from, to));
                    const Vec3 &a = motions[i - 1].to.axis, &b = motions[i].to.axis;
                    double off = 0; // from the great circle
                    for (const double t : {0.25, 0.5, 0.75}) {
                        Joints on;
                        for (std::size_t r = 0; r < 2; ++r)
                            on.rotary[r] = (1 - t) * from.rotary[r] + t * to.rotary[r];
                        const Vec3 meant = Eigen::Quaterniond::Identity().slerp(t, turn_between(a, b)) * a;
                        off = std::max(off, (k.forward(on).axis - meant).norm());
                    }
                    if (rapid) return time + (off > radians(1) || turns_over(from, to) ? 100 : 0);
                    const bool swings = swing_between(k, from, to, a, b) > radians(1);
                    return time + (swings ? 1e9 : 0) + 5e6 * off + (turns_over(from, to) ? 1000 : 0);
                };
                double least = infinity;
                const std::function<void(std::size_t, const Joints&, double)> all =
                    [&](std::size_t i, const Joints& last, double sum) {
                        if (sum >= least) return;
                        if (i == motions.size()) {
                            least = sum;
                            return;
                        }
                        for (const Joints& to : routes[i])
                            all(i + 1, to, sum + step(i, last, to));
                    };
                for (const Joints& first : routes[0])
                    all(1, first, 0);
                const MachineMotion found = machine_motion(p, machine);
                double cost = 0;
                for (std::size_t i = 1; i < motions.size(); ++i)
                    cost += step(i, found.motions[i - 1].at, found.motions[i].at);
                QVERIFY2(cost <= least + 0.002 * found.time_seconds + 1e-9 * least,
                         qPrintable(QString("%1 %2: %3 %4").arg(name).arg(trial).arg(cost).arg(least)));
                QVERIFY(cost >= least * (1 - 1e-9));
            }
        }
    }

    /// Longer than what is decided at once.
    void long_programs_go_on() {
        const ClSection p = round_and_round(1, radians(25), 40000);
        for (const char* name : {"tarus-tpi-2000", "head-b-table-c"}) {
            const MachineMotion m = machine_motion(p, find_machine(name));
            QVERIFY2(m.findings.empty(), name);
            QVERIFY2(
                near(m.time_seconds,
                     motion_totals(round_and_round(1, radians(25), 400), find_machine(name)).time_seconds,
                     1e-3),
                name);
        }
    }

    void reversals_are_counted_per_run() {
        ClSection p = timed_section(true);
        const auto x = [&](MotionKind kind, double at) { add(p, kind, Vec3(at, 0, 0)); };
        x(MotionKind::rapid, 0);
        for (const double at : {1.0, 2.0, 1.0, 1.0, 0.5, 0.5 + 1e-9, 3.0})
            x(MotionKind::cut, at); // back at 2 and at 0.5
        x(MotionKind::rapid, 9);
        x(MotionKind::cut, 8);
        const MachineMotion m = machine_motion(p, find_machine("tarus-tpi-2000"));
        QCOMPARE(m.reversals[0], std::size_t(2));
        QCOMPARE(m.reversals[1] + m.reversals[2] + m.reversals[3] + m.reversals[4], std::size_t(0));
    }

    void accelerations_cost_time_where_speeds_change() {
        Machine machine = find_machine("tarus-tpi-2000");
        machine.acceleration_mm_per_s2 = Vec3::Constant(20);
        ClSection p = timed_section(true);
        const MotionTimeOptions with{.accelerations = true};
        add(p, MotionKind::rapid, Vec3(0, 0, 0));
        add(p, MotionKind::cut, Vec3(20, 0, 0));
        add(p, MotionKind::cut, Vec3(40, 0, 0)); // straight on: one trapezoid, 4 s and 10/20 s
        QVERIFY(near(motion_totals(p, machine).time_seconds, 4));
        QVERIFY(near(motion_totals(p, machine, with).time_seconds, 4.5));
        add(p, MotionKind::cut, Vec3(20, 0, 0)); // back again: two trapezoids
        QVERIFY(near(motion_totals(p, machine, with).time_seconds, 7));
        // Short motions to and fro never get faster than from rest to rest.
        ClSection shaking = timed_section(true);
        for (int i = 0; i < 100; ++i)
            add(shaking, i ? MotionKind::cut : MotionKind::rapid, Vec3(i % 2 ? 0.05 : 0, 0, 0));
        QVERIFY(near(motion_totals(shaking, machine, with).time_seconds, 99 * 2 * std::sqrt(0.05 / 20)));
        // Programs of three axes are timed so as well; without accelerations in the file nothing changes.
        p.multi_axis = false;
        QVERIFY(near(motion_totals(p, machine, with).time_seconds, 7));
        QVERIFY(near(motion_totals(p, find_machine("tarus-tpi-2000"), with).time_seconds, 6));
    }

    void empty_and_cancelled() {
        QCOMPARE(motion_totals(timed_section(true), find_machine("trunnion-ac")).time_seconds, 0.0);
        QVERIFY(motion_seconds(timed_section(true), find_machine("trunnion-ac")).empty());
        Job job;
        job.cancel();
        QVERIFY_THROWS_EXCEPTION(Cancelled, machine_motion(round_and_round(2, 0.3),
                                                           find_machine("trunnion-ac"), {}, Progress(job)));
    }
};

FACETMILL_TEST(TestMotionTime)
#include "test_motion_time.moc"
