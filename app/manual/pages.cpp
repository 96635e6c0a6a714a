#include "app/manual/pages.h"

#include "core/base/error.h"
#include "core/base/file.h"

#include <algorithm>
#include <map>
#include <set>
#include <sstream>

namespace facetmill::manual {

namespace {

namespace fs = std::filesystem;

std::string text_of(const fs::path& file) {
    const InputFile in(file);
    return std::string(in.bytes());
}

/// resources/drawings/parameters.txt: "key drawing" or "scope.key drawing" in a line.
std::map<std::string, std::string>& drawings() {
    static std::map<std::string, std::string> all;
    return all;
}

std::string drawing_of(const std::string& scope, const std::string& key) {
    const auto& all = drawings();
    const auto own = all.find(scope + "." + key);
    if (own != all.end()) return own->second == "-" ? std::string() : own->second;
    const auto common = all.find(key);
    return common == all.end() ? std::string() : common->second;
}

/// Everything but the operations as one page, and a page for each operation.
void add_reference(const fs::path& file, const PageOptions& options, std::vector<NamedPage>& pages) {
    const std::string markdown = text_of(file);
    const std::string heading = "\n### `", operations = "\n## Operations\n";
    const auto from = markdown.find(operations);
    auto next = markdown.find(heading, from);
    if (from == std::string::npos || next == std::string::npos)
        throw Error(ErrorCode::syntax, "reference.md", "it lists no operations", "write it anew");
    std::string first = markdown.substr(0, next + 1);
    first.replace(0, first.find('\n'), "# Parameter reference");
    std::vector<NamedPage> own;
    while (next != std::string::npos) {
        const auto end = markdown.find(heading, next + 1);
        std::string one = markdown.substr(next + 1, end == std::string::npos ? end : end - next - 1);
        const auto tick = one.find('`', 5);
        const std::string kind = one.substr(5, tick - 5);
        const std::string label = one.substr(tick + 3, one.find('\n') - tick - 3);
        one.replace(0, one.find('\n'), "# " + label + ": parameters");
        first.append("- [").append(options.say(label)).append("](reference_").append(kind);
        first.append(".md): `").append(kind).append("`\n");
        PageOptions its = options;
        its.scope = kind;
        own.push_back({"reference_" + kind, make_page(one, its), file});
        next = end;
    }
    pages.push_back({"reference", make_page(first, options), file});
    pages.insert(pages.end(), own.begin(), own.end());
}

void check_links(const std::vector<NamedPage>& pages, const fs::path& resources) {
    std::set<std::string> targets;
    for (const NamedPage& p : pages) {
        targets.insert(p.file + ".html");
        for (std::size_t from = 0; (from = p.page.html.find("<a name=\"", from)) != std::string::npos;) {
            from += 9;
            const std::string name = p.page.html.substr(from, p.page.html.find('"', from) - from);
            if (!targets.insert(p.file + ".html#" + name).second)
                throw Error(ErrorCode::syntax, p.file, "two places are called " + name, "rename one");
        }
    }
    for (const NamedPage& p : pages) {
        for (const std::string& link : p.page.links) {
            if (link.find("://") != std::string::npos) continue;
            const std::string to = link.starts_with("#") ? p.file + ".html" + link : link;
            if (!targets.contains(to))
                throw Error(ErrorCode::missing_reference, p.file, "the link " + link + " leads nowhere",
                            "correct it");
        }
        for (std::string picture : p.page.pictures) {
            while (picture.starts_with("../"))
                picture.erase(0, 3);
            const bool drawn = picture.starts_with("drawings/");
            if (!fs::exists(resources
                            / (drawn ? picture : "pictures/manual/" + picture.substr(picture.find('/') + 1))))
                throw Error(ErrorCode::missing_reference, p.file, "there is no " + picture, "make it");
        }
    }
}

/// The page in the language, or the English one.
fs::path source_of(const fs::path& resources, const Words& words, const std::string& name) {
    fs::path own = resources / "manual" / words.language() / (name + ".md");
    if (words.language() != "en" && fs::exists(own)) return own;
    return name == "glossary" ? resources / "glossary.md" : resources / "manual" / (name + ".md");
}

} // namespace

std::vector<NamedPage> manual_pages(const fs::path& resources, const Words& words) {
    {
        std::istringstream table(text_of(resources / "drawings/parameters.txt"));
        for (std::string key, drawing; table >> key >> drawing;)
            drawings()[key] = drawing;
    }
    PageOptions options;
    options.drawing = drawing_of;
    if (words.language() != "en") {
        options.pictures_in = "../";
        for (const std::string& name : own_pictures(resources, words.language()))
            options.own_pictures.insert("pictures/" + name);
    }
    PageOptions of_reference = options;
    of_reference.say = [&](const std::string& english) { return words.of(english); };
    of_reference.measure = [&](const std::string& said) { return words.measure(said); };
    std::vector<NamedPage> pages;
    std::istringstream names(text_of(resources / "manual/contents.txt"));
    for (std::string name; names >> name;) {
        if (name == "reference") {
            add_reference(resources / "reference.md", of_reference, pages);
            continue;
        }
        const fs::path file = source_of(resources, words, name);
        pages.push_back({name, make_page(text_of(file), options), file});
    }
    check_links(pages, resources);
    return pages;
}

std::vector<std::string> own_pictures(const fs::path& resources, const std::string& language) {
    std::vector<std::string> names;
    std::error_code none;
    for (const auto& entry : fs::directory_iterator(resources / "pictures/manual" / language, none))
        if (entry.path().extension() == ".png") names.push_back(entry.path().filename().string());
    std::sort(names.begin(), names.end());
    return names;
}

std::vector<std::string> manual_languages(const fs::path& resources) {
    std::vector<std::string> all;
    for (const auto& entry : fs::directory_iterator(resources / "manual"))
        if (entry.is_directory()) all.push_back(entry.path().filename().string());
    std::sort(all.begin(), all.end());
    return all;
}

} // namespace facetmill::manual
