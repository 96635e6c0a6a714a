// Things that the program has as JSON files of its own, and that a user may have as files, too: machines,
// posts.
#pragma once

#include "core/base/error.h"
#include "core/base/file.h"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace facetmill {

/// "a, b, c".
inline std::string listed(const std::vector<std::string>& names) {
    std::string list;
    for (const auto& n : names)
        list += (list.empty() ? "" : ", ") + n;
    return list;
}

/// Files that are compiled in, in their order: each has a name and a text.
template <class T, class Files, class Parse>
std::vector<T> built_in(const Files& files, const Parse& parse) {
    std::vector<T> all;
    for (const auto& file : files) {
        all.push_back(parse(file.text, std::string(file.name) + ".json"));
        all.back().name = file.name;
    }
    return all;
}

/// The one with this name; `kind`: "machine". Throws Error(missing_reference) that lists the known names.
template <class T>
const T& find_built_in(const std::vector<T>& all, std::string_view name, const std::string& kind) {
    std::vector<std::string> known;
    for (const T& one : all) {
        if (one.name == name) return one;
        known.push_back(one.name);
    }
    throw Error(ErrorCode::missing_reference, kind, "there is no " + kind + " '" + printable(name) + "'",
                "known " + kind + "s: " + listed(known)
                    + "; a name that ends with .json is a file of your own");
}

/// One of a user's own, named after its file.
template <class T, class Parse>
T load_own(const std::filesystem::path& path, const Parse& parse) {
    const InputFile file(path);
    T one = parse(file.bytes(), printable(path.string(), 400));
    one.name = path.filename().string();
    return one;
}

} // namespace facetmill
