// The player's thread: positions asked for faster than it cuts, another stock while it cuts, an end at any
// time.
#include "tests/support/test_runner.h"
#include "ui/stock_player.h"

#include <QScopeGuard>
#include <QSignalSpy>
#include <QTest>

#include <atomic>
#include <stdexcept>

using namespace facetmill;
using ui::StockPlayer;

namespace {

constexpr int motions = 60;

/// A ball to and fro over a block.
std::unique_ptr<StockPlayback> playback(double depth, const Progress& progress) {
    VerifyProgram program{"Rows", VerifyTool(AptCutter::ball(6, 20)), nullptr, std::nullopt};
    auto moves = std::make_shared<ToolMotions>();
    for (int k = 0; k < motions; ++k) {
        const double x = k % 4 < 2 ? -10 : 10, y = -8 + 16.0 * k / motions;
        moves->motions.push_back({MotionKind::cut, {Vec3(x, y, 4 - depth), Vec3::UnitZ()}});
    }
    program.motions = moves;
    StockSolid block;
    block.box.add(Vec3(-10, -10, 0));
    block.box.add(Vec3(10, 10, 5));
    return std::make_unique<StockPlayback>(block, std::vector{program}, 0.5, progress);
}

StockPlayer::Source source(double depth) {
    return [depth](const Progress& progress) { return playback(depth, progress); };
}

} // namespace

class TestStockPlayer : public QObject {
    Q_OBJECT
private slots:
    void only_the_newest_position_counts() {
        StockPlayer player;
        player.load(source(2));
        for (int k = 1; k <= motions; ++k)
            player.show(k);
        for (int k = motions; k-- > 10;)
            player.show(k);
        QTRY_VERIFY_WITH_TIMEOUT(!player.behind(), 60000);
        QCOMPARE(player.frame()->position, 10.0);
        QVERIFY(!player.frame()->patches.empty());
    }

    void another_stock_while_it_cuts() {
        StockPlayer player;
        for (int k = 0; k < 10; ++k) {
            player.load(source(0.2 * k));
            player.show(motions - k);
            QTest::qWait(k % 3);
        }
        QTRY_VERIFY_WITH_TIMEOUT(!player.behind(), 60000);
        QCOMPARE(player.frame()->position, double(motions - 9));
        player.unload();
        QVERIFY(!player.frame() && !player.behind());
    }

    void what_fails_is_told_once() {
        StockPlayer player;
        QSignalSpy failed(&player, &StockPlayer::failed);
        player.load(
            [](const Progress&) -> std::unique_ptr<StockPlayback> { throw std::runtime_error("no stock"); });
        player.show(1);
        QTRY_COMPARE_WITH_TIMEOUT(failed.size(), 1, 60000);
        QVERIFY(!player.loaded());
        player.load(source(1));
        player.show(5);
        QTRY_VERIFY_WITH_TIMEOUT(!player.behind(), 60000);
        QCOMPARE(failed.size(), 1);
    }

    void it_ends_at_any_time() {
        std::atomic<int> at_work{0};
        for (int k = 0; k < 20; ++k) {
            {
                StockPlayer player;
                player.load([&](const Progress& progress) {
                    ++at_work;
                    const auto done = qScopeGuard([&] { --at_work; }); // also where it is cancelled meanwhile
                    return playback(1, progress);
                });
                player.show(motions);
                QTest::qWait(k % 5);
            }
            QCOMPARE(at_work, 0); // the thread is gone with its player
        }
    }
};

FACETMILL_TEST(TestStockPlayer)
#include "test_stock_player.moc"
