#include "tests/arch/source_tree.h"

#include <filesystem>
#include <fstream>
#include <regex>
#include <sstream>

namespace facetmill::test {

namespace fs = std::filesystem;

std::map<std::string, std::string> sources(const std::vector<std::string>& folders) {
    std::map<std::string, std::string> all;
    const fs::path root = FACETMILL_SOURCE;
    for (const auto& folder : folders)
        for (const auto& entry : fs::recursive_directory_iterator(root / folder)) {
            const auto ext = entry.path().extension();
            if (!entry.is_regular_file() || (ext != ".h" && ext != ".cpp" && ext != ".inl" && ext != ".c"))
                continue;
            std::ifstream in(entry.path(), std::ios::binary);
            std::stringstream text;
            text << in.rdbuf();
            all[fs::relative(entry.path(), root).generic_string()] = text.str();
        }
    return all;
}

std::vector<Include> includes_in(const std::string& text, const std::string& file) {
    static const std::regex pattern(R"(^\s*#\s*include\s*([<"])([^>"]+)[>"])");
    std::vector<Include> found;
    std::istringstream lines(text);
    std::string line;
    for (int n = 1; std::getline(lines, line); ++n) {
        std::smatch m;
        if (std::regex_search(line, m, pattern)) found.push_back({file, n, m[2], m[1] == "\""});
    }
    return found;
}

} // namespace facetmill::test
