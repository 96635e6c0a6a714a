// Leaning passes that would go below the stock's bottom, along an upright wall: what is raised, and what
// not.
#include "core/strategy/five_axis/low_passes.h"

#include "core/base/tolerances.h"
#include "core/strategy/plan/stock_bottom.h"
#include "tests/property/shapes.h"
#include "tests/support/error_code.h"
#include "tests/support/test_runner.h"

#include <QTest>

#include <cmath>

using namespace facetmill;
using namespace facetmill::test;

namespace {

constexpr double ball_radius = 3, stock_foot = -1;
/// Off the wall, and 60 degrees from Z.
const Vec3 wall_lean(std::sin(radians(60)), 0, std::cos(radians(60)));

/// The wall is where x = 0.
Mesh foot_wall() {
    return box(Vec3(-4, -20, 0), Vec3(0, 20, 20));
}

/// Another box of the part.
Mesh with_lip(Mesh part, const Box3& lip) {
    const Mesh more = box(lip.lo, lip.hi);
    const auto first = Index(part.vertices.size());
    part.vertices.insert(part.vertices.end(), more.vertices.begin(), more.vertices.end());
    for (const auto& facet : more.facets)
        part.facets.push_back({facet[0] + first, facet[1] + first, facet[2] + first});
    return part;
}

PlanContext beside_wall(const Mesh& part) {
    PlanContext c = context_of(part, ball_tool(2 * ball_radius));
    c.machine = find_machine("trunnion-ac");
    c.stock_box.lo.z() = stock_foot;
    return c;
}

Vec3 ball_centre(const CutterLocation& c) {
    return c.tip + ball_radius * c.axis;
}

/// Along the wall, the ball's centre at a height.
Pass wall_pass_at(double height, double step = 2) {
    Pass pass;
    for (double y = -10; y <= 10; y += step) {
        pass.cc.push_back({Vec3(0, y, height), Vec3::UnitX()});
        pass.cl.push_back({Vec3(ball_radius, y, height) - ball_radius * wall_lean, wall_lean});
    }
    return pass;
}

StrategyResult raised_passes(const PlanContext& context, std::vector<Pass> passes) {
    StrategyResult path;
    path.passes = std::move(passes);
    path.chord_tolerance = 0.02;
    OperationCommon common;
    raise_low_passes(path, context, common, 0);
    return path;
}

} // namespace

class TestLowPasses : public QObject {
    Q_OBJECT
private slots:
    void a_pass_at_the_foot_of_a_wall_is_raised_along_it() {
        const PlanContext context = beside_wall(foot_wall());
        const double lowest = stock_foot + ball_radius;
        const StrategyResult path =
            raised_passes(context, {wall_pass_at(lowest + 1), wall_pass_at(lowest - 0.8)});
        for (const CutterLocation& c : path.passes[0].cl)
            QVERIFY(std::abs(ball_centre(c).z() - (lowest + 1)) < 1e-12); // high enough
        QCOMPARE(path.passes[1].cl.size(), path.passes[0].cl.size());
        QCOMPARE(path.passes[1].cc.size(), path.passes[0].cc.size());
        for (const CutterLocation& c : path.passes[1].cl)
            QVERIFY((ball_centre(c) - Vec3(ball_radius, c.tip.y(), lowest)).norm() < 1e-9);
        QCOMPARE(path.warnings.size(), std::size_t(1));
        QVERIFY(QString::fromStdString(path.warnings[0]).contains(QStringLiteral("by up to 0.8 mm at 50 %")));
        StrategyResult kept = path;
        keep_above_bottom(kept, context, OperationCommon());
        QCOMPARE(kept.passes.size(), std::size_t(2));
    }

