// A million single facets against the reference; cases are other ones than those of the default run. And a
// grid of places over a height field of a million facets.
#include "core/base/parallel.h"
#include "core/gouge/axial_lift.h"
#include "tests/support/brute_lift.h"
#include "tests/support/test_runner.h"
#include "tests/unit/gouge/lift_cases.h"
#include "tests/unit/gouge/lift_check.h"

#include <QTest>

#include <cmath>

using namespace facetmill;
using namespace facetmill::test;

namespace {

constexpr double field_size = 250;
constexpr int field_quads = 707; ///< a side: a million facets

double waves(double x, double y) {
    return 10 * std::sin(0.11 * x) * std::cos(0.07 * y) + 2 * std::sin(0.5 * x + 0.3 * y);
}

/// The facets whose quads may come within `reach` of a square about (x, y), by where their quads are.
Mesh part_of(const Mesh& mesh, double x, double y, double reach) {
    constexpr double quad = field_size / field_quads;
    const auto clamped = [](double v) { return std::clamp(int(std::floor(v)), 0, field_quads - 1); };
    Mesh part;
    for (int j = clamped((y - reach) / quad - 1); j <= clamped((y + reach) / quad + 1); ++j)
        for (int i = clamped((x - reach) / quad - 1); i <= clamped((x + reach) / quad + 1); ++i)
            for (int half = 0; half < 2; ++half) {
                const Facet& f = mesh.facets[std::size_t(2 * (j * field_quads + i) + half)];
                const auto first = Index(part.vertices.size());
                for (const Index v : f)
                    part.vertices.push_back(mesh.vertices[v]);
                part.facets.push_back({first, first + 1, first + 2});
            }
    return part;
}

} // namespace

Q_DECLARE_METATYPE(facetmill::AptCutter)

class TestAxialLiftSlow : public QObject {
    Q_OBJECT
private slots:
    void single_facets_data() {
        QTest::addColumn<int>("part");
        for (int part = 10; part < 110; ++part)
            QTest::addRow("%d", part) << part;
    }
    void single_facets() {
        QFETCH(int, part);
        const std::uint64_t begin = std::uint64_t(part) * 10'000;
        const LiftCheck check = check_lift_cases(begin, begin + 10'000);
        QVERIFY2(check.first_failure.isEmpty(), qPrintable(check.first_failure));
        QVERIFY(check.touched > 8'000);
    }

    /// Every twentieth place, both ways, of a 500 x 500 grid from border to border.
    void large_field_data() {
        QTest::addColumn<AptCutter>("cutter");
        QTest::newRow("ball") << AptCutter::ball(6, 50);
        QTest::newRow("flat") << AptCutter::flat(6, 50);
        QTest::newRow("bull") << AptCutter::bull(6, 1, 50);
        QTest::newRow("cone") << AptCutter::cone(6, radians(45));
    }
    void large_field() {
        QFETCH(AptCutter, cutter);
        static const std::shared_ptr<const Mesh> mesh = field(field_quads, field_size, waves, 0.3);
        static const auto index = std::make_shared<const ContactIndex>(mesh, Progress());
        constexpr int grid = 500, stride = 20;
        std::vector<Vec2> points;
        for (int j = 0; j < grid; ++j)
            for (int i = 0; i < grid; ++i)
                points.push_back(field_size * Vec2(i, j) / (grid - 1));
        std::vector<double> heights(points.size());
        AxialLift(index, CutterProfile(cutter)).tip_z(points, heights, Progress());
        const BruteCutter brute(cutter);
        std::vector<double> worst(grid, 0.0);
        parallel_for(grid / stride, 1, Progress(), [&](std::size_t row) {
            for (int i = 0; i < grid; i += stride) {
                const std::size_t at = row * stride * grid + std::size_t(i);
                const Vec2& p = points[at];
                const double wanted = brute_lift(brute, part_of(*mesh, p.x(), p.y(), 3), p.x(), p.y());
                if (heights[at] == wanted) continue;
                const double error = std::abs(heights[at] - wanted);
                worst[row] = std::max(worst[row], std::isfinite(error) ? error : infinity);
            }
        });
        const double most = *std::max_element(worst.begin(), worst.end());
        QVERIFY2(most <= 1e-7, qPrintable(QString::number(most)));
        qInfo("worst difference %.2e mm", most);
    }
};

FACETMILL_TEST(TestAxialLiftSlow)
#include "test_axial_lift_slow.moc"
