// Shank and holder beside what operations before left.
#include "core/strategy/finish3/left_stock.h"
#include "tests/property/shapes.h"
#include "tests/support/test_runner.h"

#include <QTest>

#include <cmath>

using namespace facetmill;
using namespace facetmill::test;

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
                    LeftStock stock(context, cell, fine, skin, 0, Progress());
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
};

FACETMILL_TEST(TestLeftStock)
#include "test_left_stock.moc"
