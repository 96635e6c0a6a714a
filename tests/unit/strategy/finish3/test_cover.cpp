// What a cutter touches and covers, lines of tips, step-overs: against direct evaluation.
#include "core/strategy/finish3/stepover.h"
#include "core/strategy/surface/line_refiner.h"
#include "tests/property/shapes.h"
#include "tests/support/random_meshes.h"
#include "tests/support/test_runner.h"
#include "tests/support/trials.h"

#include <QTest>

#include <random>

using namespace facetmill;
using namespace facetmill::test;

namespace {

std::vector<AptCutter> cutters() {
    return {AptCutter::ball(6, 50), AptCutter::flat(6, 50), AptCutter::bull(6, 1, 50),
            AptCutter::from_shape(6, 1, radians(10), radians(8), 20), AptCutter::cone(8, radians(30))};
}

/// A tent of many facets about its tip.
Mesh tent() {
    constexpr Index sides = 40;
    Mesh mesh;
    mesh.vertices.emplace_back(0, 0, 4);
    for (Index i = 0; i < sides; ++i) {
        const double angle = 2 * pi * i / sides;
        mesh.vertices.emplace_back(8 * std::cos(angle), 6 * std::sin(angle), 0.3 * (i % 3));
        mesh.facets.push_back({0, 1 + i, 1 + (i + 1) % sides});
    }
    return mesh;
}

Vec3 upward(std::mt19937_64& rng) {
    std::uniform_real_distribution<double> slope(0.05, 1.45), turn(0, 2 * pi);
    const double a = slope(rng), b = turn(rng);
    return {std::sin(a) * std::cos(b), std::sin(a) * std::sin(b), std::cos(a)};
}

} // namespace

class TestCover : public QObject {
    Q_OBJECT
private slots:
    void the_supported_cutter_touches_its_plane() {
        std::mt19937_64 rng(1);
        for (const AptCutter& cutter : cutters()) {
            const CutterProfile profile(cutter);
            const CutterCover cover(profile, 0);
            for (int i = 0; i < 200; ++i) {
                const Vec3 n = upward(rng), tip = cover.tip_offset(n); // the plane goes through the origin
                // Nearest approach of the cutter's lower surface, by sampling it downhill and uphill.
                const Vec2 side = n.head<2>().normalized();
                double nearest = infinity;
                for (int k = 0; k <= 20000; ++k) {
                    const double rho = profile.max_radius() * k / 20000;
                    const Vec3 p(tip.x() - rho * side.x(), tip.y() - rho * side.y(),
                                 tip.z() + profile.height_at(rho));
                    nearest = std::min(nearest, n.dot(p));
                }
                QVERIFY2(std::abs(nearest) < 2e-3, qPrintable(QString::number(nearest)));
                QVERIFY(nearest > -1e-9);
            }
        }
    }

    void a_flat_bottom_stands_over_level_places() {
        const CutterCover cover(CutterProfile(AptCutter::flat(6, 50)), 0.01);
        QVERIFY(cover.has_flat_bottom());
        QCOMPARE(cover.tip_offset(Vec3(0, 0, 1)), Vec3(0, 0, 0));
        // Level but for rounding: hardly beside it. Clearly tilted: the rim.
        QVERIFY(cover.tip_offset(Vec3(1e-7, 0, 1).normalized()).norm() < 1e-3);
        QVERIFY(std::abs(cover.tip_offset(Vec3(0.5, 0, 1).normalized()).x() - 3) < 0.03);
    }

