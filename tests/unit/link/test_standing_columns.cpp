// What tilted tools leave standing, against points that are asked one by one.
#include "core/setup/stock_solid.h"
#include "core/strategy/tilt/standing_columns.h"
#include "core/strategy/tilt/tilted_stock.h"
#include "tests/support/test_runner.h"
#include "tests/support/trials.h"

#include <QTest>

#include <random>

using namespace facetmill;
using namespace facetmill::test;

namespace {

constexpr double cell = 0.5;

StockField block() {
    StockSolid solid;
    solid.box.lo = Vec3(-15, -12, -3);
    solid.box.hi = Vec3(15, 12, 14);
    return StockField(solid, cell, Progress());
}

Tool tool_of(double diameter, double corner, double taper = 0) {
    Tool t;
    t.diameter = diameter;
    t.corner_radius = corner;
    t.taper_angle = taper;
    t.flute_length = 12;
    t.shank_diameter = diameter;
    t.shank_length = 20;
    return t;
}

/// Whether a point lies in the cutter or, above its end, in its flutes; asked of the profile alone.
bool in_flutes(const Tool& tool, const CutterProfile& profile, const CutterLocation& at, const Vec3& p) {
    const double along = (p - at.tip).dot(at.axis), away = (p - at.tip).cross(at.axis).norm();
    return along <= tool.flute_length && away <= profile.max_radius() && along >= profile.height_at(away);
}

double standing_at(const StandingColumns& columns, int column, int row, double z) {
    double nearest = infinity; // 0: it stands there
    for (const Interval& i : columns.standing(column, row))
        nearest = std::min(nearest, std::max({0.0, i.lo - z, z - i.hi}));
    return nearest;
}

CutterLocation random_location(std::mt19937_64& rng) {
    std::uniform_real_distribution<double> share(-1, 1);
    Vec3 axis;
    do
        axis = Vec3(share(rng), share(rng), std::abs(share(rng)));
    while (axis.norm() < 0.1 || axis.normalized().z() < 0.15);
    return {Vec3(14 * share(rng), 11 * share(rng), 4 + 6 * share(rng)), axis.normalized()};
}

} // namespace

class TestStandingColumns : public QObject {
    Q_OBJECT
private slots:
    /// What is taken away was within the tool in every corner of its cell; and what lies deeper in the tool
    /// than a cell is wide is taken away.
    void what_goes_was_in_the_tool_and_what_is_deep_in_it_goes() {
        std::mt19937_64 rng(5);
        for (const Tool& tool : {tool_of(8, 4), tool_of(8, 0), tool_of(9, 1.5), tool_of(7, 2, radians(6))}) {
            const CutterProfile profile(tool.cutter());
            for (int trial = 0; trial < trials(12, 4); ++trial) {
                StandingColumns columns{block()};
                std::vector<CutterLocation> cuts;
                for (int i = 0; i < 4; ++i) {
                    cuts.push_back(random_location(rng));
                    for (const AxisCylinder& c : inner_cylinders(tool, cell))
                        columns.clear(cuts.back(), c.radius, c.low, c.high);
                }
                int gone = 0, missed = 0, deep = 0;
                for (int row = 0; row < columns.rows(); row += 3)
                    for (int column = 0; column < columns.columns(); column += 3)
                        for (double z = -2.9; z < 14; z += 0.37) {
                            const Vec2 middle = columns.center(column, row);
                            const auto within = [&](double x, double y, double deeper) {
                                return std::any_of(cuts.begin(), cuts.end(), [&](const CutterLocation& at) {
                                    const Vec3 p(middle.x() + x, middle.y() + y, z);
                                    if (deeper == 0) return in_flutes(tool, profile, at, p);
                                    const double along = (p - at.tip).dot(at.axis),
                                                 away = (p - at.tip).cross(at.axis).norm();
                                    return away < 0.6 * profile.max_radius() - deeper
                                           && along < tool.flute_length - deeper
                                           && along > profile.height_at(0.6 * profile.max_radius())
                                                          + 2 * deeper;
                                });
                            };
                            if (standing_at(columns, column, row, z) > 1e-9) {
                                ++gone;
                                for (const double x : {-0.5, 0.0, 0.5})
                                    for (const double y : {-0.5, 0.0, 0.5})
                                        QVERIFY(within(0.999 * x * cell, 0.999 * y * cell, 0));
                            } else if (within(0, 0, cell)) {
                                ++missed;
                            }
                            deep += within(0, 0, cell);
                        }
                QCOMPARE(missed, 0);
                QVERIFY(gone > 0 || deep == 0);
            }
        }
    }

