// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "geometry/space.h"
#include "oracle/exact/numbers/nearest_double.h"

namespace touchstone::oracle {

/// A box of doubles around balls at several positions: balls with disjoint boxes have no common point, so that a
/// distant pair costs six comparisons.
class AroundBalls {
 public:
  void add(const Point3<Rational>& center, const Rational& radius) {
    const std::array<const Rational*, 3> at{&center.x, &center.y, &center.z};
    for (std::size_t k = 0; k < 3; ++k) {
      low_[k] = std::min(low_[k], std::nextafter(nearest_double(*at[k] - radius), -HUGE_VAL));
      high_[k] = std::max(high_[k], std::nextafter(nearest_double(*at[k] + radius), HUGE_VAL));
    }
  }
  bool apart(const AroundBalls& other) const {
    for (std::size_t k = 0; k < 3; ++k)
      if (high_[k] < other.low_[k] || other.high_[k] < low_[k]) return true;
    return false;
  }

 private:
  std::array<double, 3> low_{HUGE_VAL, HUGE_VAL, HUGE_VAL}, high_{-HUGE_VAL, -HUGE_VAL, -HUGE_VAL};
};

}  // namespace touchstone::oracle
