// The text of an APT file as statements: line ends, '$' that continues a statement, '$$' that begins a
// comment. Internal to the room; the public door is apt.h.
#pragma once

#include "core/base/error.h"
#include "core/base/text.h"

#include <cctype>
#include <cstddef>
#include <string>
#include <string_view>

namespace facetmill::detail {

/// What one or several lines hold; the views are good until the next one is asked for.
struct AptLine {
    std::string_view comment;   ///< stands before the statement; without "$$"
    std::string_view statement; ///< joined where it was continued
};

class AptText {
public:
    /// Throws Error(encoding).
    AptText(std::string_view bytes, std::string name);

    /// False at the end of the file.
    bool next(AptLine& line);
    /// How much is read, from 0 to 1.
    double fraction() const { return double(at_) / double(bytes_.size()); }
    long line_number() const { return line_number_; }
    /// Line that the statement begins in.
    long statement_line() const { return statement_line_; }
    /// Messages are about the end of the file from now on. Throws Error(truncated) where it ends within a
    /// statement.
    void end();
    /// False where the last line has no end.
    bool complete_last_line() const { return complete_last_line_; }

    [[noreturn]] void fail(ErrorCode code, const std::string& what, const std::string& remedy) const {
        throw Error(code, name_ + ":" + std::to_string(statement_line_), what, remedy);
    }
    const std::string& name() const { return name_; }

private:
    bool next_physical(std::string_view& line);
    void add(std::string_view text, AptLine& line);

    std::string_view bytes_;
    std::string name_;
    std::size_t at_ = 0;
    long line_number_ = 0, statement_line_ = 1;
    std::string pending_; ///< a statement that '$' continues
    bool continues_ = false, finished_ = false, complete_last_line_ = true;
};

std::string upper(std::string_view s);
/// The line begins with the word (in upper case), in any case, and the word ends there.
bool starts_with_word(std::string_view line, std::string_view word);
/// The rest of a statement of this word is text, in which '$' and '/' mean nothing.
bool is_text_word(std::string_view word);

} // namespace facetmill::detail
