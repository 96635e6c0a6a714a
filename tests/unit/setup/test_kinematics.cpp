// Machines and their axes: poses there and back, known answers, travel, winding.
#include "core/base/error.h"
#include "core/base/tolerances.h"
#include "core/setup/kinematics.h"
#include "tests/support/test_runner.h"

#include <QTest>

#include <random>

using namespace facetmill;

namespace {

constexpr double length = 100;

double uniform(std::mt19937_64& rng, double lo, double hi) {
    return std::uniform_real_distribution<double>(lo, hi)(rng);
}

Vec3 random_axis(std::mt19937_64& rng) {
    for (;;) {
        const Vec3 v(uniform(rng, -1, 1), uniform(rng, -1, 1), uniform(rng, -1, 1));
        if (const double n = v.norm(); n > 0.1 && n < 1) return v / n;
    }
}

/// A head whose inner axis is inclined by 45 degrees, away from the nose, and the same as a table.
Machine nutating(const std::string& carries, bool outer_first) {
    const std::string c = R"({"kind": "rotary", "name": "C", "carries": ")" + carries
                          + R"(", "direction": [0, 0, 1], "point": [3, -2, 150], "sign": -1, "speed": 60})";
    const std::string b = R"({"kind": "rotary", "name": "B", "carries": ")" + carries
                          + R"(", "direction": [0, 1, 1], "point": [5, 7, 180], "sign": 1, "speed": 40})";
    return parse_machine(R"({"facetmill_machine": 1, "label": "n", "units": "mm", "axes": [
        {"kind": "linear", "name": "X", "speed": 1}, {"kind": "linear", "name": "Y", "speed": 1},
        {"kind": "linear", "name": "Z", "speed": 1}, )"
                             + (outer_first ? c + "," + b : b + "," + c) + "]}",
                         "nutating.json");
}

/// An axis that the machine can hold at some angles.
Vec3 held_axis(const std::string& name, std::mt19937_64& rng) {
    if (name == "generic-3-axis") return Vec3::UnitZ();
    if (name == "generic-4-axis-a" || name == "lathe-mill") {
        const double a = uniform(rng, -pi, pi);
        return {0, std::sin(a), std::cos(a)};
    }
    Vec3 v = random_axis(rng);
    if (name.starts_with("nutating")) v.z() = std::abs(v.z());
    return v;
}

std::vector<std::pair<std::string, Machine>> all_kinds() {
    std::vector<std::pair<std::string, Machine>> kinds;
    for (const Machine& m : machines())
        kinds.emplace_back(m.name, m);
    kinds.emplace_back("nutating head", nutating("tool", true));
    kinds.emplace_back("nutating table", nutating("table", false));
    // Long levers on both sides, lines that miss each other.
    Machine skew = find_machine("tarus-tpi-2000");
    skew.rotary[0].point = Vec3(20, -30, 0);
    skew.rotary[1].point = Vec3(0, 15, 320);
    skew.rotary[1].sign = -1;
    kinds.emplace_back("tarus with levers", skew);
    return kinds;
}

bool same(const Joints& a, const Vec3& linear, double r0, double r1) {
    return (a.linear - linear).norm() < 1e-9 && std::abs(a.rotary[0] - r0) < 1e-12
           && std::abs(a.rotary[1] - r1) < 1e-12;
}

/// All cases where the tests labelled slow run, a hundredth elsewhere.
int cases(int n) {
    return qEnvironmentVariableIsSet("FACETMILL_MANY_CASES") ? n : n / 100;
}

} // namespace

class TestKinematics : public QObject {
    Q_OBJECT
private slots:

