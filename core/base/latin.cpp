#include "core/base/latin.h"

#include <array>
#include <cstddef>

namespace facetmill {

namespace {

/// U+00C0 to U+00FF; empty: no letter.
constexpr std::array<std::string_view, 64> latin_1 = {
    "A", "A", "A", "A", "Ae", "A", "AE", "C", "E", "E", "E", "E", "I",  "I", "I",  "I",
    "D", "N", "O", "O", "O",  "O", "Oe", "",  "O", "U", "U", "U", "Ue", "Y", "Th", "ss",
    "a", "a", "a", "a", "ae", "a", "ae", "c", "e", "e", "e", "e", "i",  "i", "i",  "i",
    "d", "n", "o", "o", "o",  "o", "oe", "",  "o", "u", "u", "u", "ue", "y", "th", "y"};

/// U+0100 to U+017F; of the ligatures (0) the two letters stand in `ligature`.
constexpr std::string_view
    extended_a("AaAaAaCcCcCcCcDdDdEeEeEeEeEeGgGgGgGgHhHhIiIiIiIiIi\0\0JjKkkLlLlLlLlLlNnNnNnnNnOoOoOo"
               "\0\0RrRrRrSsSsSsSsTtTtTtUuUuUuUuUuUuWwYyYZzZzZzs",
               128);

std::string_view ligature(unsigned code) {
    switch (code) {
    case 0x132:
        return "IJ";
    case 0x133:
        return "ij";
    case 0x152:
        return "OE";
    default:
        return "oe";
    }
}

/// Empty where the character is none of these letters.
std::string_view letters_of(unsigned code) {
    if (code >= 0xC0 && code <= 0xFF) return latin_1[code - 0xC0];
    if (code < 0x100 || code > 0x17F) return {};
    const std::string_view one = extended_a.substr(code - 0x100, 1);
    return one.front() == '\0' ? ligature(code) : one;
}

} // namespace

std::string without_marks(std::string_view text) {
    std::string plain;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const auto first = static_cast<unsigned char>(text[i]);
        if (first >= 0xC3 && first <= 0xC5 && i + 1 < text.size()) {
            const auto second = static_cast<unsigned char>(text[i + 1]);
            const std::string_view letters = (second & 0xC0) == 0x80
                                                 ? letters_of((first & 0x1Fu) << 6 | (second & 0x3Fu))
                                                 : std::string_view();
            if (!letters.empty()) {
                plain += letters;
                ++i;
                continue;
            }
        }
        plain += text[i];
    }
    return plain;
}

} // namespace facetmill