    /// A lower pass raised to the same place cuts nothing more; one that is lower still would stay far from
    /// what it is to cut.
    void what_is_of_no_use_is_left() {
        const PlanContext context = beside_wall(foot_wall());
        const double lowest = stock_foot + ball_radius;
        StrategyResult path = raised_passes(
            context, {wall_pass_at(lowest - 0.8), wall_pass_at(lowest - 1.1), wall_pass_at(lowest - 2.8)});
        const double up = ball_centre(path.passes[0].cl[0]).z();
        QVERIFY(std::abs(up - lowest) < 1e-9);
        QVERIFY(std::abs(ball_centre(path.passes[1].cl[0]).z() - (lowest - 1.1)) < 1e-9);
        QVERIFY(std::abs(ball_centre(path.passes[2].cl[0]).z() - (lowest - 2.8)) < 1e-9);
        keep_above_bottom(path, context, OperationCommon());
        QCOMPARE(path.passes.size(), std::size_t(1));
        path = raised_passes(context, {wall_pass_at(lowest - 2.8)});
        QVERIFY(std::abs(ball_centre(path.passes[0].cl[0]).z() - (lowest - 2.8)) < 1e-9);
        QVERIFY(path.warnings.empty());
    }

    /// Down the wall with one axis: the lowest location once.
    void a_pass_down_a_wall_ends_at_the_lowest_location() {
        const PlanContext context = beside_wall(foot_wall());
        Pass down;
        for (double z = 8.2; z >= -0.5; z -= 0.5) {
            down.cc.push_back({Vec3(0, 0, z), Vec3::UnitX()});
            down.cl.push_back({Vec3(ball_radius, 0, z) - ball_radius * wall_lean, wall_lean});
        }
        StrategyResult path = raised_passes(context, {down});
        keep_above_bottom(path, context, OperationCommon());
        QCOMPARE(path.passes.size(), std::size_t(1));
        const auto& cl = path.passes[0].cl;
        QVERIFY(std::abs(ball_centre(cl.back()).z() - (stock_foot + ball_radius)) < 1e-9);
        for (std::size_t i = 1; i < cl.size(); ++i)
            QVERIFY((cl[i].tip - cl[i - 1].tip).norm() > 1e-6);
    }

    /// Where a lip of the part is in the way up, the tool goes out along its axis, and no motion cuts the
    /// lip.
    void a_lip_over_the_place_is_not_cut() {
        const Box3 lip{Vec3(-4, -2, 4.2), Vec3(1.2, 2, 6)};
        const PlanContext context = beside_wall(with_lip(foot_wall(), lip));
        const double lowest = stock_foot + ball_radius;
        for (const double step : {0.5, 2.0, 10.0}) {
            StrategyResult path = raised_passes(context, {wall_pass_at(lowest - 0.8, step)});
            if (step == 10) {
                // Both of its motions would go through the lip: nothing of it can be kept.
                QCOMPARE(code_of([&] { keep_above_bottom(path, context, OperationCommon()); }),
                         std::string("empty_result"));
                continue;
            }
            keep_above_bottom(path, context, OperationCommon());
            QVERIFY(!path.passes.empty());
            bool out = false;
            for (const Pass& pass : path.passes)
                for (std::size_t i = 1; i < pass.cl.size(); ++i)
                    for (int k = 0; k <= 40; ++k) {
                        const Vec3 at = ball_centre(pass.cl[i - 1])
                                        + k / 40.0 * (ball_centre(pass.cl[i]) - ball_centre(pass.cl[i - 1]));
                        const Vec3 near = at.cwiseMax(lip.lo).cwiseMin(lip.hi);
                        QVERIFY2((at - near).norm() >= ball_radius - 0.02,
                                 qPrintable(QString("%1 at %2").arg((at - near).norm()).arg(at.y())));
                        QVERIFY(at.x() >= ball_radius - 0.02 && at.z() >= lowest - 0.02);
                        out = out || at.x() > ball_radius + 0.1;
                    }
            QVERIFY(out);
        }
    }
};

FACETMILL_TEST(TestLowPasses)
#include "test_low_passes.moc"
