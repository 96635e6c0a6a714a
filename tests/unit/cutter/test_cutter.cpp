// The generalized APT cutter: shapes by tangency, profiles, growing, text.
#include "core/base/error.h"
#include "core/base/tolerances.h"
#include "core/cutter/cutter.h"
#include "tests/support/brute_lift.h"
#include "tests/support/test_runner.h"

#include <QTest>

#include <random>

using namespace facetmill;
using facetmill::test::BruteCutter;

namespace {

using Kind = ProfilePiece::Kind;

bool near(double a, double b, double tolerance = 1e-9) {
    return std::abs(a - b) <= tolerance;
}

/// The place of the error, or nothing.
template <class Call>
std::string refused_at(Call&& call) {
    try {
        call();
    } catch (const Error& e) {
        if (e.code() == ErrorCode::out_of_range) return e.where();
        return "code " + std::string(code_name(e.code()));
    }
    return "";
}

double uniform(std::mt19937_64& rng, double lo, double hi) {
    return std::uniform_real_distribution<double>(lo, hi)(rng);
}

AptCutter random_shape(std::mt19937_64& rng) {
    const double d = uniform(rng, 0.5, 30), alpha = rng() % 3 ? radians(uniform(rng, 0, 70)) : 0;
    double beta = rng() % 3 ? radians(uniform(rng, -30, 60)) : 0;
    beta = std::min(beta, pi / 2 - alpha);
    const double largest = std::min(AptCutter::largest_corner_radius(d, alpha, beta), 5 * d);
    const double r = rng() % 4 ? uniform(rng, 0, 1) * largest : 0;
    const double h =
        beta < 0 ? 0.5 * d * std::tan(alpha) + 0.4 * d / std::tan(-beta) : uniform(rng, 0.1, 4) * d;
    return AptCutter::from_shape(d, r, alpha, beta, h);
}

/// Joined pieces from the tip up, each with its ends on itself, turning to the steeper side only.
QString profile_fault(const CutterProfile& profile) {
    const auto& pieces = profile.pieces();
    if (pieces.empty()) return "no pieces";
    if (pieces.front().from != Vec2(0, 0)) return "does not start at the tip";
    double angle = 0;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        const ProfilePiece& p = pieces[i];
        if (i > 0 && p.from != pieces[i - 1].to) return "pieces do not join";
        if (p.from.x() < 0 || p.to.x() < 0) return "beyond the axis";
        if (p.to.y() < p.from.y() - 1e-12) return "falls";
        if (p.kind == Kind::arc)
            for (const Vec2& end : {p.from, p.to})
                if (!near((end - p.center).norm(), p.radius, 1e-9 * std::max(1.0, p.radius)))
                    return "end off its arc";
        if (p.angle_at_start() < angle - 1e-6 || p.angle_at_end() < p.angle_at_start() - 1e-6)
            return "not convex";
        angle = p.angle_at_end();
    }
    if (!near(profile.height(), pieces.back().to.y())) return "height";
    return {};
}

} // namespace

class TestCutter : public QObject {
    Q_OBJECT
private slots:

