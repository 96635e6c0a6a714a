// Why material stays, on jobs where one thing alone keeps the tool off.
#include "tests/support/test_runner.h"
#include "tests/unit/verify/verdict_cases.h"

#include <QTest>

using namespace facetmill;
using namespace facetmill::test;

class TestUncutReasons : public QObject {
    Q_OBJECT
private slots:
    /// What is left because the holder would touch a wall has its own reason, whatever a tool for roughing
    /// could do there.
    void what_the_holder_keeps_off() {
        const Mesh part = prism({{-20, -10}, {20, -10}, {20, 0}, {-10, 0}, {-10, 30}, {-20, 30}},
                                {{0, 1, 2, 3}, {0, 3, 4, 5}});
        StockSolid stock = stock_of(part.box());
        stock.box.hi.z() = 31;
        Tool tool = flat_tool(4);
        tool.flute_length = 10;
        tool.shank_diameter = 4;
        tool.shank_length = 5;
        tool.holder = {{20, 20}};
        const Vec2 lo(-30, 1), hi(30, 20);
        const VerifyProgram finish = lines(tool, lo, hi, 0, 2);
        const Verification v = judged(part, stock, finish);
        const UncutReason* held = reason(v, UncutReason::Why::held);
        QVERIFY(held && held->counts());
        // With the holder at the wall the cutter comes within 8 mm of it.
        QVERIFY2(std::abs(held->area - 8 * 60) < 60, qPrintable(QString::number(held->area)));
        const VerifyProgram rough = lines(flat_tool(6), lo, hi, 0.5, 2);
        const std::array<VerifyProgram, 2> both{rough, finish};
        const Verification w = verify(part, stock, both, asked(), Progress());
        QVERIFY(reason(w, UncutReason::Why::held) && reason(w, UncutReason::Why::held)->area == held->area);
        Tool longer = tool;
        longer.shank_length = 40;
        const Verification x = judged(part, stock, lines(longer, lo, hi, 0, 2));
        QVERIFY(reason(x, UncutReason::Why::not_cut) && !reason(x, UncutReason::Why::held));
    }

    /// A clean-up is there for what the cutter before it cannot enter: where that one fits, what keeps its
    /// operation off is the reason, though the smaller tool could go there; in a groove that it does not
    /// enter the smaller one is what does not go there.
    void what_is_not_for_the_smaller_tool() {
        const Mesh part = prism({{-20, -10}, {20, -10}, {20, 0}, {-10, 0}, {-10, 30}, {-20, 30}},
                                {{0, 1, 2, 3}, {0, 3, 4, 5}});
        StockSolid stock = stock_of(part.box());
        stock.box.hi.z() = 31;
        Tool tool = flat_tool(4);
        tool.flute_length = 10;
        tool.shank_diameter = 4;
        tool.shank_length = 5;
        tool.holder = {{20, 20}};
        Tool small = flat_tool(2);
        small.flute_length = 40;
        std::array<VerifyProgram, 2> programs{lines(tool, Vec2(-30, 1), Vec2(30, 20), 0, 2),
                                              lines(small, Vec2(-30, 18), Vec2(30, 20), 0, 1)};
        programs[0].name = "Finish";
        programs[1].name = "Clean-up";
        const Verification all = verify(part, stock, programs, asked(), Progress());
        const UncutReason* not_cut = reason(all, UncutReason::Why::not_cut);
        QVERIFY(not_cut && not_cut->program == programs[1].name && !reason(all, UncutReason::Why::held));
        programs[1].beyond = tool.cutter();
        const Verification v = verify(part, stock, programs, asked(), Progress());
        const UncutReason* held = reason(v, UncutReason::Why::held);
        QVERIFY(held && held->program == programs[0].name);
        QVERIFY2(std::abs(held->area - 8 * 60) < 60, qPrintable(QString::number(held->area)));
        QCOMPARE(v.uncut_share, all.uncut_share);

        const Mesh groove = grooved(6, 5);
        StockSolid block = stock_of(groove.box());
        block.box.hi.z() = 1;
        std::array<VerifyProgram, 2> over{lines(flat_tool(12), Vec2(-30, -20), Vec2(30, 20), 0, 8),
                                          lines(flat_tool(5), Vec2(-30, -20), Vec2(30, 20), 0, 4)};
        over[0].name = "Finish";
        over[1].name = "Clean-up";
        over[1].beyond = flat_tool(12).cutter();
        const Verification w = verify(groove, block, over, asked(), Progress());
        const UncutReason* floor = reason(w, UncutReason::Why::not_cut);
        QVERIFY(floor && floor->program == over[1].name && floor->area > 5 * 60);
    }

