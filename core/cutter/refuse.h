// How values of cutters and tools are refused.
#pragma once

#include "core/base/error.h"
#include "core/base/units.h"

#include <string>

namespace facetmill {

/// Throws Error(out_of_range); `key` is the letter or the parameter that is wrong.
[[noreturn]] inline void refuse(const std::string& key, const std::string& what, const std::string& remedy) {
    throw Error(ErrorCode::out_of_range, key, what, remedy);
}

inline std::string mm(double v) {
    return length_text(v, LengthUnit::mm, 6);
}

} // namespace facetmill