    void rays_enter_where_sampling_says() {
        std::mt19937_64 rng(2);
        std::uniform_real_distribution<double> at(-4, 4), low(-1, 1);
        int hits = 0;
        std::vector<CutterProfile> profiles;
        for (const AptCutter& cutter : cutters())
            profiles.emplace_back(cutter);
        // Arcs about the axis, beside it and at the rim, lines between.
        profiles.emplace_back(AptCutter::tapered_ball(1, radians(10), 20));
        profiles.push_back(CutterProfile(AptCutter::cone(5, radians(40))).grown(0.5));
        profiles.push_back(CutterProfile(AptCutter::flat(5, 50)).grown(0.5));
        profiles.push_back(
            CutterProfile(AptCutter::from_shape(6, 1, radians(15), radians(-5), 20)).grown(0.2));
        for (const CutterProfile& profile : profiles) {
            const CutterCover cover(profile, 0.005);
            for (int i = 0; i < 400; ++i) {
                const Vec3 p(at(rng), at(rng), low(rng) - 0.5), n = i % 10 == 0 ? Vec3(0, 0, 1) : upward(rng);
                const Vec3 tip(0.3, -0.2, 0.1);
                double expected = infinity;
                constexpr double fine = 0.002;
                for (double t = -6; t < 6; t += fine) {
                    const Vec3 q = p + t * n - tip;
                    if (std::hypot(q.x(), q.y()) <= profile.max_radius()
                        && q.z() >= profile.height_at(std::hypot(q.x(), q.y()))) {
                        expected = t;
                        break;
                    }
                }
                const double found = cover.ray_entry(p, n, tip, 5.9);
                if (expected > 5.8 || expected <= -5.9) continue;
                ++hits;
                QVERIFY2(found <= expected + 1e-6 && found >= expected - 2 * fine,
                         qPrintable(QString("%1 %2").arg(found).arg(expected)));
                // Just before it the line is outside, just behind it inside.
                for (const double t : {found - 1e-6, found + 1e-6}) {
                    const Vec3 q = p + t * n - tip;
                    const double rho = std::hypot(q.x(), q.y());
                    const bool inside = rho <= profile.max_radius() && q.z() >= profile.height_at(rho);
                    QVERIFY2(inside == (t > found) || std::abs(q.z() - profile.height_at(rho)) < 1e-11,
                             qPrintable(QString("%1 %2").arg(t - found).arg(q.z() - profile.height_at(rho))));
                }
            }
        }
        QVERIFY(hits > 500);
        const CutterCover ball(CutterProfile(AptCutter::ball(6, 50)), 0.005);
        QCOMPARE(ball.ray_entry(Vec3(10, 0, 0), Vec3(0, 0, 1), Vec3(0, 0, 0), 20), infinity);
    }

    void contacts_have_the_cutters_normal_where_it_has_one() {
        const CutterCover ball(CutterProfile(AptCutter::ball(6, 50)), 0.005);
        const Vec3 n = Vec3(0.3, -0.4, 0.8).normalized();
        const auto found = ball.contact_normal(-ball.tip_offset(n));
        QVERIFY(found && (*found - n).norm() < 1e-9);
        QVERIFY((*ball.contact_normal(Vec3(0, 0, 0)) - Vec3(0, 0, 1)).norm() < 1e-9);
        // With an allowance the part's point lies off the cutter, on the same normal.
        const auto off = ball.contact_normal(-ball.tip_offset(n) - 0.3 * n);
        QVERIFY(off && (*off - n).norm() < 1e-9);
        const CutterCover flat(CutterProfile(AptCutter::flat(6, 50)), 0.005);
        QVERIFY(!flat.contact_normal(Vec3(3, 0, 0)));
        QVERIFY(!flat.contact_normal(Vec3(0, 2.9999999999, 0)));
        QVERIFY((*flat.contact_normal(Vec3(1, 2, 0)) - Vec3(0, 0, 1)).norm() < 1e-9);
        QVERIFY((*flat.contact_normal(Vec3(3, 0, 5)) - Vec3(-1, 0, 0)).norm() < 1e-9);
        // A bull nose is smooth where its corner begins.
        const CutterCover bull(CutterProfile(AptCutter::bull(6, 1, 50)), 0.005);
        QVERIFY(bull.contact_normal(Vec3(2, 0, 0)) && bull.contact_normal(Vec3(2, 0, 0))->z() > 0.999999);
    }

    void lines_of_tips_keep_their_tolerances() {
        const Mesh m = height_field(
            [](double x, double y) { return std::sin(0.7 * x) + 0.3 * std::cos(y) + (x > 3 ? 2 : 0); },
            Vec2(-15, -10), Vec2(15, 10), 90, 30);
        for (const AptCutter& cutter : cutters()) {
            const PlanContext context = context_of(m, ball_tool(6));
            const CutterProfile profile(cutter);
            const AxialLift lift(context.contact, profile);
            const LiftField field{&lift, -5};
            LineTolerance tolerance;
            tolerance.below = tolerance.above = 0.002;
            tolerance.spacing = safe_spacing(profile, tolerance.below);
            const Vec2 origin(0.3, 0.2), direction = Vec2(1, 0.35).normalized();
            const auto line = lift_line(field, origin, direction, -14, 14, tolerance, Progress());
            const auto thin = thinned(line, 0.002, 0.002);
            QVERIFY(thin.size() < line.size());
            QCOMPARE(line.front().s, -14.0);
            QCOMPARE(line.back().s, 14.0);
            QCOMPARE(thin.back().s, 14.0);
            for (const auto& [points, allowed] : {std::pair(line, 0.002), std::pair(thin, 0.004)})
                for (std::size_t i = 0; i + 1 < points.size(); ++i) {
                    const LinePoint &a = points[i], &b = points[i + 1];
                    QVERIFY(b.s >= a.s);
                    const double ds = b.s - a.s, dz = b.z - a.z;
                    for (int k = 1; k < 8 && ds > 0; ++k) {
                        const double s = a.s + ds * k / 8;
                        const double off = (field.tip_z(origin + s * direction) - (a.z + dz * k / 8)) * ds
                                           / std::hypot(ds, dz);
                        // A gouge is held strictly. What stays above may be more where a sharp cutter's lift
                        // dips twice between two places looked at.
                        QVERIFY2(off <= allowed && off >= -2 * allowed, qPrintable(QString::number(off)));
                    }
                }
        }
    }

