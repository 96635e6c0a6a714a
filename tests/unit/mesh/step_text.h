// The text of STEP files, to be put together in other ways.
#pragma once

#include <string>
#include <vector>

namespace facetmill::test {

inline void replace_all(std::string& text, const std::string& from, const std::string& to) {
    for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size())
        text.replace(at, from.size(), to);
}

/// The entities of the data section, each with its semicolon, in one line.
inline std::vector<std::string> entities_of(const std::string& step) {
    const std::size_t begin = step.find("DATA;") + 5, end = step.find("ENDSEC;", begin);
    std::vector<std::string> all;
    for (std::size_t at = begin; at < end;) {
        const std::size_t semicolon = step.find(';', at);
        if (semicolon >= end) break;
        std::string one = step.substr(at, semicolon + 1 - at);
        replace_all(one, "\n", "");
        all.push_back(one);
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
