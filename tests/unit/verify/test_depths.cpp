// How deep points come to lie inside a moving tool, against a search over poses that knows nothing but the
// radius of the tool at a height.
#include "core/verify/probes.h"
#include "tests/support/part_meshes.h"
#include "tests/support/test_runner.h"
#include "tests/support/trials.h"

#include <QTest>

#include <random>

using namespace facetmill;
using namespace facetmill::test;

namespace {

Vec3 any_direction(std::mt19937& random) {
    std::normal_distribution<double> normal;
    return Vec3(normal(random), normal(random), normal(random)).normalized();
}

/// Signed depth of a point in a body of revolution: how far it is from points of the outline, which is walked
/// in small steps. Below 0 outside.
double depth_by_outline(const CutterProfile& cutter, const Vec3& point, const CutterLocation& at) {
    const Vec3 d = point - at.tip;
    const double z = d.dot(at.axis), rho = (d - z * at.axis).norm();
    const double top = cutter.height();
    std::vector<Vec2> outline{{0, 0}};
    constexpr int steps = 4000;
    for (int i = 0; i <= steps; ++i) {
        const double r = cutter.max_radius() * i / steps;
        outline.push_back({r, cutter.height_at(r)});
    }
    outline.push_back({cutter.max_radius(), top});
    outline.push_back({0, top});
    double nearest = infinity;
    for (std::size_t i = 1; i < outline.size(); ++i) {
        const Vec2 a = outline[i - 1], b = outline[i], p(rho, z);
        const double square = (b - a).squaredNorm();
        const double t = square > 0 ? std::clamp((p - a).dot(b - a) / square, 0.0, 1.0) : 0.0;
        nearest = std::min(nearest, (p - a - t * (b - a)).norm());
    }
    const bool inside = rho <= cutter.max_radius() && z <= top && z >= cutter.height_at(rho);
    return inside ? nearest : -nearest;
}

} // namespace

class TestDepths : public QObject {
    Q_OBJECT
private slots:
    void of_poses() {
        std::mt19937 random(5);
        std::uniform_real_distribution<double> share(-1, 1);
        for (const ShapedTool& shaped : tools_of_every_shape()) {
            const CutterProfile cutter(shaped.tool.cutter());
            const BodySupport body(cutter);
            for (int i = 0; i < 60; ++i) {
                const CutterLocation at{Vec3(share(random), share(random), share(random)),
                                        any_direction(random)};
                const double r = cutter.max_radius();
                const Vec3 side = at.axis.unitOrthogonal();
                const Vec3 p = at.tip + 1.2 * r * share(random) * side
                               + (0.5 + 0.7 * share(random)) * cutter.height() * at.axis;
                const double expected = depth_by_outline(cutter, p, at);
                QVERIFY2(std::abs(body.nearest(p - at.tip, at.axis).inside - expected) < 2e-3 * r,
                         qPrintable(QString("%1: %2 of %3")
                                        .arg(shaped.name)
                                        .arg(body.nearest(p - at.tip, at.axis).inside)
                                        .arg(expected)));
            }
        }
    }

    void of_programs_data() {
        QTest::addColumn<bool>("turning");
        QTest::newRow("straight") << false;
        QTest::newRow("turning") << true;
    }
    /// The deepest of all poses on random walks, a hundred to a motion.
    void of_programs() {
        QFETCH(bool, turning);
        std::mt19937 random(turning ? 11 : 3);
        std::uniform_real_distribution<double> share(-1, 1);
        constexpr double bound = 1e-3;
        std::size_t inside = 0;
        for (const ShapedTool& shaped : tools_of_every_shape())
            for (int round = 0; round < trials(6); ++round) {
                const CutterProfile cutter(shaped.tool.cutter());
                auto motions = std::make_shared<ToolMotions>();
                Vec3 axis = any_direction(random), tip(0, 0, 0);
                for (int i = 0; i < 12; ++i) {
                    if (turning && i % 3 != 0) axis = (axis + 0.3 * any_direction(random)).normalized();
                    tip += Vec3(share(random), share(random), share(random)) * 2;
                    motions->motions.push_back({MotionKind::cut, {tip, axis}, no_index, no_index});
                }
                const VerifyProgram program{"P", VerifyTool(shaped.tool), motions, std::nullopt};
                const auto tree = std::make_shared<const MotionTree>(
                    program, [](MotionKind) { return true; }, Progress());
                const MotionProbes probes{TurnedBody(cutter), BodySupport(cutter), tree, bound};
                const BodySupport body(cutter);
                for (int k = 0; k < 40; ++k) {
                    const Vec3 p = 6 * Vec3(share(random), share(random), share(random));
                    double expected = 0;
                    for (std::size_t m = 1; m < motions->motions.size(); ++m)
                        for (int s = 0; s <= 100; ++s) {
                            const CutterLocation at = location_between(
                                motions->motions[m - 1].to, motions->motions[m].to, std::nullopt, 0.01 * s);
                            expected = std::max(expected, body.nearest(p - at.tip, at.axis).inside);
                        }
                    DepthProbe probe;
                    const bool deeper = probes.deepen(p, no_index, probe);
                    QCOMPARE(deeper, probe.depth > 0);
                    QVERIFY2(
                        probe.depth >= expected - bound && probe.depth <= expected + 0.05,
                        qPrintable(QString("%1: %2 of %3").arg(shaped.name).arg(probe.depth).arg(expected)));
                    inside += expected > 0.05;
                    if (!deeper) continue;
                    // A hint changes nothing, and the first motion as deep is as deep.
                    DepthProbe hinted;
                    probes.deepen(p, Index(random() % motions->motions.size()), hinted);
                    QVERIFY(std::abs(hinted.depth - probe.depth) <= (turning ? bound : 1e-8));
                    QVERIFY(probes.first_as_deep(p, probe) <= probe.motion);
                }
            }
        QVERIFY(inside > trials(std::size_t(100)));
    }
};

FACETMILL_TEST(TestDepths)
#include "test_depths.moc"