    void poses_survive_the_way_there_and_back() {
        std::mt19937_64 rng(7);
        for (const auto& [name, machine] : all_kinds()) {
            const Kinematics k(machine, length, Vec3(12, -30, 45));
            double worst_tip = 0, worst_axis = 0, widest = 0, nearest_pair = infinity;
            std::size_t wrong_count = 0;
            const int expected = machine.rotary.size() == 2 ? 2 : 1;
            Joints near;
            for (int i = 0; i < cases(1'000'000); ++i) {
                const ToolPose pose{Vec3(uniform(rng, -60, 60), uniform(rng, -60, 60), uniform(rng, -60, 60)),
                                    held_axis(name, rng)};
                const auto solutions = k.inverse(pose, near);
                wrong_count += solutions.count != expected;
                for (int s = 0; s < solutions.count; ++s) {
                    const Joints& j = solutions.at[std::size_t(s)];
                    const ToolPose back = k.forward(j);
                    worst_tip = std::max(worst_tip, (back.tip - pose.tip).norm());
                    worst_axis = std::max(worst_axis, (back.axis - pose.axis).norm());
                    for (const double r : j.rotary)
                        widest = std::max(widest, r > -pi ? std::abs(r) : 2 * pi);
                }
                if (solutions.count == 2)
                    nearest_pair = std::min(
                        nearest_pair, std::abs(solutions.at[0].rotary[0] - solutions.at[1].rotary[0])
                                          + std::abs(solutions.at[0].rotary[1] - solutions.at[1].rotary[1]));
            }
            qInfo("%s: tip %.1e mm, axis %.1e", name.c_str(), worst_tip, worst_axis);
            QVERIFY2(worst_tip < 1e-9, name.c_str());
            QVERIFY2(worst_axis < 1e-12, name.c_str());
            QVERIFY2(wrong_count == 0, name.c_str());
            QVERIFY2(widest <= pi, name.c_str());
            QVERIFY2(expected == 1 || nearest_pair > 1e-6, name.c_str());
        }
    }

    void joints_survive_the_way_there_and_back() {
        std::mt19937_64 rng(8);
        for (const auto& [name, machine] : all_kinds()) {
            const Kinematics k(machine, length, Vec3(12, -30, 45));
            for (int i = 0; i < 20000; ++i) {
                Joints j;
                j.linear = Vec3(uniform(rng, -99, 99), uniform(rng, -99, 99), uniform(rng, -99, 99));
                for (std::size_t r = 0; r < machine.rotary.size(); ++r)
                    j.rotary[r] = uniform(rng, -3.1, 3.1);
                const auto solutions = k.inverse(k.forward(j), j);
                double nearest = infinity;
                for (int s = 0; s < solutions.count; ++s) {
                    const Joints& back = solutions.at[std::size_t(s)];
                    nearest = std::min(nearest, (back.linear - j.linear).norm()
                                                    + std::abs(back.rotary[0] - j.rotary[0])
                                                    + std::abs(back.rotary[1] - j.rotary[1]));
                }
                QVERIFY2(nearest < 1e-8, name.c_str()); // joints near a singular pose are known less well
            }
        }
    }

