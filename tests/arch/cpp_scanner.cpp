#include "tests/arch/cpp_scanner.h"

#include <algorithm>
#include <cctype>
#include <map>
#include <optional>
#include <set>

namespace facetmill::test {

namespace {

bool word_char(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) || c == '_';
}

/// Walks over a text and blanks what is no code.
class Blanker {
public:
    explicit Blanker(const std::string& text) : text_(text), bare_(text) {}

    std::string run() {
        bool line_begins = true;
        while (at_ < text_.size()) {
            const char c = text_[at_];
            if (c == '\n')
                line_begins = true;
            else if (!std::isspace(static_cast<unsigned char>(c)) && !starts("//") && !starts("/*")) {
                if (c == '#' && line_begins) {
                    preprocessor_line();
                    continue;
                }
                line_begins = false;
            }
            if (starts("//"))
                blank_to(end_of_line());
            else if (starts("/*"))
                blank_to(after("*/", at_ + 2));
            else if (c == '"')
                blank_to(raw() ? end_of_raw() : end_of_literal());
            else if (c == '\'' && !digit_separator())
                blank_to(end_of_literal());
            else
                ++at_;
        }
        return bare_;
    }

private:
    bool starts(const char* what) const { return text_.compare(at_, 2, what) == 0; }

    void blank_to(std::size_t end) {
        for (; at_ < end; ++at_)
            if (text_[at_] != '\n') bare_[at_] = ' ';
    }

    std::size_t after(const std::string& what, std::size_t from) const {
        const auto found = text_.find(what, from);
        return found == std::string::npos ? text_.size() : found + what.size();
    }

    /// End of this line; a backslash before it takes the next line along.
    std::size_t end_of_line() const {
        std::size_t i = at_;
        while (i < text_.size() && (text_[i] != '\n' || text_[i - 1] == '\\'))
            ++i;
        return i;
    }

    /// Blanks a directive; a comment that begins on it may go on behind it.
    void preprocessor_line() {
        const auto end = end_of_line();
        const auto comment = text_.find("/*", at_);
        blank_to(comment < end ? after("*/", comment + 2) : end);
    }

    std::size_t end_of_literal() const {
        std::size_t i = at_ + 1;
        while (i < text_.size() && text_[i] != text_[at_] && text_[i] != '\n')
            i += text_[i] == '\\' ? 2 : 1;
        return std::min(i + 1, text_.size());
    }

    /// Whether the prefix before the quote at hand ends in R: R"(...)", u8R"(...)".
    bool raw() const {
        if (at_ == 0 || text_[at_ - 1] != 'R') return false;
        std::size_t from = at_ - 1;
        while (from > 0 && word_char(text_[from - 1]))
            --from;
        static const std::set<std::string> prefixes = {"R", "LR", "uR", "UR", "u8R"};
        return prefixes.count(text_.substr(from, at_ - from)) > 0;
    }

    std::size_t end_of_raw() const {
        const auto open = text_.find('(', at_);
        if (open == std::string::npos) return text_.size();
        return after(")" + text_.substr(at_ + 1, open - at_ - 1) + "\"", open);
    }

    /// 1'000: the word that holds the quote begins with a digit. u8'a' and L'a' do not.
    bool digit_separator() const {
        std::size_t from = at_;
        while (from > 0 && (word_char(text_[from - 1]) || text_[from - 1] == '\''))
            --from;
        return from < at_ && std::isdigit(static_cast<unsigned char>(text_[from]));
    }

