// Cancellable parallel loops on oneTBB. Results do not depend on the number of threads: every index writes
// its own place, and reductions join fixed blocks in a fixed order.
#pragma once

#include "core/base/progress.h"

#include <atomic>
#include <cstddef>
#include <functional>
#include <span>
#include <utility>
#include <vector>

namespace facetmill {

/// Threads that parallel loops use in this process: `set_thread_count(0)` means all cores. Process-wide
/// because it is a property of the run (`--threads`), not of a job; results never depend on it.
void set_thread_count(int threads);
int thread_count();

/// The calling thread gives way to others from now on, and so do the workers of the loops it calls: for long
/// jobs beside a window that has to answer. There is no way back for a thread. Does nothing on systems
/// without priorities of threads.
void lower_thread_priority();

namespace detail {
void run_blocks(std::size_t blocks, const std::function<void(std::size_t)>& body);
}

/// body(begin, end) over [0, n) in blocks of `grain` indices. Cancellation is checked before every block; the
/// first exception of a body (or Cancelled) is rethrown on the calling thread after all running blocks ended.
template <class Body>
void parallel_blocks(std::size_t n, std::size_t grain, const Progress& progress, Body&& body) {
    if (n == 0) return;
    if (grain == 0) grain = 1;
    const std::size_t blocks = (n - 1) / grain + 1;
    std::atomic<std::size_t> done{0};
    detail::run_blocks(blocks, [&](std::size_t b) {
        progress.check();
        body(b * grain, std::min(n, (b + 1) * grain));
        progress.set(double(++done) / double(blocks));
    });
}

/// body(bounds[i], bounds[i + 1]) for every i, begun in this order: with small ranges at the end all threads
/// end at about the same time.
template <class Body>
void parallel_ranges(std::span<const std::size_t> bounds, const Progress& progress, Body&& body) {
    if (bounds.size() < 2) return;
    const std::size_t ranges = bounds.size() - 1;
    std::atomic<std::size_t> done{0};
    detail::run_blocks(ranges, [&](std::size_t b) {
        progress.check();
        body(bounds[b], bounds[b + 1]);
        progress.set(double(++done) / double(ranges));
    });
}

/// body(i) for every i in [0, n).
template <class Body>
void parallel_for(std::size_t n, std::size_t grain, const Progress& progress, Body&& body) {
    parallel_blocks(n, grain, progress, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            body(i);
    });
}

/// Reduction whose result is the same bits for every thread count: map(begin, end) per block of `grain`, then
/// join(total, block) in the order of blocks.
template <class T, class Map, class Join>
T parallel_reduce(std::size_t n, std::size_t grain, T total, const Progress& progress, Map&& map,
                  Join&& join) {
    if (n == 0) return total;
    if (grain == 0) grain = 1;
    std::vector<T> block_results((n - 1) / grain + 1, total);
    parallel_blocks(n, grain, progress, [&](std::size_t begin, std::size_t end) {
        block_results[begin / grain] = map(begin, end);
    });
    for (const T& r : block_results)
        total = join(std::move(total), r);
    return total;
}

} // namespace facetmill
