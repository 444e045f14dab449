// SPDX-License-Identifier: Apache-2.0
#include "audit/judge/exact.h"

#include <mpfr.h>

namespace touchstone::audit {
namespace {

// More than the 1074 + 1024 bits between the ends of the binary64 range would be needed for an exact sum of any two
// doubles; 2400 also leave 300 bits beyond the last place for the question of ties.
constexpr mpfr_prec_t precision = 2400;

template <class Function>
Exact by_mpfr(const Exact& a, Function function) {
  if (!a.defined()) return a;
  mpfr_t argument, result;
  mpfr_init2(argument, precision);
  mpfr_init2(result, precision);
  mpfr_set_q(argument, a.value().get_mpq_t(), MPFR_RNDN);
  function(result, argument, MPFR_RNDN);
  mpq_class value;
  mpfr_get_q(value.get_mpq_t(), result);
  mpfr_clear(argument);
  mpfr_clear(result);
  return Exact(value);
}

}  // namespace

Exact cos(const Exact& a) { return by_mpfr(a, mpfr_cos); }
Exact sin(const Exact& a) { return by_mpfr(a, mpfr_sin); }
Exact acos(const Exact& a) {
  return a.defined() && abs(a.value()) > 1 ? a / Exact(0) : by_mpfr(a, mpfr_acos);
}
Exact sqrt(const Exact& a) {
  if (!a.defined() || sgn(a.value()) < 0) return a / Exact(0);
  const mpz_class numerator = ::sqrt(a.value().get_num()), denominator = ::sqrt(a.value().get_den());
  const mpq_class root(numerator, denominator);
  return root * root == a.value() ? Exact(root) : by_mpfr(a, mpfr_sqrt);
}

}  // namespace touchstone::audit
