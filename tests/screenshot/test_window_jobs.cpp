// Background jobs: three endings, one door.
#include "core/base/parallel.h"
#include "tests/support/test_runner.h"
#include "ui/aside.h"
#include "ui/background_job.h"
#include "ui/settings_file.h"

#include <QCoreApplication>
#include <QSettings>
#include <QSignalSpy>
#include <QTest>
#include <QThread>

#include <atomic>
#include <memory>
#include <stdexcept>
#include <vector>

#ifdef __linux__
#include <sys/resource.h>
#endif

using facetmill::Cancelled;
using facetmill::Error;
using facetmill::ErrorCode;
using facetmill::Progress;
using facetmill::ui::BackgroundJob;
using facetmill::ui::do_aside;
using facetmill::ui::finish_aside;
using facetmill::ui::JobEnd;
using facetmill::ui::let_go;
using facetmill::ui::SettingsFile;

namespace {

/// Works until it is cancelled.
void work_for_ever(const Progress& progress) {
    for (;;) {
        QThread::msleep(1);
        progress.check();
    }
}

struct Watched {
    BackgroundJob job;
    std::vector<JobEnd> ends;
    int then_calls = 0;
    bool in_own_thread = true;

    Watched() {
        QObject::connect(&job, &BackgroundJob::ended, &job, [this](const JobEnd& end) {
            in_own_thread &= QThread::currentThread() == job.thread();
            in_own_thread &= !job.running();
            ends.push_back(end);
        });
    }
    void start(BackgroundJob::Work work) {
        job.start(QStringLiteral("Test"), std::move(work), [this](const JobEnd&) {
            in_own_thread &= QThread::currentThread() == job.thread();
            ++then_calls;
        });
    }
};

} // namespace

class TestBackgroundJob : public QObject {
    Q_OBJECT
private slots:
    void done() {
        Watched w;
        std::atomic<bool> elsewhere{false};
        w.start([&](const Progress&) { elsewhere = QThread::currentThread() != w.job.thread(); });
        QVERIFY(w.job.running());
        QVERIFY(w.ends.empty()); // the end always comes from the event loop
        QTRY_COMPARE_WITH_TIMEOUT(w.ends.size(), std::size_t(1), facetmill::test::patience_ms);
        QVERIFY(elsewhere);
        QVERIFY(w.ends[0].done());
        QVERIFY(!w.job.running());
        QCOMPARE(w.then_calls, 1);
        QVERIFY(w.in_own_thread);
        QTest::qWait(20);
        QCOMPARE(w.ends.size(), std::size_t(1));
    }

    void cancelled() {
        Watched w;
        w.start(work_for_ever);
        QTest::qWait(20);
        w.job.cancel();
        QVERIFY(w.job.cancelling());
        QVERIFY(w.job.running()); // until the thread has ended
        QTRY_COMPARE_WITH_TIMEOUT(w.ends.size(), std::size_t(1), facetmill::test::patience_ms);
        QCOMPARE(w.ends[0].how, JobEnd::How::cancelled);
        QVERIFY(w.ends[0].message.isEmpty());
        QCOMPARE(w.then_calls, 1);
        QVERIFY(w.in_own_thread);
    }

    void a_result_after_cancel_is_no_result() {
        Watched w;
        std::atomic<bool> go{false};
        w.start([&](const Progress&) {
            while (!go)
                QThread::msleep(1); // never looks at the flag
        });
        w.job.cancel();
        go = true;
        QTRY_COMPARE_WITH_TIMEOUT(w.ends.size(), std::size_t(1), facetmill::test::patience_ms);
        QCOMPARE(w.ends[0].how, JobEnd::How::cancelled);
    }

