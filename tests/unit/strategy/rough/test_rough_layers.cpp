// What layers leave on a slope, and where layers lie: against Lu's formula where that holds, and against a
// search.
#include "core/strategy/rough/rough_layers.h"
#include "tests/property/shapes.h"
#include "tests/support/error_code.h"
#include "tests/support/test_runner.h"
#include "tests/support/trials.h"

#include <QTest>

#include <random>

using namespace facetmill;
using namespace facetmill::test;

namespace {

/// The highest place over a plane that three layers leave, by looking at many: the cutter runs along the
/// plane on each, and on every level place behind it the floor is as high as lines leave it.
double brute_excess(const CutterProfile& p, double depth, double stepover, double slope) {
    const double step = depth / std::tan(slope), between = p.height_at(0.5 * stepover);
    // Tip of a layer's cutter when it touches the plane z = -x tan(slope): the lowest that is never below it.
    double lift = -infinity;
    const int n = 40000;
    for (int i = 0; i <= n; ++i) {
        const double rho = p.max_radius() * i / n;
        lift = std::max(lift, rho * std::tan(slope) - p.height_at(rho));
    }
    double most = 0;
    for (int i = 0; i <= n; ++i) {
        const double x = step * (double(i) / n - 0.5) - 0.5 * p.max_radius();
        double left = infinity;
        for (int layer = -60; layer <= 60; ++layer) {
            const double at = layer * step, z = lift - layer * depth;
            left = std::min(left, z + p.height_at(std::abs(x - at)));
            if (x >= at) left = std::min(left, z + between);
        }
        most = std::max(most, std::cos(slope) * (left + x * std::tan(slope)));
    }
    return most;
}

CutterProfile cutter(int shape) {
    switch (shape) {
    case 0:
        return CutterProfile(AptCutter::ball(10, 40));
    case 1:
        return CutterProfile(AptCutter::flat(10, 40));
    case 2:
        return CutterProfile(AptCutter::bull(10, 2, 40));
    default:
        return CutterProfile(AptCutter::from_shape(8, 1, 0, radians(15), 20));
    }
}

LayerInput input(const Mesh& mesh, const CutterProfile& profile, double top) {
    LayerInput in;
    in.mesh = &mesh;
    in.cutter = &profile;
    in.top = top;
    in.low = mesh.box().lo.z();
    in.stepover = 9.5;
    return in;
}

} // namespace

class TestRoughLayers : public QObject {
    Q_OBJECT
private slots:
    /// Lu 3.10 where the lower ball reaches the upper one below its level, the stairs' corner elsewhere.
    void a_ball_leaves_what_the_formulas_say() {
        const double R = 5;
        const CutterProfile ball = cutter(0);
        int lu = 0, stairs = 0;
        for (double degree = 3; degree < 90; degree += 3)
            for (const double e : {0.2, 0.8, 2.0, 4.0}) {
                const double a = radians(degree);
                const double is = layer_excess(ball, e, 1e-6, a); // lines everywhere
                if (e <= 2 * R * std::sin(a) * std::sin(a)) {
                    const double half = e / (2 * std::sin(a)), lu_says = R - std::sqrt(R * R - half * half);
                    // Above its centre a ball end is a cylinder, which leaves less.
                    if (0.5 * e + lu_says * std::cos(a) > R * std::cos(a)) {
                        QVERIFY(is < lu_says);
                        continue;
                    }
                    QVERIFY(std::abs(is - lu_says) < 1e-9);
                    ++lu;
                } else {
                    const double corner =
                        R + std::cos(a) * (e - R) - std::sin(a) * std::sqrt(2 * R * e - e * e);
                    QVERIFY(std::abs(is - corner) < 1e-6);
                    QVERIFY(is <= e + 1e-9);
                    ++stairs;
                }
            }
        QVERIFY(lu > 40 && stairs > 10);
    }

    void every_cutter_leaves_what_a_search_finds() {
        std::mt19937 random(3);
        std::uniform_real_distribution<double> unit(0, 1);
        for (int i = 0; i < trials(60); ++i) {
            const CutterProfile p = cutter(i % 4);
            const double slope = radians(4 + 80 * unit(random)), depth = 0.2 + 3 * unit(random);
            const double stepover = (0.2 + 0.75 * unit(random)) * 10;
            if (i % 4 == 3 && slope > radians(70)) continue; // steeper than the taper: looked at below
            const double is = layer_excess(p, depth, stepover, slope),
                         found = brute_excess(p, depth, stepover, slope);
            QVERIFY2(std::abs(is - found) < 0.01 * (1 + found),
                     qPrintable(QString("cutter %1 slope %2 depth %3 step %4: %5, found %6")
                                    .arg(i % 4)
                                    .arg(degrees(slope))
                                    .arg(depth)
                                    .arg(stepover)
                                    .arg(is)
                                    .arg(found)));
        }
    }

