// What the fuzz targets have in common: a reader may refuse, by an Error of its own, and do nothing else.
#pragma once

#include "core/base/error.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>

namespace facetmill::fuzz {

/// Ends the process so that the fuzzer keeps the input.
[[noreturn]] inline void found(const char* what) {
    std::fprintf(stderr, "%s\n", what);
    std::abort();
}

inline std::string_view text_of(const std::uint8_t* data, std::size_t size) {
    return {reinterpret_cast<const char*>(data), size};
}

/// True where the reader took it. An error must be one line, whatever it was about, and say something.
template <class Read>
bool reads(Read&& read) {
    try {
        read();
        return true;
    } catch (const Error& e) {
        const std::string line = e.what();
        if (e.message().empty() || line != printable(line, line.size()))
            found("an error that cannot be shown");
        return false;
    }
}

/// Every motion leads to a place, by an axis that is one.
template <class Motions>
void check_motions(const Motions& motions) {
    for (const auto& motion : motions)
        if (!motion.to.tip.allFinite() || !(std::abs(motion.to.axis.norm() - 1) < 1e-6))
            found("a motion to no place");
}

} // namespace facetmill::fuzz
