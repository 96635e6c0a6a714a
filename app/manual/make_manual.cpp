// make_manual RESOURCES FOLDER: the pages of the manual in all its languages, with their pictures; what the
// workbench shows and what is installed. English stands in FOLDER, others in a folder of their own in it.
// make_manual RESOURCES --missing: texts of the reference that stand in English for want of a translation.
#include "app/manual/pages.h"
#include "core/base/file.h"

#include <algorithm>
#include <cstdio>
#include <exception>
#include <string_view>

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

std::string href(const NamedPage& page, const Section& section) {
    return page.file + ".html" + (section.anchor.empty() ? "" : "#" + section.anchor);
}

std::string contents_list(const std::vector<NamedPage>& pages, const Words& words) {
    std::string html = "<h1>" + words.of("Facetmill: manual") + "</h1>\n<ul>\n";
    for (const NamedPage& p : pages) {
        html +=
            "<li><a href=\"" + p.file + ".html\">" + escaped(p.page.sections.front().title) + "</a></li>\n";
    }
    return html + "</ul>\n";
}

/// From the English contents to those of the other languages, for who reads the manual without the workbench.
std::string other_languages(const fs::path& resources) {
    std::string links;
    for (const std::string& language : manual_languages(resources)) {
        if (!links.empty()) links += " · ";
        links.append("<a href=\"").append(language).append("/index.html\">");
        links.append(Words(resources, language).of("English")).append("</a>");
    }
    return "<p class=\"foot\">" + links + "</p>\n";
}

std::string whole_page(const std::string& title, const std::string& body, const std::string& foot,
                       const std::string& language) {
    return "<!DOCTYPE html>\n<html lang=\"" + language
           + "\"><head><meta charset=\"utf-8\">\n"
             "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>"
           + escaped(title) + " – Facetmill</title>\n<link rel=\"stylesheet\" type=\"text/css\" href=\""
           + (language == "en" ? "" : "../") + "style.css\">\n</head><body>\n" + body + foot
           + "</body></html>\n";
}

/// Links to the neighbours of a page.
std::string foot_of(const std::vector<NamedPage>& pages, std::size_t i, const Words& words) {
    std::string foot = "<hr><p class=\"foot\"><a href=\"index.html\">" + words.of("Contents") + "</a>";
    if (i > 0)
        foot += " · " + words.of("before:") + " <a href=\"" + pages[i - 1].file + ".html\">"
                + escaped(pages[i - 1].page.sections.front().title) + "</a>";
    if (i + 1 < pages.size())
        foot += " · " + words.of("next:") + " <a href=\"" + pages[i + 1].file + ".html\">"
                + escaped(pages[i + 1].page.sections.front().title) + "</a>";
    return foot + "</p>\n";
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

/// The pages of a language, their contents and what the search looks in: returns their files.
std::vector<std::string> write_pages(const fs::path& resources, const fs::path& folder, const Words& words) {
    const std::string in = words.language() == "en" ? std::string() : words.language() + "/";
    fs::create_directories(folder / in);
    const std::vector<NamedPage> pages = manual_pages(resources, words);
    std::vector<std::string> files;
    const auto put = [&](const std::string& name, const std::string& bytes) {
        write(folder / (in + name), bytes);
        files.push_back(in + name);
    };
    std::string index;
    for (std::size_t i = 0; i < pages.size(); ++i) {
        const NamedPage& p = pages[i];
        const std::string title = p.page.sections.front().title;
        put(p.file + ".html", whole_page(title, p.page.html, foot_of(pages, i, words), words.language()));
        for (const Section& s : p.page.sections)
            index += href(p, s) + "\t" + std::to_string(s.level) + "\t" + s.title + "\t" + s.text + "\n";
    }
    put("index.html", whole_page(words.of("Manual"), contents_list(pages, words),
                                 in.empty() ? other_languages(resources) : std::string(), words.language()));
    put("index.tsv", index);
    return files;
}

void make(const fs::path& resources, const fs::path& folder) {
    const fs::path sources = resources / "manual";
    fs::create_directories(folder);
    std::vector<std::string> files =
        copy_folder(resources / "drawings", folder / "drawings", ".svg", text_of(sources / "drawing.css"));
    const auto add = [&](const std::vector<std::string>& more) {
        files.insert(files.end(), more.begin(), more.end());
    };
    add(copy_folder(resources / "pictures/manual", folder / "pictures", ".png", {}));
    add(write_pages(resources, folder, Words()));
    for (const std::string& language : manual_languages(resources)) {
        add(write_pages(resources, folder, Words(resources, language)));
        fs::create_directories(folder / language / "pictures");
        for (const std::string& name : own_pictures(resources, language)) {
            const std::string file = language + "/pictures/" + name;
            write(folder / file, text_of(resources / "pictures/manual" / language / name));
            files.push_back(file);
        }
    }
    write(folder / "style.css", text_of(sources / "style.css"));
    std::string qrc = "<RCC><qresource prefix=\"/manual\">\n";
    // The workbench gives the drawings colours of its own.
    for (const std::string& name : files)
        qrc += name.starts_with("drawings/")
                   ? "<file alias=\"" + name + "\">" + (resources / name).string() + "</file>\n"
                   : "<file>" + name + "</file>\n";
    for (const std::string name : {"drawings/parameters.txt", "manual/window.css"})
        qrc += "<file alias=\"" + name.substr(name.find('/') + 1) + "\">" + (resources / name).string()
               + "</file>\n";
    write(folder / "manual.qrc", qrc + "</qresource></RCC>\n");
}

/// What words.txt of a language is to say and does not, a text a line.
void list_missing(const fs::path& resources) {
    for (const std::string& language : manual_languages(resources)) {
        const Words words(resources, language);
        (void)manual_pages(resources, words);
        for (const std::string& text : words.missing())
            std::printf("%s: %s\n", language.c_str(), text.c_str());
    }
}

} // namespace

int main(int argc, char** argv) {
    if (argc != 3) {
        std::fprintf(stderr, "use: make_manual RESOURCES FOLDER, or make_manual RESOURCES --missing\n");
        return 2;
    }
    try {
        if (std::string_view(argv[2]) == "--missing")
            list_missing(argv[1]);
        else
            make(argv[1], argv[2]);
        return 0;
    } catch (const std::exception& e) {
        std::fprintf(stderr, "make_manual: %s\n", e.what());
        return 1;
    }
}
