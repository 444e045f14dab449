// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <climits>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "robust/kernel/decode.h"

namespace touchstone::robust::kernel {

__extension__ using Int128 = __int128;
__extension__ using UInt128 = unsigned __int128;

/// Several doubles as integers on one power of two: number i is at[i] * 2^exponent exactly, |at[i]| < 2^61.
/// So a difference is below 2^62, a product of differences below 2^124, and four such products fit a signed 128-bit integer.
template <std::size_t N>
struct Lattice {
  std::array<std::int64_t, N> at;
  int exponent;
};

inline constexpr int lattice_bits = 61;

/// Empty if the numbers span more than 61 binary digits, from the highest set bit of any to the lowest set bit of any.
template <class... Doubles>
inline std::optional<Lattice<sizeof...(Doubles)>> lattice_of(Doubles... numbers) {
  constexpr std::size_t n = sizeof...(Doubles);
  const std::array<Decoded, n> parts{decode(numbers)...};
  std::array<std::uint64_t, n> odd;
  std::array<int, n> lowest;
  int low = INT_MAX, high = INT_MIN;
  for (std::size_t i = 0; i < n; ++i) {
    const std::uint64_t magnitude = parts[i].magnitude;
    const int zeros = std::countr_zero(magnitude | std::uint64_t{1} << 63);
    odd[i] = magnitude >> zeros;
    lowest[i] = parts[i].exponent + zeros;
    low = std::min(low, magnitude != 0 ? lowest[i] : INT_MAX);
    high = std::max(high, magnitude != 0 ? lowest[i] + 64 - std::countl_zero(odd[i]) : INT_MIN);
  }
  if (low == INT_MAX) return Lattice<n>{{}, 0};
  if (high - low > lattice_bits) return std::nullopt;
  Lattice<n> result;
  result.exponent = low;
  for (std::size_t i = 0; i < n; ++i) {
    // The shift is below 61 for every number but zero, whose odd part is 0 whatever the shift.
    const auto size = static_cast<std::int64_t>(odd[i] << ((lowest[i] - low) & 63));
    result.at[i] = parts[i].negative ? -size : size;
  }
  return result;
}

inline int sign_of(std::int64_t n) { return (n > 0) - (n < 0); }
inline int sign_of(const Int128& n) { return (n > 0) - (n < 0); }

}  // namespace touchstone::robust::kernel
