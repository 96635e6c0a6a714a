// What stands of the stock as planners see it: against closed forms, and against a search at random places.
#include "core/base/parallel.h"
#include "core/strategy/surface/stock_field.h"
#include "tests/property/shapes.h"
#include "tests/support/test_runner.h"
#include "tests/support/trials.h"

#include <QTest>

#include <random>

using namespace facetmill;
using namespace facetmill::test;

namespace {

StockSolid block(const Vec3& lo, const Vec3& hi) {
    StockSolid s;
    s.box.lo = lo;
    s.box.hi = hi;
    return s;
}

template <class Height>
double over(const StockField& f, double x, double y, Height height) {
    const int column = std::clamp(int((x - f.box().lo.x()) / f.cell()), 0, f.columns() - 1);
    const int row = std::clamp(int((y - f.box().lo.y()) / f.cell()), 0, f.rows() - 1);
    return (f.*height)(column, row);
}

CutterProfile profile(int shape) {
    switch (shape) {
    case 0:
        return CutterProfile(AptCutter::ball(8, 30));
    case 1:
        return CutterProfile(AptCutter::flat(8, 30));
    case 2:
        return CutterProfile(AptCutter::bull(8, 1.5, 30));
    default:
        return CutterProfile(AptCutter::from_shape(6, 0.5, 0, radians(20), 12));
    }
}

/// What straight moves leave over a place, by many places on the way.
double left_over(const CutterProfile& p, const std::vector<std::array<Vec3, 2>>& moves, const Vec2& q,
                 double top) {
    for (const auto& [a, b] : moves)
        for (int i = 0; i <= 4000; ++i) {
            const Vec3 tip = a + (i / 4000.0) * (b - a);
            const double rho = (q - tip.head<2>()).norm();
            if (rho <= p.max_radius()) top = std::min(top, tip.z() + p.height_at(rho));
        }
    return top;
}

} // namespace

class TestStockField : public QObject {
    Q_OBJECT
private slots:
    void solids_have_their_tops() {
        const StockField box(block(Vec3(-10, -5, 0), Vec3(10, 5, 7)), 0.5, Progress());
        QCOMPARE(box.columns(), 40);
        QCOMPARE(box.rows(), 20);
        QCOMPARE(box.highest(), 7.0);

        StockSolid round = block(Vec3(-10, -10, 0), Vec3(10, 10, 5));
        round.kind = StockSolid::Kind::cylinder;
        round.radius = 10;
        const StockField upright(round, 0.5, Progress());
        QCOMPARE(over(upright, 0, 9.9, &StockField::top), 5.0);
        QCOMPARE(over(upright, 9.5, 9.5, &StockField::top), -infinity);

        StockSolid lying = block(Vec3(-20, -10, -10), Vec3(20, 10, 10));
        lying.kind = StockSolid::Kind::cylinder;
        lying.axis = 0;
        lying.radius = 10;
        const StockField on_side(lying, 0.25, Progress());
        for (double y = -9.9; y < 10; y += 0.7) {
            const double exact = std::sqrt(100 - y * y), top = over(on_side, 3.3, y, &StockField::top);
            QVERIFY(top >= exact);
            // The highest of a cell is at its edge nearest to the axis.
            const double inner = std::max(0.0, std::abs(y) - 0.25);
            QVERIFY(top <= std::sqrt(100 - inner * inner) + 1e-12);
        }
    }

    /// A mesh: never below it, and above it by no more than its slope over a cell.
    void a_mesh_has_its_top() {
        StockSolid solid;
        solid.kind = StockSolid::Kind::mesh;
        solid.mesh = std::make_shared<Mesh>(dome(20, 24));
        solid.box = solid.mesh->box();
        const StockField field(solid, 0.4, Progress());
        std::mt19937 random(7);
        std::uniform_real_distribution<double> place(-12, 12);
        for (int i = 0; i < 2000; ++i) {
            const double x = place(random), y = place(random);
            const double z = std::sqrt(400 - x * x - y * y), top = over(field, x, y, &StockField::top);
            QVERIFY2(top >= z - 0.1, qPrintable(QString::number(top - z))); // the facets' own chord
            QVERIFY(top <= z + 0.8);
        }
        QCOMPARE(over(field, -19.9, -19.9, &StockField::top), -infinity);
    }

