// Work of core's while Python waits: in a thread of its own, so that Ctrl-C is heard meanwhile.
#pragma once

#include "core/base/progress.h"

#include <pybind11/pybind11.h>

#include <chrono>
#include <condition_variable>
#include <exception>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>

namespace facetmill::python {

struct PythonJob {
    Job job;
};

/// A thread that is kept from call to call: to begin one takes as long as to lower a cutter at ten thousand
/// points, and core keeps what it works with by thread.
class WorkThread {
public:
    /// One that nobody uses now. A process that was forked from one with threads has none of them: it begins
    /// its own.
    static std::unique_ptr<WorkThread> take();
    static void give_back(std::unique_ptr<WorkThread> thread);

    /// Runs work, which must not throw, and outlive it.
    void begin(const std::function<void()>& work);
    /// Whether it has ended, within so long.
    bool ended_within(std::chrono::milliseconds time);

private:
    struct Shared {
        std::mutex mutex;
        std::condition_variable changed;
        const std::function<void()>* work = nullptr; ///< null: nothing is to be done
    };
    WorkThread();
    /// The thread itself is detached, and waits for work until the process ends.
    std::shared_ptr<Shared> shared_;
    int process_;
};

/// Runs work(progress) without the interpreter's lock, and returns what that returns. What a signal's handler
/// raises cancels it and is thrown once it has ended. Throws what it throws.
template <class Work>
auto waited(PythonJob* given, const Work& work) {
    using Result = decltype(work(Progress()));
    PythonJob own;
    PythonJob& job = given ? *given : own;
    std::optional<Result> result;
    std::exception_ptr thrown;
    std::optional<pybind11::error_already_set> raised;
    const std::function<void()> task = [&] {
        try {
            result.emplace(work(Progress(job.job)));
        } catch (...) {
            thrown = std::current_exception();
        }
    };
    std::unique_ptr<WorkThread> thread = WorkThread::take();
    thread->begin(task);
    for (;;) {
        {
            const pybind11::gil_scoped_release released;
            constexpr auto heard_within = std::chrono::milliseconds(20);
            if (thread->ended_within(heard_within)) break;
        }
        if (!raised && PyErr_CheckSignals() != 0) {
            raised.emplace();
            job.job.cancel();
        }
    }
    WorkThread::give_back(std::move(thread));
    if (raised) {
        try {
            if (thrown) std::rethrow_exception(thrown);
        } catch (const Cancelled&) {
            // As it was asked to.
        }
        throw pybind11::error_already_set(*raised);
    }
    if (thrown) std::rethrow_exception(thrown);
    return std::move(*result);
}

} // namespace facetmill::python
