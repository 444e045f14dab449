// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gmpxx.h>

#include "geometry/triangles.h"
#include "robust/kernel/strict_math.h"

namespace touchstone::robust::kernel {

/// The part of a segment p + t (q - p), 0 <= t <= 1, where linear functions are not negative, exactly. first and last
/// are t as numerator / denominator > 0. p == q is one point for every t; first and last stay 0 and 1.
struct Clipped {
  struct Parameter {
    mpz_class numerator, denominator;
    friend bool operator<(const Parameter& s, const Parameter& t) {
      return s.numerator * t.denominator < t.numerator * s.denominator;
    }
  };

  Parameter first{0, 1}, last{1, 1};
  bool empty = false;

  /// Where a function with these values at p and q is >= 0.
  void keep(const mpz_class& at_p, const mpz_class& at_q);
  void keep_zero(const mpz_class& at_p, const mpz_class& at_q) { keep(at_p, at_q), keep(-at_p, -at_q); }
};

/// The part of a segment in a triangle, which may have no area.
Clipped clipped(const Segment3<mpz_class>& segment, const Triangle3<mpz_class>& triangle);

}  // namespace touchstone::robust::kernel
