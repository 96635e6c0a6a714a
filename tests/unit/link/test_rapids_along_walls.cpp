// Where tools move fast along walls: where they have been, beside a wall, off a lead.
#include "tests/support/part_meshes.h"
#include "tests/support/path_checker.h"
#include "tests/support/test_runner.h"
#include "tests/unit/link/link_cases.h"

#include <QTest>

#include <algorithm>
#include <array>

using namespace facetmill;
using namespace facetmill::test;

class TestRapidsAlongWalls : public QObject {
    Q_OBJECT
private slots:
    /// Up a wall that leans by less than moves may stay off the part, and down again where the tool has been:
    /// in rapids, which end just below the wall's upper edge and a clearance over its foot, however high what
    /// stands beside them is. With a slim shank something may stand above the flutes.
    void where_the_tool_has_been_it_falls_in_a_rapid() {
        const Mesh m = height_field([](double x, double) { return x > 5 ? 8.0 : 0.0; }, Vec2(-20, -15),
                                    Vec2(20, 15), 400, 3);
        Tool tool = ball_tool(6);
        tool.flute_length = 12;
        PlanContext context = context_of(m, tool);
        context.stock.box = context.part_box;
        context.stock_box = context.stock.box;
        const double x = 5 - 0.5 * tool.diameter - 0.2;
        const auto falls = [&](double lean, double shank) {
            context.tool.shank_diameter = shank;
            context.tool.shank_length = 30;
            StrategyResult path;
            path.passes = {pass({Vec3(-10, 0, 0), Vec3(x, 0, 0), Vec3(x + lean, 0, 8)}),
                           pass({Vec3(x, 0, 8), Vec3(x, 0, 0), Vec3(x, 0.5, 0)}),
                           pass({Vec3(x, 0, 8), Vec3(x, 0, 0), Vec3(x, 0.5, 0)})};
            for (Pass& p : path.passes)
                p.from_above = true;
            const ToolMotions all = link_three_axis(path, context, 0, near_options(0.1), Progress());
            double up = 0;
            std::array<double, 3> down{};
            for (std::size_t i = 1; i < all.motions.size(); ++i) {
                const double dz = all.motions[i].to.tip.z() - all.motions[i - 1].to.tip.z();
                if (all.motions[i].kind != MotionKind::cut) continue;
                if (all.motions[i].pass == 0) up += std::max(dz, 0.0);
                if (all.motions[i].pass != no_index) down[all.motions[i].pass] -= std::min(dz, 0.0);
            }
            return std::array{up, down[1], down[2]};
        };
        // Chords may be off by .002.
        const auto wide = falls(0.0009, 6), leaning = falls(0.0011, 6), slim = falls(0.0009, 4);
        QVERIFY2(std::abs(wide[0] - 0.15) < 1e-9, qPrintable(QString::number(wide[0])));
        QVERIFY2(std::abs(leaning[0] - 8) < 1e-9, qPrintable(QString::number(leaning[0])));
        QVERIFY2(std::abs(wide[2] - 1.5) < 1e-9, qPrintable(QString::number(wide[2])));
        QVERIFY2(std::abs(slim[2] - 8) < 1e-9, qPrintable(QString::number(slim[2])));
    }

