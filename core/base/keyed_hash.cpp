#include "core/base/keyed_hash.h"

#include <bit>
#include <cstring>

namespace facetmill {

namespace {

static_assert(std::endian::native == std::endian::little, "words are read as they lie in memory");

void sip_round(std::array<std::uint64_t, 4>& v) {
    v[0] += v[1];
    v[1] = std::rotl(v[1], 13) ^ v[0];
    v[0] = std::rotl(v[0], 32);
    v[2] += v[3];
    v[3] = std::rotl(v[3], 16) ^ v[2];
    v[0] += v[3];
    v[3] = std::rotl(v[3], 21) ^ v[0];
    v[2] += v[1];
    v[1] = std::rotl(v[1], 17) ^ v[2];
    v[2] = std::rotl(v[2], 32);
}

void sip_rounds(std::array<std::uint64_t, 4>& v, int count) {
    for (int i = 0; i < count; ++i)
        sip_round(v);
}

} // namespace

std::string KeyedHash::hex() const {
    static constexpr char digits[] = "0123456789abcdef";
    std::string text;
    for (const std::uint64_t word : words)
        for (int shift = 0; shift < 64; shift += 8)
            for (const int nibble : {4, 0})
                text += digits[(word >> (shift + nibble)) & 15];
    return text;
}

KeyedHasher::KeyedHasher(const HashKey& key)
    : v_{key.words[0] ^ 0x736f6d6570736575u, key.words[1] ^ 0x646f72616e646f6du ^ 0xeeu,
         key.words[0] ^ 0x6c7967656e657261u, key.words[1] ^ 0x7465646279746573u} {}

void KeyedHasher::take(std::uint64_t word) {
    v_[3] ^= word;
    sip_rounds(v_, 2);
    v_[0] ^= word;
}

KeyedHasher& KeyedHasher::add(std::string_view bytes) {
    std::size_t i = 0;
    for (; i < bytes.size() && count_ % 8 != 0; ++i, ++count_) {
        rest_ |= std::uint64_t(std::uint8_t(bytes[i])) << (8 * (count_ % 8));
        if (count_ % 8 == 7) {
            take(rest_);
            rest_ = 0;
        }
    }
    for (; i + 8 <= bytes.size(); i += 8, count_ += 8) {
        std::uint64_t word = 0;
        std::memcpy(&word, bytes.data() + i, sizeof word);
        take(word);
    }
    for (; i < bytes.size(); ++i, ++count_)
        rest_ |= std::uint64_t(std::uint8_t(bytes[i])) << (8 * (count_ % 8));
    return *this;
}

KeyedHash KeyedHasher::hash() const {
    KeyedHasher end = *this;
    end.take(rest_ | (count_ << 56));
    end.v_[2] ^= 0xee;
    sip_rounds(end.v_, 4);
    KeyedHash result;
    result.words[0] = end.v_[0] ^ end.v_[1] ^ end.v_[2] ^ end.v_[3];
    end.v_[1] ^= 0xdd;
    sip_rounds(end.v_, 4);
    result.words[1] = end.v_[0] ^ end.v_[1] ^ end.v_[2] ^ end.v_[3];
    return result;
}

} // namespace facetmill