    void failed_data() {
        QTest::addColumn<int>("what");
        QTest::addColumn<QString>("message");
        QTest::newRow("error") << 0 << QStringLiteral("part.stl: broken (mend it)");
        QTest::newRow("exception") << 1 << QStringLiteral("standard");
        QTest::newRow("memory") << 2 << QStringLiteral("Not enough memory");
        QTest::newRow("anything") << 3 << QStringLiteral("unknown exception");
    }
    void failed() {
        QFETCH(int, what);
        QFETCH(QString, message);
        Watched w;
        w.start([what](const Progress&) {
            if (what == 0) throw Error(ErrorCode::syntax, "part.stl", "broken", "mend it");
            if (what == 1) throw std::runtime_error("standard");
            if (what == 2) throw std::bad_alloc();
            throw 7;
        });
        QTRY_COMPARE_WITH_TIMEOUT(w.ends.size(), std::size_t(1), facetmill::test::patience_ms);
        QCOMPARE(w.ends[0].how, JobEnd::How::failed);
        QVERIFY2(w.ends[0].message.contains(message), qPrintable(w.ends[0].message));
        QCOMPARE(w.then_calls, 1);
        QVERIFY(w.in_own_thread);
    }

    void the_window_goes_first() {
#ifdef __linux__
        const int own = getpriority(PRIO_PROCESS, 0);
        if (own >= 15) QSKIP("this process gives way to everything already");
        Watched w;
        std::atomic<int> least{100};
        w.start([&](const Progress& p) {
            facetmill::parallel_for(200, 1, p, [&](std::size_t) {
                int now = least;
                const int nice = getpriority(PRIO_PROCESS, 0); // of the thread that got this index
                while (nice < now && !least.compare_exchange_weak(now, nice)) {
                }
                QThread::usleep(200);
            });
        });
        QTRY_COMPARE_WITH_TIMEOUT(w.ends.size(), std::size_t(1), facetmill::test::patience_ms);
        QVERIFY2(least > own, qPrintable(QString::number(least)));
        QCOMPARE(getpriority(PRIO_PROCESS, 0), own);
#endif
    }

    void progress_is_polled() {
        Watched w;
        QSignalSpy progressed(&w.job, &BackgroundJob::progressed);
        std::atomic<bool> go{false};
        w.start([&](const Progress& p) {
            p.part(0, 0.5, "Half").set(1);
            while (!go)
                QThread::msleep(1);
        });
        QTRY_VERIFY_WITH_TIMEOUT(!progressed.isEmpty() && progressed.last().at(0).toDouble() == 0.5,
                                 facetmill::test::patience_ms);
        QCOMPARE(progressed.last().at(1).toString(), QStringLiteral("Half"));
        go = true;
        QTRY_COMPARE_WITH_TIMEOUT(w.ends.size(), std::size_t(1), facetmill::test::patience_ms);
        const auto count = progressed.size();
        QTest::qWait(120);
        QCOMPARE(progressed.size(), count); // nobody polls a job that has ended
    }

    void a_new_job_displaces_the_running_one() {
        Watched w;
        w.start(work_for_ever);
        int second = 0, third = 0;
        JobEnd second_end, third_end;
        w.job.start(
            QStringLiteral("Second"), [&](const Progress&) { ++second; },
            [&](const JobEnd& e) { second_end = e; });
        w.job.start(
            QStringLiteral("Third"), [&](const Progress&) { ++third; },
            [&](const JobEnd& e) { third_end = e; });
        QCOMPARE(second_end.how, JobEnd::How::cancelled); // it never ran, and that was told
        QTRY_COMPARE_WITH_TIMEOUT(w.ends.size(), std::size_t(2), facetmill::test::patience_ms);
        QCOMPARE(w.ends[0].how, JobEnd::How::cancelled);
        QVERIFY(w.ends[1].done());
        QCOMPARE(second, 0);
        QCOMPARE(third, 1);
        QVERIFY(third_end.done());
        QVERIFY(!w.job.running());
    }

    void a_job_may_start_the_next() {
        Watched w;
        int runs = 0;
        w.job.start(
            QStringLiteral("First"), [&](const Progress&) { ++runs; },
            [&](const JobEnd&) { w.job.start(QStringLiteral("Next"), [&](const Progress&) { ++runs; }); });
        QTRY_COMPARE_WITH_TIMEOUT(w.ends.size(), std::size_t(2), facetmill::test::patience_ms);
        QCOMPARE(runs, 2);
    }

