#include "core/output/post/nc_line.h"

#include "core/base/error.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace facetmill {

namespace {

constexpr long per_code_letter = 1'000'000;

char capital(char c) {
    return c >= 'a' && c <= 'z' ? char(c - 'a' + 'A') : c;
}
bool is_letter(char c) {
    return capital(c) >= 'A' && capital(c) <= 'Z';
}
bool is_figure(char c) {
    return c >= '0' && c <= '9';
}

} // namespace

bool NcLine::has_code(NcCode c) const {
    return std::find(codes.begin(), codes.end(), c) != codes.end();
}

NcLineReader::NcLineReader(const Post& post)
    : parentheses_(post.reads_comment("(")), semicolons_(post.reads_comment(";")),
      bare_numbers_(post.numbers_blocks && post.block_letter.empty()),
      tool_in_comments_(post.word(NcWord::tool).empty()), needs_point_(post.point) {
    word_letter_.fill(-1);
    const auto add_word = [&](const std::string& text, NcWord w) {
        if (text.size() == 1)
            word_letter_[std::size_t(text[0] - 'A')] = int(w);
        else if (!text.empty())
            long_words_[text] = w;
    };
    for (std::size_t i = 0; i < nc_words; ++i)
        add_word(post.words[i], NcWord(i));
    for (const std::string& w : post.ignored_words)
        add_word(w, NcWord::ignored);
    add_word(post.block_letter, NcWord::ignored);
    block_letter_ = post.numbers_blocks ? post.block_letter : std::string();
    for (const std::string& line : post.plane_on) {
        constexpr std::size_t word = std::string_view("{plane_z}").size();
        const std::size_t z = line.find("{plane_z}"), x = line.find("{plane_x}");
        if (z == std::string::npos || x == std::string::npos) continue;
        const std::size_t first = std::min(z, x), second = std::max(z, x);
        z_first_ = z < x;
        plane_on_ = {line.substr(0, first), line.substr(first + word, second - first - word),
                     line.substr(second + word)};
    }
    plane_off_ = post.plane_off;
    for (std::string line : post.wcs_lines) {
        constexpr std::string_view word = "{wcs}";
        line.erase(0, line.find_first_not_of(' '));
        const std::size_t at = line.find(word);
        if (at == std::string::npos)
            wcs_lines_.push_back({line, "", false});
        else
            wcs_lines_.push_back({line.substr(0, at), line.substr(at + word.size()), true});
    }
    for (const auto& [text, meaning] : post.codes) {
        if (text.size() == 1 || is_letter(text[1])) {
            named_[text] = {meaning, &text};
            continue;
        }
        double value = 0;
        std::from_chars(text.data() + 1, text.data() + text.size(), value, std::chars_format::fixed);
        code_letter_[std::size_t(text[0] - 'A')] = true;
        numbered_[long(text[0]) * per_code_letter + std::lround(10 * value)] = {meaning, &text};
    }
}

std::string_view NcLineReader::behind_number(std::string_view line) const {
    std::size_t at = 0;
    if (!block_letter_.empty() && line.starts_with(block_letter_)) at = block_letter_.size();
    if (at == 0 && !bare_numbers_) return line;
    while (at < line.size() && (is_figure(line[at]) || line[at] == ' '))
        ++at;
    return line.substr(at);
}

/// Lines that are understood as a whole: what they hold is no letter with a number, as in CYCLE800(...).
bool NcLineReader::whole_line(std::string_view text, NcLine& into) const {
    while (!text.empty() && text.back() == ' ')
        text.remove_suffix(1);
    return plane_line(text, into) || wcs_line(text, into);
}

bool NcLineReader::wcs_line(std::string_view text, NcLine& into) const {
    for (std::size_t i = 0; i < wcs_lines_.size(); ++i) {
        const WcsLine& line = wcs_lines_[i];
        std::string_view rest = text;
        if (!rest.starts_with(line.before)) continue;
        rest.remove_prefix(line.before.size());
        long number = 0;
        if (line.tells) {
            const auto read = std::from_chars(rest.data(), rest.data() + rest.size(), number);
            if (read.ec != std::errc()) continue;
            rest.remove_prefix(std::size_t(read.ptr - rest.data()));
        }
        if (rest != line.behind) continue;
        into.wcs_line = int(i);
        if (line.tells) into.wcs_number = number;
        return true;
    }
    return false;
}

