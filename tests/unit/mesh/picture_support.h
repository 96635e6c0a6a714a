// PNG and TIFF pictures made in memory, sound ones and others.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace facetmill::test {

inline void append_big(std::string& bytes, std::uint32_t value, int count = 4) {
    for (int k = count - 1; k >= 0; --k)
        bytes += char(value >> (8 * k) & 0xFF);
}

inline std::uint32_t crc_of(const std::string& bytes) {
    std::uint32_t crc = 0xFFFFFFFFu;
    for (const char c : bytes) {
        crc ^= static_cast<unsigned char>(c);
        for (int k = 0; k < 8; ++k)
            crc = crc >> 1 ^ (0xEDB88320u & (0u - (crc & 1)));
    }
    return ~crc;
}

inline std::string png_chunk(const std::string& kind, const std::string& data) {
    std::string chunk;
    append_big(chunk, std::uint32_t(data.size()));
    chunk += kind + data;
    append_big(chunk, crc_of(kind + data));
    return chunk;
}

/// Stored, not compressed.
inline std::string zlib_stored(const std::string& data) {
    std::string out = "\x78\x01";
    for (std::size_t at = 0; at == 0 || at < data.size(); at += 65535) {
        const std::string piece = data.substr(at, 65535);
        out += char(at + 65535 >= data.size());
        for (const std::uint32_t v : {std::uint32_t(piece.size()), ~std::uint32_t(piece.size())}) {
            out += char(v & 0xFF);
            out += char(v >> 8 & 0xFF);
        }
        out += piece;
    }
    std::uint32_t a = 1, b = 0;
    for (const char c : data) {
        a = (a + static_cast<unsigned char>(c)) % 65521;
        b = (b + a) % 65521;
    }
    append_big(out, b << 16 | a);
    return out;
}

/// The value of a channel of a pixel, in the picture's own numbers.
using PixelOf = std::function<unsigned(unsigned column, unsigned row, int channel)>;

struct PngMaker {
    unsigned columns = 3, rows = 2;
    int bits = 8;
    int colour = 0; ///< 0 grey, 2 RGB, 3 palette, 4 grey and alpha, 6 RGBA
    bool interlaced = false;
    PixelOf pixel = [](unsigned c, unsigned r, int) { return 10 * c + 100 * r; };
    std::string before_data; ///< chunks between header and picture
    std::string behind_end;

    int channels() const { return std::array<int, 7>{1, 0, 3, 1, 2, 0, 4}[std::size_t(colour)]; }
    std::string header() const {
        std::string data;
        append_big(data, columns);
        append_big(data, rows);
        for (const int v : {bits, colour, 0, 0, int(interlaced)})
            data += char(v);
        return png_chunk("IHDR", data);
    }
    std::string raw() const {
        struct Pass {
            unsigned x, y, dx, dy;
        };
        static const std::vector<Pass> adam7 = {{0, 0, 8, 8}, {4, 0, 8, 8}, {0, 4, 4, 8}, {2, 0, 4, 4},
                                                {0, 2, 2, 4}, {1, 0, 2, 2}, {0, 1, 1, 2}};
        std::string data;
        for (const Pass& pass : interlaced ? adam7 : std::vector<Pass>{{0, 0, 1, 1}}) {
            if (pass.x >= columns) continue;
            for (unsigned r = pass.y; r < rows; r += pass.dy) {
                data += '\0'; // no filter
                unsigned packed = 0;
                int used = 0;
                for (unsigned c = pass.x; c < columns; c += pass.dx)
                    for (int k = 0; k < channels(); ++k) {
                        if (bits >= 8) {
                            append_big(data, pixel(c, r, k), bits / 8);
                            continue;
                        }
                        packed = packed << bits | pixel(c, r, k);
                        if ((used += bits) == 8) {
                            data += char(std::exchange(packed, 0));
                            used = 0;
                        }
                    }
                if (used > 0) data += char(packed << (8 - used));
            }
        }
        return data;
    }
    std::string bytes() const { return with_data(zlib_stored(raw())); }
    std::string with_data(const std::string& compressed) const {
        return "\x89PNG\r\n\x1A\n" + header() + before_data + png_chunk("IDAT", compressed)
               + png_chunk("IEND", "") + behind_end;
    }
};

/// TIFF without compression, in one strip or in tiles.
struct TiffMaker {
    unsigned columns = 3, rows = 2, bits = 8, format = 1; ///< format: 1 unsigned, 2 signed, 3 float
    unsigned photometric = 1, samples = 1, orientation = 1, tile = 0;
    bool big_endian = false;
    std::uint32_t claimed_columns = 0; ///< in place of them
    std::function<double(unsigned column, unsigned row)> value = [](unsigned c, unsigned r) {
        return 10 * c + 100 * r;
    };
    /// In place of `value` where channels differ.
    std::function<double(unsigned column, unsigned row, unsigned channel)> channel = nullptr;
    unsigned opacity = 0;               ///< what the channel beside the colours is: 1 multiplied in, 2 not
    std::vector<std::uint32_t> palette; ///< all red values, all green, all blue, of 16 bits
    std::string nodata;                 ///< the text that GDAL writes for a value without height

