// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "geometry/int128.h"
#include "robust/kernel/filters/decode.h"

namespace touchstone::robust::kernel {

using touchstone::Int128;
using touchstone::UInt128;

/// Several doubles as integers over one power of two: number i is at[i] * 2^exponent exactly, |at[i]| < 2^61. So a
/// difference is below 2^62, a product of differences below 2^124, and four such products fit a signed 128-bit integer.
template <std::size_t N>
struct Lattice {
  std::array<std::int64_t, N> at;
  int exponent;
};

inline constexpr int lattice_spare = 61 - 53;

/// One double in units of 2^(top - 1075 - spare), top the largest exponent field of all; `lost` collects the bits below
/// the unit.
inline std::int64_t placed_on_lattice(std::uint64_t bits, int top, std::uint64_t& lost) {
  // Sums instead of conditions: zeros occur unpredictably, and a branch would be mispredicted.
  const int field = static_cast<int>(bits >> 52 & 0x7ff), normal = (field + 0x7ff) >> 11;
  const std::uint64_t hidden = static_cast<std::uint64_t>(normal) << 52;
  const std::uint64_t magnitude = ((bits & 0xfffffffffffffu) | hidden) << lattice_spare;
  const int down = std::min(top - field - 1 + normal, 63);
  const std::uint64_t placed = magnitude >> down;
  lost |= placed << down ^ magnitude;
  const auto sign = static_cast<std::int64_t>(bits) >> 63;
  return (static_cast<std::int64_t>(placed) ^ sign) - sign;
}

/// Empty if a number is NaN or infinite, or has a set bit more than 61 places below the leading place of the largest
/// exponent. (Folds over the arguments, because g++ at -O2 leaves loops over so few numbers as loops.)
template <class... Doubles>
[[gnu::always_inline]] inline std::optional<Lattice<sizeof...(Doubles)>> lattice_of(Doubles... numbers) {
  int top = 1;  // a subnormal has the exponent of the first normal binade
  ((top = std::max(top, static_cast<int>(std::bit_cast<std::uint64_t>(numbers) >> 52 & 0x7ff))), ...);
  std::uint64_t lost = top == 0x7ff;
  const Lattice<sizeof...(Doubles)> result{{placed_on_lattice(std::bit_cast<std::uint64_t>(numbers), top, lost)...},
                                           top - 1075 - lattice_spare};
  if (lost != 0) return std::nullopt;
  return result;
}

inline int sign_of(std::int64_t n) { return (n > 0) - (n < 0); }
inline int sign_of(const Int128& n) { return (n > 0) - (n < 0); }

}  // namespace touchstone::robust::kernel