    /// Over the edge of a steep wall, down it and on over the floor: the way bends one way and back again
    /// within less than the places looked at are apart, and its middle may lie on the chord by chance. From
    /// many starts, so that some meet it so.
    void a_steep_wall_is_followed_from_its_edge_to_its_foot() {
        const CutterProfile profile(AptCutter::ball(12, 50));
        LineTolerance tolerance;
        tolerance.below = tolerance.above = 0.0025;
        tolerance.spacing = safe_spacing(profile, tolerance.below);
        for (const double high : {4.0, 8.0, 12.0}) {
            const double x[] = {-20, 0, high * std::tan(radians(3)), 20}, z[] = {0, 0, -high, -high};
            Mesh m;
            for (int i = 0; i < 4; ++i)
                for (const double y : {-20.0, 20.0})
                    m.vertices.push_back(Vec3(x[i], y, z[i]));
            for (Index i = 0; i < 6; i += 2) {
                m.facets.push_back({i, i + 2, i + 3});
                m.facets.push_back({i, i + 3, i + 1});
            }
            const AxialLift lift(context_of(m, ball_tool(12)).contact, profile);
            double worst = 0;
            for (int k = 0; k < 200; ++k) {
                const auto line = lift_line({&lift, -infinity}, Vec2(0, 0.1), Vec2(1, 0),
                                            -3 - tolerance.spacing * k / 100, 9, tolerance, Progress());
                for (std::size_t i = 0; i + 1 < line.size(); ++i) {
                    const double ds = line[i + 1].s - line[i].s, dz = line[i + 1].z - line[i].z;
                    for (int q = 1; q < 16 && ds > 0; ++q) {
                        const double s = line[i].s + ds * q / 16;
                        worst = std::max(worst, (lift.tip_z(s, 0.1) - line[i].z - dz * q / 16) * ds
                                                    / std::hypot(ds, dz));
                    }
                }
            }
            QVERIFY2(worst > 0 && worst <= tolerance.below,
                     qPrintable(QString("wall of %1: %2").arg(high).arg(worst)));
        }
    }

    /// Teeth thinner than the places looked at are apart, under cutters that are sharp at the tip and wide at
    /// the shoulder.
    void thin_teeth_do_not_slip_between() {
        for (const double tip : {0.0, 0.02, 0.1})
            for (const double taper : {10.0, 30.0}) {
                const AptCutter apt =
                    tip > 0 ? AptCutter::from_shape(tip, 0, 0, radians(taper), 12)
                            : AptCutter::cone(2 * 12 * std::tan(radians(taper)), radians(taper));
                const CutterProfile profile(apt);
                LineTolerance tolerance;
                tolerance.below = tolerance.above = 0.004;
                tolerance.spacing = safe_spacing(profile, tolerance.below);
                for (const double pitch : {0.1, 0.13, 0.25, 0.5}) {
                    const int teeth = int(6 / pitch);
                    const double height = 0.5 * pitch / std::tan(radians(taper + 10));
                    const Mesh m = height_field(
                        [&](double x, double) { return std::lround(x / (0.5 * pitch)) & 1 ? height : 0.0; },
                        Vec2(0, -1), Vec2(teeth * pitch, 1), 2 * teeth, 2);
                    const PlanContext context = context_of(m, ball_tool(6));
                    const AxialLift lift(context.contact, profile);
                    const auto line = lift_line({&lift, -1}, Vec2(0, 0.3), Vec2(1, 0), 0.3 * pitch,
                                                teeth * pitch - 0.01, tolerance, Progress());
                    double worst = 0; // across the side
                    for (std::size_t i = 0; i + 1 < line.size(); ++i)
                        for (int k = 1; k < 16 && line[i + 1].s > line[i].s; ++k) {
                            const double t = k / 16.0, s = line[i].s + t * (line[i + 1].s - line[i].s);
                            const double z = line[i].z + t * (line[i + 1].z - line[i].z);
                            worst = std::max(worst, (lift.tip_z(s, 0.3) - z) * std::sin(radians(taper)));
                        }
                    QVERIFY2(worst <= tolerance.below,
                             qPrintable(QString("%1 %2 %3: %4").arg(tip).arg(taper).arg(pitch).arg(worst)));
                }
            }
    }

