// What a path clears: against poses so close to each other that nothing is lost between them.
#include "core/base/parallel.h"
#include "core/strategy/five_axis/posture_path.h"
#include "core/strategy/global_local/coverage.h"
#include "tests/support/test_runner.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <random>

using namespace facetmill;
using namespace facetmill::test;

namespace {

std::vector<AptCutter> cutters() {
    return {AptCutter::flat(6, 50), AptCutter::ball(6, 50), AptCutter::bull(6, 1, 50),
            AptCutter::from_shape(6, 1, radians(10), radians(8), 20), AptCutter::cone(8, radians(30))};
}

/// How deep a place comes into the cutter in a pose; below 0: it stays outside. Above `height` the cutter
/// does not count.
double depth(const CutterProfile& cutter, double height, const CutterLocation& at, const Vec3& place) {
    const Vec3 from = place - at.tip;
    const double z = from.dot(at.axis), rho = (from - z * at.axis).norm();
    if (rho > cutter.max_radius()) return cutter.max_radius() - rho;
    return std::min(z - cutter.height_at(rho), height - z);
}

} // namespace

class TestCoverage : public QObject {
    Q_OBJECT
private slots:
    /// Raised by 0.01 mm a place is within the disc of an end inclined by 30 degrees for 0.02 mm of its way.
    void an_inclined_flat_end_clears_all_along_its_line() {
        const double lead = radians(30), r = 5;
        Pass pass;
        for (const double x : {0.0, 7.0, 20.0})
            pass.cl.push_back({Vec3(x, 0, 0) - r * Vec3(std::cos(lead), 0, -std::sin(lead)),
                               Vec3(std::sin(lead), 0, std::cos(lead))});
        std::vector<SurfaceSample> samples;
        for (int i = 0; i <= 1000; ++i)
            samples.push_back({Vec3(0.02 * i, 0, 0), Vec3::UnitZ(), 1});
        Coverage coverage(samples, 0.01);
        coverage.add({&pass, 1}, CutterProfile(AptCutter::flat(2 * r, 50)), Progress());
        QCOMPARE(coverage.cleared_area(), coverage.area());
        // Nothing above the tool's way is cleared that it does not reach.
        for (SurfaceSample& s : samples)
            s.point.z() -= 0.02;
        Coverage below(samples, 0.01);
        below.add({&pass, 1}, CutterProfile(AptCutter::flat(2 * r, 50)), Progress());
        QCOMPARE(below.cleared_area(), 0.0);
    }

    void random_routes_are_those_of_dense_poses() {
        std::mt19937_64 rng(5);
        const auto number = [&](double lo, double hi) {
            return std::uniform_real_distribution<double>(lo, hi)(rng);
        };
        const auto axis = [&] { return Vec3(number(-0.6, 0.6), number(-0.6, 0.6), 1).normalized(); };
        std::size_t in = 0, out = 0, near = 0;
        for (const AptCutter& shape : cutters()) {
            const CutterProfile cutter(shape);
            const double r = cutter.max_radius(), height = std::min(cutter.height(), r);
            for (int trial = 0; trial < 5; ++trial) {
                Pass pass;
                Vec3 tip(0, 0, 0), leans = axis();
                for (int k = 0; k < 3; ++k) {
                    pass.cl.push_back({tip, leans});
                    tip += Vec3(number(0, 1.5), number(-0.5, 0.5), number(-0.3, 0.3)) * r;
                    leans = (leans + 0.3 * axis()).normalized();
                }
                std::vector<SurfaceSample> samples;
                for (int i = 0; i < 300; ++i)
                    samples.push_back(
                        {Vec3(number(-0.5, 2.5), number(-1, 1), number(-0.6, 0.3)) * r, Vec3::UnitZ(), 1});
                Coverage coverage(samples, 0);
                coverage.add({&pass, 1}, cutter, Progress());
                for (std::size_t i = 0; i < samples.size(); ++i) {
                    double deepest = -infinity;
                    for (std::size_t k = 0; k + 1 < pass.cl.size(); ++k)
                        for (int t = 0; t <= 2000; ++t)
                            deepest = std::max(
                                deepest, depth(cutter, height,
                                               location_on_route(pass.cl[k], pass.cl[k + 1], t / 2000.0),
                                               samples[i].point));
                    // What is held by less than a thousandth of the radius may count as not cleared.
                    const bool cleared = coverage.cleared(i);
                    QVERIFY2(!cleared || deepest > -1e-4 * r, qPrintable(QString::number(deepest / r)));
                    QVERIFY2(cleared || deepest < 1e-3 * r, qPrintable(QString::number(deepest / r)));
                    in += cleared;
                    out += !cleared;
                    near += std::abs(deepest) < 0.01 * r;
                }
            }
        }
        QVERIFY(in > 500 && out > 500 && near > 50);
    }

    void the_same_with_any_number_of_threads() {
        std::vector<Pass> passes(7);
        for (std::size_t i = 0; i < passes.size(); ++i)
            for (const double x : {0.0, 9.0, 20.0})
                passes[i].cl.push_back(
                    {Vec3(x, 2.0 * double(i), 0.1 * x), Vec3(0.02 * x, 0.1, 1).normalized()});
        std::vector<SurfaceSample> samples;
        for (int i = 0; i < 4000; ++i)
            samples.push_back({Vec3(i % 80 * 0.25, i / 80 * 0.3, 0.5), Vec3::UnitZ(), 1});
        const auto cleared = [&](int threads) {
            set_thread_count(threads);
            Coverage coverage(samples, 0.01);
            coverage.add(passes, CutterProfile(AptCutter::bull(6, 1, 50)), Progress());
            std::vector<bool> all;
            for (std::size_t i = 0; i < samples.size(); ++i)
                all.push_back(coverage.cleared(i));
            return all;
        };
        const auto one = cleared(1), two = cleared(2);
        set_thread_count(0);
        QVERIFY(one == two && std::count(one.begin(), one.end(), true) > 100);
    }
};

FACETMILL_TEST(TestCoverage)
#include "test_coverage.moc"
