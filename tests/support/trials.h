// How many random trials and cases of a table a test runs. Memory errors and undefined behaviour show within
// few cases, and core under a sanitizer is up to thirty times slower; what shows in rare cases only is left
// to the tests with core as it ships, which run them all.
#pragma once

#include <algorithm>

namespace facetmill::test {

/// True where this program, or the core that it is linked with, was compiled with a sanitizer.
extern const bool under_sanitizer;

/// Whether all cases of a table are asked for (FACETMILL_ALL_CASES: the slow tests), or those alone that
/// every run has time for.
extern const bool all_cases;

/// `n`; under a sanitizer one in `part` of it, at least 1. Counts that a test expects of its trials scale
/// alike.
template <class T>
T trials(T n, T part = 10) {
    return under_sanitizer ? std::max(T(1), T(n / part)) : n;
}

} // namespace facetmill::test
