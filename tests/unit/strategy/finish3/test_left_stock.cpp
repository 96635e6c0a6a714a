// Shank and holder beside what operations before left.
#include "core/strategy/finish3/left_stock.h"
#include "tests/property/shapes.h"
#include "tests/support/test_runner.h"

#include <QTest>

#include <cmath>
#include <random>

using namespace facetmill;
using namespace facetmill::test;

namespace {

/// Tips that are nowhere lower.
Box3 above(double z) {
    return {Vec3(-infinity, -infinity, z), Vec3::Constant(infinity)};
}

} // namespace

class TestLeftStock : public QObject {
    Q_OBJECT
private slots:
    /// A flat end went along a wall and left a skin on it, or two skins with a ridge between two places. A
    /// shank as wide as the ball, whose flutes are short, may go along the wall only where the skin is
    /// thinner than what counts as the part; wherever the wall lies among the cells, turned or not.
    void a_skin_thinner_than_a_cell_stops_the_shank() {
        const double radius = 3, cell = 0.12, fine = 0.024, skin = 0.0025;
        Tool tool = ball_tool(2 * radius);
        tool.flute_length = 8;
        tool.shank_diameter = 2 * radius;
        tool.shank_length = 20;
        for (const double angle : {0.0, 0.3})
            for (const double shift : {0.0, 0.3, 0.7}) {
                const Eigen::Rotation2Dd turn(angle);
                const auto at = [&](double x, double y, double z) {
                    const Vec2 p = turn * Vec2(x, y + shift * cell);
                    return Vec3(p.x(), p.y(), z);
                };
                Mesh part = step(0, 12); // its wall is the plane y = 0, low where y is above 0
                for (Vec3& v : part.vertices)
                    v = at(v.x(), v.y(), v.z());
                PlanContext context = context_of(part, tool);
                context.stock.box = context.stock_box = context.part_box;
                for (const double thick : {0.0, 0.001, 0.015, 0.05, 0.3}) {
                    auto earlier = std::make_shared<EarlierCuts>();
                    earlier->cutter = AptCutter::flat(8, 30);
                    for (const double y : {4 + thick, 10.0, 16.0})
                        earlier->motions.push_back({at(-20, y, 0), at(20, y, 0)});
                    context.earlier = {earlier};
                    LeftStock stock(context, cell, fine, skin, above(0), Progress());
                    double least = infinity, most = 0;
                    for (double x = -6; x <= 6; x += 0.37) {
                        const double lack = stock.lack(at(x, radius + 1e-6, 0));
                        least = std::min(least, lack);
                        most = std::max(most, lack);
                    }
                    const std::string told = "turned by " + std::to_string(angle) + ", "
                                             + std::to_string(thick) + ": " + std::to_string(least) + " to "
                                             + std::to_string(most);
                    if (thick < skin)
                        QVERIFY2(most == 0, told.c_str());
                    else
                        QVERIFY2(std::abs(least - 4) < 1e-5 && std::abs(most - 4) < 1e-5, told.c_str());
                    // Beside the skin there is nothing.
                    QCOMPARE(stock.lack(at(0, radius + thick + 1e-3, 0)), 0.0);
                    // Where the flutes have been higher up, the shank may follow.
                    stock.cut(at(-4, radius + 1e-6, 4), at(4, radius + 1e-6, 4));
                    QCOMPARE(stock.lack(at(1, radius + 1e-6, 0)), 0.0);
                }
            }
    }

    /// Two passes went up a wall beside each other and left a cusp between them: a shank as wide as their
    /// cutter between the two comes into it less deep than points of cells are apart, wherever it stands.
    void a_cusp_that_is_hardly_deep_stops_the_shank() {
        const double radius = 3, top = 12;
        Tool tool = ball_tool(2 * radius);
        tool.flute_length = 8;
        tool.shank_diameter = 2 * radius;
        tool.shank_length = 20;
        PlanContext context = context_of(step(0, top), tool);
        context.stock.box = context.stock_box = context.part_box;
        const double y = radius + 0.05;
        for (const double deep : {0.0001, 0.0015, 0.004, 0.01}) {
            const double half = std::sqrt(2 * radius * deep);
            int free = 0, held = 0;
            for (double x = -6; x <= 6; x += 0.37) {
                auto earlier = std::make_shared<EarlierCuts>();
                earlier->cutter = AptCutter::flat(2 * radius, 30);
                for (const double beside : {-half, half})
                    earlier->motions.push_back({Vec3(x + beside, y, 6), Vec3(x + beside, y, top)});
                context.earlier = {earlier};
                LeftStock stock(context, 0.12, 0.024, 0.0025, above(0), Progress());
                const double lack = stock.lack(Vec3(x, y, 0));
                ++(lack > 0 ? held : free);
                if (lack > 0) QVERIFY2(std::abs(lack - 4) < 1e-5, qPrintable(QString::number(lack)));
            }
            QVERIFY2((deep < 0.0003 ? held : free) == 0,
                     qPrintable(QString("%1 deep: %2 held, %3 free").arg(deep).arg(held).arg(free)));
        }
    }

