// SPDX-License-Identifier: Apache-2.0
#include "oracle/exact/numbers/parabola.h"

#include <array>

#include "oracle/exact/numbers/wide.h"

namespace touchstone::oracle {
namespace {

int changes_of_sign(const std::array<int, 3>& chain) {
  int changes = 0, last = 0;
  for (const int sign : chain) {
    changes += sign != 0 && last == -sign;
    if (sign != 0) last = sign;
  }
  return changes;
}

/// The zeros in (0, 1], each counted once, of a parabola with f(0) > 0: Sturm's chain is f, half its derivative, and
/// the remainder of these two with its sign changed, which has the sign of the discriminant.
int zeros_within(const Parabola& f) {
  if (sgn(f.square) == 0) return 0;  // no velocity: constant
  const int remainder = sgn(f.discriminant());
  return changes_of_sign({sgn(f.start), sgn(f.half), remainder}) -
         changes_of_sign({sgn(f.end()), sgn(f.half_slope_at_end()), remainder});
}

}  // namespace

FirstContact<Surd> Parabola::contact() const {
  if (sgn(start) <= 0) return {HitRelation::hit, Surd(Rational(0))};
  if (zeros_within(*this) == 0) return {HitRelation::never, std::nullopt};
  const Rational divisor(square);
  return {HitRelation::hit, Surd(Rational(-half / divisor), Rational(-1 / divisor), Rational(discriminant()))};
}

Rational Parabola::least() const {
  if (sgn(half) >= 0) return Rational(start);
  if (sgn(half_slope_at_end()) <= 0) return Rational(end());
  return quotient(Integer(-discriminant()), square);
}

const char* Parabola::kind() const {
  if (sgn(start) <= 0) return "start";
  if (zeros_within(*this) != 0) return "first_root";
  if (sgn(half) >= 0) return "receding";
  return sgn(half_slope_at_end()) <= 0 ? "too_late" : "no_root";
}

}  // namespace touchstone::oracle
