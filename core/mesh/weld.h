// Exact welding of facet corners, shared by the readers of mesh files; and the hash of positions that it
// uses.
#pragma once

#include "core/base/large_pages.h"
#include "core/base/parallel.h"
#include "core/mesh/mesh.h"

#include <atomic>
#include <bit>
#include <cstdint>
#include <vector>

namespace facetmill::detail {

struct WeldedCorners {
    std::vector<Vec3> points;  ///< distinct positions, numbered by first occurrence among the corners
    std::vector<Facet> facets; ///< three consecutive corners each
};

/// Mixes all bits of a position. -0 must have been made 0 before.
inline std::uint64_t position_hash(const Vec3& p) {
    const auto mix = [](std::uint64_t a, std::uint64_t b) {
        const auto product = static_cast<unsigned __int128>(a) * b;
        return std::uint64_t(product) ^ std::uint64_t(product >> 64);
    };
    std::uint64_t h = mix(std::bit_cast<std::uint64_t>(p.x()) ^ 0x9E3779B97F4A7C15u, 0xD6E8FEB86659FD93u);
    h = mix(std::bit_cast<std::uint64_t>(p.y()) ^ h, 0xA0761D6478BD642Fu);
    return mix(std::bit_cast<std::uint64_t>(p.z()) ^ h, 0xE7037ED1A0B428DBu);
}

/// `at(corner)` gives the position of corner 0 .. corner_count - 1 (a multiple of 3, below 2^32 - 1), finite
/// and without negative zeros. Corners are dealt into parts by hash; every part finds the first corner at
/// each of its positions with a table of its own; numbers follow from the first corners in file order, so
/// they do not depend on threads. Cancellation per 65 536 corners.
template <class At>
WeldedCorners weld_corners(std::size_t corner_count, const At& at, const Progress& progress) {
    constexpr std::size_t check_mask = (1u << 16) - 1;
    const std::size_t block = std::max<std::size_t>(std::size_t(1) << 16, corner_count / 256 + 1);
    const std::size_t blocks = corner_count == 0 ? 0 : (corner_count - 1) / block + 1;
    const int part_bits = std::clamp(int(std::bit_width(corner_count >> 15)), 0, 12);
    const std::size_t parts = std::size_t(1) << part_bits;
    const auto part_of = [&](std::uint64_t hash) {
        return part_bits == 0 ? 0 : std::size_t(hash >> (64 - part_bits));
    };

    struct Entry {
        Index corner;
        std::uint32_t hash;
    };
    LargeVector<Index> number(
        corner_count); // first the first corner at the same position, then the vertex number
    {
        std::vector<std::size_t> place(blocks * parts, 0);
        parallel_blocks(corner_count, block, progress.part(0.0, 0.2),
                        [&](std::size_t begin, std::size_t end) {
                            std::size_t* count = &place[begin / block * parts];
                            for (std::size_t c = begin; c < end; ++c)
                                ++count[part_of(position_hash(at(c)))];
                        });
        std::vector<std::size_t> part_begin(parts + 1, 0);
        std::size_t sum = 0;
        for (std::size_t p = 0; p < parts; ++p) {
            part_begin[p] = sum;
            for (std::size_t b = 0; b < blocks; ++b)
                sum += std::exchange(place[b * parts + p], sum);
        }
        part_begin[parts] = sum;

        LargeVector<Entry> entries(corner_count);
        parallel_blocks(corner_count, block, progress.part(0.2, 0.45),
                        [&](std::size_t begin, std::size_t end) {
                            std::size_t* next = &place[begin / block * parts];
                            for (std::size_t c = begin; c < end; ++c) {
                                const std::uint64_t hash = position_hash(at(c));
                                entries[next[part_of(hash)]++] = {Index(c), std::uint32_t(hash)};
                            }
                        });

        parallel_blocks(parts, 1, progress.part(0.45, 0.8), [&](std::size_t part, std::size_t) {
            const std::size_t begin = part_begin[part], end = part_begin[part + 1];
            const std::size_t mask = std::bit_ceil(2 * (end - begin) + 1) - 1;
            std::vector<Entry> table(mask + 1, Entry{no_index, 0});
            for (std::size_t i = begin; i < end; ++i) {
                if ((i & check_mask) == 0) progress.check();
                const Entry e = entries[i];
                const Vec3 p = at(e.corner);
                // The high half of the multiplied hash spreads also where the low bits of a part are alike.
                std::size_t slot = (e.hash * 0x9E3779B97F4A7C15u >> 24) & mask;
                while (table[slot].corner != no_index
                       && (table[slot].hash != e.hash || at(table[slot].corner) != p))
                    slot = (slot + 1) & mask;
                if (table[slot].corner == no_index) table[slot] = e;
                number[e.corner] = table[slot].corner;
            }
        });
    }

    std::vector<std::size_t> first_number(blocks + 1, 0);
    parallel_blocks(corner_count, block, progress.part(0.8, 0.85), [&](std::size_t begin, std::size_t end) {
        std::size_t firsts = 0;
        for (std::size_t c = begin; c < end; ++c)
            firsts += number[c] == c;
        first_number[begin / block + 1] = firsts;
    });
    for (std::size_t b = 0; b < blocks; ++b)
        first_number[b + 1] += first_number[b];

    WeldedCorners welded;
    welded.points.resize(first_number[blocks]);
    welded.facets.resize(corner_count / 3);
    LargeVector<Index> vertex_of(corner_count);
    parallel_blocks(corner_count, block, progress.part(0.85, 0.93), [&](std::size_t begin, std::size_t end) {
        std::size_t next = first_number[begin / block];
        for (std::size_t c = begin; c < end; ++c)
            if (number[c] == c) {
                welded.points[next] = at(c);
                vertex_of[c] = Index(next++);
            }
    });
    parallel_blocks(corner_count / 3, block / 3 + 1, progress.part(0.93, 1.0),
                    [&](std::size_t begin, std::size_t end) {
                        for (std::size_t f = begin; f < end; ++f)
                            for (std::size_t k = 0; k < 3; ++k)
                                welded.facets[f][k] = vertex_of[number[3 * f + k]];
                    });
    return welded;
}

} // namespace facetmill::detail
