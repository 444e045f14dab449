// SPDX-License-Identifier: Apache-2.0
// Included by one unit for each instruction set, with TOUCHSTONE_LANES of its own.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>

#include "robust/kernel/filters/strict_math.h"

#if TOUCHSTONE_LANES > 1
#include <immintrin.h>
#endif

// Everything here is internal to its unit. A function that the linker could share with other units would carry this
// unit's instructions to processors that lack them.
namespace touchstone::robust::batch::isa {
namespace {

/// One bit for each lane.
using Mask = std::uint32_t;

constexpr std::size_t lanes = TOUCHSTONE_LANES;

struct Lanes {
#if TOUCHSTONE_LANES > 1
  __extension__ typedef double Numbers __attribute__((vector_size(8 * TOUCHSTONE_LANES)));
#else
  typedef double Numbers;
#endif
  Numbers v;

  Lanes() = default;
  explicit Lanes(Numbers v) : v(v) {}
  static Lanes at(const double* p) {
    Lanes loaded;
    std::memcpy(&loaded.v, p, sizeof loaded.v);
    return loaded;
  }

  friend Lanes operator+(Lanes a, Lanes b) { return Lanes(a.v + b.v); }
  friend Lanes operator-(Lanes a, Lanes b) { return Lanes(a.v - b.v); }
  friend Lanes operator*(Lanes a, Lanes b) { return Lanes(a.v * b.v); }
};

// same(x) is x in all lanes. lesser(x, y) is y if x or y is NaN, like x < y ? x : y; greater likewise. a * b + c may be
// rounded once or twice.
#if TOUCHSTONE_LANES == 8
Lanes same(double x) { return Lanes(_mm512_set1_pd(x)); }
Lanes magnitude(Lanes x) { return Lanes(_mm512_abs_pd(x.v)); }
Lanes lesser(Lanes x, Lanes y) { return Lanes(_mm512_min_pd(x.v, y.v)); }
Lanes greater(Lanes x, Lanes y) { return Lanes(_mm512_max_pd(x.v, y.v)); }
Lanes multiply_add(Lanes a, Lanes b, Lanes c) { return Lanes(_mm512_fmadd_pd(a.v, b.v, c.v)); }
Mask above(Lanes x, Lanes y) { return _mm512_cmp_pd_mask(x.v, y.v, _CMP_GT_OQ); }
Mask not_below(Lanes x, Lanes y) { return _mm512_cmp_pd_mask(x.v, y.v, _CMP_GE_OQ); }
Mask equal(Lanes x, Lanes y) { return _mm512_cmp_pd_mask(x.v, y.v, _CMP_EQ_OQ); }
Mask negative(Lanes x) { return _mm512_movepi64_mask(_mm512_castpd_si512(x.v)); }
#elif TOUCHSTONE_LANES == 4
Lanes same(double x) { return Lanes(_mm256_set1_pd(x)); }
Lanes magnitude(Lanes x) { return Lanes(_mm256_andnot_pd(_mm256_set1_pd(-0.0), x.v)); }
Lanes lesser(Lanes x, Lanes y) { return Lanes(_mm256_min_pd(x.v, y.v)); }
Lanes greater(Lanes x, Lanes y) { return Lanes(_mm256_max_pd(x.v, y.v)); }
Lanes multiply_add(Lanes a, Lanes b, Lanes c) { return Lanes(_mm256_fmadd_pd(a.v, b.v, c.v)); }
Mask bits_of(__m256d x) { return static_cast<Mask>(_mm256_movemask_pd(x)); }
Mask above(Lanes x, Lanes y) { return bits_of(_mm256_cmp_pd(x.v, y.v, _CMP_GT_OQ)); }
Mask not_below(Lanes x, Lanes y) { return bits_of(_mm256_cmp_pd(x.v, y.v, _CMP_GE_OQ)); }
Mask equal(Lanes x, Lanes y) { return bits_of(_mm256_cmp_pd(x.v, y.v, _CMP_EQ_OQ)); }
Mask negative(Lanes x) { return bits_of(x.v); }
#elif TOUCHSTONE_LANES == 2
Lanes same(double x) { return Lanes(_mm_set1_pd(x)); }
Lanes magnitude(Lanes x) { return Lanes(_mm_andnot_pd(_mm_set1_pd(-0.0), x.v)); }
Lanes lesser(Lanes x, Lanes y) { return Lanes(_mm_min_pd(x.v, y.v)); }
Lanes greater(Lanes x, Lanes y) { return Lanes(_mm_max_pd(x.v, y.v)); }
Lanes multiply_add(Lanes a, Lanes b, Lanes c) { return a * b + c; }
Mask bits_of(__m128d x) { return static_cast<Mask>(_mm_movemask_pd(x)); }
Mask above(Lanes x, Lanes y) { return bits_of(_mm_cmpgt_pd(x.v, y.v)); }
Mask not_below(Lanes x, Lanes y) { return bits_of(_mm_cmpge_pd(x.v, y.v)); }
Mask equal(Lanes x, Lanes y) { return bits_of(_mm_cmpeq_pd(x.v, y.v)); }
Mask negative(Lanes x) { return bits_of(x.v); }
#else
Lanes same(double x) { return Lanes(x); }
Lanes magnitude(Lanes x) { return Lanes(__builtin_fabs(x.v)); }
Lanes lesser(Lanes x, Lanes y) { return x.v < y.v ? x : y; }
Lanes greater(Lanes x, Lanes y) { return x.v > y.v ? x : y; }
Lanes multiply_add(Lanes a, Lanes b, Lanes c) { return a * b + c; }
Mask above(Lanes x, Lanes y) { return x.v > y.v; }
Mask not_below(Lanes x, Lanes y) { return x.v >= y.v; }
Mask equal(Lanes x, Lanes y) { return x.v == y.v; }
Mask negative(Lanes x) { return static_cast<Mask>(__builtin_signbit(x.v) != 0); }
#endif

constexpr Mask all_lanes = (Mask{1} << lanes) - 1;

#if TOUCHSTONE_LANES == 8
/// x in the lanes of the mask, y in the others.
Lanes chosen(Mask mask, Lanes x, Lanes y) { return Lanes(_mm512_mask_blend_pd(static_cast<__mmask8>(mask), y.v, x.v)); }
#elif TOUCHSTONE_LANES == 4
Lanes chosen(Mask mask, Lanes x, Lanes y) {
  const __m256i bits = _mm256_set_epi64x(8, 4, 2, 1), kept = _mm256_and_si256(_mm256_set1_epi64x(mask), bits);
  return Lanes(_mm256_blendv_pd(y.v, x.v, _mm256_castsi256_pd(_mm256_cmpeq_epi64(kept, bits))));
}
#endif

/// Writes a byte for each bit: `set` or `clear`.
void put_bytes(std::uint8_t* to, std::uint64_t bits, std::uint8_t set, std::uint8_t clear) {
#if TOUCHSTONE_LANES == 8
  const auto bytes = _mm512_mask_blend_epi8(bits, _mm512_set1_epi8(static_cast<char>(clear)),
                                            _mm512_set1_epi8(static_cast<char>(set)));
  std::memcpy(to, &bytes, sizeof bytes);
#else
  constexpr std::uint64_t ones = 0x0101010101010101, own_bit = 0x8040201008040201;
  for (std::size_t k = 0; k < 64; k += 8) {
    // In byte j of eight copies of eight bits only bit j is kept; adding 0x7f makes a carry into its highest bit.
    const std::uint64_t kept = (bits >> k & 0xff) * ones & own_bit;
    const std::uint64_t chosen = (kept + 0x7f * ones) >> 7 & ones;
    const std::uint64_t bytes = clear * ones ^ chosen * static_cast<std::uint8_t>(set ^ clear);
    std::memcpy(to + k, &bytes, sizeof bytes);
  }
#endif
}

}  // namespace
}  // namespace touchstone::robust::batch::isa
