// SPDX-License-Identifier: Apache-2.0
#include "oracle/exact/decode.h"

namespace touchstone::oracle {

Rational scaled(const Rational& value, int exponent) {
  Rational result;
  if (exponent >= 0) {
    mpq_mul_2exp(result.get_mpq_t(), value.get_mpq_t(), static_cast<mp_bitcnt_t>(exponent));
  } else {
    mpq_div_2exp(result.get_mpq_t(), value.get_mpq_t(), static_cast<mp_bitcnt_t>(-exponent));
  }
  return result;
}

Rational scaled(const Integer& whole, int exponent) { return scaled(Rational(whole), exponent); }

Rational quotient(const Integer& numerator, const Integer& denominator) {
  Rational result(numerator, denominator);
  result.canonicalize();
  return result;
}

Rational exact(double value) {
  const Dyadic parts = decode(value);
  return scaled(Integer(static_cast<long>(parts.mantissa)), parts.exponent);
}

Integer widen(Int128 value) {
  const bool negative = value < 0;
  __extension__ typedef unsigned __int128 UnsignedInt128;
  const auto magnitude = negative ? -static_cast<UnsignedInt128>(value) : static_cast<UnsignedInt128>(value);
  Integer result(static_cast<unsigned long>(magnitude >> 64));
  result <<= 64;
  result += static_cast<unsigned long>(magnitude);
  if (negative) mpz_neg(result.get_mpz_t(), result.get_mpz_t());
  return result;
}

}  // namespace touchstone::oracle
