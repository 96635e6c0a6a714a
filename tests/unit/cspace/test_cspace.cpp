#include "core/cspace/cspace.h"

#include "core/base/parallel.h"
#include "core/base/tolerances.h"
#include "core/gouge/axial_kernel.h"
#include "core/gouge/lower_surface.h"
#include "tests/support/error_code.h"
#include "tests/support/test_runner.h"
#include "tests/unit/cspace/cspace_cases.h"

#include <QTest>

#include <cstring>
#include <set>

using namespace facetmill;
using namespace facetmill::test;

namespace {

double reference_top(const BruteCutter& cutter, const ToolPose& pose, std::span<const Vec3> curve) {
    double best = -infinity;
    for (std::size_t i = 0; i < curve.size(); ++i) {
        const Vec3 a = in_tool(pose, curve[i]), b = in_tool(pose, curve[std::min(i + 1, curve.size() - 1)]);
        best = std::max(best, brute_lift(cutter, a, b, b, 0, 0));
    }
    return best;
}

/// Over many points of the curve.
double sampled_top(const BruteCutter& cutter, const ToolPose& pose, std::span<const Vec3> curve) {
    double best = -infinity;
    for (std::size_t i = 0; i < curve.size(); ++i)
        for (int k = 0; k <= 1000; ++k) {
            const Vec3& to = curve[std::min(i + 1, curve.size() - 1)];
            const Vec3 p = in_tool(pose, curve[i] + k / 1000.0 * (to - curve[i]));
            const double rho = std::hypot(p.x(), p.y());
            if (rho <= double(cutter.radius())) best = std::max(best, p.z() - double(cutter.height(rho)));
        }
    return best;
}

/// Past a place, more or less straight, with some points that repeat.
RaisedCurve random_curve(Random& rng, const Vec3& center, int points, double size, double wild) {
    const Vec3 along = random_unit(rng), bend = random_unit(rng);
    const Vec3 offset = 0.3 * size * random_unit(rng);
    RaisedCurve curve;
    for (int i = 0; i < points; ++i) {
        const double t = points == 1 ? 0 : 2.0 * i / (points - 1) - 1;
        if (i > 0 && whole(rng, 0, 7) == 0)
            curve.push_back(curve.back());
        else
            curve.push_back(center + offset + t * size * along + 0.2 * t * t * size * bend
                            + wild * size * random_unit(rng));
    }
    return curve;
}

/// Every body of the tool against every facet.
double reference_lift(const Tool& tool, const Mesh& mesh, const ToolPose& pose) {
    Mesh local = mesh;
    for (Vec3& p : local.vertices)
        p = in_tool(pose, p);
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

bool same_bits(const std::vector<double>& a, const std::vector<double>& b) {
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0;
}

/// Contact points on facets of a mesh that points up, with curves beside them.
struct Contacts {
    std::vector<ContactFrame> frames;
    std::vector<std::vector<RaisedCurve>> curves;
    Contacts(const Mesh& mesh, int count, std::uint64_t seed) {
        Random rng(seed);
        for (int i = 0; i < count; ++i) {
            const auto f = std::size_t(whole(rng, 0, int(mesh.facet_count()) - 1));
            const Vec3 point = (mesh.corner(f, 0) + mesh.corner(f, 1) + mesh.corner(f, 2)) / 3;
            frames.push_back(ContactFrame::at(point, mesh.facet_normal(f), Vec3::UnitX()));
            curves.emplace_back();
            for (const double side : {-2.0, 2.0, 3.5})
                curves.back().push_back(random_curve(
                    rng, point + side * frames.back().left + 0.4 * frames.back().normal, 20, 8, 0.01));
        }
    }
};

} // namespace

class TestCSpace : public QObject {
    Q_OBJECT
private slots:
    void curve_lift_against_brute_force() {
        Random rng(1);
        int reached = 0, missed = 0;
        for (const auto& [name, shape] : cutters()) {
            const CurveLift lift{CutterProfile(shape)};
            const BruteCutter brute(shape);
            for (int i = 0; i < 300; ++i) {
                const ToolPose pose{20 * random_unit(rng), random_unit(rng)};
                const double wild[] = {0, 0.01, 0.3};
                auto curve = random_curve(rng, pose.tip + uniform(rng, -1, 3) * pose.axis, whole(rng, 1, 30),
                                          uniform(rng, 0.5, 40), wild[i % 3]);
                if (i % 5 == 0 && curve.size() > 1) curve[1] = curve[0] + uniform(rng, -9, 9) * pose.axis;
                const double want = reference_top(brute, pose, curve);
                CurveLift::Hint hint{std::uint32_t(whole(rng, 0, 40))};
                const double got = lift.lift(pose, curve, hint);
                QCOMPARE(got, lift.lift(pose, curve)); // whatever the hint
                QCOMPARE(got, lift.lift(pose, curve, hint));
                // The same but for what is not asked for, and whatever was asked before.
                for (const double least :
                     {-30.0, got - 0.5, got, std::nextafter(got, infinity), got + 1e-6}) {
                    QCOMPARE(lift.lift(pose, curve, hint, infinity, least), std::max(got, least));
                    QCOMPARE(lift.reaches(pose, curve, hint, least), got >= least);
                }
                if (want == -infinity) {
                    QCOMPARE(got, want);
                    ++missed;
                    continue;
                }
                ++reached;
                QVERIFY2(std::abs(got - want) <= tolerance::lift_accuracy,
                         qPrintable(QString("%1 %2: %3 not %4")
                                        .arg(name)
                                        .arg(i)
                                        .arg(got, 0, 'g', 17)
                                        .arg(want, 0, 'g', 17)));
                const double enough = got + uniform(rng, -1, 0.1);
                const double early = lift.lift(pose, curve, hint, enough);
                QVERIFY(got > enough ? early > enough && early <= got : early == got);
                // Each place by itself may be enough, and never says too much.
                for (std::uint32_t k = 0; k < curve.size(); ++k) {
                    CurveLift::Hint there{k};
                    const double some = lift.lift(pose, curve, there, got - 100);
                    QVERIFY(some > got - 100 && some <= got);
                }
                if (i % 10 == 0) {
                    const double many = sampled_top(brute, pose, curve);
                    QVERIFY2(many <= got + 1e-9, name);
                    QVERIFY2(many >= got - 0.3 || i % 3 == 2 || curve.size() == 1, name);
                }
            }
        }
        QVERIFY(reached > 1000 && missed > 100);
    }

