// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "arithmetic/rational.h"

namespace touchstone::arithmetic {
inline namespace TOUCHSTONE_WORDS {

enum class Rounding { nearest, to_zero, up, down };

/// digits 2^exponent; `digits` has as many bits as `precision` says, or is 0. Functions below write the exact result,
/// rounded once, into a number of any precision, so that results are those of MPFR; exponents have no limits.
struct Rounded {
  Integer digits;
  std::int64_t exponent = 0, precision = 53;

  Rational value() const;
  /// To nearest, halfway to even.
  Integer nearest_integer() const;
};

/// n 2^exponent.
void round(Rounded& result, const Integer& n, std::int64_t exponent, Rounding mode);
/// a / b 2^exponent.
void round_quotient(Rounded& result, const Integer& a, const Integer& b, std::int64_t exponent, Rounding mode);
void round_sum(Rounded& result, const Rounded& a, const Rounded& b, Rounding mode);
/// a is not negative.
void round_square_root(Rounded& result, const Rounded& a, Rounding mode);
void round_pi(Rounded& result, Rounding mode);
/// Either may be nullptr, and may be the angle.
void round_sine_cosine(Rounded* sine, Rounded* cosine, const Rounded& angle, Rounding mode);
void round_arc_tangent(Rounded& result, const Rounded& y, const Rounded& x, Rounding mode);
/// |x| <= 1
void round_arc_cosine(Rounded& result, const Rounded& x, Rounding mode);

}  // namespace TOUCHSTONE_WORDS
}  // namespace touchstone::arithmetic
