// SPDX-License-Identifier: Apache-2.0
#include "robust/kernel/integers/outward.h"

#include <algorithm>
#include <limits>

#include "robust/kernel/integers/rounding.h"
#include "robust/kernel/integers/term_sum.h"

namespace touchstone::robust::kernel {
namespace {

constexpr std::int64_t precision = 53, least_exponent = -1074;

/// The digits of a magnitude without the last `dropped` ones, and a flag that tells whether one of those is set.
struct Shortened {
  Int128 digits;
  bool lost;
};

std::int64_t width(const Int128& n) { return bit_width(static_cast<UInt128>(n < 0 ? -n : n)); }
Shortened shortened(const Int128& n, std::int64_t dropped) {
  const auto size = static_cast<UInt128>(n < 0 ? -n : n);
  if (dropped >= 128) return {0, size != 0};
  const UInt128 digits = size >> dropped;
  return {static_cast<Int128>(digits), digits << dropped != size};
}

std::int64_t width(const mpz_class& n) {
  return sgn(n) == 0 ? 0 : static_cast<std::int64_t>(mpz_sizeinbase(n.get_mpz_t(), 2));
}
Shortened shortened(const mpz_class& n, std::int64_t dropped) {
  mpz_class digits;
  mpz_tdiv_q_2exp(digits.get_mpz_t(), n.get_mpz_t(), static_cast<mp_bitcnt_t>(dropped));
  const bool lost = sgn(n) != 0 && static_cast<std::int64_t>(mpz_scan1(n.get_mpz_t(), 0)) < dropped;
  return {static_cast<Int128>(mpz_get_ui(digits.get_mpz_t())), lost};
}

/// `up`: towards +infinity, otherwise towards -infinity.
template <class Integer>
double rounded(const Integer& n, std::int64_t exponent, bool up) {
  const int sign = sign_of(n);
  const std::int64_t dropped = std::max<std::int64_t>({width(n) - precision, least_exponent - exponent, 0});
  auto [digits, lost] = shortened(n, dropped);
  const bool away = up == (sign > 0);
  if (lost && away) digits += 1;
  const double result = round_scaled(sign < 0 ? -digits : digits, exponent + dropped);
  // Exact, or out of range.
  constexpr double greatest = std::numeric_limits<double>::max();
  if (std::bit_cast<std::uint64_t>(result) << 1 != std::uint64_t{0x7ff} << 53 || away) return result;
  return sign < 0 ? -greatest : greatest;
}

}  // namespace

double round_down(Int128 n, std::int64_t exponent) { return rounded(n, exponent, false); }
double round_down(const mpz_class& n, std::int64_t exponent) { return rounded(n, exponent, false); }
double round_up(Int128 n, std::int64_t exponent) { return rounded(n, exponent, true); }
double round_up(const mpz_class& n, std::int64_t exponent) { return rounded(n, exponent, true); }

}  // namespace touchstone::robust::kernel