    void named_shapes() {
        const AptCutter ball = AptCutter::ball(6, 20);
        QVERIFY((ball == AptCutter{6, 3, 0, 3, 0, 0, 20}));
        const CutterProfile p(ball);
        QCOMPARE(p.pieces().size(), std::size_t(2));
        QCOMPARE(p.lower_pieces().size(), std::size_t(1));
        QCOMPARE(p.max_radius(), 3.0);
        QCOMPARE(p.height(), 20.0);
        QCOMPARE(p.height_at(0), 0.0);
        QVERIFY(near(p.height_at(1.8), 3 - 2.4));
        QCOMPARE(p.height_at(3), 3.0);
        QCOMPARE(p.height_at(3.0001), infinity);
        QVERIFY(near(p.radius_at(3 - 2.4), 1.8));
        QCOMPARE(p.radius_at(10), 3.0);
        QCOMPARE(p.radius_at(-1), 0.0);
        QCOMPARE(p.radius_at(21), 3.0);

        const CutterProfile flat(AptCutter::flat(8, 10));
        QCOMPARE(flat.height_at(4), 0.0);
        QCOMPARE(flat.radius_at(0), 4.0);
        QCOMPARE(flat.pieces().size(), std::size_t(2));

        const AptCutter bull = AptCutter::bull(10, 1, 20);
        QCOMPARE(bull.e, 4.0);
        QCOMPARE(bull.f, 1.0);
        QVERIFY(near(CutterProfile(bull).height_at(4.6), 1 - 0.8));

        const AptCutter cone = AptCutter::cone(6, radians(30));
        QVERIFY(near(cone.h, 3 * std::tan(radians(60))));
        const CutterProfile c(cone);
        QVERIFY(near(c.height_at(1), std::tan(radians(60))));
        QVERIFY(near(c.max_radius(), 3));
        QVERIFY(near(c.radius_at(cone.h / 2), 1.5));
        QVERIFY(near(CutterProfile(AptCutter::cone(6, radians(90))).height_at(2), 0));

        // Tapered ball: the circle about the axis touches the tip and the side.
        const AptCutter tapered = AptCutter::tapered_ball(2, radians(10), 30);
        QVERIFY(near(tapered.e, 0) && near(tapered.f, 2) && near(tapered.r, 2));
        const CutterProfile t(tapered);
        QVERIFY(near(t.height_at(2 * std::cos(radians(10))), 2 - 2 * std::sin(radians(10))));
        QVERIFY(near(t.max_radius(), 2 / std::cos(radians(10)) + (30 - 2) * std::tan(radians(10))));

        // Dovetail and lollipop: wider below than at the top.
        const CutterProfile dovetail(AptCutter::from_shape(10, 0, 0, radians(-20), 5));
        QCOMPARE(dovetail.max_radius(), 5.0);
        QVERIFY(near(dovetail.radius_at(5), 5 - 5 * std::tan(radians(20))));
        QCOMPARE(dovetail.lower_pieces().size(), std::size_t(1));
        const CutterProfile lollipop(AptCutter::tapered_ball(3, radians(-20), 5));
        QVERIFY(near(lollipop.max_radius(), 3));
        QVERIFY(near(lollipop.height_at(3), 3));
        QVERIFY(lollipop.radius_at(5) < 3);
    }

    // Lu 3.34-3.52 with the corrections: the corner circle touches both lines, and R at the top follows from
    // d.
    void corner_by_tangency() {
        std::mt19937_64 rng(1);
        for (int i = 0; i < 5000; ++i) {
            const AptCutter c = random_shape(rng);
            const double size = std::max(c.d, c.r), zc = 0.5 * c.d * std::tan(c.alpha);
            if (c.r > 0) {
                const double to_bottom = c.f * std::cos(c.alpha) - c.e * std::sin(c.alpha);
                const double to_side = (0.5 * c.d - c.e) * std::cos(c.beta) - (zc - c.f) * std::sin(c.beta);
                QVERIFY(near(to_bottom, c.r, 1e-9 * size));
                QVERIFY(near(to_side, c.r, 1e-9 * size));
                QVERIFY(c.e + c.r * std::sin(c.alpha) >= -1e-9 * size);
            }
            const CutterProfile p(c);
            const Vec2 top = p.pieces().back().to;
            const double side_end =
                zc + c.r * std::tan(0.25 * pi - 0.5 * (c.alpha + c.beta)) * std::cos(c.beta);
            if (c.h > side_end + 1e-9 * size)
                QVERIFY(near(top.x(), 0.5 * c.d + (c.h - zc) * std::tan(c.beta), 1e-8 * size));
        }
    }

