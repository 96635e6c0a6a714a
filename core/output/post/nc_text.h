// Blocks of a control as text: numbers, words, and names that are safe in a comment. Internal to the room.
#pragma once

#include "core/output/post/post.h"
#include "core/setup/machine.h"

#include <cstdint>
#include <string>
#include <string_view>

namespace facetmill {

/// Letters: "X", "TX"; or letters and digits that end with '=': "A3=".
bool is_nc_word(std::string_view text);
/// "G43.4", "M6"; or letters alone: "TRAORI", "L"; or with a sign: "DR-".
bool is_nc_code(std::string_view text);
/// A code's number without leading zeros: "G01" is "G1".
std::string plain_nc_code(std::string_view text);

/// The word of an axis of a machine.
inline NcWord rotary_word(const RotaryAxis& axis) {
    return NcWord(std::size_t(NcWord::a) + std::size_t(axis.name[0] - 'A'));
}

/// A value in units of the last decimal: numbers are compared as they are printed.
std::int64_t nc_digits(double value, int decimals);
double nc_value(std::int64_t digits, int decimals);
/// "-12.5", "3." or "3" as the post has it; 0 has no sign.
void append_number(std::string& to, std::int64_t digits, int decimals, const Post& post);
/// With this many significant digits, and never an exponent.
void append_significant(std::string& to, double value, int digits, const Post& post);

} // namespace facetmill
