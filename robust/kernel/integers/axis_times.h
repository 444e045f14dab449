// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/answers.h"
#include "robust/kernel/integers/integers.h"
#include "robust/kernel/integers/rounding.h"

namespace touchstone::robust::kernel {

/// The intervals of two solids on one axis, and the velocity of a.
template <class Number>
struct AxisMotion {
  Number a_min, a_max, b_min, b_max, velocity;
};

/// The time at which the intervals of all axes first overlap, on integers: on a lattice differences are below 2^62, and
/// products of two below 2^124.
template <class Integer>
class AxisTimes {
 public:
  void cut(const AxisMotion<Integer>& m) {
    const bool backwards = sign_of(m.velocity) < 0;
    const Time entry = backwards ? Time{m.a_min - m.b_max, -m.velocity} : Time{m.b_min - m.a_max, m.velocity},
               exit = backwards ? Time{m.a_max - m.b_min, -m.velocity} : Time{m.b_max - m.a_min, m.velocity};
    if (sign_of(m.velocity) == 0) {
      apart_ = apart_ || sign_of(entry.displacement) > 0 || sign_of(exit.displacement) < 0;
      return;
    }
    if (before(first_, entry)) first_ = entry;
    if (before(exit, last_)) last_ = exit;
  }

  FirstContact<double> contact() const {
    if (apart_ || before(last_, first_)) return {HitRelation::never, std::nullopt};
    return {HitRelation::hit, round_quotient(wide(first_.displacement), wide(first_.speed))};
  }

 private:
  /// way / speed, speed > 0.
  struct Time {
    Integer displacement, speed;
  };
  static Int128 wide(std::int64_t n) { return n; }
  static const mpz_class& wide(const mpz_class& n) { return n; }
  static bool before(const Time& s, const Time& t) {
    return wide(s.displacement) * t.speed < wide(t.displacement) * s.speed;
  }

  Time first_{0, 1}, last_{1, 1};
  bool apart_ = false;
};

}  // namespace touchstone::robust::kernel
