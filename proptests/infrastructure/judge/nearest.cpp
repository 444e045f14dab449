// SPDX-License-Identifier: Apache-2.0
#include <mpfr.h>

#include <bit>
#include <cmath>
#include <cstdint>

#include "catalogue/families/draw_stream.h"
#include "catalogue/numbers/ulps.h"
#include "proptests/catch.h"
#include "proptests/uses.h"

namespace touchstone::proptests::nearest_tests {
namespace {

constexpr std::uint64_t cases = 120000;  // for each of the two formats

mpq_class power_of_two(std::int64_t exponent) {
  mpq_class result(1);
  exponent < 0 ? mpq_div_2exp(result.get_mpq_t(), result.get_mpq_t(), static_cast<mp_bitcnt_t>(-exponent))
               : mpq_mul_2exp(result.get_mpq_t(), result.get_mpq_t(), static_cast<mp_bitcnt_t>(exponent));
  return result;
}

/// What MPFR rounds to, in the exponent range of the format.
double by_mpfr(const mpq_class& truth, bool binary32) {
  const mpfr_exp_t emin = mpfr_get_emin(), emax = mpfr_get_emax();
  mpfr_set_emin(binary32 ? -148 : -1073);  // MPFR's significands are below 1
  mpfr_set_emax(binary32 ? 128 : 1024);
  mpfr_t rounded;
  mpfr_init2(rounded, binary32 ? 24 : 53);
  const int ternary = mpfr_set_q(rounded, truth.get_mpq_t(), MPFR_RNDN);
  mpfr_subnormalize(rounded, ternary, MPFR_RNDN);
  const double result = mpfr_get_d(rounded, MPFR_RNDN);
  mpfr_clear(rounded);
  mpfr_set_emin(emin);
  mpfr_set_emax(emax);
  return result;
}

/// A unit in the last place of the binade that holds the truth.
mpq_class ulp_by_mpfr(const mpq_class& truth, bool binary32) {
  const std::int64_t least = binary32 ? -149 : -1074;
  if (sgn(truth) == 0) return power_of_two(least);
  mpfr_t towards_zero;
  mpfr_init2(towards_zero, 64);
  mpfr_set_q(towards_zero, truth.get_mpq_t(), MPFR_RNDZ);
  const std::int64_t exponent = mpfr_get_exp(towards_zero) - (binary32 ? 24 : 53);
  mpfr_clear(towards_zero);
  return power_of_two(std::max(exponent, least));
}

/// A rational of one of many kinds: any quotient, ties between two numbers of the format (subnormal ones too), and such
/// a tie or such a number and a little more or less, from below the range to beyond it.
mpq_class drawn(DrawStream& draws, bool binary32) {
  const std::int64_t digits = binary32 ? 24 : 53, low = binary32 ? -149 : -1074, high = binary32 ? 104 : 971;
  const bool quotient = draws.below(3) == 0;
  const std::uint64_t kind = draws.below(4);
  mpz_class size(static_cast<std::uint64_t>(
      draws.below(std::uint64_t{1} << (1 + draws.below(static_cast<std::uint64_t>(digits))))));
  if (kind != 0) size |= mpz_class(1) << static_cast<mp_bitcnt_t>(digits - 1);
  if (kind == 3) size = (mpz_class(1) << static_cast<mp_bitcnt_t>(digits)) - 1;
  std::int64_t exponent = 0;
  switch (draws.below(4)) {
    case 0: exponent = low; break;
    case 1: exponent = high; break;
    case 2: exponent = low - 60 + static_cast<std::int64_t>(draws.below(130)); break;
    default: exponent = low + static_cast<std::int64_t>(draws.below(static_cast<std::uint64_t>(high - low + 4)));
  }
  mpq_class result(size);
  if (quotient) {
    result /= mpq_class(1 + draws.below(std::uint64_t{1} << (1 + draws.below(62))));
  } else if (draws.below(2) == 1) {
    result += mpq_class(1, 2);
  }
  if (draws.below(3) == 0) result += power_of_two(-1 - static_cast<std::int64_t>(draws.below(200)));
  if (draws.below(3) == 0) result -= power_of_two(-1 - static_cast<std::int64_t>(draws.below(200)));
  result *= power_of_two(exponent);
  if (draws.below(2) == 1) result = -result;
  return result;
}

void hold_against_mpfr(bool binary32) {
  std::uint64_t wrong = 0, ties = 0, subnormal = 0, beyond = 0, zero = 0;
  for (std::uint64_t i = 0; i < cases; ++i) {
    DrawStream draws = DrawStream::seeded(seed_of(1, binary32 ? "nearest32" : "nearest64", i));
    const mpq_class truth = drawn(draws, binary32);
    const double expected = by_mpfr(truth, binary32), found = nearest(truth, binary32);
    if (found != expected) {
      if (wrong++ == 0) UNSCOPED_INFO(truth << " rounds to " << expected << ", not to " << found);
      continue;
    }
    if (std::isinf(expected)) {
      ++beyond;
      continue;
    }
    const mpq_class ulp = ulp_by_mpfr(truth, binary32), gap = abs(exact_value(expected) - truth);
    ties += gap * 2 == ulp;
    zero += expected == 0;
    subnormal += expected != 0 && std::fabs(expected) < (binary32 ? 0x1p-126 : 0x1p-1022);
    // Another number a few units away: the distance is exact up to its own rounding.
    const double answered = expected + static_cast<double>(static_cast<int>(draws.below(9)) - 4) * ulp.get_d();
    const double distance = distance_in_ulps(answered, truth, binary32);
    if (answered == expected) {
      wrong += distance != 0;
    } else if (std::isfinite(answered)) {
      const mpq_class exact = abs(exact_value(answered) - truth) / ulp;
      wrong += abs(exact_value(distance) - exact) > exact * power_of_two(-52);
    }
  }
  CHECK(wrong == 0);
  // The cases are those that are meant.
  CHECK(ties > cases / 100);
  CHECK(subnormal > cases / 100);
  CHECK(beyond > cases / 100);
  CHECK(zero > cases / 1000);
}

}  // namespace

TEST_CASE("nearest: MPFR rounds rationals to the same binary64, ties, subnormals and overflow included") {
  hold_against_mpfr(false);
}
TEST_CASE("nearest: MPFR rounds rationals to the same binary32, ties, subnormals and overflow included") {
  hold_against_mpfr(true);
}

TEST_CASE("nearest: the ends of the range by hand") {
  const mpq_class beyond = power_of_two(1024) - power_of_two(970), least = power_of_two(-1074);
  CHECK(nearest(beyond) == HUGE_VAL);  // the tie at the upper end goes to the even neighbour, which is 2^1024
  CHECK(nearest(beyond - power_of_two(-2000)) == 0x1.fffffffffffffp+1023);
  CHECK(nearest(-beyond) == -HUGE_VAL);
  CHECK(nearest(least / 2) == 0);
  CHECK(nearest(least / 2 + power_of_two(-3000)) == 5e-324);
  CHECK(nearest(least * 3 / 2) == 1e-323);  // between 1 and 2 units: 2 is even
  CHECK(std::signbit(nearest(-least / 4)));
  CHECK_FALSE(std::signbit(nearest(mpq_class(0))));
  CHECK(nearest(mpq_class(1, 10)) == 0.1);
  CHECK(nearest(mpq_class(1, 10), true) == 0.1f);
  CHECK(nearest(power_of_two(128) - power_of_two(103), true) == HUGE_VAL);
}

TEST_CASE(
    "distance_in_ulps: 0 for the nearest number alone, infinite for NaN and for an infinity where the truth is "
    "finite") {
  CHECK(distance_in_ulps(0.1, mpq_class(1, 10)) == 0);
  CHECK(distance_in_ulps(std::nextafter(1.0, 2), 1) == 1);
  CHECK(distance_in_ulps(std::nextafter(1.0, 0), 1) == 0.5);
  CHECK(distance_in_ulps(1, mpq_class(1) + power_of_two(-52) * 3 / 4) == 0.75);
  CHECK(distance_in_ulps(-0.0, 0) == 0);
  CHECK(distance_in_ulps(5e-324, 0) == 1);
  CHECK(distance_in_ulps(std::nan(""), 1) == HUGE_VAL);
  CHECK(distance_in_ulps(HUGE_VAL, 1) == HUGE_VAL);
  CHECK(distance_in_ulps(HUGE_VAL, power_of_two(1024)) == 0);
  CHECK(distance_in_ulps(-HUGE_VAL, power_of_two(1024)) == HUGE_VAL);
  CHECK(std::isfinite(distance_in_ulps(1e308, power_of_two(-1074))));  // however far
  CHECK(distance_in_ulps(0, power_of_two(-2000)) == 0);
}

TEST_CASE("exact_value: a double's bits as a rational") {
  CHECK(exact_value(0.1) == mpq_class("3602879701896397/36028797018963968"));
  CHECK(exact_value(-0.0) == 0);
  CHECK(exact_value(-5e-324) == -power_of_two(-1074));
  CHECK(exact_value(0x1.fffffffffffffp+1023) == power_of_two(1024) - power_of_two(971));
  CHECK(exact_value(-6) == -6);
}

}  // namespace touchstone::proptests::nearest_tests