    // Worked out with pencil and paper from the drawing of each machine, so that no sign is wrong both ways.
    void known_answers() {
        const auto check = [](const Machine& m, const Vec3& origin, const ToolPose& pose, const Vec3& linear,
                              double r0, double r1) {
            const Kinematics k(m, length, origin);
            Joints j;
            j.linear = linear;
            j.rotary = {r0, r1};
            const ToolPose there = k.forward(j);
            QVERIFY2((there.tip - pose.tip).norm() < 1e-9, m.name.c_str());
            QVERIFY2((there.axis - pose.axis).norm() < 1e-12, m.name.c_str());
            const auto back = k.inverse(pose, {});
            bool found = false;
            for (int s = 0; s < back.count; ++s)
                found |= same(back.at[std::size_t(s)], linear, r0, r1);
            QVERIFY2(found, m.name.c_str());
        };
        const double half = 0.5, high = std::sqrt(0.75);
        check(find_machine("generic-3-axis"), Vec3(1, 2, 3), {Vec3(10, 20, 30), Vec3::UnitZ()},
              Vec3(11, 22, 133), 0, 0);
        // A lifts nothing at 30 degrees but leans the tool to -Y; C brings -Y to +X. The pivot is 350 above
        // the tip.
        Machine tarus = find_machine("tarus-tpi-2000");
        tarus.rotary[0].point = tarus.rotary[1].point = Vec3(0, 0, 250);
        check(tarus, Vec3::Zero(), {Vec3(10, 20, 30), Vec3(half, 0, high)},
              Vec3(185, 20, 30 + 350 * high - 250), radians(90), radians(30));
        // -X of the part must come up: C brings it to +Y, A tips that over the cradle, 50 above the table.
        check(find_machine("trunnion-ac"), Vec3::Zero(), {Vec3(-40, 5, 20), -Vec3::UnitX()}, Vec3(5, 30, 190),
              radians(-90), radians(90));
        // +Y of the part must come up: C brings it to +X, B tips that up.
        check(find_machine("trunnion-bc"), Vec3::Zero(), {Vec3(3, 40, 20), Vec3::UnitY()}, Vec3(30, -3, 190),
              radians(90), radians(90));
        // The table turns half round, the head leans the tool to +X about a pivot 300 above the tip.
        check(find_machine("head-b-table-c"), Vec3::Zero(), {Vec3(10, 20, 30), Vec3(-half, 0, high)},
              Vec3(140, -20, 30 + 300 * high - 200), radians(30), radians(180));
        // +Y of the part must come up: a quarter turn about a line at Y 0, Z 150.
        check(find_machine("generic-4-axis-a"), Vec3(400, 0, 150), {Vec3(7, 30, 20), Vec3::UnitY()},
              Vec3(407, -20, 280), radians(-90), 0);
        // Half a turn about a line inclined by 45 degrees lays the tool along +Y.
        Machine head = nutating("tool", true);
        head.rotary[0].point = head.rotary[1].point = Vec3::Zero();
        check(head, Vec3::Zero(), {Vec3(1, 2, 3), Vec3::UnitY()}, Vec3(1, 102, 3), 0, pi);
    }

    void the_speeds_of_lu() {
        const Machine& m = find_machine("tarus-tpi-2000");
        QCOMPARE(m.rapid_mm_per_s, Vec3(170, 180, 240));
        QCOMPARE(m.axis_name(3), std::string("C"));
        QCOMPARE(m.axis_name(4), std::string("A"));
        QVERIFY(std::abs(m.speed(3) - 0.3) < 1e-15 && std::abs(m.speed(4) - 0.5) < 1e-15);
        const Kinematics k(m, length, Vec3::Zero());
        Joints a, b;
        QCOMPARE(k.time(a, b), 0.0);
        QCOMPARE(k.slowest_axis(a, b), 0);
        b.linear = Vec3(17, 9, -48);
        QCOMPARE(k.time(a, b), 0.2);
        QCOMPARE(k.slowest_axis(a, b), 2);
        b.rotary = {0.3, -0.7};
        QVERIFY(std::abs(k.time(a, b) - 1.4) < 1e-12);
        QCOMPARE(k.slowest_axis(a, b), 4);
    }

    void accelerations_lengthen_a_motion() {
        QCOMPARE(trapezoid_time(0, 10, 5), 0.0);
        QCOMPARE(trapezoid_time(100, 10, 5), 12.0); // 10 s at speed, 2 s to start and stop
        QCOMPARE(trapezoid_time(20, 10, 5), 4.0);   // reaches its speed and stops
        QCOMPARE(trapezoid_time(5, 10, 5), 2.0);    // a triangle
        QCOMPARE(trapezoid_time(5, 10, infinity), 0.5);
        const Machine& m = find_machine("trunnion-ac");
        const Kinematics k(m, length, Vec3::Zero());
        Joints b;
        b.linear = Vec3(100, 0, 0);
        QCOMPARE(k.time({}, b, true), 0.2 + 0.125);
        // Where the file says nothing there is no limit.
        QCOMPARE(Kinematics(find_machine("generic-3-axis"), 0, Vec3::Zero()).time({}, b, true), 0.6);
    }

