#include "core/base/text.h"

#include "core/base/error.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <map>
#include <mutex>
#include <shared_mutex>
#include <utility>

namespace facetmill {

namespace {

/// A character as it stands in UTF-8; no bytes where what stands there is not UTF-8.
struct Character {
    std::size_t bytes = 0;
    char32_t code = 0;
};

Character character_at(std::string_view s, std::size_t i) {
    const auto byte = [&](std::size_t k) { return static_cast<unsigned char>(s[k]); };
    const unsigned char c = byte(i);
    if (c < 0x80) return {1, c};
    const std::size_t n = c >= 0xC2 && c < 0xE0   ? 2
                          : c >= 0xE0 && c < 0xF0 ? 3
                          : c >= 0xF0 && c < 0xF5 ? 4
                                                  : 0;
    if (n == 0 || i + n > s.size()) return {};
    char32_t code = c & (0xFF >> (n + 1));
    for (std::size_t k = 1; k < n; ++k) {
        if ((byte(i + k) & 0xC0) != 0x80) return {};
        code = code << 6 | (byte(i + k) & 0x3F);
    }
    static constexpr std::array<char32_t, 5> first_of_length = {0, 0, 0x80, 0x800, 0x10000};
    const bool surrogate = code >= 0xD800 && code <= 0xDFFF;
    if (code < first_of_length[n] || surrogate || code > 0x10FFFF) return {};
    return {n, code};
}

/// A terminal, a line or a page would obey it instead of showing it, or shows nothing, so that two names look
/// the same. Joiners (U+200C, U+200D) are left: some scripts cannot be written without them.
bool is_hidden(char32_t c) {
    static constexpr std::array<std::array<char32_t, 2>, 10> hidden = {{{0x00, 0x1F},
                                                                        {0x7F, 0x9F},
                                                                        {0xAD, 0xAD},
                                                                        {0x61C, 0x61C},
                                                                        {0x200B, 0x200B},
                                                                        {0x200E, 0x200F},
                                                                        {0x2028, 0x202E},
                                                                        {0x2060, 0x206F},
                                                                        {0xFEFF, 0xFEFF},
                                                                        {0xE0000, 0xE007F}}};
    return std::any_of(hidden.begin(), hidden.end(),
                       [c](const auto& range) { return c >= range[0] && c <= range[1]; });
}

} // namespace

namespace {

/// Folders that users do not know, and what they know them by.
struct ShownFolders {
    std::shared_mutex mutex;
    std::atomic<std::size_t> count{0}; ///< mostly none
    std::map<std::string, std::string> names;
};

ShownFolders& shown_folders() {
    static auto* all = new ShownFolders; // outlives every thread
    return *all;
}

std::string with_known_names(std::string text) {
    ShownFolders& folders = shown_folders();
    const std::shared_lock lock(folders.mutex);
    for (const auto& [folder, name] : folders.names)
        for (std::size_t at = text.find(folder); at != std::string::npos; at = text.find(folder, at)) {
            const std::size_t end = at + folder.size();
            const bool inside = end + 1 < text.size() && text[end] == '/';
            text.replace(at, folder.size() + (inside ? 1 : 0), name + (inside ? ": " : ""));
            at += name.size();
        }
    return text;
}

} // namespace

void detail::show_as(const std::string& folder, std::string name) {
    ShownFolders& folders = shown_folders();
    const std::unique_lock lock(folders.mutex);
    if (name.empty())
        folders.names.erase(folder);
    else
        folders.names[folder] = std::move(name);
    folders.count = folders.names.size();
}

std::string printable(std::string_view text, std::size_t max_bytes) {
    std::string known, out;
    if (shown_folders().count > 0) text = known = with_known_names(std::string(text));
    for (std::size_t i = 0; i < text.size();) {
        const Character c = character_at(text, i);
        const std::size_t step = std::max<std::size_t>(c.bytes, 1);
        if (out.size() + step > max_bytes) {
            out += "...";
            break;
        }
        if (c.bytes == 0 || is_hidden(c.code))
            out += '?';
        else
            out.append(text.substr(i, step));
        i += step;
    }
    return out;
}

void check_text(std::string_view text, const std::string& place) {
    for (std::size_t i = 0; i < text.size();) {
        const Character c = character_at(text, i);
        if (c.bytes == 0)
            throw Error(ErrorCode::encoding, place, "the text is not UTF-8: '" + printable(text) + "'",
                        "rename the file or the item");
        if (is_hidden(c.code))
            throw Error(ErrorCode::out_of_range, place,
                        "the text holds control or invisible characters: '" + printable(text) + "'",
                        "write it on one line without them");
        i += c.bytes;
    }
}

std::string_view trimmed(std::string_view text) {
    constexpr std::string_view blanks = " \t\v\f\r\n";
    const std::size_t first = text.find_first_not_of(blanks);
    return first == std::string_view::npos ? std::string_view()
                                           : text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

std::string in_small_letters(std::string text) {
    for (char& c : text)
        if (c >= 'A' && c <= 'Z') c = char(c - 'A' + 'a');
    return text;
}

std::string json_text(std::string_view text, const std::string& place) {
    static constexpr char digits[] = "0123456789abcdef";
    std::string out = "\"";
    for (std::size_t i = 0; i < text.size();) {
        const Character c = character_at(text, i);
        if (c.bytes == 0)
            throw Error(ErrorCode::encoding, place, "the text is not UTF-8: '" + printable(text) + "'",
                        "rename the file or the item");
        if (c.code == '"' || c.code == '\\')
            (out += '\\') += char(c.code);
        else if (c.code == '\n')
            out += "\\n";
        else if (c.code == '\t')
            out += "\\t";
        else if (is_hidden(c.code)) {
            const char32_t above = c.code - 0x10000;
            const bool pair = c.code > 0xFFFF;
            for (const char32_t half : {0xD800 + (above >> 10 & 0x3FF), 0xDC00 + (above & 0x3FF)}) {
                out += "\\u";
                for (int shift = 12; shift >= 0; shift -= 4)
                    out += digits[(pair ? half : c.code) >> shift & 15];
                if (!pair) break;
            }
        } else
            out.append(text.substr(i, c.bytes));
        i += c.bytes;
    }
    return out + '"';
}

} // namespace facetmill
