// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
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

/// Empty if a number is NaN or infinite, or has a set bit more than 61 places below the leading place of the largest exponent.
template <class... Doubles>
inline std::optional<Lattice<sizeof...(Doubles)>> lattice_of(Doubles... numbers) {
  constexpr std::size_t n = sizeof...(Doubles);
  constexpr int spare = 61 - 53;
  const std::array<std::uint64_t, n> bits{std::bit_cast<std::uint64_t>(numbers)...};
  std::array<int, n> fields;
  int top = 1;  // a subnormal has the exponent of the first normal binade
  for (std::size_t i = 0; i < n; ++i) {
    fields[i] = static_cast<int>(bits[i] >> 52 & 0x7ff);
    top = std::max(top, fields[i]);
  }
  Lattice<n> result;
  result.exponent = top - 1075 - spare;
  std::uint64_t lost = top == 0x7ff;
  for (std::size_t i = 0; i < n; ++i) {
    const std::uint64_t hidden = static_cast<std::uint64_t>(fields[i] != 0) << 52;
    const std::uint64_t magnitude = ((bits[i] & 0xfffffffffffffu) | hidden) << spare;
    const int down = std::min(top - std::max(fields[i], 1), 63);
    const std::uint64_t placed = magnitude >> down;
    lost |= placed << down ^ magnitude;
    const auto sign = static_cast<std::int64_t>(bits[i]) >> 63;
    result.at[i] = (static_cast<std::int64_t>(placed) ^ sign) - sign;
  }
  if (lost != 0) return std::nullopt;
  return result;
}

inline int sign_of(std::int64_t n) { return (n > 0) - (n < 0); }
inline int sign_of(const Int128& n) { return (n > 0) - (n < 0); }

}  // namespace touchstone::robust::kernel
