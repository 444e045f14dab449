// SPDX-License-Identifier: Apache-2.0
#include "oracle/exact/circular.h"

#include <mpfr.h>

#include "oracle/exact/decode.h"

namespace touchstone::oracle {
namespace {

class Real {
 public:
  explicit Real(int bits) { mpfr_init2(value_, bits); }
  ~Real() { mpfr_clear(value_); }
  Real(const Real&) = delete;
  Real& operator=(const Real&) = delete;
  mpfr_ptr operator*() { return value_; }

 private:
  mpfr_t value_;
};

/// mpfr_set_d would compare doubles, which denormals-are-zero changes.
void set(Real& real, double value) {
  const Dyadic parts = decode(value);
  mpfr_set_si_2exp(*real, static_cast<long>(parts.mantissa), parts.exponent, MPFR_RNDN);
}

Rational rational(Real& real) {
  Integer whole;
  const mpfr_exp_t exponent = mpfr_get_z_2exp(whole.get_mpz_t(), *real);
  return scaled(whole, static_cast<int>(exponent));
}

/// MPFR rounds to nearest, so the true value lies strictly between the two neighbours of what it gives.
Enclosure enclose(Real& nearest) {
  Enclosure result;
  result.value = rational(nearest);
  mpfr_nextbelow(*nearest);
  result.low = rational(nearest);
  mpfr_nextabove(*nearest), mpfr_nextabove(*nearest);
  result.high = rational(nearest);
  return result;
}

}  // namespace

CosineAndSine cosine_and_sine(double u, int bits) {
  Real angle(53), cosine(bits), sine(bits);
  set(angle, u);
  mpfr_sin_cos(*sine, *cosine, *angle, MPFR_RNDN);
  return {enclose(cosine), enclose(sine)};
}

mpz_class quarter_turns(double u) {
  Real angle(1200), half_pi(1200);  // |u| < 2^1024, so the quotient is right to 2^-100
  set(angle, u);
  mpfr_const_pi(*half_pi, MPFR_RNDN);
  mpfr_div_2ui(*half_pi, *half_pi, 1, MPFR_RNDN);
  mpfr_div(*angle, *angle, *half_pi, MPFR_RNDN);
  Integer turns;
  mpfr_get_z(turns.get_mpz_t(), *angle, MPFR_RNDN);
  return turns;
}

}  // namespace touchstone::oracle