    /// A tool whose flutes are shorter than what stands of the stock about a slot does not go deeper, though
    /// it fits; nothing of the part is in its shank's way.
    void what_the_stock_keeps_off() {
        const Mesh part = prism({{-20, -10}, {20, -10}, {20, 0}, {-20, 0}}, {{0, 1, 2, 3}});
        StockSolid stock = stock_of(part.box());
        stock.box.hi.z() = 12;
        Tool tool = flat_tool(4);
        tool.flute_length = 5;
        tool.shank_diameter = 4;
        tool.shank_length = 40;
        // Of a floor of 40 x 60 a half is open, on the other one all of the 12 mm stands.
        const Vec2 lo(-30, 0.5), hi(-2, 12);
        Tool longer = tool;
        longer.flute_length = 20;
        std::array<VerifyProgram, 2> programs{lines(longer, lo, hi, 0, 2), lines(tool, lo, hi, 0, 2)};
        programs[0].name = "Long";
        programs[1].name = "Short";
        const Verification v = verify(part, stock, programs, asked(), Progress());
        const UncutReason* beside = reason(v, UncutReason::Why::stock);
        QVERIFY(beside && beside->counts());
        QCOMPARE(beside->program, programs[1].name);
        // A tool with long flutes has no such reason.
        const Verification w = judged(part, stock, programs[0]);
        QVERIFY(reason(w, UncutReason::Why::not_cut) && !reason(w, UncutReason::Why::stock));
        QVERIFY2(std::abs(w.uncut_share - v.uncut_share) < 0.02,
                 qPrintable(QString("%1 and %2").arg(w.uncut_share).arg(v.uncut_share)));
    }

    /// What stands in the end is in no shank's way, but what stood when the program began was: it is told,
    /// unless the tool went into it all the same.
    void what_the_stock_kept_off() {
        const Mesh part = prism({{-20, -10}, {20, -10}, {20, 0}, {-20, 0}}, {{0, 1, 2, 3}});
        StockSolid stock = stock_of(part.box());
        stock.box.hi.z() = 12;
        Tool tool = flat_tool(4), longer = tool;
        tool.flute_length = 5;
        tool.shank_diameter = 4;
        tool.shank_length = 40;
        longer.flute_length = 20;
        const auto finish = [&](double z) {
            VerifyProgram p = lines(tool, Vec2(-30, -20), Vec2(30, -18), z, 2);
            p.name = "Finish";
            return p;
        };
        VerifyProgram rough = lines(longer, Vec2(-30, -20), Vec2(30, 20), 0.5, 2);
        rough.name = "Rough";
        rough.leaves = 0.6;
        const auto judge = [&](const VerifyProgram& first, const VerifyProgram& second) {
            const std::array<VerifyProgram, 2> programs{first, second};
            return verify(part, stock, programs, asked(), Progress());
        };
        const Verification before = judge(finish(8), rough);
        QVERIFY(before.collisions.empty());
        const UncutReason *beside = reason(before, UncutReason::Why::stock),
                          *free = reason(before, UncutReason::Why::not_cut);
        QVERIFY(beside && beside->counts() && beside->program == "Finish");
        // From beside the block the tool comes to its rim.
        QVERIFY2(!free || free->area < 0.05 * beside->area,
                 qPrintable(QString("%1 and %2").arg(free ? free->area : 0).arg(beside->area)));
        const Verification after = judge(rough, finish(8));
        QVERIFY(reason(after, UncutReason::Why::not_cut) && !reason(after, UncutReason::Why::stock));
        const Verification through = judge(finish(4), rough);
        QVERIFY(!through.collisions.empty());
        QVERIFY(reason(through, UncutReason::Why::not_cut) && !reason(through, UncutReason::Why::stock));
    }

    /// A shank that rubs less deep in what stands than a cutter may go into the part is no collision.
    void a_shank_may_rub_as_deep_as_the_gouge_limit() {
        const Mesh part = prism({{-20, -10}, {20, -10}, {20, 0}, {-20, 0}}, {{0, 1, 2, 3}});
        StockSolid stock = stock_of(part.box());
        stock.box.hi.z() = 12;
        Tool slot = flat_tool(4), wide_above = slot;
        slot.flute_length = 20;
        wide_above.flute_length = 5;
        wide_above.shank_length = 40;
        const auto collisions = [&](double rub, double gouge_limit) {
            wide_above.shank_diameter = 4 + 2 * rub;
            const std::array<VerifyProgram, 2> programs{lines(slot, Vec2(-30, 0), Vec2(30, 0), 2, 1),
                                                        lines(wide_above, Vec2(-30, 0), Vec2(30, 0), 2, 1)};
            VerifySettings s = asked();
            s.resolution = 0.2;
            s.gouge_limit = gouge_limit;
            return verify(part, stock, programs, s, Progress()).collisions;
        };
        QVERIFY(collisions(0.0045, 0.005).empty());
        QVERIFY(!collisions(0.0045, 0.001).empty());
        const auto deep = collisions(0.02, 0.005);
        QVERIFY(!deep.empty() && deep[0].kind == Collision::Kind::shank);
        QVERIFY2(std::abs(deep[0].depth - 0.02) < 1e-4, qPrintable(QString::number(deep[0].depth)));
        // However much may be missing of the part, a hundredth of a millimetre is one.
        QVERIFY(!collisions(0.02, 0.1).empty());
    }

