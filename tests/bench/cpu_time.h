// What a measurement costs where other programs run beside it.
#pragma once

#include <ctime>

namespace facetmill::bench {

/// Seconds of processor time that all threads of this process took so far.
inline double cpu_now() {
    timespec t{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return double(t.tv_sec) + 1e-9 * double(t.tv_nsec);
}

} // namespace facetmill::bench