    void profiles_are_convex_and_right() {
        std::mt19937_64 rng(2);
        for (int i = 0; i < 5000; ++i) {
            const AptCutter c = random_shape(rng);
            const CutterProfile p(c);
            const QString fault = profile_fault(p);
            QVERIFY2(fault.isEmpty(), qPrintable(fault));
            const BruteCutter brute(c);
            QVERIFY(near(p.max_radius(), double(brute.radius()), 1e-9 * std::max(c.d, c.r)));
            for (int k = 0; k <= 20; ++k) {
                const double rho = std::min(p.max_radius(), p.max_radius() * k / 20);
                const double z = p.height_at(rho);
                // Where the surface is vertical a height says little; there the radius is compared.
                const double wanted = double(brute.height(std::min<long double>(rho, brute.radius())));
                QVERIFY(near(z, wanted, 1e-9 * std::max(c.d, c.r))
                        || near(p.radius_at(wanted), rho, 1e-9 * c.d));
                if (z > 0) QVERIFY(p.radius_at(z) >= rho * (1 - 1e-9));
            }
        }
    }

    // Any seven numbers either make a convex profile or are refused by the letter's name.
    void any_numbers() {
        std::mt19937_64 rng(3);
        int made = 0, refused = 0;
        for (int i = 0; i < 40000; ++i) {
            const auto value = [&](double lo, double hi) { return rng() % 5 ? uniform(rng, lo, hi) : 0.0; };
            AptCutter c{value(-1, 20),           value(-1, 12),           value(-4, 10), value(-4, 12),
                        radians(value(-10, 95)), radians(value(-95, 95)), value(-1, 30)};
            if (i % 2) { // near a good one
                c = random_shape(rng);
                double* const letters[] = {&c.d, &c.r, &c.e, &c.f, &c.alpha, &c.beta, &c.h};
                *letters[rng() % 7] *= uniform(rng, 0.7, 1.3);
            }
            try {
                const CutterProfile p(c);
                const QString fault = profile_fault(p);
                QVERIFY2(fault.isEmpty(), qPrintable(fault));
                QVERIFY(p.max_radius() > 0);
                ++made;
            } catch (const Error& e) {
                QCOMPARE(e.code(), ErrorCode::out_of_range);
                QVERIFY(QStringList({"d", "r", "e", "alpha", "beta", "h"})
                            .contains(QString::fromStdString(e.where())));
                ++refused;
            }
        }
        QVERIFY2(made > 500 && refused > 500, qPrintable(QString("%1 %2").arg(made).arg(refused)));
    }

    void circles_that_are_not_tangent() {
        // Both joints with a kink.
        const CutterProfile kinked(AptCutter{10, 2, 3.5, 1.5, 0, 0, 20});
        QVERIFY(profile_fault(kinked).isEmpty());
        QVERIFY(near(kinked.height_at(3.5 + std::sqrt(4 - 2.25)), 0));
        QVERIFY(near(kinked.height_at(5), 1.5 - std::sqrt(4 - 2.25)));
        QCOMPARE(kinked.max_radius(), 5.0);
        // The circle hangs above the bottom, beside the side, or outside of the corner.
        QCOMPARE(refused_at([] { CutterProfile(AptCutter{10, 2, 3, 2.5, 0, 0, 20}); }), "r");
        QCOMPARE(refused_at([] { CutterProfile(AptCutter{10, 2, 2, 2, 0, 0, 20}); }), "r");
        QCOMPARE(refused_at([] { CutterProfile(AptCutter{10, 2, 4.5, 0.5, 0, 0, 20}); }), "r");
        QCOMPARE(refused_at([] { CutterProfile(AptCutter{10, 6, -1, 6, 0, 0, 20}); }), "r");
        // Rounded to six digits as in a CL file: made tangent.
        const AptCutter exact = AptCutter::from_shape(12, 1.5, radians(7), radians(5), 40);
        AptCutter rounded = exact;
        rounded.e = std::round(exact.e * 1e4) / 1e4 - 5e-5;
        rounded.f = std::round(exact.f * 1e4) / 1e4 + 5e-5;
        QVERIFY(near(CutterProfile(rounded).height_at(5), CutterProfile(exact).height_at(5), 2e-4));
        // A pointed arc, its centre beyond the axis, is convex.
        const CutterProfile ogive(AptCutter{8, 5, -1, std::sqrt(24.0), 0, 0, 20});
        QVERIFY(profile_fault(ogive).isEmpty());
        QCOMPARE(ogive.height_at(0), 0.0);
        QVERIFY(near(ogive.height_at(4), std::sqrt(24.0)));
        for (double e = 1e-15; e < 40; e *= 1.7) { // also where it hardly is
            const double r = 5 + e;
            const CutterProfile p(AptCutter{10, r, -e, std::sqrt(r * r - e * e), 0, 0, 50});
            QVERIFY(profile_fault(p).isEmpty());
            QVERIFY(near(p.height_at(3), p.cutter().f - std::sqrt(r * r - (3 + e) * (3 + e))));
        }
        // With r = 0 there is no circle.
        QCOMPARE(CutterProfile(AptCutter{10, 0, 0, 0, 0, 0, 20}).max_radius(), 5.0);
        QCOMPARE(refused_at([] { CutterProfile(AptCutter{10, 0, 3, 0, 0, 0, 20}); }), "e");
    }

