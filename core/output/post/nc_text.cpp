#include "core/output/post/nc_text.h"

#include "core/base/latin.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace facetmill {

namespace {

bool upper_letter(char c) {
    return c >= 'A' && c <= 'Z';
}
bool decimal_digit(char c) {
    return c >= '0' && c <= '9';
}

constexpr std::array<double, 10> powers_of_ten = {1, 10, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9};

} // namespace

std::string nc_text(std::string_view name, std::size_t max_characters) {
    std::string text;
    for (const char c : without_marks(name)) {
        const bool plain =
            upper_letter(c) || (c >= 'a' && c <= 'z') || decimal_digit(c) || c == '.' || c == '-' || c == '_';
        if (text.size() + (plain ? 0 : 1) >= max_characters) break;
        if (plain)
            text += c;
        else if (!text.empty() && text.back() != ' ')
            text += ' ';
    }
    while (!text.empty() && text.back() == ' ')
        text.pop_back();
    return text;
}

bool is_nc_word(std::string_view text) {
    if (text.size() == 1) return upper_letter(text[0]);
    if (text.size() >= 2 && std::all_of(text.begin(), text.end(), upper_letter)) return true;
    return text.size() >= 2 && upper_letter(text[0]) && text.back() == '='
           && std::all_of(text.begin(), text.end() - 1,
                          [](char c) { return upper_letter(c) || decimal_digit(c); });
}

bool is_nc_code(std::string_view text) {
    if (text.empty() || !upper_letter(text[0])) return false;
    if (text.size() == 1) return true;
    const auto rest = text.substr(1);
    // "DR-" is a code as well.
    const auto letters = rest.substr(0, rest.size() - (rest.back() == '+' || rest.back() == '-' ? 1 : 0));
    if (!letters.empty() && std::all_of(letters.begin(), letters.end(), upper_letter)) return true;
    if (!decimal_digit(rest.front()) || !decimal_digit(rest.back())) return false;
    return std::all_of(rest.begin(), rest.end(), [](char c) { return decimal_digit(c) || c == '.'; })
           && std::count(rest.begin(), rest.end(), '.') <= 1 && plain_nc_code(text) == text;
}

std::string plain_nc_code(std::string_view text) {
    if (text.size() < 2 || !decimal_digit(text[1])) return std::string(text);
    std::string plain(1, text[0]);
    std::string_view rest = text.substr(1);
    while (rest.size() > 1 && rest[0] == '0' && decimal_digit(rest[1]))
        rest.remove_prefix(1);
    return plain += rest;
}

std::int64_t nc_digits(double value, int decimals) {
    return std::llround(value * powers_of_ten[std::size_t(decimals)]);
}

double nc_value(std::int64_t digits, int decimals) {
    return double(digits) / powers_of_ten[std::size_t(decimals)];
}

void append_number(std::string& to, std::int64_t digits, int decimals, const Post& post) {
    if (digits < 0) to += '-';
    std::uint64_t left = std::uint64_t(std::llabs(digits));
    if (!post.trailing_zeros)
        while (decimals > 0 && left % 10 == 0) {
            left /= 10;
            --decimals;
        }
    char text[32];
    char* at = text + sizeof text;
    int n = 0;
    if (decimals == 0 && post.point) *--at = '.';
    do {
        *--at = char('0' + left % 10);
        left /= 10;
        if (++n == decimals) *--at = '.';
    } while (left > 0 || n <= decimals);
    to.append(at, std::size_t(text + sizeof text - at));
}

void append_significant(std::string& to, double value, int digits, const Post& post) {
    const int before = value > 0 ? int(std::floor(std::log10(value))) + 1 : 1;
    const int decimals = std::clamp(digits - before, 0, 9);
    append_number(to, nc_digits(value, decimals), decimals, post);
}

} // namespace facetmill
