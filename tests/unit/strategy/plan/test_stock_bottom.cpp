// Nothing goes below the stock's bottom unless it is asked for.
#include "core/strategy/plan/stock_bottom.h"
#include "tests/support/error_code.h"
#include "tests/support/test_runner.h"

#include <QTest>

#include <cmath>
#include <random>

using namespace facetmill;
using facetmill::test::code_of;

namespace {

Tool ball(double diameter) {
    Tool tool;
    tool.diameter = tool.shank_diameter = diameter;
    tool.corner_radius = diameter / 2;
    return tool;
}

PlanContext over_table() {
    PlanContext context;
    context.part_box = {Vec3(0, 0, 2), Vec3(10, 10, 8)};
    context.stock_box = {Vec3(-1, -1, 1), Vec3(11, 11, 9)};
    context.tool = ball(4);
    return context;
}

Pass pass_at(const std::vector<double>& heights, const Vec3& axis) {
    Pass pass;
    for (std::size_t i = 0; i < heights.size(); ++i) {
        pass.cl.push_back({Vec3(double(i), 0, heights[i]), axis});
        pass.cc.push_back({Vec3(double(i), 1, heights[i]), Vec3::UnitZ()});
    }
    return pass;
}

/// What the profile says by itself, on its pieces closely.
double searched(const CutterProfile& profile, const Vec3& axis) {
    const double cosine = axis.z(), sine = std::sqrt(1 - cosine * cosine);
    double most = 0;
    for (const ProfilePiece& p : profile.pieces())
        for (int k = 0; k <= 4000; ++k) {
            const double t = k / 4000.0;
            Vec2 at = p.from + t * (p.to - p.from);
            if (p.kind == ProfilePiece::Kind::arc)
                at = p.center + p.radius * (at - p.center).normalized(); // no arc is longer than a quarter
            most = std::max(most, at.x() * sine - at.y() * cosine);
        }
    return most;
}

} // namespace

class TestStockBottom : public QObject {
    Q_OBJECT
private slots:
    void how_low_a_leaning_cutter_reaches() {
        std::mt19937 random(3);
        std::uniform_real_distribution<double> cosine(-1, 1);
        for (const AptCutter& cutter :
             {AptCutter::ball(4, 20), AptCutter::flat(4, 20), AptCutter::bull(6, 1, 20),
              AptCutter::cone(8, radians(30)), AptCutter::tapered_ball(1, radians(5), 20)}) {
            const CutterProfile profile(cutter);
            QCOMPARE(reach_below_tip(profile, Vec3::UnitZ()), 0.0);
            for (int i = 0; i < 200; ++i) {
                const double z = cosine(random);
                const Vec3 axis(std::sqrt(1 - z * z), 0, z);
                const double reach = reach_below_tip(profile, axis), found = searched(profile, axis);
                QVERIFY2(reach >= found - 1e-12 && reach <= found + 1e-4,
                         qPrintable(QString::number(reach - found)));
            }
        }
    }

    void upright_tips_are_raised() {
        const PlanContext context = over_table();
        OperationCommon common;
        StrategyResult path;
        path.passes = {pass_at({3, 1, 0.5, -1, 2}, Vec3::UnitZ())};
        path.passes[0].entry = {{Vec3(0, 0, 4), Vec3::UnitZ()}, {Vec3(0, 0, 0), Vec3::UnitZ()}};
        StrategyResult allowed = path, wall = path;
        keep_above_bottom(path, context, common);
        // On the way from -1 to 2 it leaves the level where the way crosses it.
        const std::vector<Vec2> expected{{0, 3}, {1, 1}, {2, 1}, {3, 1}, {3 + 2.0 / 3, 1}, {4, 2}};
        QCOMPARE(path.passes[0].cl.size(), expected.size());
        QCOMPARE(path.passes[0].cc.size(), expected.size());
        for (std::size_t i = 0; i < expected.size(); ++i) {
            QCOMPARE(path.passes[0].cl[i].tip.x(), expected[i].x());
            QCOMPARE(path.passes[0].cl[i].tip.z(), expected[i].y());
        }
        QCOMPARE(path.passes[0].cc[4].point.x(), 3 + 2.0 / 3);
        QCOMPARE(path.passes[0].entry[1].tip.z(), 1.0);
        QCOMPARE(path.warnings.size(), std::size_t(1));
        QVERIFY(QString::fromStdString(path.warnings[0]).contains(QStringLiteral("up to 2 mm")));

        // Of a wall nothing stays that anybody asks for.
        for (CutterContact& c : wall.passes[0].cc)
            c.normal = Vec3::UnitX();
        keep_above_bottom(wall, context, common);
        QCOMPARE(wall.passes[0].cl[3].tip.z(), 1.0);
        QVERIFY(wall.warnings.empty());

        common.below_bottom = 1.25;
        keep_above_bottom(allowed, context, common);
        QCOMPARE(allowed.passes[0].cl[2].tip.z(), 0.5);
        QCOMPARE(allowed.passes[0].cl[3].tip.z(), -0.25);
        QCOMPARE(allowed.warnings.size(), std::size_t(2));
        QVERIFY(QString::fromStdString(allowed.warnings[1]).contains(QStringLiteral("1.25 mm below")));
    }

    /// A leaning ball's lowest point is below its tip.
    void passes_of_a_leaning_tool_end() {
        const PlanContext context = over_table();
        OperationCommon common;
        const Vec3 axis(std::sqrt(0.5), 0, std::sqrt(0.5));
        const double below = 2 * (1 - std::sqrt(0.5));
        StrategyResult path;
        path.passes = {pass_at({3, 2, 1 + below, 1, 3, 1 + 0.9 * below, 4, 4, 1}, axis)};
        keep_above_bottom(path, context, common);
        QCOMPARE(path.passes.size(),
                 std::size_t(2)); // the one location between two that are left out goes, too
        QCOMPARE(path.passes[0].cl.size(), std::size_t(3));
        QCOMPARE(path.passes[0].cc.size(), std::size_t(3));
        QCOMPARE(path.passes[1].cl.size(), std::size_t(2));
        QCOMPARE(path.passes[1].cc[0].point.x(), 6.0);
        QCOMPARE(path.warnings.size(), std::size_t(1));
        QVERIFY(QString::fromStdString(path.warnings[0]).contains(QStringLiteral("33 %")));
        path.passes = {pass_at({0, 0}, axis)};
        QCOMPARE(code_of([&] { keep_above_bottom(path, context, common); }), std::string("empty_result"));
    }
};

FACETMILL_TEST(TestStockBottom)
#include "test_stock_bottom.moc"
