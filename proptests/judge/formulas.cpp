// SPDX-License-Identifier: Apache-2.0
#include <bit>
#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include "audit/inputs/numbers.h"
#include "audit/judge/exact.h"
#include "audit/judge/tracked.h"
#include "audit/judge/ulps.h"

/// The two number types in which the judge runs the slides' formulas again.
namespace touchstone::audit {
namespace {

/// A formula of a few steps, run in a floating-point type, in that type with its error bound, and exactly.
template <class Float>
struct Run {
  std::vector<Float> plain;
  std::vector<Tracked<Float>> tracked;
  std::vector<Exact> exact;

  void start(Float number) {
    plain.push_back(number), tracked.push_back(Tracked<Float>(number)), exact.push_back(Exact(exact_value(number)));
  }
  template <class Step>
  void apply(const Step& step, std::size_t i, std::size_t j) {
    plain.push_back(static_cast<Float>(step(plain[i], plain[j])));
    tracked.push_back(step(tracked[i], tracked[j]));
    exact.push_back(step(exact[i], exact[j]));
  }
  void apply(std::uint64_t operation, std::size_t i, std::size_t j) {
    switch (operation) {
      case 0:
        return apply([](const auto& a, const auto& b) { return a + b; }, i, j);
      case 1:
        return apply([](const auto& a, const auto& b) { return a - b; }, i, j);
      case 2:
        return apply([](const auto& a, const auto& b) { return a * b; }, i, j);
      default:
        return apply([](const auto& a, const auto& b) { return a / b; }, i, j);
    }
  }

