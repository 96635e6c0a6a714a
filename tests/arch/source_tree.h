// The files of the source tree, as the tests of its order read them.
#pragma once

#include <map>
#include <string>
#include <vector>

namespace facetmill::test {

/// Text of every header and source below `folders` (both written from the root), by its path from the root.
std::map<std::string, std::string> sources(const std::vector<std::string>& folders);

/// A line that includes a file.
struct Include {
    std::string file; // from the root
    int line = 0;
    std::string target; // as written, without the quotes or brackets
    bool quoted = false;
};

/// The includes of `text`, which is that of `file`.
std::vector<Include> includes_in(const std::string& text, const std::string& file);

} // namespace facetmill::test