    void a_free_angle_stays_where_it_is() {
        std::mt19937_64 rng(9);
        for (const char* name : {"tarus-tpi-2000", "trunnion-ac", "trunnion-bc", "head-b-table-c"}) {
            const Machine& m = find_machine(name);
            const Kinematics k(m, length, Vec3(3, 4, 5));
            // The axis about which the tool turns first, seen from the part.
            const std::size_t free = m.rotary[0].name == "C" ? 0 : 1;
            QCOMPARE(m.rotary[free].name, std::string("C"));
            for (int i = 0; i < 1000; ++i) {
                Joints near;
                near.rotary[free] = uniform(rng, -3, 3);
                const double lean = i % 2 ? 0 : 0.4 * tolerance::level_angle;
                const ToolPose pose{Vec3(uniform(rng, -9, 9), 2, 3), Vec3(lean, 0, 1).normalized()};
                const auto s = k.inverse(pose, near);
                QVERIFY(s.singular);
                QCOMPARE(s.count, 1);
                QVERIFY(std::abs(s.at[0].rotary[free] - near.rotary[free]) < 1e-15);
                QVERIFY((k.forward(s.at[0]).tip - pose.tip).norm() < 1e-9);
                QVERIFY((k.forward(s.at[0]).axis - pose.axis).norm() <= lean + 1e-12);
                near.rotary[free] += 2 * pi; // wound: nearest keeps it where travel does
                const auto j = k.nearest(pose, near);
                QVERIFY(j.has_value());
                const double wanted = std::min(near.rotary[free], m.rotary[free].travel.hi);
                QVERIFY(std::abs(j->rotary[free] - wanted) < 1e-12);
                QVERIFY((k.forward(*j).tip - pose.tip).norm() < 1e-9);
            }
            // Straight up, in both directions of the free axis' line.
            const auto down = k.inverse({Vec3(1, 2, 3), -Vec3::UnitZ()}, {});
            QVERIFY(down.singular);
            QCOMPARE(down.count, 1);
            QVERIFY((k.forward(down.at[0]).axis + Vec3::UnitZ()).norm() < 1e-12);
        }
        // As near as that to a singular pose, angles are still exact.
        const Kinematics k(find_machine("tarus-tpi-2000"), length, Vec3::Zero());
        for (double lean = 2e-6; lean < 0.1; lean *= 1.3) {
            const ToolPose pose{
                Vec3(1, 2, 3), Vec3(std::sin(lean) * 0.6, std::sin(lean) * 0.8, std::cos(lean)).normalized()};
            const auto s = k.inverse(pose, {});
            QCOMPARE(s.count, 2);
            for (const Joints& j : s.at) {
                QVERIFY((k.forward(j).axis - pose.axis).norm() < 1e-15 * 10);
                QVERIFY(std::abs(std::abs(j.rotary[1]) - lean) < 1e-14);
            }
        }
    }

    void axes_a_machine_cannot_hold() {
        const Kinematics three(find_machine("generic-3-axis"), length, Vec3::Zero());
        QCOMPARE(three.inverse({Vec3::Zero(), Vec3::UnitZ()}, {}).count, 1);
        for (const Vec3& v : {Vec3(-Vec3::UnitZ()), Vec3(1e-5, 0, 1)}) {
            QCOMPARE(three.inverse({Vec3::Zero(), v.normalized()}, {}).count, 0);
            QVERIFY(three.reach({Vec3::Zero(), v.normalized()}).limit == Kinematics::Reach::Limit::axis);
        }
        const Kinematics four(find_machine("generic-4-axis-a"), length, Vec3(400, 0, 150));
        QVERIFY(four.reaches({Vec3::Zero(), Vec3(0, 0.6, 0.8)}));
        QVERIFY(!four.reaches({Vec3::Zero(), Vec3(1e-5, 0.6, 0.8).normalized()}));
        QVERIFY(!four.reaches({Vec3::Zero(), Vec3::UnitX()}));
        const Kinematics head(nutating("tool", true), length, Vec3::Zero());
        QCOMPARE(head.inverse({Vec3::Zero(), -Vec3::UnitZ()}, {}).count, 0);
        QCOMPARE(head.inverse({Vec3::Zero(), Vec3(1, 0, -1e-4).normalized()}, {}).count, 0);
        QVERIFY(head.inverse({Vec3::Zero(), Vec3::UnitX()}, {}).count >= 1);
        QVERIFY_THROWS_EXCEPTION(Error, head.inverse({Vec3::Zero(), Vec3(0, 0, 2)}, {}));
        QVERIFY_THROWS_EXCEPTION(Error, head.inverse({Vec3(std::nan(""), 0, 0), Vec3::UnitZ()}, {}));
        QVERIFY_THROWS_EXCEPTION(Error, Kinematics(find_machine("trunnion-ac"), -1, Vec3::Zero()));
    }

