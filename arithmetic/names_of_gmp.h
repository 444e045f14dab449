// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdio>
#include <cstdlib>

#include "arithmetic/floating.h"

/// The functions of GMP that this project uses, by GMP's names and with GMP's meaning. A "limb", "ui" and "si" have 64
/// bits, whatever the words of the numbers are and whatever long is.
namespace touchstone::arithmetic {
inline namespace TOUCHSTONE_WORDS {
namespace names {

using mpz_class = Integer;
using mpq_class = Rational;
using mpf_class = Floating;
using mpz_t = Integer[1];
using mpz_ptr = Integer*;
using mpz_srcptr = const Integer*;
using mpq_ptr = Rational*;
using mpq_srcptr = const Rational*;
using mpf_ptr = Floating*;
using mpf_srcptr = const Floating*;
using mp_limb_t = std::uint64_t;
using mp_bitcnt_t = std::uint64_t;
using mp_exp_t = std::int64_t;

inline void mp_set_memory_functions(void* (*take)(std::size_t), void* (*)(void*, std::size_t, std::size_t),
                                    void (*give)(void*, std::size_t)) {
  memory() = {take, give};
}

inline int mpz_sgn(mpz_srcptr a) { return a->sign(); }
inline void mpz_set(mpz_ptr r, mpz_srcptr a) { *r = *a; }
inline void mpz_neg(mpz_ptr r, mpz_srcptr a) { *r = *a, r->negate(); }
inline void mpz_abs(mpz_ptr r, mpz_srcptr a) { *r = *a, r->set_negative(false); }
inline void mpz_mul(mpz_ptr r, mpz_srcptr a, mpz_srcptr b) { *r = *a * *b; }
inline void mpz_addmul(mpz_ptr r, mpz_srcptr a, mpz_srcptr b) { *r += *a * *b; }
inline void mpz_submul(mpz_ptr r, mpz_srcptr a, mpz_srcptr b) { *r -= *a * *b; }
/// Base 2 is the only one.
inline std::size_t mpz_sizeinbase(mpz_srcptr a, int) { return a->is_zero() ? 1 : a->bit_length(); }
/// From bit 0 on.
inline mp_bitcnt_t mpz_scan1(mpz_srcptr a, mp_bitcnt_t) { return a->zeros(); }
inline std::uint64_t mpz_get_ui(mpz_srcptr a) { return a->get_ui(); }
inline mp_limb_t mpz_getlimbn(mpz_srcptr a, std::int64_t i) { return a->bits64(static_cast<std::size_t>(i)); }
inline int mpz_odd_p(mpz_srcptr a) { return a->odd() ? 1 : 0; }
inline void mpz_mul_2exp(mpz_ptr r, mpz_srcptr a, mp_bitcnt_t bits) { *r = *a, *r <<= bits; }
inline void mpz_tdiv_q_2exp(mpz_ptr r, mpz_srcptr a, mp_bitcnt_t bits) { *r = *a, r->cut(bits); }
inline void mpz_fdiv_q_2exp(mpz_ptr r, mpz_srcptr a, mp_bitcnt_t bits) { *r = *a, *r >>= bits; }
inline void mpz_tdiv_r_2exp(mpz_ptr r, mpz_srcptr a, mp_bitcnt_t bits) {
  Integer above = *a;
  above.cut(bits);
  *r = *a - (above << bits);
}
inline void mpz_tdiv_qr(mpz_ptr q, mpz_ptr r, mpz_srcptr a, mpz_srcptr b) { Integer::divide(*a, *b, q, r); }
inline void mpz_fdiv_qr(mpz_ptr q, mpz_ptr r, mpz_srcptr a, mpz_srcptr b) {
  const Integer divisor = *b;
  Integer::divide(*a, *b, q, r);
  if (r->sign() * divisor.sign() < 0) --*q, *r += divisor;
}
inline void mpz_fdiv_q(mpz_ptr q, mpz_srcptr a, mpz_srcptr b) {
  Integer rest;
  mpz_fdiv_qr(q, &rest, a, b);
}
inline void mpz_cdiv_q(mpz_ptr q, mpz_srcptr a, mpz_srcptr b) {
  Integer rest;
  mpz_fdiv_qr(q, &rest, a, b);
  if (!rest.is_zero()) ++*q;
}
inline std::uint64_t mpz_fdiv_ui(mpz_srcptr a, std::uint64_t b) {
  const Integer divisor(b);
  Integer quotient, rest;
  mpz_fdiv_qr(&quotient, &rest, a, &divisor);
  return rest.get_ui();
}
inline void mpz_divexact(mpz_ptr q, mpz_srcptr a, mpz_srcptr b) { Integer::divide(*a, *b, q, nullptr); }
inline int mpz_divisible_p(mpz_srcptr a, mpz_srcptr b) { return (*a % *b).is_zero() ? 1 : 0; }
inline void mpz_gcd(mpz_ptr r, mpz_srcptr a, mpz_srcptr b) { *r = gcd(*a, *b); }
inline void mpz_lcm(mpz_ptr r, mpz_srcptr a, mpz_srcptr b) { *r = lcm(*a, *b); }
inline void mpz_sqrtrem(mpz_ptr root, mpz_ptr rest, mpz_srcptr a) {
  const Integer n = *a;
  *root = sqrt(n);
  *rest = n - *root * *root;
}
/// a is not negative.
inline int mpz_root(mpz_ptr r, mpz_srcptr a, std::uint64_t degree) {
  const Integer n = *a;
  *r = root(n, degree);
  return power(*r, degree) == n ? 1 : 0;
}
inline int mpz_perfect_square_p(mpz_srcptr a) { return is_square(*a) ? 1 : 0; }
inline void mpz_pow_ui(mpz_ptr r, mpz_srcptr a, std::uint64_t exponent) { *r = power(*a, exponent); }
inline void mpz_ui_pow_ui(mpz_ptr r, std::uint64_t a, std::uint64_t exponent) { *r = power(Integer(a), exponent); }
/// The number is not negative.
inline void mpz_setbit(mpz_ptr r, mp_bitcnt_t place) { r->set_bit(place, true); }
inline mp_bitcnt_t mpz_popcount(mpz_srcptr a) { return a->sign() < 0 ? ~mp_bitcnt_t{0} : a->count_ones(); }
inline mp_bitcnt_t mpz_remove(mpz_ptr r, mpz_srcptr a, mpz_srcptr factor) {
  Integer n = *a, quotient, rest;
  const Integer divisor = *factor;
  mp_bitcnt_t times = 0;
  for (; !n.is_zero(); ++times, n = quotient) {
    Integer::divide(n, divisor, &quotient, &rest);
    if (!rest.is_zero()) break;
  }
  *r = std::move(n);
  return times;
}
inline double mpz_get_d_2exp(std::int64_t* exponent, mpz_srcptr a) { return a->leading_digits(*exponent); }
/// Words of 64 bits, the lowest first.
inline void mpz_import(mpz_ptr r, std::size_t count, int, std::size_t, int, std::size_t, const std::uint64_t* words) {
  r->set_bits64(words, count);
}
/// GMP's is a view, this a copy.
inline mpz_srcptr mpz_roinit_n(mpz_ptr r, const mp_limb_t* limbs, std::int64_t size) {
  r->set_bits64(limbs, static_cast<std::size_t>(size < 0 ? -size : size));
  r->set_negative(size < 0);
  return r;
}

inline void mpq_mul_2exp(mpq_ptr r, mpq_srcptr a, mp_bitcnt_t bits) { *r = *a, *r <<= bits; }
inline void mpq_div_2exp(mpq_ptr r, mpq_srcptr a, mp_bitcnt_t bits) { *r = *a, *r >>= bits; }
inline void mpq_neg(mpq_ptr r, mpq_srcptr a) { *r = *a, r->negate(); }

inline void mpf_div_2exp(mpf_ptr r, mpf_srcptr a, mp_bitcnt_t bits) {
  *r = *a, r->scale(-static_cast<std::int64_t>(bits));
}
/// With the format "%.NFg" alone.
inline int gmp_snprintf(char* text, std::size_t size, const char* format, mpf_srcptr x) {
  return std::snprintf(text, size, "%s", general_text(*x, std::atoi(format + 2)).c_str());
}

}  // namespace names
}  // namespace TOUCHSTONE_WORDS
}  // namespace touchstone::arithmetic