    const std::string& text_;
    std::string bare_;
    std::size_t at_ = 0;
};

struct Token {
    std::string text; // a word, "::" or one other character
    int line = 0;
};

std::vector<Token> tokens(const std::string& bare) {
    std::vector<Token> all;
    int line = 1;
    for (std::size_t i = 0; i < bare.size();) {
        const char c = bare[i];
        if (c == '\n') ++line;
        if (std::isspace(static_cast<unsigned char>(c))) {
            ++i;
        } else if (word_char(c)) {
            const std::size_t from = i;
            while (i < bare.size() && (word_char(bare[i]) || bare[i] == '\''))
                ++i;
            all.push_back({bare.substr(from, i - from), line});
        } else if (bare.compare(i, 2, "::") == 0 || bare.compare(i, 2, "->") == 0) {
            all.push_back({bare.substr(i, 2), line});
            i += 2;
        } else {
            all.push_back({std::string(1, c), line});
            ++i;
        }
    }
    return all;
}

using Head = std::vector<Token>;

/// Index behind the bracket that closes the one at `i`.
std::size_t behind(const Head& head, std::size_t i, const char* open, const char* close) {
    int depth = 0;
    for (; i < head.size(); ++i) {
        if (head[i].text == open) ++depth;
        if (head[i].text == close && --depth == 0) return i + 1;
    }
    return i;
}

/// Drops what may stand before a declaration: template<...>, requires (...), attributes, alignas(...), labels
/// such as "public slots:" and Qt's macros in capitals.
Head without_preamble(const Head& head) {
    static const std::set<std::string> labels = {"public", "private", "protected", "slots", "signals"};
    std::size_t i = 0;
    while (i < head.size()) {
        const std::string& t = head[i].text;
        std::size_t label = i;
        while (label < head.size() && labels.count(head[label].text))
            ++label;
        if (label > i && label < head.size() && head[label].text == ":")
            i = label + 1;
        else if (t == "template" && i + 1 < head.size() && head[i + 1].text == "<")
            i = behind(head, i + 1, "<", ">");
        else if (t == "[" || t == "]")
            i = behind(head, i, "[", "]");
        else if ((t == "alignas" || t == "__attribute__" || t == "requires") && i + 1 < head.size()
                 && head[i + 1].text == "(")
            i = behind(head, i + 1, "(", ")");
        else if (t == "Q_OBJECT" || t == "Q_GADGET")
            ++i;
        else
            break;
    }
    return Head(head.begin() + static_cast<std::ptrdiff_t>(i), head.end());
}

/// The words a::b<c>::d that end before `end`, arguments of templates left out; empty when no word stands
/// there.
std::vector<Token> qualified_name(const Head& head, std::size_t end) {
    std::vector<Token> parts;
    std::size_t i = end;
    while (i > 0) {
        if (head[i - 1].text == ">") { // back over the arguments
            int depth = 0;
            do {
                --i;
                depth += head[i].text == ">" ? 1 : head[i].text == "<" ? -1 : 0;
            } while (i > 0 && depth > 0);
            if (i == 0) return {};
        }
        if (!word_char(head[i - 1].text[0])) return {};
        Token part = head[--i];
        if (i > 0 && head[i - 1].text == "~") part.text = "~" + part.text, --i;
        parts.insert(parts.begin(), part);
        if (i == 0 || head[i - 1].text != "::") break;
        --i;
        if (i == 0 || (!word_char(head[i - 1].text[0]) && head[i - 1].text != ">")) break; // ::a
    }
    return parts;
}

struct Opened {
    enum class What { Namespace, Class, Function, Values } what = What::Values;
    std::vector<Token> name; // its parts
};

/// The class a head declares, if it does: `class a::B final : public C`.
std::optional<Opened> as_class(const Head& head) {
    static const std::set<std::string> keys = {"class", "struct", "union"};
    std::size_t i = 0;
    while (i < head.size()
           && (head[i].text == "static" || head[i].text == "const" || head[i].text == "typedef"
               || head[i].text == "inline" || head[i].text == "constexpr"))
        ++i;
    if (i == head.size() || !keys.count(head[i].text)) return std::nullopt;
    std::size_t end = ++i;
    while (end < head.size() && head[end].text != ":" && head[end].text != "final") {
        if (head[end].text == "(" || head[end].text == "=")
            return std::nullopt; // a function that returns struct A
        ++end;
    }
    // One without a name has no words between its keyword and the brace.
    return Opened{Opened::What::Class, end > i ? qualified_name(head, end) : std::vector<Token>{}};
}

/// The function whose body a brace behind `head` opens, if it does.
std::optional<Opened> as_function(const Head& head) {
    std::optional<std::size_t> operator_at, parameters;
    for (std::size_t i = 0; i < head.size() && !parameters; ++i) {
        const std::string& t = head[i].text;
        if (t == "operator") {
            operator_at = i++;
            while (i + 1 < head.size() && head[i + 1].text != "(") // its signs: +=, [], ()
                ++i;
        } else if (t == "=") {
            return std::nullopt; // a value
        } else if (t == "(") {
            const std::string before = i > 0 ? head[i - 1].text : "";
            if (before == "decltype" || before == "explicit" || before == "noexcept" || before == "alignas"
                || before == "__attribute__" || before == "requires")
                i = behind(head, i, "(", ")") - 1;
            else
                parameters = i;
        }
    }
    if (!parameters || *parameters == 0) return std::nullopt;
    Opened function{Opened::What::Function, {}};
    if (operator_at) {
        if (*operator_at >= 2 && head[*operator_at - 1].text == "::")
            function.name = qualified_name(head, *operator_at - 1);
        Token name = head[*operator_at];
        for (std::size_t i = *operator_at + 1; i < *parameters; ++i)
            name.text += (word_char(head[i].text[0]) ? " " : "") + head[i].text;
        function.name.push_back(name);
    } else {
        function.name = qualified_name(head, *parameters);
    }
    if (function.name.empty()) return std::nullopt;
    // In a constructor's list, x_{1} is a value and the body comes behind a closed bracket.
    int depth = 0;
    bool list = false;
    for (std::size_t i = *parameters; i < head.size(); ++i) {
        const std::string& t = head[i].text;
        if (t == "(" || t == "{") ++depth;
        if (t == ")" || t == "}") --depth;
        if (depth == 0 && t == "=") return std::nullopt; // a value of a type with parentheses
        list = list || (depth == 0 && t == ":");
    }
    const std::string& last = head.back().text;
    if (list && last != ")" && last != "}") return std::nullopt;
    return function;
}

Opened opened_by(const Head& raw) {
    const Head head = without_preamble(raw);
    const auto has = [&](const char* word) {
        return std::any_of(head.begin(), head.end(), [&](const Token& t) { return t.text == word; });
    };
    if (head.empty()) return {};
    if (head[0].text == "enum") return {};
    if (head[0].text == "namespace" || (head.size() > 1 && head[1].text == "namespace"))
        return {Opened::What::Namespace,
                head.size() > 1 ? qualified_name(head, head.size()) : std::vector<Token>{}};
    if (head.size() == 1 && head[0].text == "extern") // the "C" is blanked
        return {Opened::What::Namespace, {}};
    if (const auto c = as_class(head)) return *c;
    if (has("(")) {
        if (const auto f = as_function(head)) return *f;
    }
    return {};
}

std::string joined(const std::string& scope, const std::vector<Token>& parts) {
    std::string all = scope;
    for (const auto& p : parts)
        all += (all.empty() ? "" : "::") + p.text;
    return all;
}

class Scanner {
public:
    explicit Scanner(std::vector<Token> all) : tokens_(std::move(all)) {}

