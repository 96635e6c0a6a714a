// make_manual RESOURCES FOLDER: the pages of the manual, from resources/manual, the glossary and the
// reference of parameters, with their pictures; what the workbench shows and what is installed. A link, a
// picture or a parameter's drawing that leads nowhere is an error.
#include "app/manual/markdown.h"
#include "core/base/file.h"

#include <cstdio>
#include <fstream>
#include <map>
#include <set>
#include <sstream>

namespace {

using namespace facetmill;
using namespace facetmill::manual;
namespace fs = std::filesystem;

std::string text_of(const fs::path& file) {
    const InputFile in(file);
    return std::string(in.bytes());
}

/// A file whose bytes are the same stays untouched: what is built of it need not be built again.
void write(const fs::path& file, const std::string& bytes) {
    if (fs::exists(file)
        && (bytes.empty() ? fs::file_size(file) == 0
                          : fs::file_size(file) == bytes.size() && text_of(file) == bytes))
        return;
    OutputFile out(file);
    out.write(bytes);
    out.commit();
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

struct NamedPage {
    std::string file; ///< without ".html"
    Page page;
};

/// Everything but the operations as one page, and a page for each operation.
void add_reference(const std::string& markdown, std::vector<NamedPage>& pages) {
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
        first += "- [" + label + "](reference_" + kind + ".md): `" + kind + "`\n";
        own.push_back({"reference_" + kind, make_page(one, kind, drawing_of)});
        next = end;
    }
    pages.push_back({"reference", make_page(first, {}, drawing_of)});
    pages.insert(pages.end(), own.begin(), own.end());
}

std::string href(const NamedPage& page, const Section& section) {
    return page.file + ".html" + (section.anchor.empty() ? "" : "#" + section.anchor);
}

std::string contents_list(const std::vector<NamedPage>& pages) {
    std::string html = "<h1>Facetmill: manual</h1>\n<ul>\n";
    for (const NamedPage& p : pages) {
        html +=
            "<li><a href=\"" + p.file + ".html\">" + escaped(p.page.sections.front().title) + "</a></li>\n";
    }
    return html + "</ul>\n";
}

std::string whole_page(const std::string& title, const std::string& body, const std::string& foot) {
    return "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">\n"
           "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>"
           + escaped(title)
           + " – Facetmill</title>\n<link rel=\"stylesheet\" type=\"text/css\" href=\"style.css\">\n"
           + "</head><body>\n" + body + foot + "</body></html>\n";
}

/// Links to the neighbours of a page.
std::string foot_of(const std::vector<NamedPage>& pages, std::size_t i) {
    std::string foot = "<hr><p class=\"foot\"><a href=\"index.html\">Contents</a>";
    if (i > 0)
        foot += " · before: <a href=\"" + pages[i - 1].file + ".html\">"
                + escaped(pages[i - 1].page.sections.front().title) + "</a>";
    if (i + 1 < pages.size())
        foot += " · next: <a href=\"" + pages[i + 1].file + ".html\">"
                + escaped(pages[i + 1].page.sections.front().title) + "</a>";
    return foot + "</p>\n";
}

void check_links(const std::vector<NamedPage>& pages, const fs::path& folder) {
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
        for (const std::string& picture : p.page.pictures)
            if (!fs::exists(folder / picture))
                throw Error(ErrorCode::missing_reference, p.file, "there is no " + picture, "make it");
    }
}

/// A drawing for browsers: its words for colours become those of `style`, which knows light and dark.
std::string styled(std::string svg, const std::string& style) {
    const auto end = svg.find('>', svg.find("<svg"));
    return svg.insert(end + 1, "<style>" + style + "</style>");
}

std::vector<std::string> copy_folder(const fs::path& from, const fs::path& to, const std::string& extension,
                                     const std::string& style) {
    fs::create_directories(to);
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(from))
        if (entry.path().extension() == extension) {
            const std::string name = entry.path().filename().string();
            write(to / name, style.empty() ? text_of(entry.path()) : styled(text_of(entry.path()), style));
            names.push_back(to.filename().string() + "/" + name);
        }
    std::sort(names.begin(), names.end());
    return names;
}

void make(const fs::path& resources, const fs::path& folder) {
    const fs::path sources = resources / "manual";
    {
        std::istringstream table(text_of(resources / "drawings/parameters.txt"));
        for (std::string key, drawing; table >> key >> drawing;)
            drawings()[key] = drawing;
    }
    fs::create_directories(folder);
    std::vector<std::string> files =
        copy_folder(resources / "drawings", folder / "drawings", ".svg", text_of(sources / "drawing.css"));
    for (const std::string& name :
         copy_folder(resources / "pictures/manual", folder / "pictures", ".png", {}))
        files.push_back(name);

    std::vector<NamedPage> pages;
    std::istringstream names(text_of(sources / "contents.txt"));
    for (std::string name; names >> name;) {
        if (name == "reference") {
            add_reference(text_of(resources / "reference.md"), pages);
            continue;
        }
        const fs::path file = name == "glossary" ? resources / "glossary.md" : sources / (name + ".md");
        pages.push_back({name, make_page(text_of(file), {}, nullptr)});
    }
    check_links(pages, folder);

    std::string index;
    for (std::size_t i = 0; i < pages.size(); ++i) {
        const NamedPage& p = pages[i];
        const std::string title = p.page.sections.front().title;
        write(folder / (p.file + ".html"), whole_page(title, p.page.html, foot_of(pages, i)));
        files.push_back(p.file + ".html");
        for (const Section& s : p.page.sections)
            index += href(p, s) + "\t" + std::to_string(s.level) + "\t" + s.title + "\t" + s.text + "\n";
    }
    write(folder / "index.html", whole_page("Manual", contents_list(pages), {}));
    write(folder / "style.css", text_of(sources / "style.css"));
    write(folder / "index.tsv", index);
    std::string qrc = "<RCC><qresource prefix=\"/manual\">\n";
    // The workbench gives the drawings colours of its own.
    for (const std::string& name : files)
        qrc += name.starts_with("drawings/")
                   ? "<file alias=\"" + name + "\">" + (resources / name).string() + "</file>\n"
                   : "<file>" + name + "</file>\n";
    for (const std::string name : {"drawings/parameters.txt", "manual/window.css"})
        qrc += "<file alias=\"" + name.substr(name.find('/') + 1) + "\">" + (resources / name).string()
               + "</file>\n";
    qrc += "<file>index.html</file><file>index.tsv</file>\n</qresource></RCC>\n";
    write(folder / "manual.qrc", qrc);
}

} // namespace

int main(int argc, char** argv) {
    if (argc != 3) {
        std::fprintf(stderr, "use: make_manual RESOURCES FOLDER\n");
        return 2;
    }
    try {
        make(argv[1], argv[2]);
        return 0;
    } catch (const std::exception& e) {
        std::fprintf(stderr, "make_manual: %s\n", e.what());
        return 1;
    }
}
