#include "app/manual/markdown.h"

#include <algorithm>
#include <cctype>
#include <set>
#include <sstream>
#include <utility>

namespace facetmill::manual {

namespace {

std::string trimmed(std::string_view s) {
    while (!s.empty() && std::isspace(static_cast<unsigned char>(s.front())))
        s.remove_prefix(1);
    while (!s.empty() && std::isspace(static_cast<unsigned char>(s.back())))
        s.remove_suffix(1);
    return std::string(s);
}

/// "dir/a.md#b" as "a.html#b"; addresses of elsewhere stay.
std::string page_link(const std::string& link) {
    if (link.find("://") != std::string::npos || link.starts_with("#")) return link;
    const auto hash = link.find('#');
    std::string file = link.substr(0, hash);
    const std::string rest = hash == std::string::npos ? std::string() : link.substr(hash);
    if (const auto slash = file.rfind('/'); slash != std::string::npos) file = file.substr(slash + 1);
    if (file.ends_with(".md")) file = file.substr(0, file.size() - 3) + ".html";
    return file + rest;
}

/// "../pictures/manual/a.png" as "pictures/a.png": pages stand beside two folders.
std::string picture_link(const std::string& link) {
    const auto slash = link.rfind('/');
    const std::string file = slash == std::string::npos ? link : link.substr(slash + 1);
    return (file.ends_with(".svg") ? "drawings/" : "pictures/") + file;
}

/// Where a bracketed text and the address behind it stand: "[text](address)" from `at`.
struct Reference {
    std::string text, address;
    std::size_t end = 0;
};

bool read_reference(std::string_view line, std::size_t at, Reference& found) {
    const auto close = line.find("](", at);
    if (close == std::string_view::npos) return false;
    const auto end = line.find(')', close);
    if (end == std::string_view::npos) return false;
    found = {std::string(line.substr(at + 1, close - at - 1)),
             std::string(line.substr(close + 2, end - close - 2)), end + 1};
    return true;
}

/// Cells of "| a | b |"; a bar behind a backslash belongs to its cell.
std::vector<std::string> cells_of(std::string_view line) {
    std::vector<std::string> cells;
    std::string cell;
    for (std::size_t i = 1; i < line.size(); ++i) {
        if (line[i] == '\\' && i + 1 < line.size() && line[i + 1] == '|')
            cell += line[++i];
        else if (line[i] == '|')
            cells.push_back(trimmed(std::exchange(cell, {})));
        else
            cell += line[i];
    }
    return cells;
}

/// What titles begin with that stand over the keys of a list's entries.
constexpr std::string_view record_title = "Each of";

std::string without_ticks(const std::string& s) {
    return s.size() > 1 && s.front() == '`' && s.back() == '`' ? s.substr(1, s.size() - 2) : s;
}

/// "a" of "`a`, `b` and others": the same in every language.
std::string first_code(const std::string& cell) {
    return cell.substr(1, cell.find('`', 1) - 1);
}

class PageMaker {
public:
    explicit PageMaker(const PageOptions& options) : options_(options), fixed_scope_(options.scope) {}

    Page make(std::string_view markdown) {
        std::istringstream in{std::string(markdown)};
        for (std::string line; std::getline(in, line);)
            lines_.push_back(line);
        while (at_ < lines_.size())
            block();
        return std::move(page_);
    }

private:
    std::string inline_html(std::string_view text) {
        std::string html;
        bool bold = false, italic = false;
        for (std::size_t i = 0; i < text.size();) {
            Reference r;
            if (text[i] == '`') {
                const auto end = std::min(text.find('`', i + 1), text.size() - 1);
                const std::string_view code = text.substr(i + 1, end - i - 1);
                html += "<code>" + escaped(code) + "</code>";
                plain_ += code;
                i = end + 1;
            } else if (text.substr(i, 2) == "![" && read_reference(text, i + 1, r)) {
                const std::string file = picture_link(r.address);
                html += picture(r.text,
                                (options_.own_pictures.contains(file) ? "" : options_.pictures_in) + file);
                i = r.end;
            } else if (text[i] == '[' && read_reference(text, i, r)) {
                const std::string to = page_link(r.address);
                page_.links.push_back(to);
                html += "<a href=\"" + to + "\">" + inline_html(r.text) + "</a>";
                i = r.end;
            } else if (text.substr(i, 2) == "**") {
                html += (bold = !bold) ? "<b>" : "</b>";
                i += 2;
            } else if (text[i] == '*') {
                html += (italic = !italic) ? "<i>" : "</i>";
                ++i;
            } else {
                if (text[i] == '\\' && i + 1 < text.size()) ++i;
                html += escaped(text.substr(i, 1));
                plain_ += text[i++];
            }
        }
        return html;
    }

    std::string picture(const std::string& what, const std::string& file) {
        page_.pictures.push_back(file);
        return "<img src=\"" + file + "\" alt=\"" + escaped(what) + "\">";
    }

    void end_section() {
        if (!page_.sections.empty()) page_.sections.back().text = trimmed(plain_);
        plain_.clear();
    }

