// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "oracle/certificates/check_reading.h"

namespace touchstone::certify {

/// p + q sqrt(r), r >= 0.
struct Surd {
  Rational p, q, r;
};

/// -1, 0, 1; by squares.
int sign(const Surd& x);
/// That of x - y, also over different roots.
int compare(const Surd& x, const Surd& y);

/// Requires that the claim's kind is "root", or "irrational_root" if no rational number is the root.
void expect_kind_of_root(const Claim& claim, bool rational);

/// Sums, and products of two over the same r.
Surd operator+(const Surd& x, const Rational& y);
Surd operator*(const Surd& x, const Rational& y);
Surd square(const Surd& x);
Surd sum_over_one_root(const Surd& x, const Surd& y);

/// f(t) = constant + linear t + square t^2, square >= 0: its slope grows.
struct Quadratic {
  Rational constant, linear, square;
  Surd at(const Surd& t) const { return sum_over_one_root(certify::square(t) * square, t * linear) + constant; }
  Surd slope_at(const Surd& t) const { return t * Rational(2 * square) + linear; }
  /// It is positive for all t >= 0, or up to t = 1 if it `ends` there: it is at 0, and
  /// - receding: its slope is not negative from there on; or
  /// - too_late: its slope is at most 0 at the end, and f falls to something positive; or
  /// - no_root: 4 square f(t) = (2 square t + linear)^2 + 4 square constant - linear^2 is positive for all t.
  bool proved_positive(const std::string& kind, bool ends) const;
};

/// An exact value, "p/q" or with a root of an integer: "p/q", "p+q*sqrt(r)", "p-sqrt(r)", "q*sqrt(r)", "-sqrt(r)",
/// where p and q are rationals.
Surd exact_surd(const json& value, const std::string& what);

/// Checks the truth's squared_distance, and distance, its root, which is rational or not, according to the kind.
void expect_distance(const Claim& claim, const Rational& square);

}  // namespace touchstone::certify
