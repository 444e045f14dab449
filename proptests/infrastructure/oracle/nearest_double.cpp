// SPDX-License-Identifier: Apache-2.0
#include "oracle/exact/numbers/nearest_double.h"

#include <mpfr.h>

#include <bit>
#include <cstdint>
#include <limits>

#include "catalogue/families/numbers.h"
#include "catalogue/judge/environment.h"
#include "oracle/exact/numbers/decode.h"
#include "proptests/catch.h"

namespace touchstone::proptests::nearest_double_tests {
namespace {

using catalogue::DrawStream, catalogue::Environment, catalogue::environment_count;
using oracle::Integer;
using oracle::Rational;

/// MPFR's own rounding to binary64, subnormals included.
double by_mpfr(const Rational& value) {
  const mpfr_exp_t least = mpfr_get_emin(), greatest = mpfr_get_emax();
  mpfr_set_emin(-1073), mpfr_set_emax(1024);
  mpfr_t rounded;
  mpfr_init2(rounded, 53);
  mpfr_subnormalize(rounded, mpfr_set_q(rounded, value.get_mpq_t(), MPFR_RNDN), MPFR_RNDN);
  const double result = mpfr_get_d(rounded, MPFR_RNDN);
  mpfr_clear(rounded);
  mpfr_set_emin(least), mpfr_set_emax(greatest);
  return result;
}

std::uint64_t bits(double value) { return std::bit_cast<std::uint64_t>(value); }

Rational times_power(const Rational& value, int exponent) { return oracle::scaled(value, exponent); }

/// A double, halfway between two, close to halfway, a quotient, or far outside of the range.
Rational drawn(DrawStream& draws) {
  const double some = draws.below(2) == 0 ? catalogue::any_finite(draws) : catalogue::mixed_exponent(draws);
  const Rational value = oracle::exact(some), ulp = times_power(Rational(1), oracle::ulp_exponent(value));
  switch (draws.below(7)) {
    case 0: return value;
    case 1: return Rational(value + ulp / 2);
    case 2: return Rational(value + ulp / 2 + times_power(ulp, -static_cast<int>(draws.below(200))));
    case 3: return Rational(value + ulp / 2 - times_power(ulp, -static_cast<int>(draws.below(200))));
    case 4: return Rational(value + ulp * Rational(1, 1 + static_cast<std::int64_t>(draws.below(1000))));
    case 5: {  // around 2^1024 - 2^970, from where on the nearest is infinite
      const Rational end(times_power(Rational(1), 1024) - times_power(Rational(1), 970));
      return Rational(end + times_power(Rational(static_cast<std::int64_t>(draws.below(7)) - 3), 969));
    }
    default: {
      const int exponent = static_cast<int>(draws.below(200)) - 100;
      return times_power(Rational(value / (1 + static_cast<std::int64_t>(draws.below(1000)))), exponent);
    }
  }
}

/// Where the rounding changes next, per the margin: not before it and right after it, on one side at least.
bool margin_is_tight(const Rational& value) {
  const Rational step = oracle::rounding_margin(value) * times_power(Rational(1), oracle::ulp_exponent(value));
  const Rational less(step * Rational(1023, 1024)), more(step + step / 1024);
  const auto nearest = [](const Rational& x) {  // apart from the sign of a zero
    const double rounded = oracle::nearest_double(x);
    return bits(rounded) << 1 == 0 ? 0 : bits(rounded);
  };
  const std::uint64_t here = nearest(value);
  const bool not_before = nearest(value - less) == here && nearest(value + less) == here;
  return not_before && (nearest(value - more) != here || nearest(value + more) != here);
}

}  // namespace

TEST_CASE("nearest double: rounds as MPFR does, in every floating-point environment") {
  DrawStream draws = DrawStream::seeded(20240602);
  int wrong = 0, halfway = 0, subnormal = 0, infinite = 0;
  for (int i = 0; i < 60000; ++i) {
    const Rational value = drawn(draws);
    const double expected = by_mpfr(value);
    std::uint64_t found = 0;
    {
      const Environment set(static_cast<std::size_t>(i) % environment_count);
      found = bits(oracle::nearest_double(value));
    }
    wrong += found != bits(expected);
    halfway += oracle::rounding_margin(value) == 0;
    subnormal += expected != 0 && std::abs(expected) < std::numeric_limits<double>::min();
    infinite += std::abs(expected) > std::numeric_limits<double>::max();
  }
  CHECK(wrong == 0);
  CHECK(halfway > 1000);
  CHECK(subnormal > 100);
  CHECK(infinite > 1000);
}

TEST_CASE("nearest double: zero is +0, a value too small keeps its sign, ties at both ends of the range go to even") {
  const Rational least = oracle::exact(std::numeric_limits<double>::denorm_min());
  const Rational greatest = oracle::exact(std::numeric_limits<double>::max());
  const Rational half_ulp = times_power(Rational(1), 970), infinity_from(greatest + half_ulp);
  CHECK(bits(oracle::nearest_double(Rational(0))) == 0);
  CHECK(bits(oracle::nearest_double(Rational(least / 2))) == 0);
  CHECK(bits(oracle::nearest_double(Rational(-least / 2))) == std::uint64_t{1} << 63);
  CHECK(oracle::nearest_double(Rational(least * Rational(3, 2))) == 2 * std::numeric_limits<double>::denorm_min());
  CHECK(oracle::nearest_double(infinity_from) == std::numeric_limits<double>::infinity());
  CHECK(oracle::nearest_double(Rational(infinity_from - times_power(Rational(1), -2000))) ==
        std::numeric_limits<double>::max());
  CHECK(oracle::nearest_double(Rational(-infinity_from)) == -std::numeric_limits<double>::infinity());
}

TEST_CASE("rounding margin: the rounding stays within it and changes beyond it") {
  DrawStream draws = DrawStream::seeded(20240603);
  int wrong = 0, asked = 0;
  for (int i = 0; i < 30000; ++i) {
    const Rational value = drawn(draws);
    if (oracle::rounding_margin(value) == 0) continue;
    ++asked, wrong += !margin_is_tight(value);
  }
  CHECK(wrong == 0);
  CHECK(asked > 10000);
}

TEST_CASE("rounding margin: far beyond the range it is the distance from the tie with infinity") {
  const Rational far(times_power(Rational(1), 1100) + times_power(Rational(1), 970));  // 2^129 + 1/2 units of 2^971
  const Integer expected((Integer(1) << 129) - (Integer(1) << 53) + 1);
  CHECK(oracle::rounding_margin(far) == expected);
}

}  // namespace touchstone::proptests::nearest_double_tests