    void random_cuts_leave_what_a_search_finds() {
        std::mt19937 random(11);
        std::uniform_real_distribution<double> place(-14, 14), height(2, 9), unit(0, 1);
        for (int round = 0; round < trials(24); ++round) {
            const CutterProfile p = profile(round % 4);
            const StockCutter cutter(p);
            StockField field(block(Vec3(-10, -10, 0), Vec3(10, 10, 10)), 0.3, Progress());
            std::vector<std::array<Vec3, 2>> moves;
            for (int k = 0; k < 4; ++k) {
                const Vec3 a(place(random), place(random), height(random));
                Vec3 b(place(random), place(random), k % 2 == 0 ? a.z() : height(random));
                if (k == 3) b.head<2>() = a.head<2>(); // straight down or up
                moves.push_back({a, b});
                field.cut(cutter, a, b);
            }
            for (int i = 0; i < 60; ++i) {
                const int column = int(unit(random) * field.columns()),
                          row = int(unit(random) * field.rows());
                const Vec2 c = field.center(column, row);
                const double exact = left_over(p, moves, c, 10);
                // A level cut is exact but for the table, one that slopes is not too low.
                QVERIFY2(field.middle(column, row) >= exact - 1e-6,
                         qPrintable(QString::number(field.middle(column, row) - exact)));
                const Vec2 q = c + field.cell() * (Vec2(unit(random), unit(random)) - Vec2(0.5, 0.5));
                QVERIFY(field.top(column, row) >= left_over(p, moves, q, 10) - 1e-6);
                QVERIFY(field.top(column, row) >= field.middle(column, row));
            }
        }
    }

    /// A cut that goes on where the last one ended leaves out what that has cut.
    void cuts_that_go_on_leave_what_single_ones_leave() {
        std::mt19937_64 rng(12);
        std::uniform_real_distribution<double> at(-12, 12), height(1, 9), step(0, 1);
        for (int shape = 0; shape < 4; ++shape) {
            const CutterProfile p = profile(shape);
            const StockCutter cutter(p), other(p);
            for (int trial = 0; trial < trials(40, 8); ++trial) {
                StockField on(block(Vec3(-15, -15, 0), Vec3(15, 15, 10)), 0.4, Progress()), alone = on;
                Vec3 from(at(rng), at(rng), height(rng));
                for (int i = 0; i < 12; ++i) {
                    Vec3 to = from;
                    const double kind = step(rng); // level, upright, sloped, a leap
                    if (kind < 0.3 || kind > 0.5) to.head<2>() += Vec2(at(rng), at(rng)) * step(rng);
                    if (kind > 0.3) to.z() = height(rng);
                    on.cut(cutter, from, to);
                    alone.cut(i % 2 ? cutter : other, from, to);
                    alone.cut(other, from, from);
                    if (kind > 0.9) to = {at(rng), at(rng), height(rng)};
                    from = to;
                }
                for (int row = 0; row < on.rows(); ++row)
                    for (int column = 0; column < on.columns(); ++column) {
                        QVERIFY(std::abs(on.top(column, row) - alone.top(column, row)) < 1e-9);
                        QVERIFY(std::abs(on.middle(column, row) - alone.middle(column, row)) < 1e-9);
                    }
            }
        }
    }

