// SPDX-License-Identifier: Apache-2.0
#include "oracle/exact/numbers/circular.h"

#include <mpfr.h>

#include <algorithm>
#include <cstdint>

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
  mpfr_set_si_2exp(*real, static_cast<std::int64_t>(parts.mantissa), parts.exponent, MPFR_RNDN);
}

/// `away` (the exponent of a power of two) bounds the distance of the function's value at the angle from that at u.
/// MPFR rounds to nearest, by less than one unit of the last of its bits.
Enclosure enclose(Real& nearest, const mpfr_exp_t* away) {
  Enclosure result{{}, Integer(1), {}};
  result.exponent = static_cast<int>(mpfr_get_z_2exp(result.nearest.get_mpz_t(), *nearest));
  if (away != nullptr) {
    const mpfr_exp_t units = std::max<mpfr_exp_t>(*away - result.exponent, 0);
    result.width += Integer(1) << static_cast<mp_bitcnt_t>(units);
  }
  return result;
}

CosineAndSine enclosures(Real& angle, int bits, const mpfr_exp_t* away) {
  Real cosine(bits), sine(bits);
  mpfr_sin_cos(*sine, *cosine, *angle, MPFR_RNDN);
  return {enclose(cosine, away), enclose(sine, away)};
}

}  // namespace

CosineAndSine cosine_and_sine(double u, int bits) {
  Real angle(53);
  set(angle, u);
  return enclosures(angle, bits, nullptr);
}

CosineAndSine cosine_and_sine(const Rational& u, int bits) {
  const auto size = [](mpz_srcptr part) { return static_cast<int>(mpz_sizeinbase(part, 2)); };
  const int above = size(u.get_num_mpz_t()) - size(u.get_den_mpz_t()) + 1;  // |u| < 2^above
  Real angle(bits + std::max(above, 0));
  mpfr_set_q(*angle, u.get_mpq_t(), MPFR_RNDN);
  // Neither function is steeper than 1, so both move by no more than the angle: half a unit of its last bit.
  const mpfr_exp_t away = mpfr_get_exp(*angle) - mpfr_get_prec(*angle);
  return enclosures(angle, bits, &away);
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
