// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <climits>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "robust/kernel/filters/decode.h"

/// Points of space whose coordinates are few large and few small numbers, brought near each other.
namespace touchstone::robust::kernel {

/// Points of space by their coordinates along x, y and z.
template <class Number, std::size_t n>
using Axes = std::array<std::array<Number, n>, 3>;

/// The coordinates of one axis as integers times 2^unit: a large number has a set bit within `few` places below the
/// greatest number's exponent `top` and none below them; a small one has none in these places.
struct FarApart {
  static constexpr int few = 13;
  int top = INT_MIN, small_top = INT_MIN, least_bit = INT_MAX;  ///< all large and small numbers are below 2^top

  template <std::size_t n>
  explicit FarApart(const std::array<Decoded, n>& numbers) {
    for (const Decoded& x : numbers)
      if (x.magnitude != 0) top = std::max(top, top_of(x));
    for (const Decoded& x : numbers)
      if (x.magnitude != 0 && !large(x))
        small_top = std::max(small_top, top_of(x)), least_bit = std::min(least_bit, least_bit_of(x));
  }
  static int least_bit_of(const Decoded& x) { return x.exponent + std::countr_zero(x.magnitude); }
  static int top_of(const Decoded& x) { return x.exponent + 64 - std::countl_zero(x.magnitude); }
  bool large(const Decoded& x) const { return least_bit_of(x) >= top - few; }
};

/// Other coordinates, with which every sum of products of up to three displacements, one along each axis, or numbers of
/// the same axis instead, has the same sign, as long as it has up to six products: all signs that the dimension of an
/// intersection depends on. Empty if the numbers are not so.
///
/// Let each coordinate along an axis be u (m Y + k), with a unit u of its own and Y = 2^q for all three, where m and k
/// are integers less than 2^13, one of them 0. A displacement is a polynomial in Y with two coefficients less than
/// 2^14, and a sum of six products of three has coefficients whose magnitudes add up to less than 6 (2 2^14)^3 < 2^48.
/// So for every Y from 2^48 on its sign is that of the coefficient of the greatest power that is not 0. Y = 2^48
/// instead of 2^q makes all numbers integers below 2^61.
template <std::size_t n>
std::optional<Axes<std::int64_t, n>> brought_near(const Axes<double, n>& axes) {
  constexpr int nearer = 48, most = INT_MAX;
  int least_apart = nearer, apart = most;
  Axes<Decoded, n> parts;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (std::size_t i = 0; i < n; ++i) {
      parts[axis][i] = decode(axes[axis][i]);
      if (parts[axis][i].exponent > 1023 - 52) return std::nullopt;  // infinite, or NaN
    }
    const FarApart found(parts[axis]);
    if (found.small_top == INT_MIN) continue;
    least_apart = std::max(least_apart, found.top - FarApart::few - found.least_bit);
    apart = std::min(apart, found.top - found.small_top);
  }
  if (apart < least_apart || apart == most) return std::nullopt;
  Axes<std::int64_t, n> near{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const FarApart found(parts[axis]);
    for (std::size_t i = 0; i < n; ++i) {
      const Decoded& x = parts[axis][i];
      if (x.magnitude == 0) continue;
      const int zeros = std::countr_zero(x.magnitude), unit = found.top - FarApart::few;
      const int up = x.exponent + zeros - unit + (found.large(x) ? nearer : apart);
      const auto magnitude = static_cast<std::int64_t>(x.magnitude >> zeros) << up;
      near[axis][i] = x.negative ? -magnitude : magnitude;
    }
  }
  return near;
}

}  // namespace touchstone::robust::kernel
