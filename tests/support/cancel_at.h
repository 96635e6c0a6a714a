// Cancelling a job while it runs.
#pragma once

#include "core/base/progress.h"

#include <atomic>
#include <thread>

namespace facetmill::test {

/// Runs `run(Progress)` with a job that another thread cancels as soon as it has come to `fraction`, or has
/// ended. True when it was cancelled. Other errors pass.
template <class Run>
bool cancelled_at(Job& job, double fraction, Run&& run) {
    std::atomic<bool> over{false};
    struct Watcher {
        std::atomic<bool>& over;
        std::thread thread;
        ~Watcher() {
            over = true;
            thread.join();
        }
    };
    const Watcher watcher{over, std::thread([&] {
                              while (!over && job.fraction() < fraction)
                                  std::this_thread::yield();
                              job.cancel();
                          })};
    try {
        run(Progress(job));
    } catch (const Cancelled&) {
        return true;
    }
    return false;
}

} // namespace facetmill::test