    /// Down two steps whose middle lies on the chord: it says nothing of what stands on either side.
    void two_steps_are_not_taken_for_a_slope() {
        struct Steps {
            using Point = LinePoint;
            static double z(double s) { return s < 0.35 ? 10 : s < 0.65 ? 5 : 0; }
            static LinePoint at(double s) { return {s, z(s)}; }
            static LinePoint middle(const LinePoint& a, const LinePoint& b) { return at(0.5 * (a.s + b.s)); }
            static LinePoint flat(const LinePoint& from, const LinePoint& p) { return {p.s - from.s, p.z}; }
            static LinePoint over(const LinePoint& high, const LinePoint& low) { return {low.s, high.z}; }
            static void check() {}
        } steps;
        LineTolerance tolerance;
        tolerance.below = tolerance.above = 0.01;
        tolerance.spacing = 1;
        std::vector<LinePoint> line{Steps::at(0)};
        LineRefiner(steps, tolerance).add(Steps::at(0), Steps::at(0.5), Steps::at(1), line);
        QCOMPARE(line.back().s, 1.0);
        for (std::size_t i = 1; i < line.size(); ++i) {
            const LinePoint &a = line[i - 1], &b = line[i];
            QVERIFY(b.s >= a.s);
            for (double t = 0; t < 1 && b.s > a.s; t += 0.05) {
                const double s = a.s + t * (b.s - a.s), under = Steps::z(s) - (a.z + t * (b.z - a.z));
                // Across the motion, of which a step's own is upright.
                QVERIFY2(under * (b.s - a.s) / std::hypot(b.s - a.s, b.z - a.z) <= tolerance.below,
                         qPrintable(QString("%1 under the step at %2").arg(under).arg(s)));
            }
        }
    }

    void thinning_keeps_within_its_band() {
        std::vector<LinePoint> line;
        for (int i = 0; i <= 1000; ++i)
            line.push_back({0.01 * i, std::sin(0.01 * i) + 0.001 * (i % 2)});
        const auto thin = thinned(line, 0.01, 0.02);
        QVERIFY(thin.size() < 60 && thin.size() > 5);
        QCOMPARE(thin.front().s, line.front().s);
        QCOMPARE(thin.back().s, line.back().s);
        std::size_t k = 0;
        for (const LinePoint& p : line) {
            while (thin[k + 1].s < p.s)
                ++k;
            const double z =
                thin[k].z + (thin[k + 1].z - thin[k].z) * (p.s - thin[k].s) / (thin[k + 1].s - thin[k].s);
            QVERIFY(p.z - z <= 0.01 + 1e-12 && z - p.z <= 0.02 + 1e-12);
        }
        // A straight line is its two ends, an upright move stays.
        QCOMPARE(thinned({{0, 0}, {1, 1}, {2, 2}, {3, 3}}, 1e-9, 1e-9).size(), std::size_t(2));
        QCOMPARE(thinned({{0, 5}, {1, 5}, {1, 0}, {2, 0}}, 1e-3, 1e-3).size(), std::size_t(4));
    }