  bool same_value(std::size_t i) const {
    return plain[i] == tracked[i].value() ? std::signbit(plain[i]) == std::signbit(tracked[i].value())
                                          : plain[i] != plain[i] && tracked[i].value() != tracked[i].value();
  }
  bool promised(std::size_t i) const {
    return std::isfinite(plain[i]) && std::isfinite(tracked[i].error()) && exact[i].defined();
  }
  bool within_bound(std::size_t i) const {
    return abs(exact_value(plain[i]) - exact[i].value()) <= exact_value(tracked[i].error());
  }
};

template <class Float>
Float number(Choices& choices) {
  switch (choices.below(5)) {
    case 0:
      return static_cast<Float>(small_integer(choices));
    case 1:
      return static_cast<Float>(typed(choices));
    case 2:
      return static_cast<Float>(ordinary(choices));
    case 3:
      return std::ldexp(
          static_cast<Float>(1 + choices.below(16)),
          static_cast<int>(choices.below(sizeof(Float) == 8 ? 1900 : 240)) - (sizeof(Float) == 8 ? 1000 : 130));
    default:
      return std::numeric_limits<Float>::denorm_min() * static_cast<Float>(choices.below(1000));
  }
}

template <class Float>
void hold_random_formulas(std::uint64_t formulas) {
  std::uint64_t promised = 0, exact_steps = 0, steps = 0;
  for (std::uint64_t i = 0; i < formulas; ++i) {
    Choices choices = Choices::seeded(seed_of(sizeof(Float), "formulas", i));
    Run<Float> run;
    for (int k = 0; k < 3; ++k) run.start(number<Float>(choices));
    for (int k = 0; k < 6; ++k) {
      const std::size_t n = run.plain.size(), a = choices.below(n), b = choices.below(n);
      run.apply(choices.below(4), a, b);
      INFO("formula " << i << ", step " << k);
      if (!run.same_value(n)) FAIL("another value than the plain computation's");
      ++steps;
      if (!run.promised(n)) continue;
      ++promised;
      if (!run.within_bound(n)) FAIL("the exact value is beyond the bound");
      exact_steps += run.tracked[n].error() == 0;
    }
  }
  CHECK(promised > steps / 2);
  CHECK(exact_steps > steps / 20);
}

}  // namespace

TEST_CASE("Tracked: in double, every value is the plain one and its bound contains the exact value") {
  hold_random_formulas<double>(40000);
}
TEST_CASE("Tracked: in float too") { hold_random_formulas<float>(20000); }

TEST_CASE("Tracked: an operation that happens to be exact adds nothing, one that rounds at most its half unit") {
  using T = Tracked<double>;
  CHECK((T(3.0) + T(4.0)).error() == 0);
  CHECK((T(3.0) - T(0.25)).error() == 0);
  CHECK((T(3.0) * T(-7.5)).error() == 0);
  CHECK((T(6.0) / T(4.0)).error() == 0);
  CHECK((T(0.0) / T(7.0)).error() == 0);
  CHECK((T(5e-324) + T(5e-324)).error() == 0);
  CHECK((-T(0.1)).error() == 0);
  const double third = (T(1.0) / T(3.0)).error(), sum = (T(1.0) + T(0x1p-60)).error(),
               product = (T(0.1) * T(0.1)).error();
  CHECK((third > 0 && third <= 0x1p-55 * (1 + 0x1p-40)));      // half a unit of 1/3
  CHECK((sum > 0 && sum <= 0x1p-53 * (1 + 0x1p-40)));          // of 1
  CHECK((product > 0 && product <= 0x1p-60 * (1 + 0x1p-40)));  // of 0.01, between 2^-7 and 2^-6
  CHECK((T(5e-324) * T(0.5)).error() >= 5e-324);  // half of it is no double
  CHECK(std::isinf((T(1e308) * T(10.0)).error()));
  CHECK(std::isinf((T(1.0) / T(0.0)).error()));
}

TEST_CASE("Tracked: a quotient by a number that is far off is within its bound, its own rounding included") {
  // Each 6 is half way between two floats beyond 2^25 and counts for 8: the divisor is 88 instead of 66. The bound is a double: its own
  // roundings are no help to a float.
  using T = Tracked<float>;
  T divisor(0x1p25f);
  for (int i = 0; i < 11; ++i) divisor = divisor + T(6.0f);
  divisor = divisor - T(0x1p25f);
  REQUIRE(divisor.value() == 88);
  REQUIRE(divisor.error() >= 22);
  int wrong = 0;
  for (int a = 1; a <= 5000; ++a) {
    const T quotient = T(static_cast<float>(a)) / divisor;
    wrong += abs(mpq_class(exact_value(quotient.value()) - mpq_class(a) / 66)) > exact_value(quotient.error());
  }
  CHECK(wrong == 0);
}

TEST_CASE("Tracked: a comparison that the bound cannot decide is in doubt, no other") {
  using T = Tracked<double>;
  const auto doubtful = [](const auto& comparison) {
    T::doubtful() = false;
    comparison();
    return T::doubtful();
  };
  const T ten_tenths = T(0.1) * T(10.0);  // 1 + 2^-54 rounded to 1
  CHECK(doubtful([&] { return ten_tenths == T(1.0); }));
  CHECK(doubtful([&] { return ten_tenths < T(1.0); }));
  CHECK(doubtful([&] { return ten_tenths >= T(1.0); }));
  CHECK_FALSE(doubtful([&] { return ten_tenths > T(0.5); }));
  CHECK_FALSE(doubtful([&] { return ten_tenths != T(2.0); }));
  CHECK_FALSE(doubtful([&] { return T(1.0) == T(1.0); }));           // both exact
  CHECK_FALSE(doubtful([&] { return T(0.0) / T(0.0) <= T(1.0); }));  // undefined in exact arithmetic too
  CHECK(doubtful([&] { return T(1e308) * T(10.0) > T(0.0); }));
  CHECK((T(0.0) / T(0.0)).value() != 0);
  T::doubtful() = false;
}

TEST_CASE("Exact: x / 0 is undefined, and so is what is computed from it; every comparison with it is false") {
  const Exact undefined = Exact(3) / Exact(0), one(1);
  CHECK_FALSE(undefined.defined());
  CHECK_FALSE((Exact(0) / Exact(0)).defined());
  for (const Exact& derived :
       {undefined + one, one - undefined, undefined * Exact(0), one / undefined, -undefined, cos(undefined)}) {
    CHECK_FALSE(derived.defined());
  }
  for (const auto& [a, b] : {std::pair{undefined, one}, {one, undefined}, {undefined, undefined}}) {
    CHECK_FALSE(a < b);
    CHECK_FALSE(a > b);
    CHECK_FALSE(a <= b);
    CHECK_FALSE(a >= b);
    CHECK_FALSE(a == b);
    CHECK(a != b);  // as with NaN
  }
}

TEST_CASE("Exact: arithmetic and comparisons of rationals") {
  const Exact third = Exact(1) / Exact(3);
  CHECK((third + third + third == Exact(1)));
  CHECK((third * Exact(3) - Exact(1) == Exact(0)));
  CHECK((-third < Exact(0) && third > Exact(0) && third <= third && third >= third && third != Exact(1)));
  CHECK((cos(Exact(0)) == Exact(1) && sin(Exact(0)) == Exact(0)));
  const Exact c = cos(Exact(1)), s = sin(Exact(1));
  mpq_class within(1);
  within >>= 2390;
  CHECK(abs((c * c + s * s - Exact(1)).value()) < within);
  CHECK(nearest(c.value()) == 0.54030230586813971740093660744297660373);  // OEIS A049470
}

}  // namespace touchstone::audit
