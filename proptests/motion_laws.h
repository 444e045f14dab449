// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "proptests/forward_error.h"

/// Laws of solids that move along straight lines.
namespace touchstone::proptests {

/// A velocity times 2^k where that is exact.
template <class Vector>
std::optional<Vector> times_two_to(const Vector& v, int k) {
  Vector w = v;
  audit::for_each_number(w, [k](double& number) { number = std::ldexp(number, k); });
  Vector back = w;
  audit::for_each_number(back, [k](double& number) { number = std::ldexp(number, -k); });
  return numbers_of(back) == numbers_of(v) ? std::optional(w) : std::nullopt;
}

/// Whether `found` is the answer after all velocities have been multiplied by 2^k: t is divided by it. What is never
/// met may be met by a faster motion, and a slower one may not get there.
template <class Number>
bool divided(const FirstContact<Number>& answer, const FirstContact<Number>& found, int k) {
  if (!answer.t) return k > 0 || !found.t;
  if (*answer.t > Number(power_of_two(k))) return !found.t;
  return found.t && *found.t == *answer.t * Number(power_of_two(-k));
}
inline bool divided(const FirstContact<double>& answer, const FirstContact<double>& found, int k) {
  if (!answer.t) return k > 0 || !found.t;
  // A rounded t that is 2^k may have been more.
  if (!found.t) return *answer.t >= std::ldexp(1, k);
  return scaled_number(*answer.t, *found.t, -k);
}

}  // namespace touchstone::proptests
