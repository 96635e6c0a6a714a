// How much a cutter takes at once: slots, faces and steps of known depth, and stretches of paths against a
// plain search.
#include "core/base/parallel.h"
#include "core/verify/cutting_load.h"
#include "core/verify/removal.h"
#include "core/verify/stock_tiles.h"
#include "tests/support/test_runner.h"

#include <QTest>

#include <random>

using namespace facetmill;

namespace {

constexpr double mill_wide = 10, mill_feed = 600; // mm, mm/min

StockSolid milled_block() {
    StockSolid s;
    s.box.add(Vec3(0, 0, 0));
    s.box.add(Vec3(60, 40, 20));
    return s;
}

/// To each place, the first of them by a rapid.
VerifyProgram milled(const std::vector<Vec3>& tips, const std::vector<double>& feeds = {}) {
    auto motions = std::make_shared<ToolMotions>();
    for (const Vec3& tip : tips)
        motions->motions.push_back(
            {motions->motions.empty() ? MotionKind::rapid : MotionKind::cut, {tip, Vec3::UnitZ()}});
    VerifyProgram program{"Test", VerifyTool(AptCutter::flat(mill_wide, 30)), motions, std::nullopt};
    program.feed = mill_feed;
    program.feeds = feeds;
    return program;
}

struct Milled {
    std::vector<CuttingLoad> loads;
    double lost = 0; ///< volume of the stock
};

Milled milled_away(const std::vector<VerifyProgram>& programs, double resolution) {
    StockModel stock(milled_block(), StockLattice::over(milled_block().box, resolution), Progress());
    Milled result;
    result.lost = stock.volume();
    MaterialRemoval removal(programs, 0.01, 0);
    for (std::size_t p = 0; p < programs.size(); ++p) {
        removal.cut(stock, p, 0, programs[p].motions->motions.size(), 1, true, Progress());
        result.loads.push_back(removal.load(p));
    }
    result.lost -= stock.volume();
    return result;
}

bool near(double value, double expect, double share) {
    return std::abs(value / expect - 1) < share;
}

#define NEAR(value, expect, share)                                                                           \
    QVERIFY2(near(value, expect, share), qPrintable(QString("%1, not %2").arg(value).arg(expect)))

struct MilledPiece {
    double length, feed, volume;
};

/// The largest mean over stretches that begin anywhere.
double searched(const std::vector<MilledPiece>& pieces, double stretch) {
    std::vector<double> at{0}, time{0}, volume{0};
    for (const MilledPiece& p : pieces) {
        at.push_back(at.back() + p.length);
        time.push_back(time.back() + p.length / p.feed);
        volume.push_back(volume.back() + p.volume);
    }
    const auto value = [&](const std::vector<double>& of, double s) {
        std::size_t i = 1;
        while (i + 1 < at.size() && at[i] < s)
            ++i;
        return of[i - 1] + (of[i] - of[i - 1]) * (s - at[i - 1]) / (at[i] - at[i - 1]);
    };
    double best = 0;
    constexpr int steps = 20000;
    for (int k = 0; k <= steps; ++k) {
        const double s = (at.back() - stretch) * k / steps;
        best = std::max(best, (value(volume, s + stretch) - value(volume, s))
                                  / (value(time, s + stretch) - value(time, s)));
    }
    return best;
}

} // namespace

class TestCuttingLoad : public QObject {
    Q_OBJECT
private slots:
    /// 2 mm deep: all of the cutter's width; beside it two fifths of it; again the same: nothing.
    void a_slot_and_a_face() {
        const std::vector<VerifyProgram> programs{milled({{-10, 10, 18}, {70, 10, 18}}),
                                                  milled({{-10, 14, 18}, {70, 14, 18}}),
                                                  milled({{-10, 14, 18}, {70, 14, 18}})};
        const Milled done = milled_away(programs, 0.25);
        NEAR(done.loads[0].peak_rate, mill_wide * 2 * mill_feed, 0.03);
        NEAR(done.loads[1].peak_rate, 4 * 2 * mill_feed, 0.03);
        QCOMPARE(done.loads[2].peak_rate, 0.0);
        NEAR(done.loads[0].volume, mill_wide * 2 * 60, 0.03);
        NEAR(done.loads[1].volume, 4.0 * 2 * 60, 0.03);
        // The stock is told by the mean of its three families of rays.
        NEAR(done.loads[0].volume + done.loads[1].volume, done.lost, 0.05);
    }