    void travel_ends() {
        using Limit = Kinematics::Reach::Limit;
        const Kinematics k(find_machine("trunnion-ac"), length, Vec3::Zero());
        QVERIFY(k.reaches({Vec3(0, 0, 10), Vec3(0, 0.6, 0.8)}));
        // A can be 180 or -180: its travel ends at -120.
        auto r = k.reach({Vec3(0, 0, 10), -Vec3::UnitZ()});
        QVERIFY(r.limit == Limit::rotary_travel);
        QCOMPARE(r.joint, 3);
        QVERIFY(std::abs(r.beyond - radians(60)) < 1e-12);
        QVERIFY(!k.nearest({Vec3(0, 0, 10), -Vec3::UnitZ()}, {}));
        r = k.reach({Vec3(360, 0, 10), Vec3::UnitZ()});
        QVERIFY(r.limit == Limit::linear_travel);
        QCOMPARE(r.joint, 0);
        QVERIFY(std::abs(r.beyond - 10) < 1e-9);
        QVERIFY(!k.nearest({Vec3(360, 0, 10), Vec3::UnitZ()}, {}));
        // At the end of travel, with the rounding of a pose.
        Joints end;
        end.linear = Vec3(350, -350, 600);
        end.rotary = {radians(-120), 1};
        QVERIFY(k.reaches(k.forward(end)));
    }

    void winding_goes_on_for_turns() {
        const Kinematics free(find_machine("head-b-table-c"), length, Vec3::Zero());
        const Kinematics limited(find_machine("tarus-tpi-2000"), length, Vec3::Zero());
        for (const double step : {radians(10), radians(-10)}) {
            Joints a, b;
            const auto pose = [&](int i) {
                const double t = step * i;
                return ToolPose{Vec3(std::cos(t), std::sin(t), 0) * 20,
                                Vec3(0.6 * std::cos(t), 0.6 * std::sin(t), 0.8)};
            };
            a = *free.nearest(pose(0), a);
            b = *limited.nearest(pose(0), b);
            const double start = a.rotary[1];
            int rewinds = 0;
            for (int i = 1; i <= 5 * 36; ++i) {
                a = *free.nearest(pose(i), a);
                QVERIFY(std::abs(a.rotary[1] - start - step * i) < 1e-12 * 50);
                QVERIFY((free.forward(a).axis - pose(i).axis).norm() < 1e-12);
                const Joints c = *limited.nearest(pose(i), b);
                rewinds += std::abs(c.rotary[0] - b.rotary[0]) > pi / 2;
                QVERIFY(std::abs(c.rotary[0]) <= 2 * pi + 1e-6);
                QVERIFY((limited.forward(c).axis - pose(i).axis).norm() < 1e-12);
                b = c;
            }
            QVERIFY(rewinds >= 1 && rewinds <= 9); // by the other solution half a turn is enough
        }
    }

