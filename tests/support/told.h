// What a plan tells of itself.
#pragma once

#include "core/strategy/plan/path.h"

#include <algorithm>
#include <string>

namespace facetmill::test {

/// Whether one of the path's warnings has these words.
inline bool tells(const StrategyResult& path, const std::string& words) {
    return std::any_of(path.warnings.begin(), path.warnings.end(),
                       [&](const std::string& w) { return w.find(words) != std::string::npos; });
}

} // namespace facetmill::test