    /// A link climbs a wall straight from where the tool is, in a rapid but for its ends, and goes on over
    /// the edge at feed.
    void a_link_goes_up_a_wall_in_a_rapid() {
        const Mesh m = height_field([](double x, double) { return x > 5 ? 8.0 : 0.0; }, Vec2(-20, -15),
                                    Vec2(20, 15), 400, 3);
        Tool tool = ball_tool(6);
        tool.flute_length = 12;
        PlanContext context = context_of(m, tool);
        context.stock.box = context.stock_box = context.part_box;
        StrategyResult path;
        path.passes = {pass({Vec3(-10, 0, 0), Vec3(1.8, 0, 0)}), pass({Vec3(6, 0, 8), Vec3(15, 0, 8)})};
        const ToolMotions all = link_three_axis(path, context, 0, near_options(5), Progress());
        double fed = 0, fast = 0;
        TipLine line;
        for (std::size_t i = 1; i < all.motions.size(); ++i) {
            const Motion& to = all.motions[i];
            const Vec3 way = to.to.tip - all.motions[i - 1].to.tip;
            line.push_back(to.to.tip);
            if (to.kind == MotionKind::link) fed += way.z();
            if (to.kind != MotionKind::rapid || all.motions[i - 1].kind != MotionKind::link) continue;
            fast += way.z();
            QCOMPARE(way.head<2>(), Vec2(0, 0));
        }
        QVERIFY2(std::abs(fed + fast - 8) < 1e-9 && fast > 3, qPrintable(QString::number(fast)));
        PathCheckOptions options;
        options.spacing = 0.2;
        QVERIFY(check_path(m, tool.cutter(), std::vector<TipLine>{line}, options).gouge_max <= 0.002);
    }

    /// The end of a lead is off the part already: from there, and to it, nearly all is a rapid.
    void out_of_a_lead_the_tool_goes_in_a_rapid() {
        PlanContext context = context_of(level(), ball_tool(6));
        context.stock.box = context.part_box;
        context.stock.box.lo.z() = -5;
        context.stock_box = context.stock.box;
        StrategyResult path;
        path.passes = {pass({Vec3(-11.5, 0, 1.5), Vec3(-10, 0, 0), Vec3(10, 0, 0), Vec3(11.5, 0, 1.5)})};
        const ToolMotions m = link_three_axis(path, context, 0, near_options(2), Progress());
        QCOMPARE(kinds_of(m), std::string("rraccc^r"));
        QVERIFY2(std::abs(m.motions[1].to.tip.z() - 1.65) < 1e-9,
                 qPrintable(QString::number(m.motions[1].to.tip.z())));
        QVERIFY2(std::abs(m.motions[6].to.tip.z() - 1.65) < 1e-9,
                 qPrintable(QString::number(m.motions[6].to.tip.z())));
    }

    /// And down beside a wall: from over a place a little away from it, where nothing stands any more.
    void roughing_comes_down_beside_a_wall() {
        Tool tool = flat_tool(6);
        tool.flute_length = 20;
        tool.shank_diameter = 6;
        tool.shank_length = 30;
        PlanContext context = context_of(step(0, 12), tool);
        context.stock.box = context.stock_box = context.part_box;
        StrategyResult path;
        path.chord_tolerance = 0.01;
        RoughPath rough;
        rough.stock_cell = 0.3;
        path.detail = rough;
        const auto approach = [&](double width) {
            path.passes = {pass({Vec3(-25, 3.02, 0.02), Vec3(10, 3.02, 0.02)}),
                           pass({Vec3(-25, 3.02 + width, 0.02), Vec3(10, 3.02 + width, 0.02)}),
                           pass({Vec3(-10, -10, 12), Vec3(0, -10, 12)}),
                           pass({Vec3(-5, 3.02, 0.02), Vec3(0, 3.02, 0.02)})};
            const ToolMotions all = link_rough(path, context, 0, near_options(0), Progress());
            std::array<Vec3, 2> way;
            for (std::size_t i = 1; i < all.motions.size(); ++i)
                if (all.motions[i].kind == MotionKind::approach)
                    way = {all.motions[i - 1].to.tip, all.motions[i].to.tip};
            return way;
        };
        const auto [over, start] = approach(3);
        QCOMPARE(start, Vec3(-5, 3.02, 0.02));
        QVERIFY2(over.y() > 3.5 && std::abs(over.z() - 1.52) < 1e-9, qPrintable(QString::number(over.z())));
        // In a slot as wide as the tool it goes down at feed.
        QVERIFY(approach(0)[0].z() > 12);
    }
};

FACETMILL_TEST(TestRapidsAlongWalls)
#include "test_rapids_along_walls.moc"
