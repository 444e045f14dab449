// SPDX-License-Identifier: Apache-2.0
#include "catalogue/numbers/ulps.h"

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace touchstone::catalogue {
namespace {

struct Format {
  int precision;                   // bits of the significand
  std::int64_t least_exponent;     // of the unit in the last place of subnormals
  std::int64_t greatest_exponent;  // 2^greatest is the first power beyond the range
};

Format format_of(bool binary32) { return binary32 ? Format{24, -149, 128} : Format{53, -1074, 1024}; }

mpz_class shifted(const mpz_class& value, std::int64_t bits) {
  mpz_class result;
  if (bits >= 0) {
    mpz_mul_2exp(result.get_mpz_t(), value.get_mpz_t(), static_cast<mp_bitcnt_t>(bits));
  } else {
    mpz_fdiv_q_2exp(result.get_mpz_t(), value.get_mpz_t(), static_cast<mp_bitcnt_t>(-bits));
  }
  return result;
}

/// floor(log2(|x|)) of x != 0.
std::int64_t binary_exponent(const mpq_class& x) {
  const mpz_class num = abs(x.get_num());
  const mpz_class& den = x.get_den();
  const std::int64_t guess = static_cast<std::int64_t>(mpz_sizeinbase(num.get_mpz_t(), 2)) -
                             static_cast<std::int64_t>(mpz_sizeinbase(den.get_mpz_t(), 2));
  const bool reached = guess >= 0 ? num >= shifted(den, guess) : shifted(num, -guess) >= den;
  return reached ? guess : guess - 1;
}

std::int64_t exponent_of_ulp(const mpq_class& x, const Format& format) {
  if (sgn(x) == 0) return format.least_exponent;
  return std::max(binary_exponent(x) - format.precision + 1, format.least_exponent);
}

}  // namespace

mpq_class exact_value(double value) {
  const auto bits = std::bit_cast<std::uint64_t>(value);
  const int biased = static_cast<int>(bits >> 52 & 0x7ff);
  const std::uint64_t fraction = bits & 0xfffffffffffffu;
  mpz_class significand(biased == 0 ? fraction : fraction | 0x10000000000000u);
  if (bits >> 63 != 0) significand = -significand;
  const std::int64_t exponent = (biased == 0 ? 1 : biased) - 1075;
  if (exponent >= 0) return mpq_class(shifted(significand, exponent));
  mpq_class result(significand, shifted(mpz_class(1), -exponent));
  result.canonicalize();
  return result;
}

double nearest(const mpq_class& truth, bool binary32) {
  if (sgn(truth) == 0) return 0.0;
  const Format format = format_of(binary32);
  const std::int64_t unit = exponent_of_ulp(truth, format);
  mpz_class num = abs(truth.get_num()), den = truth.get_den();
  unit >= 0 ? den = shifted(den, unit) : num = shifted(num, -unit);
  mpz_class count, rest;
  mpz_fdiv_qr(count.get_mpz_t(), rest.get_mpz_t(), num.get_mpz_t(), den.get_mpz_t());
  const int half = cmp(mpz_class(2 * rest), den);
  if (half > 0 || (half == 0 && mpz_odd_p(count.get_mpz_t()) != 0)) ++count;
  // count <= 2^53 is a double; a carry to 2^precision only moves the exponent.
  const bool beyond = sgn(count) != 0 &&
                      static_cast<std::int64_t>(mpz_sizeinbase(count.get_mpz_t(), 2)) + unit > format.greatest_exponent;
  const double size = beyond ? HUGE_VAL : std::ldexp(static_cast<double>(count.get_ui()), static_cast<int>(unit));
  return sgn(truth) < 0 ? -size : size;
}

double distance_in_ulps(double answered, const mpq_class& truth, bool binary32) {
  const double right = nearest(truth, binary32);
  if (answered == right) return 0;
  if (!std::isfinite(answered)) return HUGE_VAL;
  const mpq_class gap = abs(exact_value(answered) - truth);
  const std::int64_t unit = exponent_of_ulp(truth, format_of(binary32));
  const mpq_class scaled = unit >= 0 ? mpq_class(gap / mpq_class(shifted(mpz_class(1), unit)))
                                     : mpq_class(gap * mpq_class(shifted(mpz_class(1), -unit)));
  if (scaled > mpq_class(shifted(mpz_class(1), 990))) return 0x1p990;
  const double distance = scaled.get_d();
  return distance > 0 ? distance : std::numeric_limits<double>::min();
}

}  // namespace touchstone::catalogue