    void the_step_on_a_level_plane_is_the_known_one() {
        const Mesh m = height_field([](double, double) { return 0.0; }, Vec2(-10, -10), Vec2(10, 10), 2, 2);
        const PlanContext context = context_of(m, ball_tool(6));
        const double h = 0.04;
        for (const auto& [cutter, flat] :
             {std::pair(AptCutter::ball(6, 50), 0.0), std::pair(AptCutter::bull(6, 1, 50), 4.0)}) {
            const CutterProfile profile(cutter);
            const CutterCover cover(profile, 0.01 * h);
            const AxialLift lift(context.contact, profile);
            const ContactDomain domain(m, DriveFrame(0), cover, 0, Progress());
            StepOverInput in;
            in.mesh = &m;
            in.contact = context.contact;
            in.lift = &lift;
            in.cover = &cover;
            in.domain = &domain;
            in.floor = domain.lowest_tip();
            in.cusp = h;
            in.merge = 0.1;
            StepOver stepover(in);
            const DriveLine a = stepover.line(-1, 0.5, 0.5, nullptr, Progress());
            const StepOver::Step step =
                stepover.next({&a, domain.hi(), nullptr, stepover.first_guess(), false}, Progress());
            const double exact = flat + 2 * std::sqrt(2 * cutter.r * h - h * h);
            QVERIFY(step.satisfied && step.cusp <= h);
            QVERIFY2(step.line.v + 1 <= exact + 1e-9 && step.line.v + 1 > 0.97 * exact,
                     qPrintable(QString("%1 of %2").arg(step.line.v + 1).arg(exact)));
            // and what it leaves at a step of one's own choice.
            const DriveLine b = stepover.line(flat, 0.5, 0.5, nullptr, Progress());
            const double half = 0.5 * (b.v - a.v - flat),
                         known = cutter.r - std::sqrt(cutter.r * cutter.r - half * half);
            const double found = stepover.worst_cusp(&a, &b, 0, Progress());
            QVERIFY2(std::abs(found - known) < 0.02 * known,
                     qPrintable(QString("%1 %2").arg(found).arg(known)));
            const DriveLine far = stepover.line(8, 0.5, 0.5, nullptr, Progress());
            QCOMPARE(stepover.worst_cusp(&a, &far, 0, Progress()), infinity);
        }
    }

    /// Large meshes keep no outlines; what their domains cover must not be told apart.
    void a_domain_is_the_same_without_kept_outlines() {
        const CutterProfile profile(AptCutter::ball(3, 20));
        const CutterCover cover(profile, 0.001);
        const auto hills = field(
            25, 20, [](double x, double y) { return std::sin(x) * std::cos(0.8 * y); }, 0.3);
        const auto scattered = soup(400, 20, 5);
        Random rng(4);
        for (const Mesh& mesh : {*hills, *scattered, tent()}) {
            const DriveFrame frame(uniform(rng, 0, 6));
            const ContactDomain kept(mesh, frame, cover, 0.2, Progress()),
                found(mesh, frame, cover, 0.2, Progress(), 0);
            QCOMPARE(found.lo(), kept.lo());
            QCOMPARE(found.hi(), kept.hi());
            QCOMPARE(found.lowest_tip(), kept.lowest_tip());
            for (int trial = 0; trial < trials(100, 20); ++trial) {
                const double v = uniform(rng, kept.lo() - 1, kept.hi()), wide = uniform(rng, -1, 3);
                const auto a = kept.strip(v, v + std::max(wide, 0.0), 0.01),
                           b = found.strip(v, v + std::max(wide, 0.0), 0.01);
                QCOMPARE(b.size(), a.size());
                for (std::size_t i = 0; i < a.size(); ++i)
                    QVERIFY(a[i].lo == b[i].lo && a[i].hi == b[i].hi);
            }
        }
    }

    /// Asked about a place alone, where few facets come into it, and about all of a strip, where most are
    /// passed over.
    void a_strip_covers_what_its_places_do() {
        const CutterProfile profile(AptCutter::ball(3, 20));
        const CutterCover cover(profile, 0.001);
        const auto hills = field(
            60, 20, [](double x, double y) { return std::sin(x) * std::cos(0.8 * y); }, 0.3);
        const auto scattered = soup(400, 20, 5);
        const auto covers = [](const std::vector<Interval>& pieces, double u) {
            return std::ranges::any_of(pieces, [u](const Interval& i) { return i.lo <= u && u <= i.hi; });
        };
        Random rng(6);
        std::size_t covered = 0, bare = 0;
        for (const Mesh& mesh : {*hills, *scattered}) {
            const ContactDomain domain(mesh, DriveFrame(uniform(rng, 0, 6)), cover, 0.2, Progress());
            for (int trial = 0; trial < trials(300, 100); ++trial) {
                const double v = uniform(rng, domain.lo(), domain.hi()), u = uniform(rng, -30, 30);
                const Interval here{u, u};
                const bool is_covered = covers(domain.strip(v, v + 0.1, 0.001), u);
                QCOMPARE(is_covered, covers(domain.strip(v, v + 0.1, 0.001, &here), u));
                (is_covered ? covered : bare) += 1;
            }
        }
        QVERIFY(covered > 50 && bare > 50);
    }
};

FACETMILL_TEST(TestCover)
#include "test_cover.moc"
