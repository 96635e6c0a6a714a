// Errors that end a job. A gouge or collision found in a path is data, never an exception.
#pragma once

#include <exception>
#include <string>
#include <string_view>

namespace facetmill {

/// Kind of error. `code_name` gives the stable snake_case word that scripts and tests compare.
enum class ErrorCode {
    // files
    not_found,
    is_directory,
    unreadable,
    unwritable,
    empty_file,
    truncated,
    syntax,
    encoding,
    not_stl,
    not_triangles,
    no_facets,
    count_mismatch,
    non_finite,
    coordinate_range,
    unsupported_format,
    too_large,
    // projects, parameters, command line
    unknown_key,
    wrong_type,
    out_of_range,
    missing_key,
    missing_reference,
    newer_version,
    usage,
    // jobs
    empty_result,
    limit_exceeded,
    internal,
};

std::string_view code_name(ErrorCode code);

/// What happened, where (file, line, record, key or operation), and what the user can do about it. `what()`
/// is one line: "where: what (remedy)".
class Error : public std::exception {
public:
    Error(ErrorCode code, std::string where, std::string what, std::string remedy);

    ErrorCode code() const { return code_; }
    const std::string& where() const { return where_; }
    const std::string& message() const { return message_; }
    const std::string& remedy() const { return remedy_; }
    const char* what() const noexcept override { return line_.c_str(); }

    /// The same error with `outer` put before the place ("project.facetmill" + "operations[0]").
    Error within(const std::string& outer) const;

private:
    ErrorCode code_;
    std::string where_, message_, remedy_, line_;
};

/// Thrown out of a job whose cancel flag was raised. Not an error: nothing is reported, nothing is written.
class Cancelled : public std::exception {
public:
    const char* what() const noexcept override { return "cancelled"; }
};

/// Text with control characters, line breaks and invalid UTF-8 replaced by '?', cut to `max_bytes`: safe to
/// put into a one-line message whatever a file contained.
std::string printable(std::string_view text, std::size_t max_bytes = 80);

} // namespace facetmill
