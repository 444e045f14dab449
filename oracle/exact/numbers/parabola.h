// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/answers.h"
#include "oracle/exact/numbers/surd.h"
#include "oracle/truth.h"

namespace touchstone::oracle {

/// f(t) = square t^2 + 2 half t + start on integers, square >= 0: at most 0 if two moving solids meet.
struct Parabola {
  Integer start, half, square;

  /// 0 if f(0) <= 0; otherwise Sturm's chain of f counts its zeros in (0, 1] by changes of sign, and the first is the
  /// smaller root.
  FirstContact<Surd> contact() const;
  /// The least f(t) for t in [0, 1].
  Rational least() const;
  /// "start", "first_root", "receding", "too_late" or "no_root", in this order: a claim of `never` has a kind that
  /// fits, since only the last has its least value inside the step.
  const char* kind() const;

  Integer end() const { return Integer(start + 2 * half + square); }
  Integer half_slope_at_end() const { return Integer(half + square); }
  Integer discriminant() const { return Integer(half * half - square * start); }
};

}  // namespace touchstone::oracle
