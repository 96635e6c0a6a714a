#include "tests/support/trials.h"

#include <cstdlib>

// The start-up functions of the sanitizers' libraries, which are there only where something asked for them.
extern "C" {
[[gnu::weak]] void __asan_init();
[[gnu::weak]] void __tsan_init();
}

namespace facetmill::test {

const bool under_sanitizer = &__asan_init != nullptr || &__tsan_init != nullptr;
const bool all_cases = std::getenv("FACETMILL_ALL_CASES") != nullptr; // NOLINT(concurrency-mt-unsafe)

} // namespace facetmill::test
