#include "core/output/apt_text.h"

#include <algorithm>
#include <array>

namespace facetmill::detail {

namespace {

char upper(char c) {
    return c >= 'a' && c <= 'z' ? char(c - 'a' + 'A') : c;
}

/// The rest of these is text, in which '$' and '/' mean nothing.
constexpr std::array<std::string_view, 7> text_words = {"PARTNO", "PPRINT", "TPRINT", "INSERT",
                                                        "LETTER", "REMARK", "NOTE"};

} // namespace

std::string upper(std::string_view s) {
    std::string out(s);
    for (char& c : out)
        c = upper(c);
    return out;
}

bool starts_with_word(std::string_view line, std::string_view word) {
    if (line.size() < word.size()) return false;
    for (std::size_t i = 0; i < word.size(); ++i)
        if (upper(line[i]) != word[i]) return false;
    return line.size() == word.size() || !std::isalnum(static_cast<unsigned char>(line[word.size()]));
}

bool is_text_word(std::string_view word) {
    return std::find(text_words.begin(), text_words.end(), word) != text_words.end();
}

AptText::AptText(std::string_view bytes, std::string name) : bytes_(bytes), name_(std::move(name)) {
    const auto starts = [&](std::string_view bom) { return bytes_.substr(0, bom.size()) == bom; };
    if (starts("\xFF\xFE") || starts("\xFE\xFF")
        || bytes_.substr(0, 4096).find('\0') != std::string_view::npos)
        fail(ErrorCode::encoding, "the file is not plain text (UTF-16 or binary)",
             "save it as ASCII or UTF-8");
    if (starts("\xEF\xBB\xBF")) at_ = 3;
}

bool AptText::next_physical(std::string_view& line) {
    if (at_ >= bytes_.size()) return false;
    const std::size_t end = bytes_.find_first_of("\r\n", at_);
    ++line_number_;
    complete_last_line_ = end != std::string_view::npos;
    line = bytes_.substr(at_, complete_last_line_ ? end - at_ : std::string_view::npos);
    at_ = complete_last_line_ ? end + 1 : bytes_.size();
    if (complete_last_line_ && bytes_[end] == '\r' && at_ < bytes_.size() && bytes_[at_] == '\n') ++at_;
    return true;
}

bool AptText::next(AptLine& line) {
    line = {};
    std::string_view text;
    if (!next_physical(text)) return false;
    if (finished_) {
        pending_.clear();
        continues_ = finished_ = false;
    }
    add(text, line);
    return true;
}

/// Adds one line of the file.
void AptText::add(std::string_view text, AptLine& line) {
    if (!continues_) statement_line_ = line_number_;
    const std::string_view body = trimmed(text);
    const auto joined = [&](std::string_view part) -> std::string_view {
        if (!continues_) return part;
        pending_.append(part);
        return pending_;
    };
    const bool literal = !continues_
                         && std::any_of(text_words.begin(), text_words.end(),
                                        [&](std::string_view w) { return starts_with_word(body, w); });
    // '$$' starts a comment; a single '$' ends the line and continues the statement. In a text only a last
    // '$' does.
    std::size_t dollar = literal ? std::string_view::npos : body.find('$');
    if (literal && !body.empty() && body.back() == '$' && !body.ends_with("$$")) dollar = body.size() - 1;
    if (dollar == std::string_view::npos) {
        line.statement = joined(body);
    } else if (dollar + 1 < body.size() && body[dollar + 1] == '$') {
        line.comment = body.substr(dollar + 2);
        const std::string_view before = trimmed(body.substr(0, dollar));
        if (continues_ && before.empty()) return; // a comment between the lines of a statement
        line.statement = joined(before);
    } else {
        if (!continues_) pending_.clear();
        pending_.append(body.substr(0, dollar));
        continues_ = true;
        return;
    }
    finished_ = true;
}

void AptText::end() {
    statement_line_ = std::max(line_number_, 1L);
    if (continues_ && !finished_)
        fail(ErrorCode::truncated, "the file ends within a statement", "export it again");
}

} // namespace facetmill::detail
