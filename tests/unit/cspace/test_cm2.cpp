#include "core/cspace/cm2.h"

#include "core/mesh/geometry.h"
#include "tests/support/test_runner.h"
#include "tests/unit/cspace/cspace_cases.h"

#include <QTest>

using namespace facetmill;
using namespace facetmill::test;

namespace {

using Real = long double;

/// Support function of the cutter that leans by the lead along X, in direction (0, sin turn, -cos turn): how
/// far it reaches there. Seen along the feed the swept cutter is convex with this support. By a search over
/// the profile.
Real support(const BruteCutter& cutter, Real lead, Real turn) {
    const Real along = -std::cos(turn) * std::cos(lead); // on the axis (sin lead, 0, cos lead)
    const Real across = std::sqrt(std::max(Real(0), 1 - along * along));
    const auto reach = [&](Real rho) {
        return rho * across + cutter.height(rho) * along;
    }; // concave: along < 0
    Real lo = 0, hi = cutter.radius();
    for (int i = 0; i < 300; ++i) {
        const Real a = lo + (hi - lo) * 0.382L, b = lo + (hi - lo) * 0.618L;
        (reach(a) < reach(b) ? lo : hi) = reach(a) < reach(b) ? a : b;
    }
    return std::max({reach(lo), reach(Real(0)), reach(cutter.radius())});
}

/// Radius of curvature at the lowest point of the swept profile: h + h''.
Real swept_radius(const BruteCutter& cutter, Real lead) {
    const Real step = 1e-3L, h0 = support(cutter, lead, 0);
    const Real h1 = support(cutter, lead, step) + support(cutter, lead, -step),
               h2 = support(cutter, lead, 2 * step) + support(cutter, lead, -2 * step);
    return h0 + (16 * h1 - h2 - 30 * h0) / (12 * step * step);
}

} // namespace

class TestCm2 : public QObject {
    Q_OBJECT
private slots:
    void cutter_curvature_against_the_swept_profile() {
        Random rng(1);
        int compared = 0;
        for (const auto& [name, shape] : cutters()) {
            const CutterProfile cutter(shape);
            const BruteCutter brute(shape);
            for (int i = 0; i < 30; ++i) {
                const double lead = radians(uniform(rng, 2, 80));
                bool straight = false; // where the profile's straight pieces touch there is no one curvature
                for (const double angle : {shape.alpha, pi / 2 - shape.beta})
                    straight |= std::abs(lead - angle) < radians(1);
                if (straight || !can_touch(cutter, lead)) continue;
                ++compared;
                const double want = 1 / double(swept_radius(brute, lead));
                const double got = cutter_curvature_across(cutter, lead);
                QVERIFY2(got == infinity ? std::abs(want) > 1e6 : std::abs(got - want) < 1e-6 * (1 + got),
                         qPrintable(QString("%1 %2: %3 %4").arg(name).arg(degrees(lead)).arg(got).arg(want)));
            }
        }
        QVERIFY(compared > 100);
        QCOMPARE(cutter_curvature_across(CutterProfile(AptCutter::ball(10, 20)), 0), 1.0 / 5);
        QCOMPARE(cutter_curvature_across(CutterProfile(AptCutter::flat(10, 20)), 0), 0.0);
        QCOMPARE(cutter_curvature_across(CutterProfile(AptCutter::bull(10, 2, 20)), 0), 0.0);
    }

    void leads_by_hand() {
        const CutterProfile flat(AptCutter::flat(12, 25)), bull(AptCutter::bull(12, 2, 25)),
            ball(AptCutter::ball(12, 25));
        const double hi = radians(45);
        QVERIFY(std::abs(cm2_lead(flat, 1.0 / 30, 0, hi) - std::asin(6.0 / 30)) < 1e-14);
        // 30 = r + (R - r) / sin(lead)
        QVERIFY(std::abs(cm2_lead(bull, 1.0 / 30, 0, hi) - std::asin(4.0 / 28)) < 1e-14);
        for (const CutterProfile& cutter : {flat, bull, ball}) {
            const double lo = radians(3);
            QCOMPARE(cm2_lead(cutter, 0, lo, hi), lo);
            QCOMPARE(cm2_lead(cutter, -1.0 / 30, lo, hi), lo);
            QCOMPARE(cm2_lead(cutter, 1e-4, lo, hi), lo);
            QCOMPARE(cm2_lead(cutter, NAN, lo, hi), lo);
            QCOMPARE(cm2_lead(cutter, 1.0 / 2.1, 0.2, 0.2), 0.2);
        }
        QCOMPARE(cm2_lead(flat, 1.0 / 7, 0, hi), hi); // would be 59 degrees
        QCOMPARE(cm2_lead(flat, 1.0 / 5, 0, hi), hi); // no lead will do
        QCOMPARE(cm2_lead(bull, 1.0 / 1.9, 0, hi), hi);
        QCOMPARE(cm2_lead(ball, 1.0 / 30, 0, hi), 0.0);
        QCOMPARE(cm2_lead(ball, 1.0 / 5.9, 0, hi), hi);
        // On the rim, not on the drill's point; as far as the limits let.
        const CutterProfile drill(AptCutter::from_shape(12, 0, radians(10), 0, 25));
        QVERIFY(std::abs(cm2_lead(drill, 0, 0, hi) - radians(10)) < 1e-14);
        QCOMPARE(cm2_lead(drill, 0, 0, radians(5)), radians(5));
        QVERIFY(std::abs(cm2_lead(drill, 1.0 / 30, 0, hi) - std::asin(6.0 / 30)) < 1e-14);
    }

