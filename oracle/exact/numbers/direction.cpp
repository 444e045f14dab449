// SPDX-License-Identifier: Apache-2.0
#include "oracle/exact/numbers/direction.h"

#include <mpfr.h>

#include <algorithm>

namespace touchstone::oracle {
namespace {

Rational angle(const Integer& x, const Integer& y, int bits, mpfr_rnd_t direction) {
  const auto places = [](const Integer& n) {
    return static_cast<mpfr_prec_t>(std::max<std::size_t>(mpz_sizeinbase(n.get_mpz_t(), 2), 2));
  };
  mpfr_t along, across, turn, whole;
  mpfr_init2(along, places(x)), mpfr_init2(across, places(y)), mpfr_init2(turn, bits), mpfr_init2(whole, bits);
  mpfr_set_z(along, x.get_mpz_t(), MPFR_RNDN), mpfr_set_z(across, y.get_mpz_t(), MPFR_RNDN);  // exact
  mpfr_atan2(turn, across, along, direction);
  if (sgn(y) < 0) {
    mpfr_const_pi(whole, direction), mpfr_mul_2ui(whole, whole, 1, direction);
    mpfr_add(turn, turn, whole, direction);
  }
  Rational result;
  mpfr_get_q(result.get_mpq_t(), turn);
  mpfr_clears(along, across, turn, whole, static_cast<mpfr_ptr>(nullptr));
  return result;
}

}  // namespace

AngleBetween angle_between(const Integer& x, const Integer& y, int bits) {
  return {angle(x, y, bits, MPFR_RNDD), angle(x, y, bits, MPFR_RNDU)};
}

}  // namespace touchstone::oracle
