// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "robust/kernel/filters/strict_math.h"

#include <arm_sve.h>

#include "robust/batch/isa/lanes/bytes.h"

namespace touchstone::robust::batch::isa {
namespace {

// The type that Lanes holds, as these instructions take it.
typedef svfloat64_t Vector __attribute__((arm_sve_vector_bits(64 * TOUCHSTONE_LANES)));

svbool_t all() { return svptrue_b64(); }
Lanes lanes_of(svfloat64_t x) { return Lanes(Vector(x)); }
svfloat64_t vector_of(Lanes x) { return Vector(x.v); }
Lanes same(double x) { return lanes_of(svdup_f64(x)); }
Lanes magnitude(Lanes x) { return lanes_of(svabs_x(all(), vector_of(x))); }
Lanes where_above(Lanes x, Lanes y, Lanes then, Lanes otherwise) {
  return lanes_of(svsel(svcmpgt(all(), vector_of(x), vector_of(y)), vector_of(then), vector_of(otherwise)));
}
Lanes lesser(Lanes x, Lanes y) { return where_above(y, x, x, y); }  // FMIN keeps a NaN
Lanes greater(Lanes x, Lanes y) { return where_above(x, y, x, y); }
Lanes multiply_add(Lanes a, Lanes b, Lanes c) {
  return lanes_of(svmla_x(all(), vector_of(c), vector_of(a), vector_of(b)));
}
svuint64_t bit_of_each() { return svlsl_x(all(), svdup_u64(1), svindex_u64(0, 1)); }
Mask bits_of(svbool_t x) { return static_cast<Mask>(svorv(x, bit_of_each())); }
Mask above(Lanes x, Lanes y) { return bits_of(svcmpgt(all(), vector_of(x), vector_of(y))); }
Mask not_below(Lanes x, Lanes y) { return bits_of(svcmpge(all(), vector_of(x), vector_of(y))); }
Mask equal(Lanes x, Lanes y) { return bits_of(svcmpeq(all(), vector_of(x), vector_of(y))); }
Mask negative(Lanes x) { return bits_of(svcmplt(all(), svreinterpret_s64(vector_of(x)), svdup_s64(0))); }
Lanes chosen(Mask mask, Lanes x, Lanes y) {
  const svbool_t kept = svcmpne(all(), svand_x(all(), svdup_u64(mask), bit_of_each()), svdup_u64(0));
  return lanes_of(svsel(kept, vector_of(x), vector_of(y)));
}

}  // namespace
}  // namespace touchstone::robust::batch::isa
