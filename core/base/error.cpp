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
    constexpr std::size_t longest_line = 8000;
    line_ = printable(line_, longest_line);
}

Error Error::within(const std::string& outer) const {
    return Error(code_, where_.empty() ? outer : outer + ": " + where_, message_, remedy_);
}

} // namespace facetmill
