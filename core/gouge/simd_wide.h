// As many floats at once as a packet of places has: sixteen with AVX-512, else eight (simd.h). Sixteen are a
// type of their own, with masks of bits: what is written for one kind of lanes compiles for the other, and
// `all_of<F>` says of which kind a number shall be.
#pragma once

#include "core/gouge/simd.h"

namespace facetmill::simd {

#ifdef __AVX512F__

struct Mask16 {
    __mmask16 bit;
    FACETMILL_MEMBER friend Mask16 operator&(Mask16 a, Mask16 b) { return {__mmask16(a.bit & b.bit)}; }
    FACETMILL_MEMBER friend Mask16 operator|(Mask16 a, Mask16 b) { return {__mmask16(a.bit | b.bit)}; }
    FACETMILL_MEMBER friend Mask16 operator~(Mask16 a) { return {__mmask16(~a.bit)}; }
    FACETMILL_MEMBER Mask16& operator&=(Mask16 b) { return *this = *this & b; }
};

struct Float16 {
    __m512 v;
    FACETMILL_MEMBER friend Float16 operator-(const Float16& a) {
        return {_mm512_xor_ps(a.v, _mm512_set1_ps(-0.0f))};
    }
};

#define FACETMILL_LANES_OF(op, call)                                                                         \
    FACETMILL_LANES Float16 operator op(const Float16& a, const Float16& b) {                                \
        return {call(a.v, b.v)};                                                                             \
    }                                                                                                        \
    FACETMILL_LANES Float16 operator op(const Float16& a, float b) {                                         \
        return {call(a.v, _mm512_set1_ps(b))};                                                               \
    }                                                                                                        \
    FACETMILL_LANES Float16 operator op(float a, const Float16& b) {                                         \
        return {call(_mm512_set1_ps(a), b.v)};                                                               \
    }
FACETMILL_LANES_OF(+, _mm512_add_ps)
FACETMILL_LANES_OF(-, _mm512_sub_ps)
FACETMILL_LANES_OF(*, _mm512_mul_ps)
FACETMILL_LANES_OF(/, _mm512_div_ps)
#undef FACETMILL_LANES_OF

#define FACETMILL_LANES_COMPARED(op, how)                                                                    \
    FACETMILL_LANES Mask16 operator op(const Float16& a, const Float16& b) {                                 \
        return {_mm512_cmp_ps_mask(a.v, b.v, how)};                                                          \
    }                                                                                                        \
    FACETMILL_LANES Mask16 operator op(const Float16& a, float b) {                                          \
        return {_mm512_cmp_ps_mask(a.v, _mm512_set1_ps(b), how)};                                            \
    }
FACETMILL_LANES_COMPARED(<, _CMP_LT_OQ)
FACETMILL_LANES_COMPARED(>, _CMP_GT_OQ)
FACETMILL_LANES_COMPARED(<=, _CMP_LE_OQ)
FACETMILL_LANES_COMPARED(>=, _CMP_GE_OQ)
#undef FACETMILL_LANES_COMPARED

FACETMILL_LANES Float16 larger(const Float16& a, const Float16& b) {
    return {_mm512_max_ps(a.v, b.v)};
}
FACETMILL_LANES Float16 smaller(const Float16& a, const Float16& b) {
    return {_mm512_min_ps(a.v, b.v)};
}
FACETMILL_LANES Float16 select(Mask16 mask, const Float16& a, const Float16& b) {
    return {_mm512_mask_blend_ps(mask.bit, b.v, a.v)};
}
FACETMILL_LANES Float16 magnitude(const Float16& a) {
    return {_mm512_abs_ps(a.v)};
}
FACETMILL_LANES Float16 root(const Float16& a) {
    return {_mm512_sqrt_ps(a.v)};
}
FACETMILL_LANES Float16 rough_inverse_root(const Float16& a) {
    return {_mm512_rsqrt14_ps(a.v)};
}
FACETMILL_LANES unsigned bits(Mask16 mask) {
    return mask.bit;
}
FACETMILL_LANES void store(const Float16& a, float* p) {
    _mm512_storeu_ps(p, a.v);
}
/// The largest of the lanes.
FACETMILL_LANES float max_of(const Float16& a) {
    return _mm512_reduce_max_ps(a.v);
}
FACETMILL_LANES float lane(const Float16& a, int k) {
    return a.v[k];
}
FACETMILL_LANES void set_lane(Float16& a, int k, float value) {
    a.v[k] = value;
}

FACETMILL_LANES Float16 filled(float v, const Float16*) {
    return {_mm512_set1_ps(v)};
}
FACETMILL_LANES Float16 repeated(const float* p, const Float16*) {
    return {_mm512_broadcast_f32x8(_mm256_loadu_ps(p))};
}
FACETMILL_LANES Float16 by_eights(const float* v, const Float16*) {
    return {_mm512_insertf32x8(_mm512_set1_ps(v[0]), _mm256_set1_ps(v[1]), 1)};
}
FACETMILL_LANES Float8 eight(const Float16& a, int k) {
    return Float8(k == 0 ? _mm512_castps512_ps256(a.v) : _mm512_extractf32x8_ps(a.v, 1));
}

using PlaceFloats = Float16;
using PlaceMask = Mask16;
inline constexpr int place_lanes = 16;

FACETMILL_LANES PlaceFloats load_places(const float* p) {
    return {_mm512_loadu_ps(p)};
}
/// From an origin, the difference rounded once more to single precision.
FACETMILL_LANES PlaceFloats from_origin(const double* p, double origin) {
    const __m512d o = _mm512_set1_pd(origin);
    const __m256 low = _mm512_cvtpd_ps(_mm512_sub_pd(_mm512_loadu_pd(p), o)),
                 high = _mm512_cvtpd_ps(_mm512_sub_pd(_mm512_loadu_pd(p + 8), o));
    return {_mm512_insertf32x8(_mm512_castps256_ps512(low), high, 1)};
}

#else

using PlaceFloats = Float8;
using PlaceMask = Int8;
inline constexpr int place_lanes = float_lanes;

FACETMILL_LANES PlaceFloats load_places(const float* p) {
    return load(p);
}
FACETMILL_LANES PlaceFloats from_origin(const double* p, double origin) {
    return narrow(load(p) - origin, load(p + 4) - origin);
}

#endif

FACETMILL_LANES float max_of(Float8 v) {
    v = larger(v, __builtin_shufflevector(v, v, 4, 5, 6, 7, 0, 1, 2, 3));
    v = larger(v, __builtin_shufflevector(v, v, 2, 3, 0, 1, 6, 7, 4, 5));
    return v[0] > v[1] ? v[0] : v[1];
}
FACETMILL_LANES float lane(const Float8& a, int k) {
    return a[k];
}
FACETMILL_LANES void set_lane(Float8& a, int k, float value) {
    a[k] = value;
}
template <class F>
FACETMILL_LANES float min_of(const F& v) {
    return -max_of(-v);
}

FACETMILL_LANES Float8 filled(float v, const Float8*) {
    return all(v);
}
/// A number in all lanes of this kind.
template <class F>
FACETMILL_LANES F all_of(float v) {
    return filled(v, static_cast<const F*>(nullptr));
}
FACETMILL_LANES Float8 repeated(const float* p, const Float8*) {
    return load(p);
}
FACETMILL_LANES Float8 by_eights(const float* v, const Float8*) {
    return all(v[0]);
}
FACETMILL_LANES Float8 eight(const Float8& a, int) {
    return a;
}
/// Eight numbers, as often as they find room.
template <class F>
FACETMILL_LANES F repeat(const float* p) {
    return repeated(p, static_cast<const F*>(nullptr));
}
/// A number in every eight of the lanes.
template <class F>
FACETMILL_LANES F each_eight(const float* v) {
    return by_eights(v, static_cast<const F*>(nullptr));
}
template <class F>
FACETMILL_LANES F larger(const F& a, float b) {
    return larger(a, all_of<F>(b));
}
template <class F>
FACETMILL_LANES F smaller(const F& a, float b) {
    return smaller(a, all_of<F>(b));
}
template <class Mask, class F>
FACETMILL_LANES F select(const Mask& mask, const F& a, float b) {
    return select(mask, a, all_of<F>(b));
}

} // namespace facetmill::simd
