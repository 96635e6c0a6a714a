// The path checker itself: it finds what is put there.
#include "tests/property/shapes.h"
#include "tests/support/path_checker.h"
#include "tests/support/test_runner.h"

#include <QTest>

using namespace facetmill;
using namespace facetmill::test;

namespace {

/// Straight passes of a tip at height z over 40 x 30 mm.
std::vector<TipLine> rows(double step, double z) {
    std::vector<TipLine> path;
    for (double y = -15; y <= 15 + 1e-9; y += step)
        path.push_back({Vec3(-20, y, z), Vec3(20, y, z)});
    return path;
}

const Mesh& level() {
    static const Mesh mesh =
        height_field([](double, double) { return 0.0; }, Vec2(-20, -15), Vec2(20, 15), 4, 3);
    return mesh;
}

} // namespace

class TestPathChecker : public QObject {
    Q_OBJECT
private slots:
    void cusps_between_straight_passes_have_their_known_height() {
        PathCheckOptions options;
        options.spacing = 0.05;
        options.border = 0.5;
        const Mesh strip = height_field([](double, double) { return 0.0; }, Vec2(-2, -2), Vec2(2, 2), 1, 1);
        const auto path = rows(1, 0);
        const double ball = 3 - std::sqrt(9 - 0.25); // radius 3, half a millimetre off
        PathCheckResult r = check_path(strip, AptCutter::ball(6, 50), path, options);
        QVERIFY2(std::abs(r.cusp_max - ball) < 0.0025, qPrintable(QString::number(r.cusp_max - ball)));
        QVERIFY(std::abs(r.cusp_max - ball) <= r.resolution);
        QVERIFY(r.cusp_p50 > 0.2 * ball && r.cusp_p50 < 0.3 * ball); // a parabola's median: a quarter
        QVERIFY(r.gouge_max < 1e-9);
        QCOMPARE(r.uncut_fraction, 0.0);
        r = check_path(strip, AptCutter::flat(6, 50), path, options);
        QVERIFY(r.cusp_max < 1e-6);
        // A pointed cone of 45 degrees leaves half the step.
        r = check_path(strip, AptCutter::cone(6, pi / 4), path, options);
        QVERIFY2(std::abs(r.cusp_max - 0.5) < 0.03, qPrintable(QString::number(r.cusp_max)));
    }

    void a_gouge_is_found_with_its_depth_and_place() {
        PathCheckOptions options;
        options.spacing = 0.1;
        const Mesh patch = height_field([](double, double) { return 0.0; }, Vec2(0, -2), Vec2(4, 2), 1, 1);
        auto path = rows(1, 0);
        path.push_back({Vec3(3, 0, 5), Vec3(3, 0, -0.2), Vec3(3, 0, 5)});
        for (const AptCutter& cutter :
             {AptCutter::ball(6, 50), AptCutter::flat(6, 50), AptCutter::bull(6, 1, 50)}) {
            const PathCheckResult r = check_path(patch, cutter, path, options);
            QVERIFY2(std::abs(r.gouge_max - 0.2) < 0.01, qPrintable(QString::number(r.gouge_max)));
            QVERIFY((r.gouge_at - Vec3(3, 0, 0)).norm() <= 3.1);
        }
    }

    void a_gouge_on_a_straight_move_between_good_ends_is_found() {
        const Mesh roof =
            height_field([](double x, double) { return -std::abs(x); }, Vec2(-20, -15), Vec2(20, 15), 2, 1);
        // Both ends clear the roof, the move between them goes through it.
        const std::vector<TipLine> path{{Vec3(-10, 0, -8), Vec3(10, 0, -8)}};
        const PathCheckResult r = check_path(roof, AptCutter::ball(4, 50), path, {.reach = 20});
        QVERIFY(r.gouge_max > 3);
    }

    void what_no_pass_comes_near_is_uncut() {
        std::vector<TipLine> path;
        for (const TipLine& line : rows(0.5, 0))
            if (line[0].y() < 0) path.push_back(line);
        const PathCheckResult r = check_path(level(), AptCutter::ball(6, 50), path, {});
        // Uncut where more than 1 mm is left: beyond -0.5 + sqrt(9 - 4) of 30 mm.
        const double expected = (15 - (-0.5 + std::sqrt(5.0))) / 30;
        QVERIFY2(std::abs(r.uncut_fraction - expected) < 0.02, qPrintable(QString::number(r.uncut_fraction)));
    }

    void an_allowance_is_measured_from() {
        const PathCheckResult r =
            check_path(level(), AptCutter::ball(6, 50), rows(0.2, 0.4), {.allowance = 0.4});
        QVERIFY(r.gouge_max < 1e-6 && r.cusp_max < 0.01);
        QVERIFY(check_path(level(), AptCutter::ball(6, 50), rows(0.2, 0.3), {.allowance = 0.4}).gouge_max
                > 0.09);
    }

    void the_border_and_named_places_are_left_out_of_cusps() {
        const auto path = rows(1, 0);
        PathCheckOptions options;
        const PathCheckResult all = check_path(level(), AptCutter::ball(6, 50), path, options);
        options.border = 5;
        const PathCheckResult inner = check_path(level(), AptCutter::ball(6, 50), path, options);
        const double share = double(inner.cusp_samples) / double(all.cusp_samples);
        QVERIFY2(std::abs(share - 30.0 * 20 / (40 * 30)) < 0.03, qPrintable(QString::number(share)));
        options.no_cusp = [](const Vec3& p) { return p.x() > 0; };
        const PathCheckResult half = check_path(level(), AptCutter::ball(6, 50), path, options);
        QVERIFY(double(half.cusp_samples) < 0.6 * double(inner.cusp_samples));
    }
};

FACETMILL_TEST(TestPathChecker)
#include "test_path_checker.moc"