    /// On many threads, row by row, to the last bit what single cuts leave and find.
    void many_cuts_leave_what_single_ones_leave() {
        std::mt19937_64 rng(14);
        std::uniform_real_distribution<double> at(-18, 18), height(1, 9), step(0, 1);
        constexpr double least = 0.05;
        for (const int threads : {1, 4}) {
            set_thread_count(threads);
            for (int shape = 0; shape < 4; ++shape) {
                const StockCutter cutter(profile(shape));
                StockField single(block(Vec3(-15, -15, 0), Vec3(15, 15, 10)), 0.4, Progress());
                StockField many = single, telling = single;
                for (const std::size_t count : {1, 5, 40, 60}) {
                    std::vector<StockField::Motion> motions;
                    Vec3 from(at(rng), at(rng), height(rng));
                    std::vector<char> work;
                    while (motions.size() < count) {
                        const double kind = step(rng);
                        Vec3 to(at(rng), at(rng), kind < 0.5 ? from.z() : height(rng));
                        if (kind > 0.8) to.head<2>() = from.head<2>();
                        motions.push_back({from, to});
                        work.push_back(single.has_work(cutter, from, to, least));
                        single.cut(cutter, from, to);
                        from = kind < 0.1 ? Vec3(at(rng), at(rng), height(rng)) : to;
                    }
                    many.cut(cutter, motions, Progress());
                    QCOMPARE(telling.cut_telling_work(cutter, motions, least, Progress()), work);
                    for (int row = 0; row < single.rows(); ++row)
                        for (int column = 0; column < single.columns(); ++column)
                            for (const StockField* field : {&many, &telling}) {
                                QVERIFY(field->top(column, row) == single.top(column, row));
                                QVERIFY(field->middle(column, row) == single.middle(column, row));
                            }
                    QVERIFY(single.highest() <= single.no_higher());
                }
            }
        }
        set_thread_count(0);
    }

    /// Of what others cut lower nothing is asked, and nothing of it changes: level cuts, far and near to each
    /// other, leave over every cell what the lowest of them leaves by the cutter's table, whatever comes
    /// first.
    void level_cuts_leave_what_the_lowest_of_them_leaves() {
        std::mt19937_64 rng(16);
        std::uniform_real_distribution<double> at(-14, 14), height(1, 9), turn(-0.4, 0.4);
        for (int shape = 0; shape < 4; ++shape) {
            const StockCutter cutter(profile(shape));
            StockField field(block(Vec3(-10, -10, 0), Vec3(10, 10, 10)), 0.3, Progress());
            const double half = field.cell() * std::numbers::sqrt2 / 2;
            std::vector<StockField::Motion> motions;
            for (int path = 0; path < 6; ++path) {
                Vec3 from(at(rng), at(rng), height(rng));
                double angle = at(rng);
                for (int k = 0; k < 60; ++k) {
                    angle += turn(rng);
                    const Vec3 to = from + 0.35 * Vec3(std::cos(angle), std::sin(angle), 0);
                    motions.push_back({from, to});
                    from = to;
                }
            }
            for (const auto& [a, b] : motions)
                field.cut(cutter, a, b);
            int lowered = 0;
            for (int row = 0; row < field.rows(); ++row)
                for (int column = 0; column < field.columns(); ++column) {
                    const Vec2 c = field.center(column, row);
                    if (c.cwiseAbs().maxCoeff() > 10) continue;
                    double top = 10, middle = 10;
                    for (const auto& [a, b] : motions) {
                        const Vec2 d = (b - a).head<2>(), p = c - a.head<2>();
                        const double away = (p - std::clamp(p.dot(d) / d.squaredNorm(), 0.0, 1.0) * d).norm();
                        middle = std::min(middle, a.z() + cutter.above(away));
                        if (away <= cutter.radius() - half)
                            top = std::min(top, a.z() + cutter.above(away + half));
                    }
                    lowered += top < 10;
                    // Rounding may take the next place of the table.
                    QVERIFY2(std::abs(field.middle(column, row) - middle) < 1e-3
                                 && std::abs(field.top(column, row) - top) < 1e-3,
                             qPrintable(QString("%1 %2").arg(field.top(column, row)).arg(top)));
                }
            QVERIFY(lowered > 500);
        }
    }

