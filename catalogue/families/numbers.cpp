// SPDX-License-Identifier: Apache-2.0
#include "catalogue/families/numbers.h"

#include <array>
#include <bit>
#include <limits>

namespace touchstone::catalogue {

double integer(DrawStream& draws, int bits) {
  const auto width = integer_in(draws, 0, 7) < 5 ? std::min(bits, 3)
                                                 : 1 + static_cast<int>(draws.below(static_cast<std::uint64_t>(bits)));
  const std::uint64_t size = draws.below(std::uint64_t{1} << width);
  return draws.coin() ? -static_cast<double>(size) : static_cast<double>(size);
}

double any_finite(DrawStream& draws) {
  const std::uint64_t bits = draws.any_bits();
  const double value = std::bit_cast<double>(bits);
  // An infinity or NaN pattern becomes a number of the greatest binade.
  return (bits >> 52 & 0x7ff) == 0x7ff ? std::bit_cast<double>(bits & ~(std::uint64_t{1} << 52)) : value;
}

double ordinary(DrawStream& draws) {
  const std::uint64_t k = draws.below(std::uint64_t{1} << 53);
  return (static_cast<double>(k) - 0x1p52) * 0x1p-52;
}

double typed(DrawStream& draws) {
  static constexpr std::array<double, 24> values{0.0,     1.0,       0.1,  0.2,     0.3, 0.5, 2.0,  0.7,
                                                 1.0 / 3, 2.0 / 3,   0.6,  1.1,     3.3, 10,  12.5, 99.99,
                                                 100,     1000000.1, 1e-3, 3.14159, 0.9, 0.4, 0.8,  1e6};
  const double value = values[draws.below(values.size())];
  return draws.one_in(4) ? -value : value;
}

double mixed_exponent(DrawStream& draws) {
  const auto significand = up_to(draws, 15);
  const double sign = either_sign(draws);
  const int exponent = integer_in(draws, -1074, 1020);  // 15 * 2^1020 is the greatest
  return sign * std::ldexp(significand, exponent);
}

int scale_exponent(DrawStream& draws) {
  switch (draws.below(16)) {
    default: return 0;
    case 9: return 39;
    case 10: return -39;
    case 11: return 500;
    case 12: return -537;
    case 13: return -1074;
    case 14: return 960;
    case 15: return integer_in(draws, -1000, 899);
  }
}

double beside_half_an_ulp(DrawStream& draws, int first, int places) {
  const double bit = std::ldexp(1, first - static_cast<int>(draws.below(static_cast<std::uint64_t>(places))));
  return draws.coin() ? 0x1p-53 - bit : 0x1p-53 + bit;
}

std::size_t list_length(DrawStream& draws) {
  const std::uint64_t k = draws.below(32);
  if (k < 30) return 3 + k % 6;
  return k == 30 ? draws.below(3) : 9 + draws.below(32);
}

double moved_by_ulps(double value, int ulps) {
  const double towards = ulps > 0 ? std::numeric_limits<double>::max() : std::numeric_limits<double>::lowest();
  for (int i = ulps > 0 ? ulps : -ulps; i > 0; --i) value = std::nextafter(value, towards);
  return value;
}

}  // namespace touchstone::catalogue
