// The Markdown of the manual as HTML that a browser shows and Qt's rich text, too: headings, paragraphs,
// lists, tables, code, links and pictures, and nothing else.
#pragma once

#include <functional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace facetmill::manual {

/// A heading and what stands below it, for the table of contents and the search.
struct Section {
    std::string anchor; ///< empty: the page itself
    std::string title;  ///< plain text
    std::string text;   ///< plain text up to the next heading
    int level = 1;      ///< 1 a page, 2 and 3 its headings, 4 a parameter
};

struct Page {
    std::string html; ///< of the body
    std::vector<Section> sections;
    std::vector<std::string> links;    ///< as they stand in the HTML
    std::vector<std::string> pictures; ///< likewise
};

/// What the words of a parameter's drawing are looked up by: returns its file, or an empty text. `scope` is
/// the kind of an operation or a section of the reference.
using DrawingOf = std::string (*)(const std::string& scope, const std::string& key);

struct PageOptions {
    /// What the anchors of a page begin with that is all of one operation; empty: that of the heading.
    std::string scope;
    DrawingOf drawing = nullptr;
    /// What a text that stands in English is to say on the page: a paragraph, a title, a cell of a table.
    /// Anchors stay those of the English words.
    std::function<std::string(const std::string&)> say = [](const std::string& text) { return text; };
    /// The same for numbers with their units: "0.5 rpm".
    std::function<std::string(const std::string&)> measure = [](const std::string& text) { return text; };
    std::string pictures_in; ///< "../": what the folders of pictures and drawings stand in, from the page
    /// Pictures in the page's own language, which stand beside it: "pictures/start.png".
    std::set<std::string> own_pictures = {};
};

/// Links to FILE.md lead to FILE.html in the same folder, pictures to the folder they stand in. Tables of
/// parameters as the reference page has them become entries, each with an anchor SCOPE-KEY and its drawing.
Page make_page(std::string_view markdown, const PageOptions& options);

/// A name in small letters, digits and underscores.
std::string slug(std::string_view title);
std::string escaped(std::string_view text);

} // namespace facetmill::manual
