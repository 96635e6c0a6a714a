// Two indices as one key.
#pragma once

#include "core/mesh/mesh.h"

#include <algorithm>
#include <cstdint>

namespace facetmill {

/// The same for (a, b) and (b, a).
inline std::uint64_t pair_of(Index a, Index b) {
    return (std::uint64_t(std::min(a, b)) << 32) | std::max(a, b);
}

/// From a to b.
inline std::uint64_t directed_pair(Index a, Index b) {
    return (std::uint64_t(a) << 32) | b;
}

} // namespace facetmill
