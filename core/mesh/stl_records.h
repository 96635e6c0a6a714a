// One facet of a binary STL file where it lies in memory. Internal to the room.
#pragma once

#include "core/mesh/mesh_reader.h"

#include <bit>
#include <cstring>

namespace facetmill::detail {

class StlRecord {
public:
    static constexpr std::size_t size = 50;

    StlRecord(const TriangleSoup& soup, std::size_t facet)
        : bytes_(soup.records + (soup.record_offsets.empty() ? facet * size : soup.record_offsets[facet])),
          swap_(soup.big_endian != (std::endian::native == std::endian::big)) {}

    Vec3 normal() const { return vector(0); }
    Vec3 corner(std::size_t k) const { return vector(12 + 12 * k); }
    unsigned attribute() const {
        return static_cast<unsigned char>(bytes_[48]) | unsigned(static_cast<unsigned char>(bytes_[49])) << 8;
    }

private:
    /// Negative zero becomes zero: both are the same place.
    Vec3 vector(std::size_t offset) const {
        std::uint32_t words[3];
        std::memcpy(words, bytes_ + offset, sizeof words);
        Vec3 v;
        for (int i = 0; i < 3; ++i)
            v[i] = double(std::bit_cast<float>(swap_ ? __builtin_bswap32(words[i]) : words[i])) + 0.0;
        return v;
    }

    const char* bytes_;
    bool swap_;
};

} // namespace facetmill::detail
