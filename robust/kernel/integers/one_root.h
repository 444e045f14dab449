// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gmpxx.h>

#include "geometry/space.h"
#include "robust/kernel/filters/strict_math.h"

/// Numbers p + q sqrt(d) over one rational d, in which formulas can be written as they stand: sums, products, quotients
/// and signs are exact.
namespace touchstone::robust::kernel {

/// d >= 0, and no square of a rational unless q = 0: `with_root` ensures that. Numbers of two such d are never
/// combined.
struct OneRoot {
  mpq_class p = 0, q = 0, d = 0;

  OneRoot() = default;
  OneRoot(mpq_class number) : p(std::move(number)) {}  // implicit: every rational is one
  OneRoot(mpq_class rational, mpq_class of_root, mpq_class square)
      : p(std::move(rational)), q(std::move(of_root)), d(std::move(square)) {}
  bool rational() const { return sgn(q) == 0; }
};

/// p + q sqrt(square), square >= 0.
OneRoot with_root(const mpq_class& p, const mpq_class& q, const mpq_class& square);

OneRoot operator+(const OneRoot& a, const OneRoot& b);
OneRoot operator-(const OneRoot& a, const OneRoot& b);
OneRoot operator*(const OneRoot& a, const OneRoot& b);
/// b != 0
OneRoot operator/(const OneRoot& a, const OneRoot& b);
int sign(const OneRoot& a);

/// The nearest number of 53 binary digits, ties to even; the exponent is unbounded.
mpq_class of_53_digits(const OneRoot& a);

/// The nearest double, as defined in rounding.h.
double nearest(const OneRoot& a);

inline Vector3<OneRoot> with_root(const Vector3<mpq_class>& v) { return {v.x, v.y, v.z}; }

}  // namespace touchstone::robust::kernel