bool NcLineReader::plane_line(std::string_view text, NcLine& into) const {
    if (plane_off_.empty()) return false;
    if (std::find(plane_off_.begin(), plane_off_.end(), text) != plane_off_.end()) {
        into.plane_off = true;
        return true;
    }
    std::array<double, 2> angles{};
    for (std::size_t k = 0; k < 3; ++k) {
        if (!text.starts_with(plane_on_[k])) return false;
        text.remove_prefix(plane_on_[k].size());
        if (k == 2) break;
        if (!text.empty() && text.front() == '+') text.remove_prefix(1);
        const auto read = std::from_chars(text.data(), text.data() + text.size(),
                                          angles[z_first_ ? k : 1 - k], std::chars_format::fixed);
        if (read.ec != std::errc() || !std::isfinite(angles[z_first_ ? k : 1 - k])) return false;
        text.remove_prefix(std::size_t(read.ptr - text.data()));
    }
    if (!text.empty()) return false;
    into.plane = angles;
    return true;
}

void NcLineReader::fail(const Cursor& c, const std::string& what, const std::string& remedy) {
    throw Error(ErrorCode::syntax, c.file + ":" + std::to_string(c.number), what, remedy);
}

double NcLineReader::number(Cursor& c) {
    const char* first = c.line.data() + c.at;
    const char* end = c.line.data() + c.line.size();
    if (first != end && *first == '+' && first + 1 != end && *(first + 1) != '-') ++first;
    double value = 0;
    const auto read = std::from_chars(first, end, value, std::chars_format::fixed);
    if (read.ec != std::errc() || !std::isfinite(value))
        fail(c, "a number is missing behind '" + printable(c.line.substr(0, c.at)) + "'",
             "write decimal numbers; formulas and variables are not read");
    c.at = std::size_t(read.ptr - c.line.data());
    return value;
}

void NcLineReader::code(const Cursor& c, std::size_t from, const Meaning& meaning, NcLine& into) const {
    if (meaning.code == NcCode::wcs) {
        if (!into.wcs.empty())
            fail(c, "two work coordinate systems in '" + printable(c.line.substr(from)) + "'", "keep one");
        into.wcs = *meaning.text;
    } else if (meaning.code != NcCode::none) {
        into.codes.push_back(meaning.code);
    }
}

void NcLineReader::check_point(const Cursor& c, std::size_t from, NcWord which, double value) const {
    if ((which > NcWord::radius && which != NcWord::feed) || value == 0) return;
    const std::string_view text = c.line.substr(from, c.at - from);
    if (text.find('.') != std::string_view::npos) return;
    fail(c, "'" + printable(text) + "' has no decimal point, and the control would count its last digits",
         "write '" + printable(text) + ".'");
}

void NcLineReader::word(const Cursor& c, std::size_t from, NcWord which, double value, NcLine& into) const {
    if (which == NcWord::ignored) {
        into.read_over = into.read_over || capital(c.line[from]) != 'N';
        return;
    }
    if (needs_point_) check_point(c, from, which, value);
    if (into.has(which))
        fail(c, "'" + printable(c.line.substr(from, c.at - from)) + "' occurs twice", "keep one of them");
    into.value[std::size_t(which)] = value;
    into.given |= 1u << unsigned(which);
}

void NcLineReader::comment(std::string_view text, NcLine& into) const {
    constexpr std::string_view start = "tool ";
    if (!tool_in_comments_ || text.substr(0, start.size()) != start) return;
    long tool = 0;
    const auto read = std::from_chars(text.data() + start.size(), text.data() + text.size(), tool);
    if (read.ec != std::errc()) return;
    into.value[std::size_t(NcWord::tool)] = double(tool);
    into.given |= 1u << unsigned(NcWord::tool);
}