    void nothing_is_nearer_than_the_nearest() {
        std::mt19937_64 rng(10);
        for (const auto& [name, machine] : all_kinds()) {
            Machine m = machine;
            for (RotaryAxis& axis : m.rotary) // odd limits, some wider than a turn
                axis.travel = {uniform(rng, -9, -1), uniform(rng, 1, 9)};
            for (Travel& t : m.travel)
                t = {-200, 300};
            const Kinematics k(m, length, Vec3(5, 5, 5));
            int missing = 0;
            for (int i = 0; i < 3000; ++i) {
                Joints from;
                from.linear = Vec3(uniform(rng, -50, 50), uniform(rng, -50, 50), uniform(rng, -50, 50));
                for (std::size_t r = 0; r < m.rotary.size(); ++r)
                    from.rotary[r] = uniform(rng, m.rotary[r].travel.lo, m.rotary[r].travel.hi);
                const ToolPose pose{Vec3(uniform(rng, -99, 99), uniform(rng, -99, 99), uniform(rng, -99, 99)),
                                    held_axis(name, rng)};
                const auto s = k.inverse(pose, from);
                double least = infinity;
                for (int c = 0; c < s.count; ++c)
                    for (int u = -3; u <= 3; ++u)
                        for (int v = -3; v <= 3; ++v) {
                            Joints j = s.at[std::size_t(c)];
                            j.rotary[0] += 2 * pi * u;
                            j.rotary[1] += 2 * pi * v;
                            bool inside = true;
                            for (int q = 0; q < m.joints(); ++q)
                                inside = inside && m.joint_travel(q).contains(j[q]);
                            if (inside && (m.rotary.size() > 1 || v == 0) && (!m.rotary.empty() || u == 0))
                                least = std::min(least, k.time(from, j));
                        }
                const auto nearest = k.nearest(pose, from);
                missing += !nearest;
                QCOMPARE(nearest.has_value(), std::isfinite(least));
                QCOMPARE(k.reaches(pose), std::isfinite(least));
                if (nearest) QVERIFY(std::abs(k.time(from, *nearest) - least) < 1e-12 * (1 + least));
                if (nearest) QVERIFY((k.forward(*nearest).tip - pose.tip).norm() < 1e-9);
            }
            QVERIFY2(missing < 3000, name.c_str());
        }
    }

    void a_turning_part_lies_in_the_tables_axis() {
        QCOMPARE(turning_table(find_machine("generic-3-axis"), Vec3::UnitX()), -1);
        QCOMPARE(turning_table(find_machine("generic-4-axis-a"), Vec3::UnitX()), 0);
        QCOMPARE(turning_table(find_machine("generic-4-axis-a"), Vec3(-1, 0, 0)), 0);
        QCOMPARE(turning_table(find_machine("generic-4-axis-a"), Vec3::UnitZ()), -1);
        QCOMPARE(turning_table(find_machine("tarus-tpi-2000"), Vec3::UnitZ()), -1); // C carries the tool
        Box3 box;
        box.add(Vec3(10, 20, 30));
        box.add(Vec3(30, 60, 90));
        for (const char* name : {"generic-4-axis-a", "lathe-mill"}) {
            const Machine& m = find_machine(name);
            const Vec3 point(-5, 40, 60); // on the part's axis
            const Vec3 origin = turning_part_origin(m, 0, point, box);
            const Vec3 off = point + origin - m.rotary[0].point;
            QVERIFY(off.cross(m.rotary[0].direction).norm() < 1e-12);
            QCOMPARE(origin.x(), default_part_origin(m, box).x());
            // So a radial tool stands over the axis all round: only A turns.
            const Kinematics k(m, 150, origin);
            Joints from;
            for (const double angle : {0.0, 1.0, 2.5, -2.0}) {
                const Vec3 out(0, -std::sin(angle), std::cos(angle));
                const auto at = k.nearest({point + 25 * Vec3::UnitX() + 30 * out, out}, from);
                QVERIFY2(at.has_value(), name);
                QVERIFY(std::abs(at->linear.y() - m.rotary[0].point.y()) < 1e-9);
                QVERIFY(std::abs(at->linear.z() - (m.rotary[0].point.z() + 30 + 150)) < 1e-9);
                // Either way round, by whole turns.
                const auto astray = [&](double turned) {
                    return std::abs(std::remainder(at->rotary[0] - turned, 2 * pi));
                };
                QVERIFY(std::min(astray(angle), astray(-angle)) < 1e-9);
                from = *at;
            }
        }
    }