    /// A ball that is kept above the bottom of the stock leaves the lower end of a steep side, which it would
    /// cut from farther down; when it goes down there itself that is no reason.
    void what_the_bottom_keeps_off() {
        const Mesh part = prism({{-20, -10}, {20, -10}, {12, 10}, {-12, 10}}, {{0, 1, 2, 3}});
        const StockSolid stock = stock_of(part.box());
        Tool ball = ball_tool(8);
        ball.flute_length = 40;
        // At height z over the bottom the side is at y = 20 - 0.4 z; the ball touches it from the outside.
        const auto along_sides = [&](double lowest) {
            VerifyProgram p{"Ball", VerifyTool(ball), nullptr, {}};
            auto motions = std::make_shared<ToolMotions>();
            const Vec2 out = Vec2(1, 0.4).normalized(); // (y, z)
            for (double z = 0; z <= 20; z += 0.5)
                for (const double side : {-1.0, 1.0}) {
                    const double y = 20 - 0.4 * z + 4 * out.x(), tip = z - 10 + 4 * out.y() - 4;
                    if (tip < lowest) continue;
                    for (const MotionKind kind : {MotionKind::rapid, MotionKind::cut})
                        motions->motions.push_back(
                            {kind,
                             {Vec3(kind == MotionKind::rapid ? -40 : 40, side * y, tip), Vec3::UnitZ()},
                             no_index,
                             no_index});
                }
            p.motions = motions;
            return p;
        };
        const Verification kept = judged(part, stock, along_sides(-10));
        const UncutReason* low = reason(kept, UncutReason::Why::below_bottom);
        QVERIFY(low && low->counts() && low->program == "Ball");
        QVERIFY(low->place.z() < -6);
        const Verification down = judged(part, stock, along_sides(-14));
        QVERIFY(!reason(down, UncutReason::Why::below_bottom));
        QVERIFY(down.uncut_share < kept.uncut_share);
    }

    /// The same with axes that lean to this side and that in turn: tips lie elsewhere, the ball goes by.
    void what_leaning_passes_too_far_apart_leave() {
        const Mesh part = prism({{-20, -10}, {20, -10}, {20, 0}, {-20, 0}}, {{0, 1, 2, 3}});
        StockSolid stock = stock_of(part.box());
        stock.box.hi.z() = 4;
        Tool ball = ball_tool(6);
        ball.flute_length = 40;
        VerifyProgram leaning{"Leaning", VerifyTool(ball), nullptr, {}};
        auto motions = std::make_shared<ToolMotions>();
        const double lean = radians(50);
        double side = 1;
        for (double y = -20; y <= 20; y += 4, side = -side) {
            const Vec3 axis(0, side * std::sin(lean), std::cos(lean));
            const auto to = [&](MotionKind kind, const Vec3& middle) {
                motions->motions.push_back({kind, {middle - 3 * axis, axis}, no_index, no_index});
            };
            to(MotionKind::rapid, Vec3(-40, y, 40));
            to(MotionKind::cut, Vec3(-40, y, 3));
            to(MotionKind::cut, Vec3(40, y, 3));
            to(MotionKind::rapid, Vec3(40, y, 40));
        }
        leaning.motions = motions;
        const Verification v = judged(part, stock, leaning);
        QVERIFY(!v.gouged());
        const UncutReason* apart = reason(v, UncutReason::Why::passes_apart);
        QVERIFY(apart && apart->counts() && apart->excess_max > 0.6);
        const UncutReason* not_cut = reason(v, UncutReason::Why::not_cut);
        QVERIFY2(!not_cut || not_cut->area < 0.02 * apart->area,
                 qPrintable(QString::number(not_cut ? not_cut->area : 0)));
    }

