// A fingerprint of bytes that nobody can make without the key: SipHash-2-4 with 128 bits of result
// (Aumasson, Bernstein 2012). With a key that only this user's programs know it seals files; two contents
// that have the same one are never met with by chance, and without the key not on purpose either.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

namespace facetmill {

struct HashKey {
    std::array<std::uint64_t, 2> words{0, 0};
};

struct KeyedHash {
    std::array<std::uint64_t, 2> words{0, 0};
    bool operator==(const KeyedHash&) const = default;
    /// 32 lower-case hexadecimal digits.
    std::string hex() const;
};

/// The bytes come in pieces; how they are cut makes no difference.
class KeyedHasher {
public:
    explicit KeyedHasher(const HashKey& key);
    KeyedHasher& add(std::string_view bytes);
    KeyedHash hash() const;

private:
    void take(std::uint64_t word);
    std::array<std::uint64_t, 4> v_;
    std::uint64_t rest_ = 0;  ///< bytes that do not make a word yet
    std::uint64_t count_ = 0; ///< all bytes so far
};

inline KeyedHash keyed_hash(const HashKey& key, std::string_view bytes) {
    return KeyedHasher(key).add(bytes).hash();
}

} // namespace facetmill