    Scan run() {
        for (; at_ < tokens_.size(); ++at_) {
            const std::string& t = tokens_[at_].text;
            if (t == "{" && parentheses_ == 0)
                open();
            else if (t == "}" && parentheses_ == 0)
                close();
            else if (t == ";" && parentheses_ == 0)
                head_.clear();
            else {
                // A brace inside parentheses is a value, and so is what follows in it.
                if (t == "(" || t == "{") ++parentheses_;
                if (t == ")" || t == "}") parentheses_ = std::max(0, parentheses_ - 1);
                head_.push_back(tokens_[at_]);
            }
        }
        scan_.closed = scan_.closed && levels_.empty() && parentheses_ == 0;
        return scan_;
    }

private:
    struct Level {
        Opened::What what;
        Extent extent;
        bool named = true;
    };

    void open() {
        Opened opened = opened_by(head_);
        if (opened.what == Opened::What::Namespace
            || (opened.what == Opened::What::Class && opened.name.empty())) {
            const bool unnamed = opened.name.empty() && opened.what == Opened::What::Namespace;
            push(opened, unnamed && !head_.empty() && head_.back().text == "namespace");
            head_.clear();
        } else if (opened.what == Opened::What::Class) {
            push(opened, false);
            head_.clear();
        } else {
            // A body or values: on to the brace that closes it.
            const int first = opened.name.empty() ? 0 : opened.name.back().line;
            int depth = 0;
            for (; at_ < tokens_.size(); ++at_) {
                if (tokens_[at_].text == "{") ++depth;
                if (tokens_[at_].text == "}" && --depth == 0) break;
            }
            if (at_ == tokens_.size()) {
                scan_.closed = false;
            } else if (opened.what == Opened::What::Function) {
                Extent extent = named(opened, Extent::Kind::Function);
                extent.first = first;
                extent.last = tokens_[at_].line;
                scan_.extents.push_back(extent);
                head_.clear();
            } else {
                head_.push_back({"{", tokens_[at_].line}); // x_{1} of a constructor: its head goes on
                head_.push_back(tokens_[at_]);
            }
        }
    }