    void level_places_keep_the_floor() {
        for (int shape = 0; shape < 4; ++shape) {
            const CutterProfile p = cutter(shape);
            QVERIFY(std::abs(layer_excess(p, 2, 6, 0) - (2 + p.height_at(3))) < 1e-12);
            QVERIFY(layer_excess(p, 2, 6, 0.5 * pi) >= 0);
        }
        // A flat end leaves the whole step, and nothing on a wall.
        QVERIFY(std::abs(layer_excess(cutter(1), 2, 9, radians(30)) - 2 * std::cos(radians(30))) < 1e-9);
        QVERIFY(layer_excess(cutter(1), 2, 9, radians(90)) < 0.003);
    }

    void the_depth_is_the_largest_that_is_allowed() {
        for (int shape = 0; shape < 4; ++shape)
            for (const double degree : {0.0, 10.0, 45.0, 80.0}) {
                const CutterProfile p = cutter(shape);
                const double depth = layer_depth(p, 0.7, 1, radians(degree), 20);
                QVERIFY(depth > 0);
                QVERIFY(layer_excess(p, depth, 1, radians(degree)) <= 0.7 + 1e-9);
                if (depth < 20) QVERIFY(layer_excess(p, 1.01 * depth, 1, radians(degree)) > 0.7);
            }
        // The floor between lines is higher already.
        QCOMPARE(layer_depth(cutter(0), 0.1, 9, 0, 5), 0.0);
    }

    void given_depths_are_kept_and_level_places_met() {
        const CutterProfile flat = cutter(1);
        const Mesh part = step(0, 8); // levels at 0 and 8
        LayerInput in = input(part, flat, 20);
        in.depth = 3;
        in.allowance = 0.5;
        in.margin = 0.01;
        const Layers layers = layer_heights(in, Progress());
        QCOMPARE(layers.level_places, std::size_t(2));
        QCOMPARE(layers.heights.back(), 0.0);
        for (const double level : {8.51, 0.51})
            QVERIFY(std::any_of(layers.heights.begin(), layers.heights.end(),
                                [&](double z) { return z > level && z < level + 1e-5; }));
        double z = in.top;
        for (const double next : layers.heights) {
            QVERIFY(next < z && z - next <= 3 + 1e-9);
            z = next;
        }
        QCOMPARE(layers.heights.size(), std::size_t(4 + 3 + 1));
        QVERIFY(layers.depth_max <= 3 + 1e-9 && layers.excess < 0.1); // only levels, and they are met
    }

    /// Steep places allow deeper layers than flat ones, each where it is.
    void depths_follow_the_local_slope() {
        const CutterProfile ball = cutter(0);
        const double steep = std::tan(radians(70)), flat = std::tan(radians(15));
        const Mesh part =
            height_field([=](double x, double) { return x < 0 ? -flat * x + steep * 20 : steep * (20 - x); },
                         Vec2(-20, -15), Vec2(20, 15), 40, 4);
        LayerInput in = input(part, ball, part.box().hi.z());
        in.excess = 0.5;
        in.deepest = 20;
        in.stepover = 1;
        const Layers layers = layer_heights(in, Progress());
        QVERIFY(layers.excess <= 0.5 + 1e-9 && layers.excess > 0.45);
        QVERIFY(layers.depth_max > 2 * layers.depth_min);
        const double wall = layer_depth(ball, 0.5, 1, radians(70), 20);
        QVERIFY(layers.depth_max <= wall * (1 + 1e-3) && layers.depth_max > 0.9 * wall);
    }

    void too_many_layers_are_refused() {
        const CutterProfile flat = cutter(1);
        const Mesh part = step(0, 8);
        LayerInput in = input(part, flat, 20);
        in.depth = 1e-6;
        QCOMPARE(code_of([&] { layer_heights(in, Progress()); }), std::string("limit_exceeded"));
        in.depth = 1;
        in.top = -1; // nothing above the part
        QVERIFY(layer_heights(in, Progress()).heights.empty());
    }
};

FACETMILL_TEST(TestRoughLayers)
#include "test_rough_layers.moc"