    /// Over a step the cutter is in by 3 mm and then by 1 mm; where it is deeper it goes more slowly.
    void a_step_of_known_depth() {
        std::vector<Vec3> lower{{30 + mill_wide / 2, -10, 18}};
        for (double x = 30 + mill_wide / 2; x < 70;
             x += mill_wide / 2) { // all of the block beyond x = 30, 2 mm down
            lower.emplace_back(x, -10, 18);
            lower.emplace_back(x, 50, 18);
            lower.emplace_back(x, -10, 18);
        }
        const double slow = 150;
        const std::vector<VerifyProgram> programs{
            milled(lower), milled({{-10, 10, 17}, {25, 10, 17}, {70, 10, 17}}),
            milled({{-10, 30, 17}, {25, 30, 17}, {70, 30, 17}}, {mill_feed, slow, mill_feed})};
        const Milled done = milled_away(programs, 0.25);
        NEAR(done.loads[1].peak_rate, mill_wide * 3 * mill_feed, 0.03);
        QCOMPARE(done.loads[1].peak_motion, std::size_t(1));
        // Deep and slow is 4500 a minute, beyond the step 6000; between them stretches have some of both.
        QVERIFY2(done.loads[2].peak_rate > mill_wide * 1 * mill_feed * 0.97,
                 qPrintable(QString::number(done.loads[2].peak_rate)));
        QCOMPARE(done.loads[2].peak_motion, std::size_t(2));
    }

    void no_feed_is_no_rate() {
        VerifyProgram program = milled({{-10, 10, 18}, {70, 10, 18}});
        program.feed = 0;
        const Milled done = milled_away({program}, 0.5);
        QCOMPARE(done.loads[0].peak_rate, 0.0);
        NEAR(done.loads[0].volume, mill_wide * 2 * 60, 0.03);
    }

    void threads_do_not_matter_to_loads() {
        std::mt19937 random(4);
        std::uniform_real_distribution<double> share(0, 1);
        std::vector<Vec3> tips;
        for (int i = 0; i < 60; ++i)
            tips.emplace_back(60 * share(random), 40 * share(random), 10 + 12 * share(random));
        const std::vector<VerifyProgram> programs{milled(tips)};
        const auto with = [&](int threads) {
            set_thread_count(threads);
            const Milled done = milled_away(programs, 0.8);
            set_thread_count(0);
            return done;
        };
        const Milled one = with(1), two = with(2);
        QVERIFY(one.loads[0].volume > 100);
        QVERIFY(one.loads[0].volume == two.loads[0].volume);
        QVERIFY(one.loads[0].peak_rate == two.loads[0].peak_rate);
        QCOMPARE(one.loads[0].peak_motion, two.loads[0].peak_motion);
        NEAR(one.loads[0].volume, one.lost, 0.05);
    }

    void stretches_are_those_of_a_search() {
        std::mt19937 random(9);
        std::uniform_real_distribution<double> share(0, 1);
        for (int round = 0; round < 20; ++round) {
            std::vector<MilledPiece> pieces;
            for (int i = 0; i < 30; ++i)
                pieces.push_back({0.1 + 4 * share(random), 300, 50 * share(random) * share(random)});
            LoadMeter meter(mill_wide);
            for (std::size_t i = 0; i < pieces.size(); ++i)
                meter.add(pieces[i].length, pieces[i].feed, pieces[i].volume, i);
            meter.lift();
            const double expect = searched(pieces, mill_wide);
            QVERIFY2(meter.load().peak_rate >= expect * (1 - 1e-9)
                         && near(meter.load().peak_rate, expect, 2e-3),
                     qPrintable(QString("%1 %2").arg(meter.load().peak_rate).arg(expect)));
        }
    }

    /// Rapids part stretches; a short one counts as if it were whole; what is cut in place goes on.
    void short_runs() {
        LoadMeter meter(mill_wide);
        meter.add(2, mill_feed, 40, 0);
        meter.lift();
        NEAR(meter.load().peak_rate, 40 / (mill_wide / mill_feed), 1e-12);
        QCOMPARE(meter.load().peak_motion, std::size_t(0));
        meter.add(2, mill_feed, 30, 1);
        meter.add(0, mill_feed, 30, 2);
        meter.add(2, mill_feed, 0, 3);
        meter.lift();
        NEAR(meter.load().peak_rate, 60 / (mill_wide / mill_feed), 1e-12);
        QCOMPARE(meter.load().peak_motion, std::size_t(3));
        NEAR(meter.load().volume, 100.0, 1e-12);
    }
};

FACETMILL_TEST(TestCuttingLoad)
#include "test_cutting_load.moc"
