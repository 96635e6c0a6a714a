// How many random trials a test runs. Memory errors and undefined behaviour show within few cases, and a
// build under a sanitizer is up to thirty times slower; what shows in rare cases only is left to the release
// build, which runs them all.
#pragma once

#include <algorithm>

namespace facetmill::test {

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool under_sanitizer = true;
#else
constexpr bool under_sanitizer = false;
#endif

/// `n`; under a sanitizer one in `part` of it, at least 1. Counts that a test expects of its trials scale
/// alike.
template <class T>
constexpr T trials(T n, T part = 10) {
    return under_sanitizer ? std::max(T(1), T(n / part)) : n;
}

} // namespace facetmill::test
