// A picture in memory and as a PNG file.
#pragma once

#include "core/base/file.h"

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace facetmill {

/// RGB, 8 bits each, rows from the top down, no padding.
struct Picture {
    int width = 0, height = 0;
    std::vector<std::uint8_t> rgb;

    std::uint8_t* pixel(int x, int y) {
        return &rgb[3 * (std::size_t(y) * std::size_t(width) + std::size_t(x))];
    }
    const std::uint8_t* pixel(int x, int y) const {
        return &rgb[3 * (std::size_t(y) * std::size_t(width) + std::size_t(x))];
    }
};

/// The same bytes for the same picture.
std::string encode_png(const Picture& picture);
/// Complete or not at all. Throws Error(unwritable).
void write_png(const Picture& picture, const std::filesystem::path& path);
/// Throws Error(not_found, unreadable, unsupported_format ...). Transparency is dropped, grey becomes RGB.
Picture read_png(const std::filesystem::path& path);

} // namespace facetmill
