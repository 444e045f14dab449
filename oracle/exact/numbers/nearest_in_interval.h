// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "oracle/exact/numbers/wide.h"

namespace touchstone::oracle {

/// The least (x - p)^2 / 2 with min <= x <= max, by the conditions of Karush, Kuhn and Tucker: x is the place of the
/// least exactly if min <= x <= max and there are multipliers lower, upper >= 0 with x - p = lower - upper, lower = 0
/// unless x = min, and upper = 0 unless x = max. (The conditions suffice because all is convex.) On integers.
template <class Value>
struct NearestInInterval {
  Value x, lower, upper;

  bool conditions(const Value& min, const Value& max) const {
    const Value zero(0);
    return min <= x && x <= max && lower >= zero && upper >= zero && (lower == zero || x == min) &&
           (upper == zero || x == max);
  }
};

/// Each set of bounds that may be attained gives one candidate; the one that satisfies the conditions is it.
template <class Value>
NearestInInterval<Value> nearest_in_interval(const Value& p, const Value& min, const Value& max) {
  const Value zero(0);
  const NearestInInterval<Value> candidates[]{{p, zero, zero}, {min, Value(min - p), zero}};
  for (const auto& candidate : candidates)
    if (candidate.conditions(min, max)) return candidate;
  return {max, zero, Value(p - max)};
}

}  // namespace touchstone::oracle
