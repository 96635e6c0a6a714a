// How the benches of the window measure: pauses of the event loop.
#pragma once

#include "ui/main_window.h"
#include "ui/viewport.h"

#include <QApplication>
#include <QElapsedTimer>
#include <QTemporaryDir>
#include <QTimer>

#include <algorithm>
#include <ctime>

#include <vtkObject.h>

namespace facetmill::test {

/// What the calling thread has computed, in ns.
inline qint64 thread_time() {
    timespec t{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
    return qint64(t.tv_sec) * 1'000'000'000 + t.tv_nsec;
}

/// The longest time the event loop did not come round, and the most that its thread itself computed in one
/// round: what other programs do at the same time lengthens the first only.
class Heart : public QObject {
public:
    Heart() {
        connect(&timer_, &QTimer::timeout, this, [this] {
            longest_ = std::max(longest_, since_.nsecsElapsed());
            max_ = std::max(max_, thread_time() - computed_);
            restart();
        });
        timer_.setTimerType(Qt::PreciseTimer);
        timer_.start(1);
        restart();
    }
    void reset() {
        longest_ = max_ = 0;
        restart();
    }
    /// Also of a pause that has just ended, or has not.
    double longest_ms() const { return double(std::max(longest_, since_.nsecsElapsed())) * 1e-6; }
    double computed_ms() const { return double(std::max(max_, thread_time() - computed_)) * 1e-6; }

private:
    void restart() {
        since_.restart();
        computed_ = thread_time();
    }
    QTimer timer_;
    QElapsedTimer since_;
    qint64 longest_ = 0, computed_ = 0, max_ = 0;
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