    void append(std::string& out, std::uint64_t v, int count) const {
        for (int k = 0; k < count; ++k)
            out += char(v >> (8 * (big_endian ? count - 1 - k : k)) & 0xFF);
    }
    /// Its bits, in the lowest places.
    std::uint64_t value_bits(unsigned c, unsigned r, unsigned k) const {
        const double v = c >= columns || r >= rows ? 0 : channel ? channel(c, r, k) : value(c, r);
        std::uint64_t word = 0;
        if (format == 3 && bits == 32) {
            const auto f = float(v);
            std::uint32_t half = 0;
            std::memcpy(&half, &f, sizeof half);
            word = half;
        } else if (format == 3 && bits == 64) {
            std::memcpy(&word, &v, sizeof word);
        } else {
            word = std::uint64_t(std::int64_t(v));
        }
        return word;
    }
    void append_row(std::string& out, unsigned x, unsigned width, unsigned r) const {
        unsigned packed = 0, used = 0;
        for (unsigned c = x; c < x + width; ++c)
            for (unsigned k = 0; k < samples; ++k) {
                const std::uint64_t word = value_bits(c, r, k);
                if (bits % 8 == 0) {
                    append(out, word, int(bits / 8));
                    continue;
                }
                for (unsigned bit = bits; bit-- > 0;) {
                    packed = packed << 1 | unsigned(word >> bit & 1);
                    if (++used == 8) {
                        out += char(std::exchange(packed, 0U));
                        used = 0;
                    }
                }
            }
        if (used > 0) out += char(packed << (8 - used));
    }
    std::string bytes() const {
        std::string data;
        std::vector<std::uint32_t> places, sizes;
        const unsigned step_x = tile ? tile : columns, step_y = tile ? tile : rows;
        for (unsigned y = 0; y < rows; y += step_y)
            for (unsigned x = 0; x < columns; x += step_x) {
                places.push_back(std::uint32_t(8 + data.size()));
                for (unsigned r = y; r < y + step_y; ++r)
                    append_row(data, x, step_x, r);
                sizes.push_back(std::uint32_t(8 + data.size()) - places.back());
            }
        if (data.size() % 2 == 1) data += '\0';
        const auto list_at = std::uint32_t(8 + data.size());
        std::string lists;
        for (const auto& list : {places, sizes})
            for (const std::uint32_t v : list)
                append(lists, v, 4);
        const auto palette_at = std::uint32_t(list_at + lists.size());
        for (const std::uint32_t v : palette)
            append(lists, v, 2);
        const auto nodata_at = std::uint32_t(list_at + lists.size());
        lists += nodata;
        lists += nodata.size() % 2 == 0 ? std::string(2, '\0') : std::string(1, '\0');
        const auto count = std::uint32_t(places.size());
        const auto directory_at = std::uint32_t(list_at + lists.size());
        std::string out = big_endian ? std::string("MM\0*", 4) : std::string("II*\0", 4);
        append(out, directory_at, 4);
        out += data + lists;
        struct Tag {
            unsigned number, kind, count;
            std::uint32_t value;
        };
        const unsigned word = 4, half = 3;
        std::vector<Tag> tags = {{256, word, 1, claimed_columns ? claimed_columns : columns},
                                 {257, word, 1, rows},
                                 {258, half, 1, bits},
                                 {259, half, 1, 1},
                                 {262, half, 1, photometric}};
        const auto listed = [&](unsigned number, std::uint32_t at, const std::vector<std::uint32_t>& list) {
            tags.push_back({number, word, count, count == 1 ? list[0] : at});
        };
        if (!tile) listed(273, list_at, places);
        tags.push_back({274, half, 1, orientation});
        tags.push_back({277, half, 1, samples});
        if (!tile) {
            tags.push_back({278, word, 1, rows});
            listed(279, list_at + 4 * count, sizes);
        } else {
            tags.push_back({322, word, 1, tile});
            tags.push_back({323, word, 1, tile});
            listed(324, list_at, places);
            listed(325, list_at + 4 * count, sizes);
        }
        if (!palette.empty()) tags.push_back({320, half, std::uint32_t(palette.size()), palette_at});
        if (opacity != 0) tags.push_back({338, half, 1, opacity});
        tags.push_back({339, half, 1, format});
        if (!nodata.empty()) {
            std::uint32_t within = 0; // a short text stands in the place of its address
            for (std::size_t k = 0; k < 4; ++k)
                within |= std::uint32_t(k < nodata.size() ? nodata[k] : '\0')
                          << (8 * (big_endian ? 3 - k : k));
            tags.push_back(
                {42113, 2, std::uint32_t(nodata.size() + 1), nodata.size() < 4 ? within : nodata_at});
        }
        std::sort(tags.begin(), tags.end(), [](const Tag& a, const Tag& b) { return a.number < b.number; });
        append(out, std::uint32_t(tags.size()), 2);
        for (const Tag& tag : tags) {
            append(out, tag.number, 2);
            append(out, tag.kind, 2);
            append(out, tag.count, 4);
            const bool is_short = tag.kind == half && tag.count == 1;
            append(out, tag.value, is_short ? 2 : 4);
            if (is_short) append(out, 0, 2);
        }
        append(out, 0, 4);
        return out;
    }
};

} // namespace facetmill::test
