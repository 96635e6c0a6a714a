// Texts that come in from elsewhere, and texts that go out to a terminal, a report or a page. Characters that
// move what stands beside them (controls of both sets, line and paragraph separators, bidirectional
// embeddings, overrides and isolates) and those that nobody sees (spaces of no width, tags) are neither let
// in nor let out: every text that leaves passes `printable` (error.h) or `json_text`.
#pragma once

#include <string>
#include <string_view>

namespace facetmill {

/// Every text that enters a project passes here: throws Error(encoding) where it is not UTF-8 and
/// Error(out_of_range) where it holds a character that `printable` would replace. `place` is put into the
/// error.
void check_text(std::string_view text, const std::string& place);

/// The same text with A to Z in small letters; whatever else it holds stays.
std::string in_small_letters(std::string text);

/// Without the blanks, tabs and line ends around it.
std::string_view trimmed(std::string_view text);

/// The same text as a JSON string, quotes included; what `printable` would replace is escaped. Throws
/// Error(encoding), whose place is `place`, where it is not UTF-8.
std::string json_text(std::string_view text, const std::string& place);

namespace detail {

/// From now on `printable` writes "name: file" for "folder/file"; an empty name ends that.
void show_as(const std::string& folder, std::string name);

} // namespace detail

} // namespace facetmill