    /// A positive angle by ISO 841 turns the tool by the right hand relative to the part, and the other sign
    /// the other way, for heads and for tables.
    void signs_by_iso_841() {
        const auto turned = [](double angle, const Vec3& line, const Vec3& v) {
            return Vec3(Eigen::AngleAxisd(angle, line) * v);
        };
        for (const Machine& m : machines()) {
            if (m.rotary.size() != 2) continue;
            for (const double against : {1.0, -1.0}) {
                Machine changed = m;
                for (RotaryAxis& r : changed.rotary)
                    r.sign *= against;
                Joints at;
                at.rotary = {0.3, -0.5};
                // From the tool to the part: heads from the inner to the outer, tables from the outer in.
                Vec3 axis = Vec3::UnitZ();
                const auto& r = m.rotary;
                for (std::size_t i = r.size(); i-- > 0;)
                    if (r[i].carries == RotaryAxis::Carries::tool)
                        axis = turned(against * at.rotary[i], r[i].direction, axis);
                for (std::size_t i = 0; i < r.size(); ++i)
                    if (r[i].carries == RotaryAxis::Carries::table)
                        axis = turned(against * at.rotary[i], r[i].direction, axis);
                const Vec3 seen = Kinematics(changed, length, Vec3::Zero()).forward(at).axis;
                QVERIFY2((seen - axis).norm() < 1e-12, m.name.c_str());
            }
        }
    }

    /// LinuxCNC's trunnions as its documentation gives them (5-axis kinematics, xyzac-trt and xyzbc-trt):
    /// with r the point that the table turns about, d the way from there to the cradle's axis and dt the
    /// tool's length, P = r + Rz(-C) (d + R(-A or -B) (Q - r - d)). Its tables turn by the right hand,
    /// against ISO 841.
    void the_trunnions_of_linuxcnc() {
        std::mt19937_64 rng(841);
        for (const bool cradle_a : {true, false})
            for (int machine = 0; machine < 10; ++machine) {
                const Vec3 r(uniform(rng, -90, 90), uniform(rng, -90, 90), uniform(rng, -90, 90));
                const double aside = uniform(rng, -60, 60), below = uniform(rng, -60, 60),
                             dt = uniform(rng, 0, 200);
                const Vec3 off = cradle_a ? Vec3(0, aside, below) : Vec3(aside, 0, below);
                Machine m = find_machine(cradle_a ? "trunnion-ac" : "trunnion-bc");
                for (RotaryAxis& axis : m.rotary)
                    axis.sign = 1;
                m.rotary[0].point = r + off;
                m.rotary[1].point = r;
                const Kinematics kinematics(m, dt, Vec3::Zero());
                const Vec3 line = cradle_a ? Vec3::UnitX() : Vec3::UnitY();
                for (int i = 0; i < cases(10'000); ++i) {
                    Joints q;
                    q.linear = {uniform(rng, -300, 300), uniform(rng, -300, 300), uniform(rng, -300, 300)};
                    q.rotary = {uniform(rng, -pi, pi), uniform(rng, -2 * pi, 2 * pi)};
                    const Vec3 d = off + Vec3(0, 0, dt);
                    const Vec3 in_cradle = Eigen::AngleAxisd(-q.rotary[0], line) * Vec3(q.linear - r - d);
                    const Vec3 p = r + Eigen::AngleAxisd(-q.rotary[1], Vec3::UnitZ()) * Vec3(d + in_cradle);
                    const ToolPose pose = kinematics.forward(q);
                    // Its places are those of a tip with the tool's length added along the part's Z.
                    QVERIFY((pose.tip + Vec3(0, 0, dt) - p).norm() < 1e-9);
                    QVERIFY((kinematics.linear(pose.tip, q) - q.linear).norm() < 1e-9);
                }
            }
    }

    void the_part_stands_on_the_table() {
        Box3 box;
        box.add(Vec3(10, 20, 30));
        box.add(Vec3(30, 60, 90));
        QCOMPARE(default_part_origin(find_machine("trunnion-ac"), box), Vec3(-20, -40, -30));
        QCOMPARE(default_part_origin(find_machine("generic-4-axis-a"), box), Vec3(380, -40, 120));
        QVERIFY_THROWS_EXCEPTION(Error, default_part_origin(find_machine("trunnion-ac"), Box3()));
        for (const Machine& m : machines()) {
            const Kinematics k(m, 150, default_part_origin(m, box));
            QVERIFY2(k.reaches({Vec3(10, 20, 90), Vec3::UnitZ()}), m.name.c_str());
            QVERIFY2(k.reaches({Vec3(30, 60, 90), Vec3::UnitZ()}), m.name.c_str());
        }
    }
};

FACETMILL_TEST(TestKinematics)
#include "test_kinematics.moc"
