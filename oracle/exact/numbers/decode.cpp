// SPDX-License-Identifier: Apache-2.0
#include "oracle/exact/numbers/decode.h"

namespace touchstone::oracle {

Rational scaled(Rational value, int exponent) {
  mpq_ptr number = value.get_mpq_t();
  if (exponent >= 0) {
    mpq_mul_2exp(number, number, static_cast<mp_bitcnt_t>(exponent));
  } else {
    mpq_div_2exp(number, number, static_cast<mp_bitcnt_t>(-exponent));
  }
  return value;
}

Rational scaled(const Integer& integer, int exponent) { return scaled(Rational(integer), exponent); }

Rational exact(double value) {
  const Dyadic parts = decode(value);
  return scaled(Integer(static_cast<std::int64_t>(parts.mantissa)), parts.exponent);
}

}  // namespace touchstone::oracle