    /// Cuts within a box leave there, to the last bit, what cuts everywhere leave, and elsewhere nothing
    /// lower; far from it nothing is cut.
    void cuts_within_a_box_are_all_there() {
        std::mt19937_64 rng(15);
        std::uniform_real_distribution<double> at(-18, 18), height(1, 9), step(0, 1);
        for (const int threads : {1, 4}) {
            set_thread_count(threads);
            for (int shape = 0; shape < 4; ++shape)
                for (int trial = 0; trial < trials(12, 3); ++trial) {
                    const StockCutter cutter(profile(shape));
                    StockField all(block(Vec3(-15, -15, 0), Vec3(15, 15, 10)), 0.4, Progress()), near = all;
                    const Vec3 place(at(rng), at(rng), 0), size(3 * step(rng), 3 * step(rng), 0);
                    const Box3 within{place - size, place + size};
                    for (int batch = 0; batch < 3; ++batch) {
                        std::vector<StockField::Motion> motions;
                        Vec3 from(at(rng), at(rng), height(rng));
                        for (int k = 0; k < 25; ++k) {
                            Vec3 to(at(rng), at(rng), step(rng) < 0.5 ? from.z() : height(rng));
                            if (step(rng) > 0.5) to.head<2>() = from.head<2>() + 0.05 * (to - from).head<2>();
                            motions.push_back({from, to});
                            from = step(rng) < 0.1 ? Vec3(at(rng), at(rng), height(rng)) : to;
                        }
                        all.cut(cutter, motions, Progress());
                        near.cut(cutter, motions, Progress(), within);
                    }
                    std::size_t untouched = 0;
                    for (int row = 0; row < all.rows(); ++row)
                        for (int column = 0; column < all.columns(); ++column) {
                            const Vec2 c = all.center(column, row);
                            if (((c - place.head<2>()).cwiseAbs() - size.head<2>()).maxCoeff()
                                <= all.cell()) {
                                QVERIFY(near.top(column, row) == all.top(column, row));
                                QVERIFY(near.middle(column, row) == all.middle(column, row));
                            }
                            QVERIFY(near.top(column, row) >= all.top(column, row));
                            untouched += near.top(column, row) == 10 && all.top(column, row) < 10;
                        }
                    QVERIFY(untouched > 100);
                }
        }
        set_thread_count(0);
    }

    /// What is forgotten stays so under later cuts, and what is higher is as without.
    void what_is_forgotten_changes_nothing_above_it() {
        std::mt19937_64 rng(13);
        std::uniform_real_distribution<double> at(-14, 14), height(1, 9);
        for (int shape = 0; shape < 4; ++shape) {
            const StockCutter cutter(profile(shape));
            for (int trial = 0; trial < trials(20, 4); ++trial) {
                const double low = height(rng);
                StockField all(block(Vec3(-15, -15, 0), Vec3(15, 15, 10)), 0.4, Progress()), high = all;
                if (trial % 2) high.forget_below(low);
                for (int i = 0; i < 20; ++i) {
                    const Vec3 a(at(rng), at(rng), height(rng)),
                        b(at(rng), at(rng), i % 3 ? a.z() : height(rng));
                    all.cut(cutter, a, b);
                    high.cut(cutter, a, b);
                    if (i == 7) high.forget_below(low);
                }
                for (int row = 0; row < all.rows(); ++row)
                    for (int column = 0; column < all.columns(); ++column) {
                        const double top = all.top(column, row);
                        QCOMPARE(high.top(column, row), top > low ? top : -infinity);
                    }
                QCOMPARE(high.highest(), all.highest() > low ? all.highest() : -infinity);
            }
        }
    }

