// How the benches of the window measure: pauses of the event loop.
#pragma once

#include "tests/screenshot/pause_trace.h"
#include "ui/main_window.h"
#include "ui/viewport.h"

#include <QApplication>
#include <QElapsedTimer>
#include <QTemporaryDir>
#include <QTimer>

#include <algorithm>
#include <cstdio>
#include <ctime>

#include <fcntl.h>
#include <unistd.h>

#include <vtkObject.h>

namespace facetmill::test {

/// Where the time of a thread went, in ns: it computed; it was ready and had no core.
struct ThreadTimes {
    qint64 computed = 0, without_core = 0, wall = 0;

    ThreadTimes since(const ThreadTimes& start) const {
        return {computed - start.computed, without_core - start.without_core, wall - start.wall};
    }
    /// It waited for a lock, a disk, the display or a thread that draws.
    qint64 waited() const { return std::max<qint64>(0, wall - computed - without_core); }
};

/// The times of the thread that makes it, as the kernel counts them (/proc/self/task/N/schedstat).
class ThreadClock {
public:
    ThreadClock() : file_(open("/proc/thread-self/schedstat", O_RDONLY | O_CLOEXEC)) { timer_.start(); }
    ~ThreadClock() { close(file_); }
    ThreadClock(const ThreadClock&) = delete;
    ThreadClock& operator=(const ThreadClock&) = delete;

    ThreadTimes now() const {
        ThreadTimes t;
        timespec computed{};
        clock_gettime(CLOCK_THREAD_CPUTIME_ID, &computed);
        t.computed = qint64(computed.tv_sec) * 1'000'000'000 + computed.tv_nsec;
        t.wall = timer_.nsecsElapsed();
        char text[96] = {};
        long long ran = 0, waited = 0;
        if (pread(file_, text, sizeof text - 1, 0) > 0 && std::sscanf(text, "%lld %lld", &ran, &waited) == 2)
            t.without_core = waited;
        return t;
    }

private:
    QElapsedTimer timer_;
    int file_;
};

/// The longest time the event loop did not come round, where that went, and the most that its thread itself
/// computed in one round: what other threads and programs do at the same time lengthens the first only.
class Heart : public QObject {
public:
    Heart() {
        connect(&timer_, &QTimer::timeout, this, [this] { beat(); });
        timer_.setTimerType(Qt::PreciseTimer);
        timer_.start(1);
        last_ = clock_.now();
    }
    void reset() {
        last_ = clock_.now();
        longest_ = {};
        max_ = 0;
    }
    /// Also of a pause that has just ended, or has not.
    double longest_ms() { return (beat(), ms(longest_.wall)); }
    double computed_ms() { return (beat(), ms(max_)); }
    /// "computed 12.1, no core 30.2, waited 1.0": the longest pause, in ms.
    QString longest_by_cause() {
        beat();
        return QString::asprintf("computed %.1f, no core %.1f, waited %.1f", ms(longest_.computed),
                                 ms(longest_.without_core), ms(longest_.waited()));
    }

private:
    static double ms(qint64 ns) { return double(ns) * 1e-6; }
    void beat() {
        const ThreadTimes now = clock_.now(), round = now.since(last_);
        if (round.wall > longest_.wall) longest_ = round;
        max_ = std::max(max_, round.computed);
        if (trace_) trace_->round_ended();
        last_ = clock_.now();
    }
    QTimer timer_;
    std::unique_ptr<PauseTrace> trace_ = PauseTrace::as_asked();
    ThreadClock clock_;
    ThreadTimes last_, longest_;
    qint64 max_ = 0;
};

/// The application of a bench: settings and files of its own, in a folder that goes with it.
class BenchApplication {
public:
    BenchApplication(int& argc, char** argv) : app_((prepare(home_), argc), argv) {}
    QString home() const { return home_.path(); }

private:
    static void prepare(const QTemporaryDir& home) {
        qputenv("XDG_CONFIG_HOME", (home.path() + QStringLiteral("/config")).toUtf8());
        qputenv("XDG_CACHE_HOME", (home.path() + QStringLiteral("/cache")).toUtf8());
        qputenv("XDG_DATA_HOME", (home.path() + QStringLiteral("/data")).toUtf8());
        vtkObject::GlobalWarningDisplayOff();
        ui::Viewport::set_default_format();
        QApplication::setOrganizationName(QStringLiteral("FacetmillTest"));
    }
    QTemporaryDir home_;
    QApplication app_;
};

inline void run_for(int ms) {
    QElapsedTimer timer;
    timer.start();
    while (timer.elapsed() < ms)
        QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents, 5);
}

inline void wait(ui::MainWindow& window) {
    while (window.busy())
        QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents, 5);
    run_for(50);
}

} // namespace facetmill::test