    /// Between two passes a ball leaves a cusp that it could cut; where it never goes it leaves all.
    void what_passes_too_far_apart_leave() {
        const Mesh part = prism({{-20, -10}, {20, -10}, {20, 0}, {-20, 0}}, {{0, 1, 2, 3}});
        StockSolid stock = stock_of(part.box());
        stock.box.hi.z() = 8;
        Tool ball = ball_tool(6);
        ball.flute_length = 40;
        // Cusps of .7 mm between them, and all of the other half.
        VerifyProgram half = lines(ball, Vec2(-30, -20), Vec2(30, 0), 0, 4);
        const Verification v = judged(part, stock, half);
        const UncutReason *apart = reason(v, UncutReason::Why::passes_apart),
                          *not_cut = reason(v, UncutReason::Why::not_cut);
        QVERIFY(apart && apart->counts() && apart->program == half.name && not_cut);
        // A place that is asked stands for those about it.
        QVERIFY2(
            apart->excess_max > 0.6 && apart->place.y() < 4,
            qPrintable(
                QString("%1 at %2, %3").arg(apart->excess_max).arg(apart->place.x()).arg(apart->place.y())));
        QVERIFY2(std::abs(not_cut->area - 17 * 60) < 60 && not_cut->place.y() > 2.5,
                 qPrintable(QString::number(not_cut->area)));
        // What a pass high above left was not left by one that goes by.
        const Verification high = judged(part, stock, lines(ball, Vec2(-30, -20), Vec2(30, 20), 4, 0.5));
        QVERIFY(!reason(high, UncutReason::Why::passes_apart) && reason(high, UncutReason::Why::not_cut));
        // Along a steep side that is higher than the ball is wide one goes above and one below.
        const Mesh side = prism({{-10, -20}, {10, -20}, {6, 0}, {-6, 0}}, {{0, 1, 2, 3}});
        const auto along = [&](std::vector<Vec2> tips) {
            VerifyProgram p{"Along", VerifyTool(ball), nullptr, {}};
            auto motions = std::make_shared<ToolMotions>();
            for (const Vec2& tip : tips)
                for (const MotionKind kind : {MotionKind::rapid, MotionKind::cut})
                    motions->motions.push_back(
                        {kind,
                         {Vec3(kind == MotionKind::rapid ? -40 : 40, tip.x(), tip.y()), Vec3::UnitZ()},
                         no_index,
                         no_index});
            p.motions = motions;
            return p;
        };
        const StockSolid over = stock_of(side.box());
        const Verification both = judged(side, over, along({{8.95, -2.41}, {11.35, -14.41}})),
                           one = judged(side, over, along({{8.95, -2.41}}));
        const UncutReason *between = reason(both, UncutReason::Why::passes_apart),
                          *some = reason(one, UncutReason::Why::passes_apart);
        QVERIFY(between && between->area > (some ? some->area : 0) + 60);
        // Nor is roughing that leaves as much on purpose at fault.
        half.leaves = 2 * 2 * asked().tolerance;
        QVERIFY(!reason(judged(part, stock, half), UncutReason::Why::passes_apart));
    }

    /// Beside an upright wall a ball leaves what the flat end before it could cut: the reason names that one.
    void whose_tool_would_fit() {
        const Mesh part = prism({{-20, -10}, {20, -10}, {20, 0}, {-10, 0}, {-10, 6}, {-20, 6}},
                                {{0, 1, 2, 3}, {0, 3, 4, 5}});
        StockSolid stock = stock_of(part.box());
        stock.box.hi.z() = 7;
        Tool flat = flat_tool(6), ball = ball_tool(6);
        flat.flute_length = ball.flute_length = 20;
        std::array<VerifyProgram, 3> programs{lines(flat, Vec2(-30, -6.5), Vec2(30, 20), 0.1, 2),
                                              lines(flat, Vec2(-30, -24), Vec2(30, -10), 6, 2),
                                              lines(ball, Vec2(-30, -7), Vec2(30, 20), 0, 0.5)};
        programs[0].name = "Rough";
        programs[1].name = "Top";
        programs[2].name = "Finish";
        const Verification v = verify(part, stock, programs, asked(), Progress());
        QVERIFY(!v.gouged());
        const UncutReason *foot = reason(v, UncutReason::Why::not_cut),
                          *wall = reason(v, UncutReason::Why::upright);
        QVERIFY(foot && wall);
        QCOMPARE(v.uncut.size(), std::size_t(2));
        QCOMPARE(foot->program, programs[1].name);
        // Half a millimetre between where the flat end went and the wall.
        QVERIFY2(std::abs(foot->area - 0.5 * 60) < 8, qPrintable(QString::number(foot->area)));
        // On the wall it stands as high as the ball leaves more than twice the tolerance beside it.
        const double high = 3 - std::sqrt(9 - std::pow(3 - 2 * asked().tolerance, 2));
        QVERIFY2(std::abs(wall->area - high * 60) < 40, qPrintable(QString::number(wall->area)));
    }
};

FACETMILL_TEST(TestUncutReasons)
#include "test_uncut_reasons.moc"