    void curve_lift_degenerate() {
        const CurveLift flat{CutterProfile(AptCutter::flat(10, 20))};
        const ToolPose pose;
        QCOMPARE(flat.lift(pose, {}), -infinity);
        const std::vector<Vec3> point = {{1, 2, 3}}, same(5, Vec3(1, 2, 3)), outside = {{5.001, 0, 3}};
        QCOMPARE(flat.lift(pose, point), 3.0);
        QCOMPARE(flat.lift(pose, same), 3.0);
        QCOMPARE(flat.lift(pose, outside), -infinity);
        const std::vector<Vec3> rim = {{5, 0, 3}}, upright = {{1, 2, -7}, {1, 2, 4}, {1, 2, -9}};
        QCOMPARE(flat.lift(pose, rim), 3.0);
        QCOMPARE(flat.lift(pose, upright), 4.0);
        const std::vector<Vec3> no_numbers = {{NAN, 0, 0}, {1, NAN, 2}, {0, 0, NAN}, {2, 2, 1}, {2, 2, 1}};
        QCOMPARE(flat.lift(pose, no_numbers), 1.0);
        QCOMPARE(flat.lift(pose, std::span<const Vec3>(no_numbers).first(2)), -infinity);
        // Many segments, all as high as each other.
        std::vector<Vec3> level;
        for (int i = 0; i < 1000; ++i)
            level.push_back({0.001 * i - 0.5, 1, 2});
        QCOMPARE(flat.lift(pose, level), 2.0);
    }