    void destruction_cancels_and_waits() {
        std::atomic<bool> ended{false};
        int calls = 0;
        {
            BackgroundJob job;
            job.start(
                QStringLiteral("Test"),
                [&](const Progress& p) {
                    try {
                        work_for_ever(p);
                    } catch (const Cancelled&) {
                        QThread::msleep(20); // the destructor waits for this too
                        ended = true;
                        throw;
                    }
                },
                [&](const JobEnd&) { ++calls; });
            QTest::qWait(10);
        }
        QVERIFY(ended);
        QTest::qWait(20);
        QCOMPARE(calls, 0); // nobody is left to be told
    }
};
FACETMILL_TEST(TestBackgroundJob)

class TestAside : public QObject {
    Q_OBJECT
private slots:
    void cleanupTestCase() { SettingsFile::own().clear(); }

    void work_is_done_in_order_in_a_thread_that_gives_way() {
        std::vector<int> done; // read when all is done
        bool elsewhere = true;
        for (int i = 0; i < 5; ++i)
            do_aside([&, i] {
                QThread::msleep(2);
                elsewhere = elsewhere && QThread::currentThread() != qApp->thread();
                done.push_back(i);
            });
        finish_aside();
        QVERIFY(elsewhere);
        QCOMPARE(done, (std::vector<int>{0, 1, 2, 3, 4}));
#ifdef __linux__
        const int own = getpriority(PRIO_PROCESS, 0);
        if (own >= 15) QSKIP("this process gives way to everything already");
        int nice = own;
        do_aside([&] { nice = getpriority(PRIO_PROCESS, 0); });
        finish_aside();
        QVERIFY2(nice > own, qPrintable(QString::number(nice)));
#endif
    }

    /// Also where somebody still has it for a moment.
    void large_things_are_freed_elsewhere() {
        std::atomic<QThread*> freed_in{nullptr};
        std::shared_ptr<int> thing(new int(7), [&](const int* p) {
            freed_in = QThread::currentThread();
            delete p;
        });
        auto shown = thing;
        let_go(std::move(thing));
        QTest::qWait(50);
        QVERIFY(!freed_in);
        shown = nullptr;
        QVERIFY(!freed_in); // not here
        QTRY_VERIFY_WITH_TIMEOUT(freed_in, facetmill::test::patience_ms);
        QVERIFY(freed_in != qApp->thread());
    }

    void settings_are_there_at_once_and_in_the_file_soon() {
        SettingsFile& own = SettingsFile::own();
        own.clear();
        own.set_value(QStringLiteral("a/one"), 1);
        own.set_value(QStringLiteral("a/two"), QStringList{QStringLiteral("x")});
        own.set_value(QStringLiteral("b"), QStringLiteral("there"));
        QCOMPARE(own.value(QStringLiteral("a/one")).toInt(), 1);
        QCOMPARE(own.value(QStringLiteral("c"), 5).toInt(), 5);
        QCOMPARE(own.keys(QStringLiteral("a/")),
                 QStringList({QStringLiteral("a/one"), QStringLiteral("a/two")}));
        own.remove({QStringLiteral("b")});
        QVERIFY(!own.value(QStringLiteral("b")).isValid());
        finish_aside();
        {
            QSettings file;
            QCOMPARE(file.value(QStringLiteral("a/one")).toInt(), 1);
            QCOMPARE(file.value(QStringLiteral("a/two")).toStringList(), QStringList{QStringLiteral("x")});
            QVERIFY(!file.contains(QStringLiteral("b")));
            file.setValue(QStringLiteral("a/one"), 2); // as another window does
        }
        QCOMPARE(own.value(QStringLiteral("a/one")).toInt(), 1);
        own.read_again();
        QTRY_COMPARE_WITH_TIMEOUT(own.value(QStringLiteral("a/one")).toInt(), 2,
                                  facetmill::test::patience_ms);
        own.clear();
        QVERIFY(!own.value(QStringLiteral("a/one")).isValid());
        finish_aside();
        QVERIFY(!QSettings().contains(QStringLiteral("a/one")));
    }
};
FACETMILL_TEST(TestAside)

#include "test_window_jobs.moc"
