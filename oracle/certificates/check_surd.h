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

/// Sums, and products of two over the same r.
Surd operator+(const Surd& x, const Rational& y);
Surd operator*(const Surd& x, const Rational& y);
Surd square(const Surd& x);
Surd sum_over_one_root(const Surd& x, const Surd& y);

/// An exact value, "p/q" or with a root of an integer: "p/q", "p+q*sqrt(r)", "p-sqrt(r)", "q*sqrt(r)", "-sqrt(r)",
/// where p and q are rationals.
Surd exact_surd(const json& value, const std::string& what);

}  // namespace touchstone::certify