    /// Above the flutes the cutter holds nothing.
    void curve_lift_below_the_flutes() {
        Random rng(5);
        int differ = 0;
        for (const double flutes : {0.5, 2.0, 4.0})
            for (const auto& [name, shape] : cutters()) {
                const CurveLift whole_cutter{CutterProfile(shape)}, lower{CutterProfile(shape), flutes};
                AptCutter cut = shape;
                cut.h = std::min(cut.h, flutes);
                const BruteCutter brute(cut);
                for (int i = 0; i < 30; ++i) {
                    const ToolPose pose{20 * random_unit(rng), random_unit(rng)};
                    const auto curve = random_curve(rng, pose.tip + 2 * pose.axis, 10, 10, 0.1);
                    const double want = reference_top(brute, pose, curve), got = lower.lift(pose, curve);
                    QVERIFY2(got == want || std::abs(got - want) <= tolerance::lift_accuracy, name);
                    differ += got != whole_cutter.lift(pose, curve);
                }
            }
        QVERIFY(differ > 20);
        QCOMPARE(code_of([] { CurveLift(CutterProfile(AptCutter::ball(6, 10)), -1); }),
                 std::string("out_of_range"));
    }

    void curve_lift_same_bits_on_all_kernels() {
        const AxialKernels* sets[4];
        const int count = axial_kernel_sets(sets);
        Random rng(6);
        for (int i = 0; i < 3000; ++i) {
            const auto surface =
                lower_surface(CutterProfile(cutters()[std::size_t(i) % cutters().size()].cutter));
            const auto curve = random_curve(rng, Vec3(0, 0, 1), whole(rng, 1, 30), 10, 0.1);
            AxialQuery query;
            for (int k = 0; k < 3; ++k)
                query.frame[k][k] = 1;
            double first = 0;
            for (int set = 0; set < count; ++set) {
                AxialAnswer answer;
                query.hint = std::uint32_t(whole(rng, 0, 40));
                sets[set]->curve(surface, query, curve[0].data(), std::uint32_t(curve.size()), answer);
                if (set == 0) first = answer.tip;
                QVERIFY(std::memcmp(&answer.tip, &first, sizeof first) == 0);
            }
        }
    }

    /// A line along the feed at sideways distance d, raised by tau over a plane; flat end of radius R, ball
    /// of radius r.
    void top_over_a_plane() {
        const double tau = 0.1, radius = 6;
        const Bench flat(level_plane(200), tool_of(12, 0, 25, 12, 30, 20));
        const Bench ball(level_plane(200), tool_of(12, 6, 25, 12, 30, 20));
        const CSpaceBuilder flat_space(flat.input), ball_space(ball.input);
        const ContactFrame frame;
        for (const double d : {0.0, 0.3, 2.0, 4.0, 5.9})
            for (const double lead : {0.0, 1.0, 10.0, 45.0}) {
                const double a = radians(lead), leg = std::sqrt(radius * radius - d * d);
                const std::vector<RaisedCurve> curve = {
                    {{-90, d, tau}, {-7, d, tau}, {1, d, tau}, {90, d, tau}}};
                const double flat_top = (tau + std::sin(a) * (leg - radius)) / std::cos(a);
                QVERIFY(std::abs(flat_space.top(frame, a, 0, curve) - flat_top) < 1e-12);
                const double ball_top = (tau - radius + leg) / std::cos(a);
                QVERIFY(std::abs(ball_space.top(frame, a, 0, curve) - ball_top) < 1e-12);
                ToolLift::Hint hint;
                QVERIFY(std::abs(flat_space.bottom(frame, a, 0, hint)) < 1e-12);
            }
        QCOMPARE(flat_space.top(frame, 0.1, 0, {}), infinity);
        QCOMPARE(flat_space.top(frame, 0.1, 0, beside(6.2, tau)), -infinity);
        // The smaller of two.
        const std::vector<RaisedCurve> two = {{{-90, 1, tau}, {90, 1, tau}}, {{-90, -4, tau}, {90, -4, tau}}};
        QCOMPARE(flat_space.top(frame, 0.3, 0, two), flat_space.top(frame, 0.3, 0, {&two[1], 1}));
    }

