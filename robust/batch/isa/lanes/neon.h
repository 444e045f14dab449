// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "robust/kernel/filters/strict_math.h"

#include <arm_neon.h>

#include "robust/batch/isa/lanes/bytes.h"

namespace touchstone::robust::batch::isa {
namespace {

Lanes same(double x) { return Lanes(vdupq_n_f64(x)); }
Lanes magnitude(Lanes x) { return Lanes(vabsq_f64(x.v)); }
Lanes lesser(Lanes x, Lanes y) { return Lanes(vbslq_f64(vcltq_f64(x.v, y.v), x.v, y.v)); }  // FMIN keeps a NaN
Lanes greater(Lanes x, Lanes y) { return Lanes(vbslq_f64(vcgtq_f64(x.v, y.v), x.v, y.v)); }
Lanes multiply_add(Lanes a, Lanes b, Lanes c) { return Lanes(vfmaq_f64(c.v, a.v, b.v)); }
uint64x2_t bit_of_each() { return uint64x2_t{1, 2}; }
Mask bits_of(uint64x2_t x) { return static_cast<Mask>(vaddvq_u64(vandq_u64(x, bit_of_each()))); }
Mask above(Lanes x, Lanes y) { return bits_of(vcgtq_f64(x.v, y.v)); }
Mask not_below(Lanes x, Lanes y) { return bits_of(vcgeq_f64(x.v, y.v)); }
Mask equal(Lanes x, Lanes y) { return bits_of(vceqq_f64(x.v, y.v)); }
Mask negative(Lanes x) { return bits_of(vcltzq_s64(vreinterpretq_s64_f64(x.v))); }
Lanes chosen(Mask mask, Lanes x, Lanes y) {
  return Lanes(vbslq_f64(vtstq_u64(vdupq_n_u64(mask), bit_of_each()), x.v, y.v));
}
Lanes where_above(Lanes x, Lanes y, Lanes then, Lanes otherwise) {
  return Lanes(vbslq_f64(vcgtq_f64(x.v, y.v), then.v, otherwise.v));
}

}  // namespace
}  // namespace touchstone::robust::batch::isa
