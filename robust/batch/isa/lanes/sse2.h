// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <emmintrin.h>

#include "robust/batch/isa/lanes/bytes.h"

namespace touchstone::robust::batch::isa {
namespace {

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

}  // namespace
}  // namespace touchstone::robust::batch::isa