    Extent named(const Opened& opened, Extent::Kind kind) const {
        const std::string scope = levels_.empty() ? "" : levels_.back().extent.name;
        auto outer = opened.name;
        if (!outer.empty()) outer.pop_back();
        Extent extent;
        extent.kind = kind;
        extent.name = joined(scope, opened.name);
        extent.scope = joined(scope, outer);
        extent.hidden = !levels_.empty() && levels_.back().extent.hidden;
        extent.first = opened.name.empty() ? tokens_[at_].line : opened.name.back().line;
        return extent;
    }

    void push(const Opened& opened, bool hides) {
        Level level{opened.what, named(opened, Extent::Kind::Class), !opened.name.empty()};
        level.extent.hidden = level.extent.hidden || hides;
        levels_.push_back(level);
    }

    void close() {
        head_.clear();
        if (levels_.empty()) {
            scan_.closed = false;
            return;
        }
        Level level = levels_.back();
        levels_.pop_back();
        level.extent.last = tokens_[at_].line;
        if (level.what == Opened::What::Class && level.named) scan_.extents.push_back(level.extent);
    }

    std::vector<Token> tokens_;
    std::size_t at_ = 0;
    int parentheses_ = 0;
    Head head_; // what stands before the token at hand, since the last declaration ended
    std::vector<Level> levels_;
    Scan scan_;
};

} // namespace

std::string bare_code(const std::string& text) {
    return Blanker(text).run();
}

Scan scan_cpp(const std::string& text) {
    return Scanner(tokens(bare_code(text))).run();
}

std::vector<ClassSize> class_sizes(const std::vector<std::pair<std::string, Scan>>& scans) {
    std::vector<ClassSize> sizes;
    std::map<std::pair<std::string, std::string>, std::size_t> known; // file (hidden ones only) and name
    for (const auto& [file, scan] : scans)
        for (const auto& e : scan.extents)
            if (e.kind == Extent::Kind::Class) {
                known[{e.hidden ? file : "", e.name}] = sizes.size();
                sizes.push_back({e.name, file, e.lines()});
            }
    // A member inside the declaration is counted with it.
    const auto inside = [](const Scan& scan, const Extent& function) {
        return std::any_of(scan.extents.begin(), scan.extents.end(), [&](const Extent& e) {
            return e.kind == Extent::Kind::Class && e.name == function.scope && e.first <= function.first
                   && function.last <= e.last;
        });
    };
    for (const auto& [file, scan] : scans)
        for (const auto& e : scan.extents) {
            if (e.kind != Extent::Kind::Function || inside(scan, e)) continue;
            auto owner = known.find({file, e.scope});
            if (owner == known.end()) owner = known.find({"", e.scope});
            if (owner != known.end()) sizes[owner->second].lines += e.lines();
        }
    return sizes;
}

} // namespace facetmill::test
