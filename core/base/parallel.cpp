#include "core/base/parallel.h"

#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <exception>
#include <memory>
#include <mutex>
#include <thread>

#ifdef __linux__
#include <sched.h>
#include <sys/resource.h>
#include <unistd.h>
#endif

namespace facetmill {

namespace {
std::atomic<int> configured_threads{0};
thread_local bool low_priority = false;

#ifdef __SANITIZE_THREAD__
/// TBB's library is not made for the thread sanitizer, which does not see what it orders, and would take
/// every loop for a race. Threads of the loop's own, which it sees, take the same blocks.
void run_on_threads(int threads, const std::function<void()>& body) {
    std::vector<std::jthread> others;
    for (int k = 1; k < threads; ++k)
        others.emplace_back(body);
    body();
}
#else
/// Arenas that no loop uses now. A worker lingers in the arena of its last loop, giving way again and again,
/// before it looks for another; where cores are short that takes longer than many a loop. So a loop takes the
/// arena that was used last, and its workers are there already. Loops within loops, and beside others, have
/// arenas of their own.
class SpareArenas {
public:
    std::unique_ptr<tbb::task_arena> take(int threads) {
        {
            std::lock_guard lock(mutex_);
            for (auto it = spare_.rbegin(); it != spare_.rend(); ++it) {
                if ((*it)->max_concurrency() != threads) continue;
                std::unique_ptr<tbb::task_arena> arena = std::move(*it);
                spare_.erase(std::next(it).base());
                return arena;
            }
        }
        return std::make_unique<tbb::task_arena>(threads);
    }
    void give_back(std::unique_ptr<tbb::task_arena> arena) {
        std::lock_guard lock(mutex_);
        spare_.push_back(std::move(arena));
    }

private:
    std::mutex mutex_;
    std::vector<std::unique_ptr<tbb::task_arena>> spare_;
};

SpareArenas& spare_arenas() {
    // Never destroyed: threads may still run when the program ends.
    static auto& arenas = *new SpareArenas;
    return arenas;
}

/// Calls the body once for each of so many threads, on as many as there are.
void run_on_threads(int threads, const std::function<void()>& body) {
    auto arena = spare_arenas().take(threads);
    arena->execute([&] {
        tbb::parallel_for(
            tbb::blocked_range<int>(0, threads, 1), [&](const tbb::blocked_range<int>&) { body(); },
            tbb::simple_partitioner());
    });
    spare_arenas().give_back(std::move(arena));
}
#endif
} // namespace

void set_thread_count(int threads) {
    configured_threads = threads < 0 ? 0 : threads;
}

int thread_count() {
    const int n = configured_threads;
    return n > 0 ? n : tbb::info::default_concurrency();
}

void lower_thread_priority() {
    if (low_priority) return;
    low_priority = true;
#ifdef __linux__
    // Beside the program's first thread, the one with the window, a third of its share where there is not
    // enough for both; and it does not push that one aside when it is woken. 0 is the calling thread alone.
    const int nice = std::min(19, getpriority(PRIO_PROCESS, id_t(getpid())) + 5);
    if (getpriority(PRIO_PROCESS, 0) < nice) setpriority(PRIO_PROCESS, 0, nice);
    const sched_param none{};
    if (sched_getscheduler(0) == SCHED_OTHER) sched_setscheduler(0, SCHED_BATCH, &none);
#endif
}

namespace detail {

void run_blocks(std::size_t blocks, const std::function<void(std::size_t)>& body) {
    const int threads = std::min(thread_count(), tbb::info::default_concurrency());
    if (threads == 1 || blocks == 1) {
        for (std::size_t b = 0; b < blocks; ++b)
            body(b);
        return;
    }
    // The exception is carried by hand: TBB would cancel the group, but which of several exceptions it
    // rethrows is not defined, and Cancelled must not hide an Error that happened first.
    std::exception_ptr first;
    std::mutex first_mutex;
    std::atomic<bool> stop{false};
    const bool lower = low_priority;
    // As many loops as threads, each of which takes the next block that nobody has: blocks are begun in
    // order.
    std::atomic<std::size_t> next{0};
    run_on_threads(threads, [&] {
        if (lower) lower_thread_priority();
        for (std::size_t b = next++; b < blocks && !stop; b = next++) {
            try {
                body(b);
            } catch (...) {
                std::lock_guard lock(first_mutex);
                if (!first) first = std::current_exception();
                stop = true;
            }
        }
    });
    if (first) std::rethrow_exception(first);
}

} // namespace detail
} // namespace facetmill
