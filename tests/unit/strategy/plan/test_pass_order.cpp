// The order of finishing passes: all of them, each once, with less travel between them.
#include "core/strategy/plan/pass_order.h"
#include "tests/support/test_runner.h"

#include <QTest>

#include <cmath>
#include <random>

using namespace facetmill;

namespace {

Pass pass(int number, const Vec3& from, const Vec3& to) {
    Pass p;
    p.drive = number;
    p.cl = {{from, Vec3::UnitZ()}, {to, Vec3::UnitZ()}};
    p.cc = {{from, Vec3::UnitZ()}, {to, Vec3::UnitZ()}};
    return p;
}

double travel(const std::vector<Pass>& passes, double clear_z) {
    double sum = 0;
    for (std::size_t i = 1; i < passes.size(); ++i)
        sum += travel_between(passes[i - 1].cl.back().tip, passes[i].cl.front().tip, clear_z);
    return sum;
}

/// Zigzag over two strips side by side, planned plane by plane: from strip to strip on every plane.
std::vector<Pass> two_strips(int planes, bool turn) {
    std::vector<Pass> passes;
    for (int i = 0; i < planes; ++i) {
        const bool back = turn && i % 2 == 1;
        for (const int strip : {0, 1}) {
            const double x = (strip == 0) != back ? 0 : 100;
            const Vec3 a(x, i, 0), b(x + 10, i, 0);
            passes.push_back(back ? pass(2 * i + strip, b, a) : pass(2 * i + strip, a, b));
        }
    }
    return passes;
}

} // namespace

class TestPassOrder : public QObject {
    Q_OBJECT
private slots:
    /// One strip after the other: one way across, one step per plane.
    void strips_are_cut_one_after_the_other() {
        std::vector<Pass> passes = two_strips(20, true);
        const double before = travel(passes, 50);
        order_by_travel(passes, false, 50, Progress());
        QVERIFY(before > 20 * 90);
        // Zigzag along each, and once from the one to the other.
        QVERIFY2(travel(passes, 50) <= 2 * 19 + 101, qPrintable(QString::number(travel(passes, 50))));
        QCOMPARE(passes.front().drive, 0);
        // Not turned: the tool leans into its travel.
        for (const Pass& p : passes)
            QCOMPARE(p.cl.front().tip.x() > p.cl.back().tip.x(), p.drive / 2 % 2 == 1);
    }

    /// All of one way: turned where that is allowed, with both of their lists.
    void passes_are_turned_where_they_may_be() {
        std::vector<Pass> passes = two_strips(20, false);
        std::vector<Pass> kept = passes;
        order_by_travel(passes, true, 50, Progress());
        QVERIFY(travel(passes, 50) <= 2 * 19 + 101);
        order_by_travel(kept, false, 50, Progress());
        QVERIFY(travel(kept, 50) > 38 * 10);
        for (const Pass& p : passes)
            for (std::size_t k = 0; k < p.cl.size(); ++k)
                QVERIFY(p.cl[k].tip == p.cc[k].point);
    }

    void every_pass_once_and_never_worse() {
        std::mt19937 random(7);
        std::uniform_real_distribution<double> at(0, 100);
        for (const int count : {0, 1, 2, 3, 10, 150}) {
            std::vector<Pass> passes;
            for (int i = 0; i < count; ++i)
                passes.push_back(pass(i, Vec3(at(random), at(random), 0), Vec3(at(random), at(random), 0)));
            const double before = travel(passes, 20);
            for (const bool either_way : {false, true}) {
                std::vector<Pass> ordered = passes;
                order_by_travel(ordered, either_way, 20, Progress());
                QVERIFY(travel(ordered, 20) <= before);
                std::vector<int> seen(std::size_t(count), 0);
                for (const Pass& p : ordered)
                    ++seen[std::size_t(p.drive)];
                QVERIFY(ordered.size() == passes.size());
                for (const int n : seen)
                    QCOMPARE(n, 1);
                if (count > 2) QCOMPARE(ordered.front().drive, 0);
            }
        }
    }
};

FACETMILL_TEST(TestPassOrder)
#include "test_pass_order.moc"
