#include "core/mesh/mesh_reader.h"

#include <cctype>
#include <charconv>
#include <cmath>

namespace facetmill::detail {

std::size_t line_number(std::string_view text, std::size_t offset) {
    std::size_t line = 1;
    offset = std::min(offset, text.size());
    for (std::size_t i = 0; i < offset; ++i)
        if (text[i] == '\n' || (text[i] == '\r' && (i + 1 == text.size() || text[i + 1] != '\n'))) ++line;
    return line;
}

std::string at_line(const MeshSource& source, std::size_t offset) {
    return source.name + ", line " + std::to_string(line_number(source.bytes, offset));
}

bool same_word(std::string_view token, std::string_view lower_case_word) {
    if (token.size() != lower_case_word.size()) return false;
    for (std::size_t i = 0; i < token.size(); ++i) {
        const char c = token[i];
        if ((c >= 'A' && c <= 'Z' ? char(c - 'A' + 'a') : c) != lower_case_word[i]) return false;
    }
    return true;
}

std::size_t byte_order_mark(std::string_view text) {
    return text.starts_with("\xEF\xBB\xBF") ? 3 : 0;
}

bool starts_with_solid(std::string_view bytes) {
    std::size_t begin = byte_order_mark(bytes);
    while (begin < bytes.size() && is_space(bytes[begin]))
        ++begin;
    if (!same_word(bytes.substr(begin, 5), "solid")) return false;
    const unsigned char next = begin + 5 < bytes.size() ? static_cast<unsigned char>(bytes[begin + 5]) : 0;
    return !std::isalnum(next) && next != '_';
}

bool is_wide_text(std::string_view bytes) {
    if (bytes.starts_with("\xFF\xFE") || bytes.starts_with("\xFE\xFF")) return true;
    if (bytes.starts_with(std::string_view("\0\0\xFE\xFF", 4))) return true;
    // Without a mark: the letters of an ASCII keyword, each with one zero beside it, or with three.
    if (bytes.size() < 16) return false;
    for (const std::size_t width : {2, 4})
        for (const std::size_t letter : {std::size_t(0), width - 1}) {
            bool wide = true;
            for (std::size_t i = 0; i < 4 * width; ++i)
                wide =
                    wide && (i % width == letter ? bytes[i] >= '\t' && bytes[i] < '\x7F' : bytes[i] == '\0');
            if (wide) return true;
        }
    return false;
}

bool is_text(std::string_view bytes) {
    // Padding at the end, with zeros or CP/M's end of file, does not make a text binary; one damaged byte
    // does not either.
    while (!bytes.empty() && (bytes.back() == '\0' || bytes.back() == '\x1A'))
        bytes.remove_suffix(1);
    const std::string_view sample = bytes.substr(0, 1u << 16);
    std::size_t odd = 0;
    for (const char c : sample)
        odd += (static_cast<unsigned char>(c) < 0x20 && !is_space(c)) || c == 0x7F;
    return !sample.empty() && odd * 50 < sample.size();
}

std::string lower_extension(const std::string& name) {
    const std::size_t slash = name.find_last_of('/'), dot = name.find_last_of('.');
    if (dot == std::string::npos || (slash != std::string::npos && dot < slash)) return {};
    std::string extension = name.substr(dot);
    for (char& c : extension)
        c = char(std::tolower(static_cast<unsigned char>(c)));
    return extension;
}

std::string_view foreign_content(std::string_view bytes) {
    struct Familiar {
        std::string_view start, what;
    };
    static constexpr Familiar familiar[] = {
        {"\x89PNG", "a PNG picture"},
        {"II*", "a TIFF picture"},
        {std::string_view("MM\0*", 4), "a TIFF picture"},
        {"\xFF\xD8\xFF", "a JPEG picture"},
        {"GIF8", "a GIF picture"},
        {"BM", "a BMP picture"},
        {"\x1F\x8B", "a gzip archive"},
        {"PK\x03\x04", "a ZIP archive (perhaps 3MF)"},
        {"PK\x05\x06", "an empty ZIP archive"},
        {"7z\xBC\xAF", "a 7z archive"},
        {"Rar!", "a RAR archive"},
        {"BZh", "a bzip2 archive"},
        {"\xFD"
         "7zXZ",
         "an xz archive"},
        {"\x28\xB5\x2F\xFD", "a Zstandard archive"},
        {"x\x9C", "data compressed by zlib"},
        {"x\xDA", "data compressed by zlib"},
        {"%PDF", "a PDF document"},
        {"\x7F"
         "ELF",
         "a program"},
        {"\xD0\xCF\x11\xE0", "an Office or SolidWorks document"},
        {"MZ\x90", "a program"},
        {"RIFF", "a RIFF sound or picture"},
        {"SQLite format 3", "a database"},
        {"ISO-10303-21", "a STEP file"},
        {"glTF", "a glTF file"},
        {"#VRML", "a VRML file"},
        {"OFF", "an OFF file"},
        {"BLENDER", "a Blender file"},
        {"DRACO", "a Draco file"},
        {"**ABCDEFGHIJKLMNOPQRSTUVWXYZ", "a Parasolid file"},
        {"0\nSECTION", "a DXF file"},
        {"0\r\nSECTION", "a DXF file"},
        {"  0\nSECTION", "a DXF file"},
        {"  0\r\nSECTION", "a DXF file"},
        {"version https://git-lfs", "a pointer of Git LFS to a file that was not fetched"},
        {std::string_view("\0\x05\x16\x07", 4), "an AppleDouble file, which macOS puts beside the mesh"},
        {"<?xml", "an XML document"},
        {"<!DOCTYPE", "a web page"},
        {"<!doctype", "a web page"},
        {"<html", "a web page"},
        {"<HTML", "a web page"},
    };
    const std::string_view text = bytes.substr(std::min(byte_order_mark(bytes), bytes.size()));
    for (const Familiar& f : familiar)
        if (text.starts_with(f.start)) return f.what;
    if (bytes.size() > 512 && bytes.substr(257, 5) == "ustar") return "a tar archive";
    return {};
}

namespace {

bool is_digit(char c) {
    return c >= '0' && c <= '9';
}

/// nan, -nan(ind), inf, infinity, 1.#QNAN, -1.#IND00, 1.#INF ...
bool is_non_finite_word(std::string_view token) {
    std::string word;
    for (const char c : token.substr(0, 32))
        word += c >= 'A' && c <= 'Z' ? char(c - 'A' + 'a') : c;
    std::string_view w = word;
    if (w.starts_with('+') || w.starts_with('-')) w.remove_prefix(1);
    if (w == "nan" || w == "inf" || w == "infinity") return true;
    if (w.starts_with("nan(") && w.ends_with(')')) return true;
    if (!w.starts_with("1.#")) return false;
    w.remove_prefix(3);
    while (!w.empty() && is_digit(w.back()))
        w.remove_suffix(1);
    return w == "ind" || w == "qnan" || w == "snan" || w == "nan" || w == "inf";
}

/// A decimal number that double cannot hold: is it too large (and not too small)? `text` is digits, '.',
/// exponent.
bool exceeds_double(std::string_view text) {
    long long first = 0; // decimal place of the first digit that is not zero: 1 for 1.0, 0 for 0.1
    bool point = false, found = false;
    std::size_t i = 0;
    for (; i < text.size() && (is_digit(text[i]) || text[i] == '.' || text[i] == '-'); ++i) {
        if (text[i] == '.') {
            point = true;
        } else if (is_digit(text[i])) {
            found = found || text[i] != '0';
            if (found && !point) ++first;
            if (!found && point) --first;
        }
    }
    if (!found) return false;
    long long exponent = 0;
    const bool negative = i + 1 < text.size() && text[i + 1] == '-';
    for (; i < text.size(); ++i)
        if (is_digit(text[i])) exponent = std::min(exponent * 10 + (text[i] - '0'), 1'000'000'000'000LL);
    return first + (negative ? -exponent : exponent) > 0;
}

} // namespace

NumberForm read_number(std::string_view token, double& value, char decimal_mark) {
    const auto starts_number = [](std::string_view t) {
        const std::size_t sign = t.starts_with('-') ? 1 : 0;
        return t.size() > sign && (is_digit(t[sign]) || t[sign] == '.');
    };
    if (decimal_mark == '.' && starts_number(token)) {
        const auto r = std::from_chars(token.data(), token.data() + token.size(), value);
        if (r.ec == std::errc() && r.ptr == token.data() + token.size()) {
            value += 0.0; // -0 becomes 0
            return NumberForm::number;
        }
    }
    std::string plain; // as from_chars reads it
    plain.reserve(token.size());
    bool has_comma = false, has_point = false;
    std::size_t i = token.starts_with('+') ? 1 : 0;
    if (i == 1 && token.substr(1).starts_with('-')) return NumberForm::invalid;
    for (; i < token.size(); ++i) {
        char c = token[i];
        if (c == ',') {
            if (has_comma || i + 1 == token.size()) return NumberForm::invalid; // it parts numbers
            has_comma = true;
            c = '.';
        } else if (c == '.') {
            has_point = true;
        } else if (c == 'd' || c == 'D') {
            c = 'e';
        }
        plain += c;
    }
    if (has_comma && has_point)
        return is_non_finite_word(token) ? NumberForm::non_finite : NumberForm::invalid;
    if (!starts_number(plain))
        return is_non_finite_word(token) ? NumberForm::non_finite : NumberForm::invalid;
    const auto r = std::from_chars(plain.data(), plain.data() + plain.size(), value);
    if (r.ptr != plain.data() + plain.size() || r.ec == std::errc::invalid_argument)
        return is_non_finite_word(token) ? NumberForm::non_finite : NumberForm::invalid;
    if (r.ec == std::errc::result_out_of_range || !std::isfinite(value)) {
        if (exceeds_double(plain)) return NumberForm::overflow;
        value = 0.0;
    }
    value += 0.0;
    if (has_comma && decimal_mark != ',') return NumberForm::comma;
    if (has_point && decimal_mark == ',') return NumberForm::point;
    return NumberForm::number;
}

} // namespace facetmill::detail
