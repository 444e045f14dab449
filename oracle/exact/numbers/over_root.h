// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "oracle/exact/numbers/surd.h"

namespace touchstone::oracle {

/// p + q sqrt(r): over one root, that of a time, which outlives it; a rational number needs none. Unlike a Surd it is
/// not made canonical after each operation.
struct OverRoot {
  OverRoot() = default;
  OverRoot(Rational p) : p(std::move(p)) {}  // implicit, as for a Surd
  OverRoot(Rational p, Rational q, const Integer* r) : p(std::move(p)), q(std::move(q)), r(r) {}
  explicit OverRoot(const Surd& x) : p(x.rational_part()) {
    if (!x.rational()) q = x.coefficient(), r = &x.radicand();
  }
  explicit operator Surd() const { return r == nullptr ? Surd(p) : Surd(p, q, Rational(*r)); }

  Rational p, q;
  const Integer* r = nullptr;
};

inline OverRoot operator-(const OverRoot& x) { return {Rational(-x.p), Rational(-x.q), x.r}; }
inline OverRoot operator+(const OverRoot& x, const OverRoot& y) {
  return {Rational(x.p + y.p), Rational(x.q + y.q), x.r != nullptr ? x.r : y.r};
}
inline OverRoot operator-(const OverRoot& x, const OverRoot& y) { return x + -y; }
inline OverRoot operator*(const OverRoot& x, const OverRoot& y) {
  if (x.r == nullptr) return {Rational(x.p * y.p), Rational(x.p * y.q), y.r};
  if (y.r == nullptr) return {Rational(x.p * y.p), Rational(x.q * y.p), x.r};
  return {Rational(x.p * y.p + x.q * y.q * *x.r), Rational(x.p * y.q + x.q * y.p), x.r};
}
/// y is not 0.
inline OverRoot operator/(const OverRoot& x, const OverRoot& y) {
  if (y.r == nullptr) return {Rational(x.p / y.p), Rational(x.q / y.p), x.r};
  const Rational norm = y.p * y.p - y.q * y.q * *y.r;
  return x * OverRoot(Rational(y.p / norm), Rational(-y.q / norm), y.r);
}
inline int sgn(const OverRoot& x) {
  const int of_p = sgn(x.p), of_root = sgn(x.q);
  if (of_root == 0 || of_p == of_root) return of_p;
  if (of_p == 0) return of_root;
  return of_p * sgn(Rational(x.p * x.p - x.q * x.q * *x.r));
}

}  // namespace touchstone::oracle
