// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <compare>
#include <cstdint>
#include <memory>
#include <string>

#include "oracle/exact/numbers/decode.h"

namespace touchstone::oracle {

struct RationalInterval {
  Rational low, high;
};

/// An exact number p + q sqrt(r): rationals p and q, r an integer that is not a square; q = r = 0 if it is rational.
///
/// Canonical: equal numbers have equal parts and equal text. For p is the rational part of the number, q sqrt(r) the
/// rest, and q and r are made from the square of that rest alone: of its numerator and its denominator apart, the
/// squares of primes below 50 are taken out, and what is left if it is a square; the denominator's rest moves into q.
/// (No number is factored: r may still hold the square of a larger prime.) A copy of a rational one costs a copy of an
/// mpq and of a null pointer.
class Surd {
 public:
  Surd() = default;
  Surd(Rational value) : rational_part_(std::move(value)) {}  // implicit: every rational is a surd
  /// p + q sqrt(r); throws std::domain_error if r < 0.
  Surd(const Rational& p, const Rational& q, const Rational& r);

  bool rational() const { return root_ == nullptr; }
  const Rational& rational_part() const { return rational_part_; }
  const Rational& coefficient() const;
  const Integer& radicand() const;

  /// low <= number <= high, high - low <= 2^-bits; bits may be negative. Rational: both are the number.
  RationalInterval enclosure(std::int64_t bits) const;

  /// surd     = rational | [rational] root
  /// root     = [sign] [fraction "*"] "sqrt(" digits ")"     + is left out where nothing stands before it
  /// rational = ["-"] fraction
  /// fraction = digits ["/" digits]
  /// without spaces, as "3/2-1/2*sqrt(5)": fractions in lowest terms without "/1", a rational part of 0 and a
  /// coefficient of 1 left out.
  std::string text() const;

  /// Exact. std::domain_error: a divisor of 0, or two roots of which no rational multiple of one is the other.
  friend Surd operator-(const Surd& a);
  friend Surd operator+(const Surd& a, const Surd& b);
  friend Surd operator-(const Surd& a, const Surd& b);
  friend Surd operator*(const Surd& a, const Surd& b);
  friend Surd operator/(const Surd& a, const Surd& b);
  /// For a rational number that is not negative; std::domain_error for others.
  friend Surd sqrt(const Surd& a);

  /// -1, 0, 1; by squares alone.
  friend int sgn(const Surd& a);
  /// For any two radicands.
  friend std::strong_ordering operator<=>(const Surd& a, const Surd& b);
  friend bool operator==(const Surd& a, const Surd& b);

 private:
  struct Root {
    Rational coefficient;
    Integer radicand;
  };

  Rational rational_part_;
  std::shared_ptr<const Root> root_;  // never changed: copies share it
};

/// The number of a text of that grammar, canonical or not; throws std::invalid_argument for other text.
Surd surd_of(const std::string& text);

/// The nearest double or float, ties to even, as in nearest_double.h and nearest_float.h. An irrational surd is never a
/// halfway case, so that some enclosure decides.
double nearest_double(const Surd& value);
float nearest_float(const Surd& value);

}  // namespace touchstone::oracle