    /// Pieces stay sorted, apart from each other and within the block whatever is taken away.
    void pieces_are_in_order() {
        std::mt19937_64 rng(6);
        StandingColumns columns{block()};
        std::uniform_real_distribution<double> share(0, 1);
        for (int i = 0; i < trials(400, 10); ++i) {
            const double low = 12 * share(rng);
            columns.clear(random_location(rng), 1 + 2 * share(rng), low, low + 4 * share(rng));
        }
        int several = 0, none = 0;
        for (int row = 0; row < columns.rows(); ++row)
            for (int column = 0; column < columns.columns(); ++column) {
                const auto pieces = columns.standing(column, row);
                double below = -infinity;
                for (const Interval& p : pieces) {
                    QVERIFY(p.hi > p.lo && p.lo > below && p.lo >= -3 && p.hi <= 14);
                    below = p.hi;
                }
                several += pieces.size() > 1;
                none += pieces.empty();
            }
        QVERIFY(several > 20);
        QCOMPARE(none, 0); // what lies below the lowest tip stays
    }

    /// An undercut cutter takes nothing away here, as what stands beside its neck is not known to be gone.
    void what_is_not_known_to_go_stays() {
        QVERIFY(inner_cylinders(tool_of(8, 0, -radians(10)), cell).empty());
        QCOMPARE(inner_cylinders(tool_of(8, 0), cell).size(), std::size_t(1)); // its end is level
        QVERIFY(inner_cylinders(tool_of(8, 4), cell).size() > 1);
    }

    /// Every point of a cutter lies in one of the cylinders that hold it, and each point of those within it
    /// in the cutter.
    void cylinders_hold_the_cutter_and_lie_in_it() {
        for (const Tool& tool : {tool_of(8, 4), tool_of(8, 0), tool_of(9, 1.5), tool_of(7, 2, radians(6)),
                                 tool_of(8, 0, -radians(10))}) {
            const CutterProfile profile(tool.cutter());
            for (int i = 0; i <= 200; ++i) {
                const double rho = profile.max_radius() * i / 200 * (1 - 1e-9);
                bool held = false;
                for (const AxisCylinder& c : outer_cylinders(tool, cell))
                    held = held || (rho <= c.radius && profile.height_at(rho) >= c.low);
                QVERIFY(held);
                for (const AxisCylinder& c : inner_cylinders(tool, cell))
                    if (rho < c.radius * (1 - 2e-3)) QVERIFY(profile.height_at(rho) <= c.low);
            }
        }
    }

    /// A leaning tool slots a block; then it goes into the slot without touching anything, on a way that was
    /// solid before, and beside the slot it still meets the block.
    void a_tool_goes_where_it_has_cut() {
        Tool tool = tool_of(8, 4);
        TiltedStock stock(block(), tool, 4, 0.2);
        Tool thin = tool_of(4, 2);
        thin.flute_length = 30;
        const Vec3 axis = Vec3(0.4, 0, 1).normalized();
        const CutterLocation from{Vec3(-12, 0, 6), axis}, to{Vec3(8, 0, 6), axis};
        const auto free_way = [&](double y) { return stock.lift({Vec3(0, y, 7), axis}, 0) < 0; };
        QVERIFY(!free_way(0));
        QVERIFY(!stock.free_behind({Vec3(0, 0, -8), axis}));
        stock.cut(from, to);
        QVERIFY(!free_way(0)); // the tool is as wide as the slot, and must keep a gap
        TiltedStock wider(block(), tool, 4, 0.2);
        for (const double y : {-1.5, 0.0, 1.5})
            wider.cut({from.tip + Vec3(0, y, 0), axis}, {to.tip + Vec3(0, y, 0), axis});
        QVERIFY(wider.lift({Vec3(0, 0, 7), axis}, 0) < 2);
        QVERIFY(wider.lift({Vec3(0, 6, 7), axis}, 0) > 5);
        QVERIFY(wider.free_behind({Vec3(0, 0, 6), axis}));
    }
};

FACETMILL_TEST(TestStandingColumns)
#include "test_standing_columns.moc"