    /// Whoever says where its tips are is told the same there as one that may ask anywhere, shank and holder
    /// reaching out of the box, and does not wait for what was cut far away.
    void tips_in_a_box_meet_what_stands_about_it() {
        Tool tool = ball_tool(2);
        tool.flute_length = 3;
        tool.shank_diameter = 2;
        tool.shank_length = 2;
        tool.holder = {{9, 20}};
        const Mesh part =
            height_field([](double, double) { return 0.0; }, Vec2(-20, -15), Vec2(20, 15), 4, 3);
        PlanContext context = context_of(part, tool);
        context.stock.box = context.part_box;
        context.stock.box.hi.z() = 9;
        context.stock_box = context.stock.box;
        std::mt19937_64 rng(21);
        std::uniform_real_distribution<double> x(-20, 20), y(-15, 15), z(1, 8), unit(0, 1);
        auto earlier = std::make_shared<EarlierCuts>();
        earlier->cutter = AptCutter::flat(4, 30);
        Vec3 from(x(rng), y(rng), z(rng));
        for (int k = 0; k < 40; ++k) {
            const Vec3 to(x(rng), y(rng), k % 2 == 0 ? from.z() : z(rng));
            earlier->motions.push_back({from, to});
            from = to;
        }
        context.earlier = {earlier};
        int met = 0;
        for (int trial = 0; trial < 12; ++trial) {
            Box3 tips;
            tips.add(Vec3(x(rng), y(rng), 0));
            tips.add(tips.lo + Vec3(3 * unit(rng), 3 * unit(rng), 4));
            LeftStock near(context, 0.2, 0.05, 0.0025, tips, Progress()),
                all(context, 0.2, 0.05, 0.0025, above(0), Progress());
            for (int k = 0; k < 40; ++k) {
                const auto tip = [&] {
                    return Vec3(tips.lo + Vec3(unit(rng), unit(rng), unit(rng)).cwiseProduct(tips.size()));
                };
                const Vec3 a = tip(), b = tip();
                met += all.lack(a) > 0;
                QCOMPARE(near.lack(a), all.lack(a));
                QCOMPARE(near.free_height(a, b), all.free_height(a, b));
                if (k % 8 != 0) continue;
                near.cut(a, b);
                all.cut(a, b);
            }
        }
        QVERIFY(met > 50 && met < 450);
    }

    /// Two channels side by side with a thin ridge between them that is higher than the flutes: from one to
    /// the other a near link goes over it as far as the shank asks for, and a far one does not go.
    void links_go_over_what_the_shank_would_meet() {
        const double radius = 3, height = 12, flutes = 8, cell = 0.12;
        Tool tool = ball_tool(2 * radius);
        tool.flute_length = flutes;
        tool.shank_diameter = 2 * radius;
        tool.shank_length = 20;
        const Mesh part =
            height_field([](double, double) { return 0.0; }, Vec2(-20, -15), Vec2(20, 15), 4, 3);
        PlanContext context = context_of(part, tool);
        context.stock.box = context.part_box;
        context.stock.box.hi.z() = height;
        context.stock_box = context.stock.box;
        auto earlier = std::make_shared<EarlierCuts>();
        earlier->cutter = AptCutter::flat(8, 30);
        const double here = -5, there = 3.3;
        for (const double y : {here, there})
            earlier->motions.push_back({Vec3(-30, y, 0), Vec3(30, y, 0)});
        context.earlier = {earlier};
        const auto along = [](double y, double from, double to) {
            Pass pass;
            for (const double x : {from, to}) {
                pass.cl.push_back({Vec3(x, y, 0), Vec3::UnitZ()});
                pass.cc.push_back({Vec3(x, y, 0), Vec3::UnitZ()});
            }
            return pass;
        };
        LeftStock stock(context, cell, 0.024, 0.0025, above(0), Progress());
        const ContactAt contact = [](const Vec3& tip) { return CutterContact{tip, Vec3::UnitZ()}; };
        const ClearOfStock clear = keep_clear_of_stock(
            {along(here, -15, 0), along(here, 2, 5), along(there, 5, 15), along(here, -5, -15)}, stock, 0.1,
            contact, Progress());
        QVERIFY(clear.left.empty());
        QCOMPARE(clear.kept.size(), std::size_t(4));
        QVERIFY(clear.kept[1].entry.empty() && !clear.kept[1].from_above);
        QVERIFY(clear.kept[2].entry.size() == 1 && !clear.kept[2].from_above);
        const Vec3 over = clear.kept[2].entry.front().tip;
        QCOMPARE(Vec2(over.head<2>()), Vec2(5, there));
        QVERIFY2(over.z() > height - flutes && over.z() < height - flutes + 2 * cell,
                 qPrintable(QString::number(over.z())));
        QVERIFY(clear.kept[3].entry.empty() && clear.kept[3].from_above);
    }
};

FACETMILL_TEST(TestLeftStock)
#include "test_left_stock.moc"