    /// The lead matches, and less does not, whatever the cutter.
    void leads_match() {
        Random rng(2);
        int matched = 0;
        for (const auto& [name, shape] : cutters()) {
            const CutterProfile cutter(shape);
            for (int i = 0; i < 200; ++i) {
                const double kappa = std::exp(uniform(rng, -6, 0)), lo = radians(uniform(rng, 0, 10)),
                             hi = radians(uniform(rng, 10, 80));
                const double lead = cm2_lead(cutter, kappa, lo, hi);
                QVERIFY2(lead >= lo && lead <= hi, name);
                const double there = cutter_curvature_across(cutter, lead);
                if (lead < hi) QVERIFY2(there >= kappa * (1 - 1e-9), name);
                if (lead > lo + 1e-6) {
                    ++matched;
                    // With a little less lead: flatter than the part, or on the bottom's cone or tip.
                    const double less = cutter_curvature_across(cutter, lead - 1e-7);
                    QVERIFY2(less < kappa || less == infinity || lead <= shape.alpha + 1e-9 || lead == hi,
                             name);
                }
            }
        }
        QVERIFY(matched > 200);
    }

    void curvature_by_direction() {
        VertexCurvature at;
        at.k1 = 0.2;
        at.k2 = -0.1;
        at.direction1 = Vec3::UnitY();
        at.direction2 = Vec3::UnitX();
        at.mean = 0.05;
        QVERIFY(std::abs(normal_curvature(at, Vec3(0, -3, 0)) - 0.2) < 1e-15);
        QVERIFY(std::abs(normal_curvature(at, Vec3(5, 0, 2)) + 0.1)
                < 1e-15); // what is along the normal does not count
        QVERIFY(std::abs(normal_curvature(at, Vec3(1, 1, 0)) - 0.05) < 1e-15);
        at.direction1 = at.direction2 = Vec3::Zero();
        QVERIFY(std::abs(normal_curvature(at, Vec3(1, 0, 0)) - 0.05) < 1e-15);
        at.k1 = at.k2 = NAN;
        QVERIFY(std::isnan(normal_curvature(at, Vec3(1, 0, 0))));
    }

    /// A gutter of radius 40 along Y: hollow by 1/40 across it, not at all along it.
    void hollowness_of_a_gutter() {
        const double radius = 40, size = 30;
        const auto mesh = field(
            30, size,
            [&](double x, double) { return -std::sqrt(radius * radius - (x - size / 2) * (x - size / 2)); },
            0.2, 3);
        const auto normals = vertex_normals(*mesh, NormalWeight::angle, Progress());
        const auto curvatures = vertex_curvatures(*mesh, normals, Progress());
        Random rng(4);
        for (int i = 0; i < 300; ++i) {
            const auto f = std::size_t(whole(rng, 0, int(mesh->facet_count()) - 1));
            double u = uniform(rng, 0, 1), v = uniform(rng, 0, 1);
            if (u + v > 1) u = 1 - u, v = 1 - v;
            if (i % 3 == 0) u = 0; // on an edge
            const Vec3 p = mesh->corner(f, 0) + u * (mesh->corner(f, 1) - mesh->corner(f, 0))
                           + v * (mesh->corner(f, 2) - mesh->corner(f, 0));
            if (p.x() < 3 || p.x() > 27 || p.y() < 3 || p.y() > 27) continue;
            const double slope =
                (p.x() - size / 2) / std::sqrt(radius * radius - std::pow(p.x() - size / 2, 2));
            const Vec3 across = Vec3(1, 0, slope).normalized();
            QVERIFY(std::abs(hollowness(*mesh, curvatures, Index(f), p, across) - 1 / radius) < 1e-3);
            QVERIFY(std::abs(hollowness(*mesh, curvatures, Index(f), p, Vec3::UnitY())) < 1e-3);
            const double half = hollowness(*mesh, curvatures, Index(f), p, across + Vec3::UnitY());
            QVERIFY(std::abs(half - 0.5 / radius) < 1e-3);
        }
        // Corners on the border have no curvature; where no corner has one the part counts as level.
        Mesh alone;
        alone.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
        alone.facets = {{0, 1, 2}};
        const auto none =
            vertex_curvatures(alone, vertex_normals(alone, NormalWeight::angle, Progress()), Progress());
        QCOMPARE(hollowness(alone, none, 0, Vec3(0.2, 0.2, 0), Vec3::UnitX()), 0.0);
    }

    /// Weights are where the point lies: a patch whose corners differ.
    void hollowness_is_shared_out() {
        Mesh mesh;
        mesh.vertices = {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};
        mesh.facets = {{0, 1, 2}};
        std::vector<VertexCurvature> at(3);
        for (std::size_t k = 0; k < 3; ++k) {
            at[k].k1 = at[k].k2 = double(k + 1);
            at[k].direction1 = Vec3::UnitX();
            at[k].direction2 = Vec3::UnitY();
        }
        QCOMPARE(hollowness(mesh, at, 0, Vec3(4, 0, 0), Vec3::UnitX()), -2.0);
        QVERIFY(std::abs(hollowness(mesh, at, 0, Vec3(1, 2, 0), Vec3::UnitX()) + (0.25 + 0.5 + 1.5)) < 1e-14);
        at[0].k1 = at[0].k2 = NAN;
        QVERIFY(std::abs(hollowness(mesh, at, 0, Vec3(1, 2, 0), Vec3::UnitX()) + (0.5 + 1.5) / 0.75) < 1e-14);
        mesh.vertices[2] = {8, 0, 0}; // no area
        QCOMPARE(hollowness(mesh, at, 0, Vec3(1, 0, 0), Vec3::UnitX()), -2.5);
    }
};

FACETMILL_TEST(TestCm2)
#include "test_cm2.moc"