    /// Inside a sphere of radius S along a great circle: a flat end touches with its rim from where it leans
    /// more than its rim needs, sin lead = R / S, and is stopped with less lean.
    void bottom_in_a_bowl() {
        Mesh mesh;
        const double sphere = 30;
        const int n = 120;
        const auto at = [&](int i, int j) {
            const double polar = 0.5 * pi * i / n, turn = 2 * pi * j / (2 * n);
            return Vec3(sphere * std::sin(polar) * std::cos(turn), sphere * std::sin(polar) * std::sin(turn),
                        -sphere * std::cos(polar));
        };
        for (int i = 0; i < n; ++i)
            for (int j = 0; j < 2 * n; ++j)
                add_quad(mesh, at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));
        Tool tool = tool_of(12, 0, 12, 6, 60, 8);
        const Bench bowl(std::move(mesh), tool);
        const CSpaceBuilder space(bowl.input);
        const ContactFrame frame = ContactFrame::at(Vec3(0, 0, -sphere), Vec3::UnitZ(), Vec3::UnitX());
        const double needed = std::asin(6 / sphere), chord = sphere * (1 - std::cos(0.25 * pi / n)) * 2;
        for (int deg = 0; deg <= 40; deg += 2) {
            ToolLift::Hint hint;
            const double lead = radians(deg), got = space.bottom(frame, lead, 0.4, hint);
            // The rim is a circle of radius R at lift s. Its centre is at R(-cos, sin) from the contact
            // point, along and up; it is inside the sphere when the plane of the rim is no deeper than a
            // circle of that size.
            const double axial =
                -sphere * std::cos(lead) + 6 * 0; // of the contact point from the centre, along the axis
            const double offset = sphere * std::sin(lead) - 6; // of the rim's centre across it
            const double reach = std::abs(offset) + 6;
            const double want = std::max(0.0, -std::sqrt(sphere * sphere - reach * reach) - axial);
            QVERIFY2(std::abs(got - want) < 3 * chord,
                     qPrintable(QString("%1: %2 %3").arg(deg).arg(got).arg(want)));
            if (lead > needed + 0.01) QVERIFY(got < 3 * chord);
            if (lead < needed - 0.05) QVERIFY(got > 0.05);
        }
    }

    void bottom_against_brute_force() {
        int lifted = 0;
        for (const std::uint64_t seed : {1u, 2u, 3u}) {
            const auto mesh = hills(seed);
            Tool tool = tool_of(6, seed == 1 ? 0 : 1.5, 8, 10, 10, 20);
            const Bench bench(*mesh, tool);
            const CSpaceBuilder builder(bench.input);
            const Contacts contacts(*mesh, 10, seed);
            const BruteCutter cutter(tool.cutter());
            for (std::size_t i = 0; i < contacts.frames.size(); ++i) {
                const CSpace space = builder.build(contacts.frames[i], contacts.curves[i]);
                QCOMPARE(space.bottom.size(), bench.grid.size());
                for (std::size_t il = 0; il < bench.grid.lead.size(); il += 2)
                    for (std::size_t io = 0; io < bench.grid.yaw.size(); io += 5) {
                        const std::size_t node = bench.grid.node(il, io);
                        const ToolPose pose = posture_pose(CutterProfile(tool.cutter()), contacts.frames[i],
                                                           {bench.grid.lead[il], bench.grid.yaw[io], 0});
                        const double want = std::max(0.0, reference_lift(tool, *mesh, pose));
                        QVERIFY(std::abs(space.bottom[node] - want) <= tolerance::lift_accuracy);
                        lifted += want > 0.01;
                        double top = infinity;
                        for (const RaisedCurve& curve : contacts.curves[i])
                            top = std::min(top, reference_top(cutter, pose, curve));
                        QVERIFY(space.top[node] == top
                                || std::abs(space.top[node] - top) <= tolerance::lift_accuracy);
                    }
            }
        }
        QVERIFY(lifted > 20);
    }