    void short_cutters_end_at_their_height() {
        QVERIFY(near(CutterProfile(AptCutter::ball(10, 2)).max_radius(), 4)); // 5 - 2 = 3, 4, 5
        QVERIFY(near(CutterProfile(AptCutter::ball(10, 2)).height(), 2));
        QVERIFY(near(CutterProfile(AptCutter::from_shape(10, 0, radians(45), 0, 2)).max_radius(), 2));
        QVERIFY(near(CutterProfile(AptCutter::from_shape(10, 0, 0, radians(45), 2)).max_radius(), 7));
    }

    void bad_shapes() {
        const double nan = std::nan("");
        QCOMPARE(refused_at([&] { AptCutter::from_shape(nan, 0, 0, 0, 10); }), "d");
        QCOMPARE(refused_at([] { AptCutter::from_shape(0, 0, 0, 0, 10); }), "d");
        QCOMPARE(refused_at([] { AptCutter::from_shape(-6, 0, 0, 0, 10); }), "d");
        QCOMPARE(refused_at([] { AptCutter::from_shape(1e30, 0, 0, 0, 10); }), "d");
        QCOMPARE(refused_at([] { AptCutter::from_shape(1e-12, 0, 0, 0, 10); }), "d");
        QCOMPARE(refused_at([&] { AptCutter::from_shape(6, infinity, 0, 0, 10); }), "r");
        QCOMPARE(refused_at([] { AptCutter::from_shape(6, -1, 0, 0, 10); }), "r");
        QCOMPARE(refused_at([] { AptCutter::from_shape(6, 3.1, 0, 0, 10); }), "r");
        QCOMPARE(refused_at([] { AptCutter::from_shape(6, 1, radians(90), 0, 10); }), "alpha");
        QCOMPARE(refused_at([] { AptCutter::from_shape(6, 1, radians(-1), 0, 10); }), "alpha");
        QCOMPARE(refused_at([] { AptCutter::from_shape(6, 0, radians(60), radians(31), 10); }), "beta");
        QCOMPARE(refused_at([] { AptCutter::from_shape(6, 0, 0, radians(90), 10); }), "beta");
        QCOMPARE(refused_at([] { AptCutter::from_shape(6, 0, 0, radians(-45), 3.1); }), "h");
        QCOMPARE(refused_at([] { AptCutter::from_shape(6, 0, 0, 0, 0); }), "h");
        QCOMPARE(refused_at([&] { AptCutter::from_shape(6, 0, 0, 0, nan); }), "h");
        QCOMPARE(refused_at([] { AptCutter::from_shape(6, 0, 0, radians(89), 1e6); }), "h");
        QCOMPARE(refused_at([&] { CutterProfile(AptCutter{6, 1, nan, 1, 0, 0, 10}); }), "e");
        QCOMPARE(refused_at([&] { CutterProfile(AptCutter{6, 1, 2, infinity, 0, 0, 10}); }), "f");
        QCOMPARE(refused_at([] { AptCutter::cone(6, 0); }), "half_angle");
        QCOMPARE(refused_at([] { AptCutter::cone(6, radians(91)); }), "half_angle");
        QCOMPARE(refused_at([] { AptCutter::cone(-1, radians(30)); }), "d");
    }