void NcLineReader::named(Cursor& c, std::size_t letters, NcLine& into) const {
    const std::size_t from = c.at;
    std::string name;
    std::size_t end = from;
    while (end < c.line.size() && (is_letter(c.line[end]) || is_figure(c.line[end])))
        name += capital(c.line[end++]);
    if (end < c.line.size() && c.line[end] == '=') {
        const auto known = long_words_.find(name + "=");
        if (known == long_words_.end())
            fail(c, "'" + printable(name) + "=' is no word of this control", "see the words of its post");
        c.at = end + 1;
        word(c, from, known->second, number(c), into);
        return;
    }
    if (end < c.line.size() && (c.line[end] == '+' || c.line[end] == '-'))
        if (const auto known = named_.find(name + c.line[end]); known != named_.end()) {
            c.at = end + 1;
            return code(c, from, known->second, into);
        }
    // "TX+0.5", "CALL 3": letters with a number.
    if (const auto known = long_words_.find(name.substr(0, letters)); known != long_words_.end()) {
        c.at = from + letters;
        while (c.at < c.line.size() && c.line[c.at] == ' ')
            ++c.at;
        word(c, from, known->second, number(c), into);
        return;
    }
    const auto known = named_.find(name);
    if (known == named_.end() || name.size() != letters)
        fail(c, "'" + printable(name) + "' is no code of this control", "see the codes of its post");
    c.at = end;
    code(c, from, known->second, into);
}

void NcLineReader::token(Cursor& c, NcLine& into) const {
    const std::size_t from = c.at;
    if (!is_letter(c.line[from]))
        fail(c, "'" + printable(c.line.substr(from, 12)) + "' cannot be read",
             "write letters with decimal numbers");
    std::size_t letters = 1, end = from + 1;
    while (end < c.line.size() && is_letter(c.line[end]))
        ++end, ++letters;
    std::size_t figures = end;
    while (figures < c.line.size() && is_figure(c.line[figures]))
        ++figures;
    if (letters > 1 || (figures < c.line.size() && c.line[figures] == '=')) {
        named(c, letters, into);
        return;
    }
    const char letter = capital(c.line[from]);
    c.at = from + 1;
    if (c.at == c.line.size() || c.line[c.at] == ' ')
        if (const auto known = named_.find(std::string(1, letter)); known != named_.end())
            return code(c, from, known->second, into);
    const double value = number(c);
    const std::size_t index = std::size_t(letter - 'A');
    if (code_letter_[index]) {
        const double tenths = 10 * value;
        const auto known = std::abs(tenths) < per_code_letter && tenths == std::round(tenths)
                               ? numbered_.find(long(letter) * per_code_letter + std::lround(tenths))
                               : numbered_.end();
        if (known != numbered_.end()) return code(c, from, known->second, into);
    }
    if (word_letter_[index] < 0)
        fail(c, "'" + printable(c.line.substr(from, c.at - from)) + "' is no word of this control",
             "see the words and codes of its post");
    word(c, from, NcWord(word_letter_[index]), value, into);
}

void NcLineReader::read(std::string_view line, NcLine& into, const std::string& file, long number) const {
    into.codes.clear();
    into.wcs = {};
    into.given = 0;
    Cursor c{line, 0, file, number};
    into.plane.reset();
    into.plane_off = into.read_over = false;
    into.wcs_line = -1;
    into.wcs_number.reset();
    while (bare_numbers_ && c.at < line.size() && is_figure(line[c.at]))
        ++c.at;
    if ((!plane_off_.empty() || !wcs_lines_.empty()) && whole_line(behind_number(line), into)) return;
    while (c.at < line.size()) {
        const char ch = line[c.at];
        if (ch == ' ' || ch == '\t') {
            ++c.at;
        } else if (parentheses_ && ch == '(') {
            const std::size_t close = line.find_first_of("()", c.at + 1);
            if (close == std::string_view::npos || line[close] == '(')
                fail(c, "a comment is not closed, or holds another one", "write one ( and one )");
            comment(line.substr(c.at + 1, close - c.at - 1), into);
            c.at = close + 1;
        } else if (semicolons_ && ch == ';') {
            return comment(line.substr(c.at + 1), into);
        } else {
            token(c, into);
        }
    }
}

} // namespace facetmill
