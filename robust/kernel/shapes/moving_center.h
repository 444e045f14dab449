// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <optional>
#include <vector>

#include "robust/kernel/integers/quadratic_root.h"
#include "robust/kernel/shapes/first_contact.h"

/// When a ball that moves first meets a convex solid at rest, in integers. The squared distance f of its center from
/// the solid is convex in t, its slope is continuous, and it is a polynomial between two times of change.
namespace touchstone::robust::kernel {

/// numerator / denominator, denominator > 0.
struct TimeOfStep {
  mpz_class numerator, denominator;
  friend bool operator<(const TimeOfStep& s, const TimeOfStep& t) {
    return s.numerator * t.denominator < t.numerator * s.denominator;
  }
};

/// start + t rise: a coordinate of the center, or its height over a plane.
struct HeightOfStep {
  mpz_class start, rise;
  int sign_at(const TimeOfStep& t) const { return sgn(start * t.denominator + rise * t.numerator); }
};

/// f(t) - r^2 = square t^2 + 2 half t + start, or a positive multiple.
struct SquaredGap {
  mpz_class start, half, square;

  mpz_class slope_at(const TimeOfStep& t) const { return square * t.numerator + half * t.denominator; }
  mpz_class value_at(const TimeOfStep& t) const {
    const mpz_class slopes = slope_at(t) + half * t.denominator;
    return slopes * t.numerator + start * t.denominator * t.denominator;
  }
  mpz_class discriminant() const { return half * half - square * start; }
  /// Where the contact is, rounded; there is one.
  double least_zero() const { return round_quadratic_root(-half, -1, discriminant(), square); }
};

/// The sign of the least zero of f less that of g, both of which are there: of n - sqrt(a) + sqrt(b).
inline int compare_least_zeros(const SquaredGap& f, const SquaredGap& g) {
  const mpz_class n = g.half * f.square - f.half * g.square;
  const mpz_class a = f.discriminant() * g.square * g.square, b = g.discriminant() * f.square * f.square;
  if (sign_with_root(n, 1, b) < 0) return -1;
  const mpz_class squares = n * n + b - a;
  return sign_with_root(squares, sgn(n), 4 * n * n * b);
}

/// The start and the end; with `crosses`, between them the times at which heights are 0.
class TimesOfChange {
 public:
  void crosses(const HeightOfStep& height) {
    const mpz_class gap = -height.start * sgn(height.rise), speed = abs(height.rise);
    if (sgn(gap) > 0 && gap < speed) times_.push_back({gap, speed});
  }
  std::vector<TimeOfStep> in_order() const {
    std::vector<TimeOfStep> times = times_;
    std::sort(times.begin(), times.end());
    return times;
  }

 private:
  std::vector<TimeOfStep> times_{{0, 1}, {1, 1}};
};

inline const SquaredGap gap_of_start{0, 0, 1};

/// gap_around(t): f - r^2 as it is around t. The first of the pieces in which that has a zero has the first contact,
/// unless f has stopped falling before. Returns the polynomial that has it as its least zero; t^2 if it is at the
/// start.
template <class GapAround>
std::optional<SquaredGap> gap_of_contact(const TimesOfChange& changes, const GapAround& gap_around) {
  const std::vector<TimeOfStep> times = changes.in_order();
  if (sgn(gap_around(times[0]).start) <= 0) return gap_of_start;
  for (std::size_t i = 1; i < times.size(); ++i) {
    const TimeOfStep &from = times[i - 1], &to = times[i];
    const SquaredGap f = gap_around(
        {from.numerator * to.denominator + to.numerator * from.denominator, 2 * from.denominator * to.denominator});
    if (sgn(f.slope_at(from)) >= 0) return std::nullopt;
    const bool turns = sgn(f.slope_at(to)) > 0 && sgn(f.discriminant()) >= 0;
    if (turns || sgn(f.value_at(to)) <= 0) return f;
  }
  return std::nullopt;
}

template <class GapAround>
FirstContact<double> first_contact(const TimesOfChange& changes, const GapAround& gap_around) {
  const std::optional<SquaredGap> gap = gap_of_contact(changes, gap_around);
  return gap ? hit(gap->least_zero()) : no_hit;
}

}  // namespace touchstone::robust::kernel