    // The grown body holds exactly the points within the allowance: against the convolution of the profile
    // with a circle.
    void growing() {
        std::mt19937_64 rng(4);
        for (int i = 0; i < 400; ++i) {
            const CutterProfile p(random_shape(rng));
            const double a = uniform(rng, 0.01, 3);
            const CutterProfile g = p.grown(a);
            const QString fault = profile_fault(g);
            QVERIFY2(fault.isEmpty(), qPrintable(fault));
            QVERIFY(near(g.max_radius(), p.max_radius() + a, 1e-9 * (g.max_radius())));
            QVERIFY(near(g.height(), p.height() + 2 * a, 1e-9 * (1 + g.height())));
            QVERIFY(g.cutter() == p.cutter());
            for (int k = 0; k < 20; ++k) {
                const double rho = 0.999 * g.max_radius() * k / 20;
                // A ball of radius a rolled on the lower surface, on either side of the axis: lowest point
                // over rho.
                double lowest = infinity;
                const int steps = 4000;
                const double end = p.max_radius();
                const double from = std::max(rho - a, -end), to = std::min(rho + a, end);
                for (int s = 0; s <= steps; ++s) {
                    const double at = std::clamp(from + (to - from) * s / steps, -end, end), off = rho - at;
                    lowest = std::min(lowest, p.height_at(at) - std::sqrt(std::max(0.0, a * a - off * off)));
                }
                // The samples come within a step's slope from above.
                const double got = g.height_at(rho) - a;
                QVERIFY2(got <= lowest + 1e-9 && lowest - got <= 0.02 * a,
                         qPrintable(QString("%1 %2").arg(got).arg(lowest)));
            }
            // Twice is once.
            const CutterProfile twice = p.grown(0.4 * a).grown(0.6 * a);
            for (int k = 0; k < 20; ++k) {
                const double rho = 0.999 * g.max_radius() * k / 20;
                QVERIFY(near(twice.height_at(rho), g.height_at(rho), 1e-7));
            }
        }
        const CutterProfile ball = CutterProfile(AptCutter::ball(6, 20)).grown(1);
        QVERIFY(near(ball.height_at(2), CutterProfile(AptCutter::ball(8, 20)).height_at(2)));
        const CutterProfile cone = CutterProfile(AptCutter::cone(6, radians(45))).grown(1);
        QVERIFY(near(cone.height_at(0), 0) && near(cone.height_at(2), 1 + 2 - std::sqrt(2.0)));
        QCOMPARE(refused_at([] { CutterProfile(AptCutter::ball(6, 20)).grown(-1); }), "allowance");
        QCOMPARE(refused_at([] { CutterProfile(AptCutter::ball(6, 20)).grown(infinity); }), "allowance");
    }

    void text() {
        QVERIFY(parse_cutter("ball:6", 1) == AptCutter::ball(6, unlimited_height));
        QVERIFY(parse_cutter("flat:0.5", 25.4) == AptCutter::flat(12.7, unlimited_height));
        QVERIFY(parse_cutter("bull:6,1", 1) == AptCutter::bull(6, 1, unlimited_height));
        QVERIFY(parse_cutter("cone:6,30", 1) == AptCutter::cone(6, radians(30)));
        QVERIFY((parse_cutter("apt:10,1,4,1,0,0,30", 2) == AptCutter{20, 2, 8, 2, 0, 0, 60}));
        for (const char* bad :
             {"", "ball", "ball:", "ball:x", "ball:6,1", "bull:6", "bull:6,", "disc:6", "Ball:6", "cone:6",
              "apt:1,2,3", "flat:nan", "flat:inf", "flat:6 ", "ball:6,"})
            QCOMPARE(refused_at([&] { parse_cutter(bad, 1); }), "code syntax");
        for (const char* bad : {"ball:0", "ball:-6", "bull:6,4", "bull:6,-1", "cone:6,0", "cone:6,120",
                                "apt:10,1,9,1,0,0,30", "flat:1e30", "apt:10,1,4,1,0,0,0"})
            QVERIFY2(
                refused_at([&] { parse_cutter(bad, 1); }).starts_with(std::string("cutter '") + bad + "': "),
                bad);
    }
};

FACETMILL_TEST(TestCutter)
#include "test_cutter.moc"