    void a_level_slot_is_exact() {
        for (int shape = 0; shape < 4; ++shape) {
            const CutterProfile p = profile(shape);
            StockField field(block(Vec3(-20, -10, 0), Vec3(20, 10, 10)), 0.25, Progress());
            const StockCutter cutter(p);
            const Vec3 a(-25, 1, 6), b(25, 1, 6);
            QVERIFY(field.has_work(cutter, a, b, 0.01));
            const auto work = field.work(cutter, a, b, 0.01);
            QCOMPARE(work.size(), std::size_t(1));
            QVERIFY(std::abs(work[0].lo * 50 - 5) < 0.6 && std::abs(work[0].hi * 50 - 45) < 0.6);
            // By the centre nearest to the tip.
            QVERIFY(std::abs(field.stand_height(cutter, Vec2(0, 1), Vec2(0, 1)) - 10) < 0.01);
            QCOMPARE(field.clear_height(cutter, Vec2(-40, 1), Vec2(-36, 1)), -infinity);
            field.cut(cutter, a, b);
            QVERIFY(!field.has_work(cutter, a, b, 1e-9));
            QVERIFY(field.work(cutter, a, b, 1e-9).empty());
            for (int row = 0; row < field.rows(); ++row) {
                const double y = field.center(0, row).y(), rho = std::abs(y - 1);
                const double exact = rho <= p.max_radius() ? std::min(10.0, 6 + p.height_at(rho)) : 10.0;
                const double off = field.middle(80, row) - exact;
                QVERIFY2(off >= -1e-9 && off <= 0.05 + 0.02 * rho, qPrintable(QString::number(off)));
            }
            // It stands there again, and not beside it.
            QVERIFY(field.stand_height(cutter, Vec2(-5, 1), Vec2(5, 1)) <= 6.01);
            QVERIFY(field.stand_height(cutter, Vec2(-5, 3), Vec2(5, 3)) > 7);
            QVERIFY(field.clear_height(cutter, Vec2(-5, 1), Vec2(5, 1)) >= 6);
            QCOMPARE(field.highest_near(Vec2(0, 1), Vec2(0, 1), 6), 10.0);
        }
    }

    /// What the cutting part leaves above its own height stays.
    void a_short_cutter_leaves_what_is_above_it() {
        StockField field(block(Vec3(-20, -10, 0), Vec3(20, 10, 10)), 0.5, Progress());
        const StockCutter low(CutterProfile(AptCutter::flat(8, 3)));
        field.cut(low, Vec3(-25, 0, 4), Vec3(25, 0, 4));
        QCOMPARE(over(field, 0, 0, &StockField::middle), 10.0);
        field.cut(low, Vec3(-25, 0, 7.5), Vec3(25, 0, 7.5));
        field.cut(low, Vec3(-25, 0, 5), Vec3(25, 0, 5));
        QCOMPARE(over(field, 0, 0, &StockField::middle), 5.0);
    }

    /// A dovetail takes away under what it leaves standing over its wide end, which so still stands as high.
    void an_undercut_cutter_leaves_what_hangs_over_it() {
        StockField field(block(Vec3(-20, -10, 0), Vec3(20, 10, 10)), 0.25, Progress());
        const CutterProfile dovetail(AptCutter::from_shape(10, 0, 0, radians(-20), 5));
        field.cut(StockCutter(dovetail), Vec3(-25, 0, 5), Vec3(25, 0, 5));
        const double neck = dovetail.radius_at(5);
        for (int row = 0; row < field.rows(); ++row) {
            const double y = std::abs(field.center(0, row).y());
            if (std::abs(y - neck) > 0.25) QCOMPARE(field.middle(80, row), y < neck ? 5.0 : 10.0);
            if (y > neck) QCOMPARE(field.top(80, row), 10.0);
        }
        // A thinner layer is within what the side covers, but for the rim.
        StockField thin(block(Vec3(-20, -10, 0), Vec3(20, 10, 10)), 0.25, Progress());
        thin.cut(StockCutter(dovetail), Vec3(-25, 0, 9), Vec3(25, 0, 9));
        const double covered = dovetail.radius_at(1);
        for (int row = 0; row < thin.rows(); ++row)
            if (const double y = std::abs(thin.center(0, row).y()); std::abs(y - covered) > 0.05)
                QCOMPARE(thin.middle(80, row), y < covered ? 9.0 : 10.0);
    }

    void bad_cells_are_refused() {
        QVERIFY_EXCEPTION_THROWN(StockField(block(Vec3(0, 0, 0), Vec3(1, 1, 1)), 0, Progress()), Error);
        const StockField empty(StockSolid(), 1, Progress());
        QCOMPARE(empty.highest(), -infinity);
        QCOMPARE(empty.clear_height(StockCutter(profile(0)), Vec2(0, 0), Vec2(1, 0)), -infinity);
        // However large the stock, the field stays small.
        const StockField large(block(Vec3(0, 0, 0), Vec3(1e5, 1e5, 1)), 0.01, Progress());
        QVERIFY(double(large.columns()) * large.rows() <= 1.01 * StockField::max_cells);
    }
};

FACETMILL_TEST(TestStockField)
#include "test_stock_field.moc"
