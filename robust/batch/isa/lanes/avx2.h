// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <immintrin.h>

#include "robust/batch/isa/lanes/bytes.h"

namespace touchstone::robust::batch::isa {
namespace {

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
Lanes chosen(Mask mask, Lanes x, Lanes y) {
  const __m256i bits = _mm256_set_epi64x(8, 4, 2, 1), kept = _mm256_and_si256(_mm256_set1_epi64x(mask), bits);
  return Lanes(_mm256_blendv_pd(y.v, x.v, _mm256_castsi256_pd(_mm256_cmpeq_epi64(kept, bits))));
}
Lanes where_above(Lanes x, Lanes y, Lanes then, Lanes otherwise) {
  return Lanes(_mm256_blendv_pd(otherwise.v, then.v, _mm256_cmp_pd(x.v, y.v, _CMP_GT_OQ)));
}

}  // namespace
}  // namespace touchstone::robust::batch::isa