    void one_posture_gives_the_bits_of_the_grid() {
        const auto mesh = hills(7);
        const Bench bench(*mesh, tool_of(6, 1, 8, 10, 10, 20));
        const CSpaceBuilder builder(bench.input);
        const Contacts contacts(*mesh, 5, 7);
        std::set<PostureBlock> seen;
        for (std::size_t i = 0; i < contacts.frames.size(); ++i) {
            const ContactFrame& frame = contacts.frames[i];
            const CSpace space = builder.build(frame, contacts.curves[i]);
            ToolLift::Hint hint;
            CSpaceBuilder::Hints hints;
            for (std::size_t il = 0; il < bench.grid.lead.size(); ++il)
                for (std::size_t io = 0; io < bench.grid.yaw.size(); ++io) {
                    const std::size_t node = bench.grid.node(il, io);
                    const double lead = bench.grid.lead[il], yaw = bench.grid.yaw[io];
                    QCOMPARE(builder.bottom(frame, lead, yaw, hint), space.bottom[node]);
                    QCOMPARE(builder.top(frame, lead, yaw, contacts.curves[i]), space.top[node]);
                    const auto reason = builder.reason(frame, lead, yaw, contacts.curves[i]);
                    QCOMPARE(reason.bottom, space.bottom[node]);
                    QCOMPARE(reason.top, space.top[node]);
                    QCOMPARE(int(reason.block), int(space.block[node]));
                    QCOMPARE(reason.contact.body == ToolBody::none, reason.bottom == 0);
                    const auto free = builder.free(frame, lead, yaw, contacts.curves[i], hints);
                    QCOMPARE(free.has_value(), reason.block == PostureBlock::free);
                    if (free) {
                        QCOMPARE(free->posture.delta, reason.bottom);
                        QCOMPARE(free->top, reason.top);
                    }
                    const double enough = 0.3 * double(il % 4);
                    const double known = builder.bottom(frame, lead, yaw, hint, enough);
                    QVERIFY(known == reason.bottom || (known > enough && known <= reason.bottom));
                    seen.insert(reason.block);
                }
        }
        QVERIFY(seen.size() >= 3);
    }

    void same_bits_with_any_number_of_threads() {
        const auto mesh = hills(8);
        const Bench bench(*mesh, tool_of(6, 1, 8, 10, 10, 20));
        const CSpaceBuilder builder(bench.input);
        const Contacts contacts(*mesh, 12, 8);
        set_thread_count(1);
        CSpaceBuilder::Stages stages;
        const auto one = builder.build(contacts.frames, contacts.curves, Progress(), &stages);
        set_thread_count(2);
        const auto two = builder.build(contacts.frames, contacts.curves, Progress());
        set_thread_count(0);
        QVERIFY(stages.bottom > 0 && stages.top > 0);
        QCOMPARE(one.size(), contacts.frames.size());
        for (std::size_t i = 0; i < one.size(); ++i) {
            const CSpace alone = builder.build(contacts.frames[i], contacts.curves[i]);
            QVERIFY(same_bits(one[i].bottom, two[i].bottom) && same_bits(one[i].bottom, alone.bottom));
            QVERIFY(same_bits(one[i].top, two[i].top) && same_bits(one[i].top, alone.top));
            QVERIFY(one[i].block == two[i].block && one[i].block == alone.block);
            QCOMPARE(one[i].frame.point, contacts.frames[i].point);
        }
    }

    void cancelled_and_refused() {
        const auto mesh = hills(9);
        const Bench bench(*mesh, tool_of(6, 1, 8, 10, 10, 20));
        const CSpaceBuilder builder(bench.input);
        const Contacts contacts(*mesh, 3, 9);
        Job job;
        job.cancel();
        QCOMPARE(code_of([&] { builder.build(contacts.frames, contacts.curves, Progress(job)); }),
                 std::string("cancelled"));
        QCOMPARE(code_of([&] { builder.build(contacts.frames[0], contacts.curves[0], Progress(job)); }),
                 std::string("cancelled"));
        const auto fewer = std::span(contacts.curves).first(2);
        QCOMPARE(code_of([&] { builder.build(contacts.frames, fewer, Progress()); }),
                 std::string("internal"));
        QCOMPARE(code_of([] { CSpaceBuilder{CSpaceInput{}}; }), std::string("internal"));
        CSpaceInput bad = bench.input;
        bad.height = -1;
        QCOMPARE(code_of([&] { CSpaceBuilder{bad}; }), std::string("out_of_range"));
        bad = bench.input;
        bad.local_radius = NAN;
        QCOMPARE(code_of([&] { CSpaceBuilder{bad}; }), std::string("out_of_range"));
        bad = bench.input;
        bad.grid = nullptr;
        QCOMPARE(code_of([&] { CSpaceBuilder(bad).build(contacts.frames[0], contacts.curves[0]); }),
                 std::string("internal"));
    }
};

FACETMILL_TEST(TestCSpace)
#include "test_cspace.moc"
