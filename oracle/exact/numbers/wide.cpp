// SPDX-License-Identifier: Apache-2.0
#include "oracle/exact/numbers/wide.h"

namespace touchstone::oracle {

Rational quotient(mpz_srcptr numerator, mpz_srcptr denominator) {
  Rational result;
  mpz_ptr above = result.get_num_mpz_t(), below = result.get_den_mpz_t();
  mpz_gcd(below, numerator, denominator);
  if (mpz_sgn(denominator) < 0) mpz_neg(below, below);
  mpz_divexact(above, numerator, below);
  mpz_divexact(below, denominator, below);
  return result;
}

}  // namespace touchstone::oracle
