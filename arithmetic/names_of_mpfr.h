// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "arithmetic/names_of_gmp.h"
#include "arithmetic/rounded.h"

/// The functions of MPFR that this project uses, by MPFR's names: rounded correctly, so to the same bits.
namespace touchstone::arithmetic {
inline namespace TOUCHSTONE_WORDS {
namespace names {

using mpfr_t = Rounded[1];
using mpfr_ptr = Rounded*;
using mpfr_srcptr = const Rounded*;
using mpfr_prec_t = std::int64_t;
using mpfr_exp_t = std::int64_t;
using mpfr_rnd_t = Rounding;
inline constexpr Rounding MPFR_RNDN = Rounding::nearest, MPFR_RNDZ = Rounding::to_zero, MPFR_RNDU = Rounding::up,
                          MPFR_RNDD = Rounding::down;
enum mpfr_free_cache_t { MPFR_FREE_LOCAL_CACHE };

inline void mpfr_init2(mpfr_ptr x, mpfr_prec_t precision) { x->digits = Integer(), x->precision = precision; }
inline void mpfr_clear(mpfr_ptr) {}
template <class... Numbers>
void mpfr_clears(const Numbers&...) {}
inline void mpfr_free_cache2(mpfr_free_cache_t) {}
inline mpfr_prec_t mpfr_get_prec(mpfr_srcptr x) { return x->precision; }
inline mpfr_exp_t mpfr_get_exp(mpfr_srcptr x) { return x->exponent + static_cast<mpfr_exp_t>(x->digits.bit_length()); }
/// 0 has the least exponent, as in MPFR.
inline mpfr_exp_t mpfr_get_z_2exp(mpz_ptr n, mpfr_srcptr x) {
  *n = x->digits;
  return x->digits.is_zero() ? -4611686018427387903 : x->exponent;
}
inline void mpfr_set_z(mpfr_ptr r, mpz_srcptr n, mpfr_rnd_t mode) { round(*r, *n, 0, mode); }
inline void mpfr_set_si_2exp(mpfr_ptr r, std::int64_t n, mpfr_exp_t exponent, mpfr_rnd_t mode) {
  round(*r, Integer(n), exponent, mode);
}
inline void mpfr_set_q(mpfr_ptr r, mpq_srcptr q, mpfr_rnd_t mode) {
  round_quotient(*r, q->get_num(), q->get_den(), 0, mode);
}
inline void mpfr_get_q(mpq_ptr q, mpfr_srcptr x) { *q = x->value(); }
/// To nearest.
inline void mpfr_get_z(mpz_ptr n, mpfr_srcptr x, mpfr_rnd_t) { *n = x->nearest_integer(); }
inline void mpfr_div(mpfr_ptr r, mpfr_srcptr a, mpfr_srcptr b, mpfr_rnd_t mode) {
  round_quotient(*r, a->digits, b->digits, a->exponent - b->exponent, mode);
}
inline void mpfr_add(mpfr_ptr r, mpfr_srcptr a, mpfr_srcptr b, mpfr_rnd_t mode) { round_sum(*r, *a, *b, mode); }
inline void mpfr_mul_2ui(mpfr_ptr r, mpfr_srcptr a, std::uint64_t bits, mpfr_rnd_t mode) {
  round(*r, a->digits, a->exponent + static_cast<mpfr_exp_t>(bits), mode);
}
inline void mpfr_div_2ui(mpfr_ptr r, mpfr_srcptr a, std::uint64_t bits, mpfr_rnd_t mode) {
  round(*r, a->digits, a->exponent - static_cast<mpfr_exp_t>(bits), mode);
}
inline void mpfr_const_pi(mpfr_ptr r, mpfr_rnd_t mode) { round_pi(*r, mode); }
inline int mpfr_sqrt(mpfr_ptr r, mpfr_srcptr a, mpfr_rnd_t mode) { return round_square_root(*r, *a, mode), 0; }
inline int mpfr_sin_cos(mpfr_ptr sine, mpfr_ptr cosine, mpfr_srcptr a, mpfr_rnd_t mode) {
  return round_sine_cosine(sine, cosine, *a, mode), 0;
}
inline int mpfr_sin(mpfr_ptr r, mpfr_srcptr a, mpfr_rnd_t mode) { return mpfr_sin_cos(r, nullptr, a, mode); }
inline int mpfr_cos(mpfr_ptr r, mpfr_srcptr a, mpfr_rnd_t mode) { return mpfr_sin_cos(nullptr, r, a, mode); }
inline int mpfr_atan2(mpfr_ptr r, mpfr_srcptr y, mpfr_srcptr x, mpfr_rnd_t mode) {
  return round_arc_tangent(*r, *y, *x, mode), 0;
}
inline int mpfr_acos(mpfr_ptr r, mpfr_srcptr a, mpfr_rnd_t mode) { return round_arc_cosine(*r, *a, mode), 0; }

}  // namespace names
}  // namespace TOUCHSTONE_WORDS
}  // namespace touchstone::arithmetic
