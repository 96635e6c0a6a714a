#include "ui/aside.h"

#include "core/base/parallel.h"

#include <QCoreApplication>
#include <QTimer>

#include <condition_variable>
#include <deque>
#include <mutex>
#include <thread>
#include <utility>

namespace facetmill::ui {

namespace {

constexpr int let_go_after_ms = 400;

class AsideThread {
public:
    AsideThread() {
        std::thread([this] { run(); }).detach();
        qAddPostRoutine([] { finish_aside(); });
    }
    void add(std::function<void()> work) {
        {
            const std::lock_guard lock(mutex_);
            waiting_.push_back(std::move(work));
        }
        changed_.notify_all();
    }
    void finish() {
        std::unique_lock lock(mutex_);
        changed_.wait(lock, [this] { return waiting_.empty() && !working_; });
    }
    bool finish(std::chrono::milliseconds at_most) {
        std::unique_lock lock(mutex_);
        return changed_.wait_for(lock, at_most, [this] { return waiting_.empty() && !working_; });
    }

private:
    void run() {
        lower_thread_priority();
        std::unique_lock lock(mutex_);
        for (;;) {
            changed_.wait(lock, [this] { return !waiting_.empty(); });
            std::function<void()> work = std::move(waiting_.front());
            waiting_.pop_front();
            working_ = true;
            lock.unlock();
            work();
            work = nullptr; // frees what it has, too
            lock.lock();
            working_ = false;
            changed_.notify_all();
        }
    }

    std::mutex mutex_;
    std::condition_variable changed_;
    std::deque<std::function<void()>> waiting_;
    bool working_ = false;
};

AsideThread& aside_thread() {
    // Never destroyed: its thread runs until the program has ended.
    static auto& thread = *new AsideThread;
    return thread;
}

} // namespace

void do_aside(std::function<void()> work) {
    aside_thread().add(std::move(work));
}

void finish_aside() {
    aside_thread().finish();
}

bool finish_aside(std::chrono::milliseconds at_most) {
    return aside_thread().finish(at_most);
}

void let_go(std::shared_ptr<const void> thing) {
    if (!thing || !QCoreApplication::instance()) return;
    // The timer's function is freed in the window's thread: the thing must have left it by then.
    const auto held = std::make_shared<std::shared_ptr<const void>>(std::move(thing));
    QTimer::singleShot(let_go_after_ms, qApp, [held] { do_aside([last = std::move(*held)] {}); });
}

} // namespace facetmill::ui
