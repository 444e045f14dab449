// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <immintrin.h>

#include "robust/batch/isa/lanes/lanes.h"

namespace touchstone::robust::batch::isa {
namespace {

Lanes same(double x) { return Lanes(_mm512_set1_pd(x)); }
Lanes magnitude(Lanes x) { return Lanes(_mm512_abs_pd(x.v)); }
Lanes lesser(Lanes x, Lanes y) { return Lanes(_mm512_min_pd(x.v, y.v)); }
Lanes greater(Lanes x, Lanes y) { return Lanes(_mm512_max_pd(x.v, y.v)); }
Lanes multiply_add(Lanes a, Lanes b, Lanes c) { return Lanes(_mm512_fmadd_pd(a.v, b.v, c.v)); }
Mask above(Lanes x, Lanes y) { return _mm512_cmp_pd_mask(x.v, y.v, _CMP_GT_OQ); }
Mask not_below(Lanes x, Lanes y) { return _mm512_cmp_pd_mask(x.v, y.v, _CMP_GE_OQ); }
Mask equal(Lanes x, Lanes y) { return _mm512_cmp_pd_mask(x.v, y.v, _CMP_EQ_OQ); }
Mask negative(Lanes x) { return _mm512_movepi64_mask(_mm512_castpd_si512(x.v)); }
Lanes chosen(Mask mask, Lanes x, Lanes y) { return Lanes(_mm512_mask_blend_pd(static_cast<__mmask8>(mask), y.v, x.v)); }
Lanes where_above(Lanes x, Lanes y, Lanes then, Lanes otherwise) { return chosen(above(x, y), then, otherwise); }

void put_bytes(std::uint8_t* to, std::uint64_t bits, std::uint8_t set, std::uint8_t clear) {
  const auto bytes = _mm512_mask_blend_epi8(bits, _mm512_set1_epi8(static_cast<char>(clear)),
                                            _mm512_set1_epi8(static_cast<char>(set)));
  std::memcpy(to, &bytes, sizeof bytes);
}

void put_answers(std::uint8_t* to, std::uint64_t where, std::uint64_t one, std::uint64_t two) {
  _mm512_mask_storeu_epi8(to, where, _mm512_mask_set1_epi8(_mm512_maskz_set1_epi8(one, 1), two, 2));
}

}  // namespace
}  // namespace touchstone::robust::batch::isa
