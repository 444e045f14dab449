// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <limits>

#include "catalogue/families/draw_stream.h"

/// Single numbers, drawn from a draw stream; the first choice gives the simplest.
namespace touchstone::catalogue {

inline constexpr double greatest_double = std::numeric_limits<double>::max();

/// 0, 1, -1, 2, -2, ... up to +-most.
inline double small_integer(DrawStream& draws, int most = 8) {
  const auto k = static_cast<int>(draws.below(2 * static_cast<std::uint64_t>(most) + 1));
  return k % 2 == 0 ? -k / 2 : (k + 1) / 2;
}

/// 0, 1, 2 ... up to `most`.
inline double up_to(DrawStream& draws, std::uint64_t most) { return static_cast<double>(draws.below(most + 1)); }

/// 1, 2 ... up to `most`.
inline double one_to(DrawStream& draws, std::uint64_t most) { return static_cast<double>(1 + draws.below(most)); }

/// From `least`, which is the simplest, to `most`; mostly an exponent.
inline int integer_in(DrawStream& draws, int least, int most) {
  return least + static_cast<int>(draws.below(static_cast<std::uint64_t>(most - least) + 1));
}

/// 2^least to 2^most.
inline double power_of_two(DrawStream& draws, int least, int most) {
  return std::ldexp(1, integer_in(draws, least, most));
}

/// A point or vector in space, times 2^k.
template <class Triple>
void lengthen(Triple& v, int k) {
  v = {std::ldexp(v.x, k), std::ldexp(v.y, k), std::ldexp(v.z, k)};
}

inline double zero(DrawStream& draws) { return draws.coin() ? -0.0 : 0.0; }
inline double either_sign(DrawStream& draws) { return draws.coin() ? -1 : 1; }

/// The least number times a small integer.
inline double subnormal(DrawStream& draws, int most = 8) { return std::ldexp(small_integer(draws, most), -1074); }
/// Near 2^1022.
inline double huge(DrawStream& draws) { return std::ldexp(1 + small_integer(draws, 1) / 4, 1022); }

/// 1 to `most` times 2^k, 0 <= k < `exponents`, or 2^-k; both drawn, k second.
inline double scaled_up(DrawStream& draws, std::uint64_t most, std::uint64_t exponents) {
  const auto number = one_to(draws, most);
  return std::ldexp(number, static_cast<int>(draws.below(exponents)));
}
inline double scaled_down(DrawStream& draws, std::uint64_t most, std::uint64_t exponents) {
  const auto number = one_to(draws, most);
  return std::ldexp(number, -static_cast<int>(draws.below(exponents)));
}

/// An integer of at most `bits` bits with sign; mostly a small one. bits <= 53.
double integer(DrawStream& draws, int bits);

/// Any finite double, every bit pattern alike: subnormals, 1e308, -0.0.
double any_finite(DrawStream& draws);

/// Uniform in [-1, 1) on a grid of 2^-52: what a random test draws.
double ordinary(DrawStream& draws);

/// A number that people type: 0.1, 0.2, 0.3, 1/3, 1e6 + 0.1 ...
double typed(DrawStream& draws);

/// A few bits at an exponent from one end of the range to the other: 1e-308 next to 1e308.
double mixed_exponent(DrawStream& draws);

/// Half a unit in the last place of 1, give or take one bit at 2^first or less than `places` below.
double beside_half_an_ulp(DrawStream& draws, int first, int places);

/// The greatest number or 2^1022, of either sign.
inline double end_of_range(DrawStream& draws) {
  const double size = draws.coin() ? greatest_double : 0x1p1022;
  return either_sign(draws) * size;
}

/// An exponent for scaling a whole input: mostly 0, else +-39, one end of the range or the other (see numbers.cpp).
int scale_exponent(DrawStream& draws);

/// The length of a list: mostly 3 to 8, 3 being the simplest; sometimes fewer, sometimes up to 40.
std::size_t list_length(DrawStream& draws);

/// `value` moved by `ulps` units in the last place; finite values stay finite, zero passes through the subnormals.
double moved_by_ulps(double value, int ulps);

/// `value`, or moved by up to so many units in the last place, few first.
inline double ulps_apart(DrawStream& draws, double value, int most) {
  return moved_by_ulps(value, static_cast<int>(small_integer(draws, most)));
}

/// `value` moved by -most to most units in the last place.
inline double within_ulps(DrawStream& draws, double value, int most) {
  return moved_by_ulps(value, integer_in(draws, -most, most));
}

}  // namespace touchstone::catalogue
