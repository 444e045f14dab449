// SPDX-License-Identifier: Apache-2.0
#include "robust/kernel/integers/one_root.h"

#include <bit>
#include <cstdint>

#include "robust/kernel/integers/dyadic.h"
#include "robust/kernel/integers/quadratic_root.h"

namespace touchstone::robust::kernel {
namespace {

/// The square of whichever number has a root.
const mpq_class& square_of(const OneRoot& a, const OneRoot& b) { return a.rational() ? b.d : a.d; }

/// number * 2^exponent
mpq_class times_power(const mpq_class& number, std::int64_t exponent) {
  mpq_class result;
  if (exponent >= 0) mpq_mul_2exp(result.get_mpq_t(), number.get_mpq_t(), static_cast<mp_bitcnt_t>(exponent));
  else mpq_div_2exp(result.get_mpq_t(), number.get_mpq_t(), static_cast<mp_bitcnt_t>(-exponent));
  return result;
}

/// a * 2^exponent, rounded. With p = a / b, q = e / f and d = g / h, the number is a f h plus the root of b^2 e^2 g h,
/// over b f h.
double rounded(const OneRoot& a, std::int64_t exponent) {
  if (a.rational()) return round_quotient(a.p.get_num(), a.p.get_den(), exponent);
  const mpz_class &f = a.q.get_den(), &h = a.d.get_den(), &b = a.p.get_den();
  const mpz_class whole = a.p.get_num() * f * h, of_root = b * a.q.get_num(), below = b * f * h;
  const mpz_class square = of_root * of_root * a.d.get_num() * h;
  return round_quadratic_root(whole, sgn(a.q), square, below, exponent);
}

}  // namespace

OneRoot with_root(const mpq_class& p, const mpq_class& q, const mpq_class& square) {
  const mpz_class product = square.get_num() * square.get_den();
  if (sgn(q) == 0 || mpz_perfect_square_p(product.get_mpz_t()) == 0) return {p, q, square};
  return mpq_class(p + q * mpq_class(sqrt(product)) / square.get_den());
}

OneRoot operator+(const OneRoot& a, const OneRoot& b) { return {a.p + b.p, a.q + b.q, square_of(a, b)}; }
OneRoot operator-(const OneRoot& a, const OneRoot& b) { return {a.p - b.p, a.q - b.q, square_of(a, b)}; }
OneRoot operator*(const OneRoot& a, const OneRoot& b) {
  const mpq_class& d = square_of(a, b);
  return {a.p * b.p + a.q * b.q * d, a.p * b.q + a.q * b.p, d};
}
OneRoot operator/(const OneRoot& a, const OneRoot& b) {
  const mpq_class norm = b.p * b.p - b.q * b.q * b.d;
  return a * OneRoot(b.p / norm, -b.q / norm, b.d);
}

int sign(const OneRoot& a) {
  const int of_p = sgn(a.p), of_root = sgn(a.q);
  if (of_p * of_root >= 0) return of_p != 0 ? of_p : of_root;
  return of_p * cmp(mpq_class(a.p * a.p), mpq_class(a.q * a.q * a.d));
}

mpq_class of_53_digits(const OneRoot& a) {
  if (sign(a) == 0) return 0;
  // Scaled into the range in which doubles have 53 digits. The steps are shorter than that range.
  for (std::int64_t exponent = 0;;) {
    const double number = rounded(a, exponent);
    const int field = static_cast<int>(std::bit_cast<std::uint64_t>(number) >> 52 & 0x7ff);
    if (field > 1 && field < 0x7ff) {  // with a field of 1 it may have been a subnormal number that was rounded up
      const Dyadic digits = dyadic(number);
      return times_power(mpq_class(digits.n), digits.exponent - exponent);
    }
    exponent += field <= 1 ? 900 : -900;
  }
}

double nearest(const OneRoot& a) { return sign(a) == 0 ? 0.0 : rounded(a, 0); }

}  // namespace touchstone::robust::kernel
