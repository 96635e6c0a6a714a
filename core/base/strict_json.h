// JSON as project and machine files need it: errors with line and column, no duplicate keys, bounded depth
// and size.
#pragma once

#include <nlohmann/json.hpp>

#include <string>
#include <string_view>
#include <vector>

namespace facetmill {

using Json = nlohmann::ordered_json;

/// Throws Error(encoding, syntax, truncated, out_of_range, limit_exceeded) whose place starts with `name`:
/// "name:3:17" for what the text breaks, "name: tools[0].number" for a key that occurs twice. A UTF-8
/// byte-order mark is read over.
Json parse_strict_json(std::string_view text, const std::string& name);

/// Text with two blanks of indentation; what fits on a line stands on one. Strings as `json_text` writes
/// them. Throws Error(encoding) that names the place of a string that is not UTF-8.
std::string pretty_json(const Json& value);

/// "object", "array", "text", "number" ...: how messages call it.
std::string json_type_name(const Json& value);

/// A double as files carry it: at most 15 significant digits, whole numbers without a point. Fifteen digits
/// survive the way into core units and back (three roundings of half an ulp stay below half a unit of the
/// fifteenth digit), so that saving what was loaded gives the same text. Throws Error(out_of_range) naming
/// `where` for NaN and infinity.
Json json_number(double value, const std::string& where);

/// Steps of reading a parsed file key by key. `place` is the way to a value: "tools[0].holder[1]"; the errors
/// name it.
namespace strict {

std::string member(const std::string& place, const std::string& key);
std::string element(const std::string& place, std::size_t i);

[[noreturn]] void wrong_type(const std::string& place, const Json& value, const std::string& expected);
/// Says which of the known keys may have been meant.
[[noreturn]] void unknown_key(const std::string& key, const std::string& place,
                              const std::vector<std::string>& known);

/// Throw Error(wrong_type).
void expect_object(const Json& value, const std::string& place);
const Json& expect_list(const Json& value, const std::string& place);
/// Throws Error(missing_key).
const Json& require(const Json& object, const std::string& place, const std::string& key,
                    const std::string& remedy);
/// Throws Error(wrong_type, and what check_text throws).
std::string read_text(const Json& value, const std::string& place);

} // namespace strict

} // namespace facetmill
