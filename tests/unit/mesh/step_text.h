// The text of STEP files, to be put together in other ways.
#pragma once

#include "tests/unit/mesh/mesh_io_support.h"

#include <string>
#include <vector>

namespace facetmill::test {

/// The entities of the data section, each with its semicolon, in one line.
inline std::vector<std::string> entities_of(const std::string& step) {
    const std::size_t begin = step.find("DATA;") + 5, end = step.find("ENDSEC;", begin);
    std::vector<std::string> all;
    for (std::size_t at = begin; at < end;) {
        const std::size_t semicolon = step.find(';', at);
        if (semicolon >= end) break;
        all.push_back(replaced_all(step.substr(at, semicolon + 1 - at), "\n", ""));
        at = semicolon + 1;
    }
    return all;
}

inline std::string with_entities(const std::string& step, const std::vector<std::string>& entities) {
    const std::size_t begin = step.find("DATA;") + 5, end = step.find("ENDSEC;", begin);
    std::string text = step.substr(0, begin) + "\n";
    for (const std::string& one : entities)
        text += one + "\n";
    return text + step.substr(end);
}

} // namespace facetmill::test
