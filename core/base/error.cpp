#include "core/base/error.h"

#include <utility>

namespace facetmill {

std::string_view code_name(ErrorCode code) {
    switch (code) {
    case ErrorCode::not_found:
        return "not_found";
    case ErrorCode::is_directory:
        return "is_directory";
    case ErrorCode::unreadable:
        return "unreadable";
    case ErrorCode::unwritable:
        return "unwritable";
    case ErrorCode::empty_file:
        return "empty_file";
    case ErrorCode::truncated:
        return "truncated";
    case ErrorCode::syntax:
        return "syntax";
    case ErrorCode::encoding:
        return "encoding";
    case ErrorCode::not_stl:
        return "not_stl";
    case ErrorCode::not_triangles:
        return "not_triangles";
    case ErrorCode::no_facets:
        return "no_facets";
    case ErrorCode::count_mismatch:
        return "count_mismatch";
    case ErrorCode::non_finite:
        return "non_finite";
    case ErrorCode::coordinate_range:
        return "coordinate_range";
    case ErrorCode::unsupported_format:
        return "unsupported_format";
    case ErrorCode::too_large:
        return "too_large";
    case ErrorCode::unknown_key:
        return "unknown_key";
    case ErrorCode::wrong_type:
        return "wrong_type";
    case ErrorCode::out_of_range:
        return "out_of_range";
    case ErrorCode::missing_key:
        return "missing_key";
    case ErrorCode::missing_reference:
        return "missing_reference";
    case ErrorCode::newer_version:
        return "newer_version";
    case ErrorCode::usage:
        return "usage";
    case ErrorCode::empty_result:
        return "empty_result";
    case ErrorCode::limit_exceeded:
        return "limit_exceeded";
    case ErrorCode::internal:
        return "internal";
    }
    return "internal";
}

Error::Error(ErrorCode code, std::string where, std::string what, std::string remedy)
    : code_(code), where_(std::move(where)), message_(std::move(what)), remedy_(std::move(remedy)) {
    line_ = where_.empty() ? message_ : where_ + ": " + message_;
    if (!remedy_.empty()) line_ += " (" + remedy_ + ")";
}

Error Error::within(const std::string& outer) const {
    return Error(code_, where_.empty() ? outer : outer + ": " + where_, message_, remedy_);
}

namespace {
/// Length of the valid UTF-8 sequence that starts at `i`, or 0.
std::size_t utf8_length(std::string_view s, std::size_t i) {
    const auto byte = [&](std::size_t k) { return static_cast<unsigned char>(s[k]); };
    const unsigned char c = byte(i);
    std::size_t n = c < 0x80                ? 1
                    : c >= 0xC2 && c < 0xE0 ? 2
                    : c >= 0xE0 && c < 0xF0 ? 3
                    : c >= 0xF0 && c < 0xF5 ? 4
                                            : 0;
    if (n == 0 || i + n > s.size()) return 0;
    for (std::size_t k = 1; k < n; ++k)
        if ((byte(i + k) & 0xC0) != 0x80) return 0;
    if (c == 0xE0 && byte(i + 1) < 0xA0) return 0; // overlong
    if (c == 0xED && byte(i + 1) > 0x9F) return 0; // surrogate
    if (c == 0xF0 && byte(i + 1) < 0x90) return 0; // overlong
    if (c == 0xF4 && byte(i + 1) > 0x8F) return 0; // beyond U+10FFFF
    return n;
}
} // namespace

std::string printable(std::string_view text, std::size_t max_bytes) {
    std::string out;
    for (std::size_t i = 0; i < text.size();) {
        const std::size_t n = utf8_length(text, i);
        const bool control = n == 1 && (static_cast<unsigned char>(text[i]) < 0x20 || text[i] == 0x7F);
        const std::size_t step = n == 0 ? 1 : n;
        if (out.size() + step > max_bytes) {
            out += "...";
            break;
        }
        if (n == 0 || control)
            out += '?';
        else
            out.append(text.substr(i, n));
        i += step;
    }
    return out;
}

} // namespace facetmill
