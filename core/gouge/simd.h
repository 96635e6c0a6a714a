// Four doubles or eight floats at once, by the compiler's vector extensions: one source for every instruction
// set. Files that include this are compiled once per set (axial_kernel_*.cpp), so everything here has
// internal linkage. Only IEEE operations, one rounding each: a lane gives the same bits whatever its place,
// its neighbours and the instruction set.
#pragma once

#include <cstdint>
#ifdef __AVX2__
#include <immintrin.h>
#endif

#define FACETMILL_LANES [[gnu::always_inline]] static inline
#define FACETMILL_MEMBER [[gnu::always_inline]] inline
// The loops' bodies are called: inlined everywhere they would not fit into the instruction cache.
#define FACETMILL_CALLED [[gnu::noinline]]

namespace facetmill::simd {

/// 32 bytes, a register of AVX2.
inline constexpr int double_lanes = 4, float_lanes = 8;

typedef double Double4 __attribute__((vector_size(32)));
typedef decltype(Double4() < Double4()) Mask4; ///< 64 bits each, -1 or 0; compilers differ in their name
typedef float Float8 __attribute__((vector_size(32)));
typedef std::int32_t Int8 __attribute__((vector_size(32))); ///< as a mask -1 or 0

FACETMILL_LANES Double4 all(double v) {
    return Double4{v, v, v, v};
}
FACETMILL_LANES Float8 all(float v) {
    return Float8{v, v, v, v, v, v, v, v};
}
FACETMILL_LANES Double4 load(const double* p) {
    Double4 v;
    __builtin_memcpy(&v, p, sizeof v);
    return v;
}
FACETMILL_LANES Float8 load(const float* p) {
    Float8 v;
    __builtin_memcpy(&v, p, sizeof v);
    return v;
}
FACETMILL_LANES void store(const Double4& v, double* p) {
    __builtin_memcpy(p, &v, sizeof v);
}
FACETMILL_LANES void store(const Float8& v, float* p) {
    __builtin_memcpy(p, &v, sizeof v);
}

/// a where the mask is set, else b.
FACETMILL_LANES Double4 select(const Mask4& mask, const Double4& a, const Double4& b) {
    return mask ? a : b;
}
FACETMILL_LANES Float8 select(const Int8& mask, const Float8& a, const Float8& b) {
    return mask ? a : b;
}
// The larger and the smaller of two: the second of them where either is not a number or both are zero. With
// intrinsics, since the compiler makes two instructions of the operators.
#ifdef __AVX2__
FACETMILL_LANES Double4 larger(const Double4& a, const Double4& b) {
    return Double4(_mm256_max_pd(__m256d(a), __m256d(b)));
}
FACETMILL_LANES Float8 larger(const Float8& a, const Float8& b) {
    return Float8(_mm256_max_ps(__m256(a), __m256(b)));
}
FACETMILL_LANES Double4 smaller(const Double4& a, const Double4& b) {
    return Double4(_mm256_min_pd(__m256d(a), __m256d(b)));
}
FACETMILL_LANES Float8 smaller(const Float8& a, const Float8& b) {
    return Float8(_mm256_min_ps(__m256(a), __m256(b)));
}
#else
FACETMILL_LANES Double4 larger(const Double4& a, const Double4& b) {
    return a > b ? a : b;
}
FACETMILL_LANES Float8 larger(const Float8& a, const Float8& b) {
    return a > b ? a : b;
}
FACETMILL_LANES Double4 smaller(const Double4& a, const Double4& b) {
    return a < b ? a : b;
}
FACETMILL_LANES Float8 smaller(const Float8& a, const Float8& b) {
    return a < b ? a : b;
}
#endif
FACETMILL_LANES Double4 clamped(const Double4& v, const Double4& lo, const Double4& hi) {
    return smaller(larger(v, lo), hi);
}
FACETMILL_LANES Double4 magnitude(const Double4& v) {
    return Double4(Mask4(v) & 0x7FFFFFFFFFFFFFFF);
}
FACETMILL_LANES Float8 magnitude(const Float8& v) {
    return Float8(Int8(v) & 0x7FFFFFFF);
}

#ifdef __AVX2__
/// For every choice of lanes their numbers, four bits each, the lowest first.
struct KeptLanes {
    std::uint32_t of[256];
    constexpr KeptLanes() : of{} {
        for (unsigned chosen = 0; chosen < 256; ++chosen)
            for (unsigned lane = 0, n = 0; lane < 8; ++lane)
                if (chosen >> lane & 1) of[chosen] |= lane << 4 * n++;
    }
    constexpr std::uint32_t operator[](unsigned chosen) const { return of[chosen]; }
};
static constexpr KeptLanes kept_lanes;

FACETMILL_LANES Double4 root(const Double4& v) {
    return Double4(_mm256_sqrt_pd(__m256d(v)));
}
FACETMILL_LANES Float8 root(const Float8& v) {
    return Float8(_mm256_sqrt_ps(__m256(v)));
}
/// A mask as bits: bit k is lane k.
FACETMILL_LANES unsigned bits(const Mask4& mask) {
    return unsigned(_mm256_movemask_pd(__m256d(mask)));
}
FACETMILL_LANES unsigned bits(const Int8& mask) {
    return unsigned(_mm256_movemask_ps(__m256(mask)));
}
FACETMILL_LANES Float8 narrow(const Double4& low, const Double4& high) {
    return Float8(_mm256_set_m128(_mm256_cvtpd_ps(__m256d(high)), _mm256_cvtpd_ps(__m256d(low))));
}
#else
FACETMILL_LANES Double4 root(const Double4& v) {
    Double4 r;
    for (int k = 0; k < double_lanes; ++k)
        r[k] = __builtin_sqrt(v[k]);
    return r;
}
FACETMILL_LANES Float8 root(const Float8& v) {
    Float8 r;
    for (int k = 0; k < float_lanes; ++k)
        r[k] = __builtin_sqrtf(v[k]);
    return r;
}
FACETMILL_LANES unsigned bits(const Mask4& mask) {
    unsigned b = 0;
    for (int k = 0; k < double_lanes; ++k)
        b |= unsigned(mask[k] & 1) << k;
    return b;
}
FACETMILL_LANES unsigned bits(const Int8& mask) {
    unsigned b = 0;
    for (int k = 0; k < float_lanes; ++k)
        b |= unsigned(mask[k] & 1) << k;
    return b;
}
FACETMILL_LANES Float8 narrow(const Double4& low, const Double4& high) {
    return Float8{float(low[0]),  float(low[1]),  float(low[2]),  float(low[3]),
                  float(high[0]), float(high[1]), float(high[2]), float(high[3])};
}
#endif

/// Eight bytes as eight integers.
FACETMILL_LANES Int8 widened(const std::uint8_t* p) {
    typedef std::uint8_t Bytes __attribute__((vector_size(8)));
    Bytes bytes;
    __builtin_memcpy(&bytes, p, sizeof bytes);
    return __builtin_convertvector(bytes, Int8);
}

/// About 1 / sqrt(v), wrong by less than rough_share of it; not the same bits on every processor: for bounds
/// only.
inline constexpr float rough_share = 4e-4f;
FACETMILL_LANES Float8 rough_inverse_root(const Float8& v) {
#ifdef __AVX2__
    return Float8(_mm256_rsqrt_ps(__m256(v)));
#else
    return 1.0f / root(v);
#endif
}

/// The lanes in `chosen` (bit k: lane k) of two vectors, moved together in order; the rest of the eight
/// places may be overwritten. How many there are.
FACETMILL_LANES int keep(unsigned chosen, const Float8& a, const std::uint32_t* b, float* a_out,
                         std::uint32_t* b_out) {
#ifdef __AVX2__
    // Lane numbers as bytes, widened: eight nibbles a choice.
    const __m256i lanes = _mm256_srlv_epi32(_mm256_set1_epi32(int(kept_lanes[chosen])),
                                            _mm256_setr_epi32(0, 4, 8, 12, 16, 20, 24, 28));
    _mm256_storeu_ps(a_out, _mm256_permutevar8x32_ps(__m256(a), lanes));
    const __m256i whole = _mm256_loadu_si256(reinterpret_cast<const __m256i*>(b));
    _mm256_storeu_si256(reinterpret_cast<__m256i*>(b_out), _mm256_permutevar8x32_epi32(whole, lanes));
#else
    int n = 0;
    for (int k = 0; k < float_lanes; ++k) {
        a_out[n] = a[k];
        b_out[n] = b[k];
        n += int(chosen >> k & 1);
    }
#endif
    return __builtin_popcount(chosen);
}

} // namespace facetmill::simd
