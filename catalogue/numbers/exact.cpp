// SPDX-License-Identifier: Apache-2.0
#include "catalogue/numbers/exact.h"

#include <mpfr.h>

#include <algorithm>

namespace touchstone::catalogue {
namespace {

// The exact sum of any two doubles needs no more than the 1074 + 1024 bits between the ends of the binary64 range; 2400
// leave another 300 bits beyond the last place to decide halfway cases.
constexpr mpfr_prec_t precision = 2400;

// Distinct directions of doubles have a sine of at least 2^-4200, so their cosine is at least 2^-8401 away from 1: a
// root in the denominator of such a cosine must distinguish it from 1.
constexpr mpfr_prec_t nearest_cosine = 8402, precision_of_roots = 9000;

/// MPFR keeps constants for each thread, and frees them only on request.
struct Constants {
  ~Constants() { mpfr_free_cache2(MPFR_FREE_LOCAL_CACHE); }
};

template <class Function>
Exact by_mpfr(const Exact& a, Function function, mpfr_prec_t of_argument = precision,
              mpfr_prec_t of_result = precision) {
  if (!a.defined()) return a;
  [[maybe_unused]] static thread_local const Constants freed_when_the_thread_ends;
  mpfr_t argument, result;
  mpfr_init2(argument, of_argument);
  mpfr_init2(result, of_result);
  const mpq_class exactly = a.value();
  mpfr_set_q(argument, exactly.get_mpq_t(), MPFR_RNDN);
  function(result, argument, MPFR_RNDN);
  mpq_class value;
  mpfr_get_q(value.get_mpq_t(), result);
  mpfr_clear(argument);
  mpfr_clear(result);
  return Exact(value);
}

}  // namespace

mpq_class Exact::in_full() const {
  mpq_class value(static_cast<std::int64_t>(digits_));
  if (power_ >= 0) value <<= static_cast<mp_bitcnt_t>(power_);
  else value >>= static_cast<mp_bitcnt_t>(-power_);
  return value;
}

void Exact::keep(mpq_class value) {
  const mpz_srcptr numerator = value.get_num_mpz_t(), denominator = value.get_den_mpz_t();
  const std::size_t below = mpz_sizeinbase(denominator, 2) - 1;
  const mp_bitcnt_t zeros = sgn(value) == 0 ? 0 : mpz_scan1(numerator, 0);
  if (mpz_scan1(denominator, 0) != below || mpz_sizeinbase(numerator, 2) - zeros > 62) {
    rational_ = std::move(value);
    return;
  }
  const mpz_class digits = value.get_num() >> zeros;
  digits_ = digits.get_si(), power_ = static_cast<int>(zeros) - static_cast<int>(below);
}

Exact cos(const Exact& a) { return by_mpfr(a, mpfr_cos); }
Exact sin(const Exact& a) { return by_mpfr(a, mpfr_sin); }
Exact acos(const Exact& a) {
  if (!a.defined()) return a;
  const mpq_class exactly = a.value(), room = 1 - abs(exactly);
  if (sgn(room) < 0) return a / Exact(0);
  // If there is a room of 2^-k, an argument rounded to 2^-(precision + k) changes the room, and the angle from an end,
  // by 2^-precision relatively; and pi - angle must be as precise as that angle, which is the root of twice the room.
  const std::size_t numerator = mpz_sizeinbase(room.get_num_mpz_t(), 2),
                    denominator = mpz_sizeinbase(room.get_den_mpz_t(), 2);
  const auto near_end =
      sgn(room) == 0 ? nearest_cosine : static_cast<mpfr_prec_t>(denominator - std::min(numerator, denominator) + 2);
  return by_mpfr(a, mpfr_acos, precision + near_end, precision + near_end / 2);
}
Exact sqrt(const Exact& a) {
  if (!a.defined() || a < Exact(0)) return a / Exact(0);
  const mpq_class square = a.value();
  const mpz_class numerator = ::sqrt(square.get_num()), denominator = ::sqrt(square.get_den());
  const mpq_class root(numerator, denominator);
  return root * root == square ? Exact(root) : by_mpfr(a, mpfr_sqrt, precision_of_roots + 1, precision_of_roots);
}

}  // namespace touchstone::catalogue