    /// Of what stands in `html`, whose words are in `plain_`.
    void begin_section(int level, const std::string& anchor, const std::string& title) {
        plain_.clear();
        page_.sections.push_back({level == 1 ? std::string() : anchor, trimmed(title), {}, level});
    }

    void heading(const std::string& line) {
        const auto level = line.find_first_not_of('#');
        end_section();
        // "## Clean-up <!-- cleanup -->": what links call it.
        const auto named = line.find("<!--"), end = line.find("-->");
        const std::string text =
            trimmed(std::string_view(line).substr(level, named == std::string::npos ? named : named - level));
        (void)inline_html(text);
        const std::string title = trimmed(std::exchange(plain_, {}));
        const bool record = title.starts_with(record_title); // a list of the parameters above it
        const std::string html =
            inline_html(record ? options_.say(std::string(record_title)) + text.substr(record_title.size())
                               : options_.say(text));
        const std::string name = named == std::string::npos || end == std::string::npos
                                     ? slug(title)
                                     : trimmed(std::string_view(line).substr(named + 4, end - named - 4));
        const std::string tag = "h" + std::to_string(level);
        page_.html +=
            "<" + tag + "><a name=\"" + name + "\" id=\"" + name + "\"></a>" + html + "</" + tag + ">\n";
        record_ = record ? title.substr(record_title.size() + 1) + "-" : std::string();
        if (fixed_scope_.empty() && !record) scope_ = name;
        begin_section(int(std::min<std::size_t>(level, 3)), name, std::string(plain_));
    }

    std::string anchor_of(const std::string& key) const {
        return (fixed_scope_.empty() ? scope_ : fixed_scope_) + "-" + record_ + key;
    }

    /// A row of a table of parameters: key, meaning, value, unit, range, default.
    void parameter(const std::vector<std::string>& row) {
        const std::string key = without_ticks(row[0]), anchor = anchor_of(key);
        const auto end = row[1].find(".** ");
        const std::string label = options_.say(row[1].substr(2, end - 2)),
                          help = options_.say(row[1].substr(end + 4));
        end_section();
        begin_section(4, anchor, label);
        page_.html += "<h4><a name=\"" + anchor + "\" id=\"" + anchor + "\"></a>" + escaped(label) + " <code>"
                      + escaped(key) + "</code></h4>\n";
        plain_ = key + " ";
        const std::string drawing =
            options_.drawing ? options_.drawing(fixed_scope_.empty() ? scope_ : fixed_scope_, record_ + key)
                             : std::string();
        if (!drawing.empty())
            page_.html +=
                "<p>" + picture(label, options_.pictures_in + "drawings/" + drawing + ".svg") + "</p>\n";
        page_.html += "<p>" + inline_html(help) + "</p>\n";
        std::string facts = inline_html(options_.say(row[2]));
        if (!row[3].empty()) facts += ", " + inline_html(options_.measure(row[3]));
        if (!row[4].empty()) facts += " · " + options_.say("range") + ' ' + inline_html(measured(row[4]));
        if (!row[5].empty()) facts += " · " + options_.say("default") + ' ' + inline_html(measured(row[5]));
        page_.html += "<p class=\"facts\">" + facts + "</p>\n";
    }

    void table() {
        const std::vector<std::string> head = cells_of(lines_[at_++]);
        ++at_; // the line below it
        const bool parameters = head.size() == 6 && head[0] == "key";
        if (!parameters) {
            page_.html += "<table>\n<tr>";
            for (const std::string& cell : head)
                page_.html += "<th>" + inline_html(options_.say(cell)) + "</th>";
            page_.html += "</tr>\n";
        }
        for (; at_ < lines_.size() && lines_[at_].starts_with("|"); ++at_) {
            std::vector<std::string> row = cells_of(lines_[at_]);
            row.resize(head.size());
            if (parameters) {
                parameter(row);
                continue;
            }
            page_.html += "<tr>";
            for (std::size_t i = 0; i < row.size(); ++i) {
                std::string name;
                if (i == 0 && row[i].starts_with("`")) {
                    const std::string anchor = anchor_of(first_code(row[i]));
                    if (names_.insert(anchor).second) { // several rows may tell of one thing
                        name.append("<a name=\"")
                            .append(anchor)
                            .append("\" id=\"")
                            .append(anchor)
                            .append("\"></a>");
                        end_section();
                        begin_section(4, anchor, label_of(row));
                    }
                }
                page_.html += "<td>" + name + inline_html(said_cell(row[i])) + "</td>";
                plain_ += ' ';
            }
            page_.html += "</tr>\n";
        }
        if (!parameters) page_.html += "</table>\n";
    }

    /// "**Label.** Text" beside a key, or the key.
    std::string label_of(const std::vector<std::string>& row) const {
        const auto end = row.size() > 1 && row[1].starts_with("**") ? row[1].find(".**") : std::string::npos;
        return end == std::string::npos ? without_ticks(row[0]) : options_.say(row[1].substr(2, end - 2));
    }

    std::string measured(const std::string& cell) const { return options_.measure(options_.say(cell)); }

    std::string said_cell(const std::string& cell) const {
        const auto end = cell.starts_with("**") ? cell.find(".** ") : std::string::npos;
        const bool number = cell.find_first_of("0123456789") == (cell.starts_with("-") ? 1 : 0);
        if (end == std::string::npos) return number ? measured(cell) : options_.say(cell);
        return "**" + options_.say(cell.substr(2, end - 2)) + ".** " + options_.say(cell.substr(end + 4));
    }

    static bool is_item(const std::string& line, bool& ordered) {
        std::size_t digits = 0;
        while (digits < line.size() && std::isdigit(static_cast<unsigned char>(line[digits])))
            ++digits;
        ordered = digits > 0 && std::string_view(line).substr(digits).starts_with(". ");
        return ordered || line.starts_with("- ");
    }

    /// Items with what is indented below them: more text, or a picture in a line of its own.
    void list(bool ordered) {
        const std::string tag = ordered ? "ol" : "ul";
        page_.html += "<" + tag + ">\n";
        bool same = ordered;
        while (at_ < lines_.size() && is_item(lines_[at_], same) && same == ordered) {
            std::vector<std::string> paragraphs{lines_[at_].substr(ordered ? lines_[at_].find(". ") + 2 : 2)};
            for (++at_; at_ < lines_.size(); ++at_) {
                const std::string& line = lines_[at_];
                const bool blank = trimmed(line).empty();
                if (blank && at_ + 1 < lines_.size() && lines_[at_ + 1].starts_with("  "))
                    paragraphs.emplace_back();
                else if (!line.starts_with("  "))
                    break;
                else
                    paragraphs.back() += (paragraphs.back().empty() ? "" : " ") + trimmed(line);
            }
            while (at_ < lines_.size() && trimmed(lines_[at_]).empty() && at_ + 1 < lines_.size()
                   && is_item(lines_[at_ + 1], same) && same == ordered)
                ++at_;
            page_.html += "<li>";
            for (std::size_t i = 0; i < paragraphs.size(); ++i) {
                if (i > 0) page_.html += "<br>";
                // A link has the title of its page.
                const bool link = paragraphs[i].starts_with("[");
                page_.html += inline_html(link ? paragraphs[i] : options_.say(paragraphs[i]));
                plain_ += ' ';
            }
            page_.html += "</li>\n";
        }
        page_.html += "</" + tag + ">\n";
    }

    void code() {
        page_.html += "<pre>";
        std::size_t blank = 0;
        for (; at_ < lines_.size() && (lines_[at_].starts_with("    ") || trimmed(lines_[at_]).empty());
             ++at_) {
            if (trimmed(lines_[at_]).empty()) {
                ++blank;
                continue;
            }
            page_.html += std::string(std::exchange(blank, 0), '\n')
                          + escaped(std::string_view(lines_[at_]).substr(4)) + "\n";
            plain_ += lines_[at_] + " ";
        }
        page_.html += "</pre>\n";
    }

    void block() {
        const std::string& line = lines_[at_];
        bool ordered = false;
        if (trimmed(line).empty()) {
            ++at_;
        } else if (line.starts_with("#")) {
            heading(line);
            ++at_;
        } else if (line.starts_with("|")) {
            table();
        } else if (line.starts_with("    ")) {
            code();
        } else if (is_item(line, ordered)) {
            list(ordered);
        } else {
            std::string text;
            for (; at_ < lines_.size() && !trimmed(lines_[at_]).empty() && !is_item(lines_[at_], ordered)
                   && !lines_[at_].starts_with("#") && !lines_[at_].starts_with("|");
                 ++at_)
                text += (text.empty() ? "" : " ") + trimmed(lines_[at_]);
            page_.html += "<p>" + inline_html(options_.say(text)) + "</p>\n";
            plain_ += ' ';
        }
        if (at_ >= lines_.size()) end_section();
    }

    const PageOptions& options_;
    std::string fixed_scope_;
    std::vector<std::string> lines_;
    std::size_t at_ = 0;
    std::set<std::string> names_;
    Page page_;
    std::string plain_, scope_, record_;
};

} // namespace

std::string slug(std::string_view title) {
    std::string name;
    for (const char c : title) {
        if (std::isalnum(static_cast<unsigned char>(c)) || c == '_')
            name += char(std::tolower(static_cast<unsigned char>(c)));
        else if (!name.empty() && name.back() != '_' && (c == ' ' || c == '-'))
            name += '_';
    }
    while (name.ends_with("_"))
        name.pop_back();
    return name;
}

std::string escaped(std::string_view text) {
    std::string result;
    for (const char c : text) {
        if (c == '<')
            result += "&lt;";
        else if (c == '>')
            result += "&gt;";
        else if (c == '&')
            result += "&amp;";
        else if (c == '"')
            result += "&quot;";
        else
            result += c;
    }
    return result;
}

Page make_page(std::string_view markdown, const PageOptions& options) {
    return PageMaker(options).make(markdown);
}

} // namespace facetmill::manual
