// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>
#include <vector>

#include "catalogue/families/numbers.h"
#include "catalogue/numbers/exact.h"
#include "catalogue/numbers/tracked.h"
#include "catalogue/numbers/ulps.h"
#include "proptests/catch.h"
#include "proptests/uses.h"
#include "reference/mixed/ray_sphere.h"

/// The number type in which the judge runs the slides' formulas again with a bound of their rounding.
namespace touchstone::proptests::formulas_tests {
namespace {

/// A formula of a few steps, run in a floating-point type, in that type with its error bound, and exactly.
template <class Float>
struct Run {
  std::vector<Float> plain;
  std::vector<Tracked> tracked;
  std::vector<Exact> exact;

  void start(Float number) {
    plain.push_back(number), tracked.push_back(Tracked(number)), exact.push_back(Exact(exact_value(number)));
  }
  template <class Step>
  void apply(const Step& step, std::size_t i, std::size_t j) {
    plain.push_back(static_cast<Float>(step(plain[i], plain[j])));
    tracked.push_back(step(tracked[i], tracked[j]));
    exact.push_back(step(exact[i], exact[j]));
  }
  void apply(std::uint64_t operation, std::size_t i, std::size_t j) {
    switch (operation) {
      case 0: return apply([](const auto& a, const auto& b) { return a + b; }, i, j);
      case 1: return apply([](const auto& a, const auto& b) { return a - b; }, i, j);
      case 2: return apply([](const auto& a, const auto& b) { return a * b; }, i, j);
      default: return apply([](const auto& a, const auto& b) { return a / b; }, i, j);
    }
  }

  bool same_value(std::size_t i) const {
    return plain[i] == tracked[i].value() ? std::signbit(plain[i]) == std::signbit(tracked[i].value())
                                          : plain[i] != plain[i] && tracked[i].value() != tracked[i].value();
  }
  /// Among the subnormals rounding a bound upwards is more than nothing.
  bool is_normal() const {
    const auto normal = [](const Tracked& x) {
      return (x.value() == 0 || std::isnormal(static_cast<Float>(x.value()))) &&
             (x.error() == 0 || x.error() > 0x1p-1000);
    };
    return !Tracked::out_of_range() && std::all_of(tracked.begin(), tracked.end(), normal);
  }
  bool promised(std::size_t i) const {
    return std::isfinite(plain[i]) && std::isfinite(tracked[i].error()) && exact[i].defined();
  }
  bool within_bound(std::size_t i) const {
    return abs(exact_value(plain[i]) - exact[i].value()) <= exact_value(tracked[i].error());
  }
};

template <class Float>
Float number(DrawStream& draws) {
  switch (draws.below(5)) {
    case 0: return static_cast<Float>(small_integer(draws));
    case 1: return static_cast<Float>(typed(draws));
    case 2: return static_cast<Float>(ordinary(draws));
    case 3: {
      const auto exponent = static_cast<int>(draws.below(sizeof(Float) == 8 ? 1900 : 240));
      return std::ldexp(static_cast<Float>(1 + draws.below(16)), exponent - (sizeof(Float) == 8 ? 1000 : 130));
    }
    default: return std::numeric_limits<Float>::denorm_min() * static_cast<Float>(draws.below(1000));
  }
}

template <class Float>
void hold_random_formulas(std::uint64_t formulas) {
  const Tracked::Format format(sizeof(Float) == 4);
  std::uint64_t promised = 0, exact_steps = 0, steps = 0;
  for (std::uint64_t i = 0; i < formulas; ++i) {
    DrawStream draws = DrawStream::seeded(seed_of(sizeof(Float), "formulas", i));
    Run<Float> run;
    Tracked::out_of_range() = false;
    for (int k = 0; k < 3; ++k) run.start(number<Float>(draws));
    for (int k = 0; k < 6; ++k) {
      const std::size_t n = run.plain.size(), a = draws.below(n), b = draws.below(n);
      run.apply(draws.below(4), a, b);
      INFO("formula " << i << ", step " << k);
      if (!run.same_value(n)) FAIL("another value than the plain computation's");
      ++steps;
      if (!run.promised(n)) continue;
      ++promised;
      if (!run.within_bound(n)) FAIL("the exact value is beyond the bound");
      if (run.is_normal() && run.tracked[n].error() > run.tracked[n].spread() * (1 + 0x1p-10))
        FAIL("the spread is less than the bound");
      exact_steps += run.tracked[n].error() == 0;
    }
  }
  CHECK(promised > steps / 2);
  CHECK(exact_steps > steps / 20);
}

/// A function of one number: the value is the plain one, and its bound contains the exact value. Counts what was
/// promised.
template <class Float, class Function>
std::uint64_t holds(const Function& function, const Tracked& argument, const Exact& exactly) {
  const Tracked found = function(argument);
  const Float plain = function(static_cast<Float>(argument.value()));
  const Exact exact = function(exactly);
  CAPTURE(argument.value(), argument.error(), plain, found.error());
  if (plain == plain ? plain != found.value() : found.value() == found.value())
    FAIL("another value than the plain computation's");
  if (!std::isfinite(plain) || !std::isfinite(found.error()) || !exact.defined()) return 0;
  if (abs(exact_value(plain) - exact.value()) > exact_value(found.error())) FAIL("the exact value is beyond the bound");
  return 1;
}

/// Roots and arc cosines of numbers that are exact, and of numbers that carry an error: quotients, and differences that
/// cancel.
template <class Float>
void hold_roots_and_arc_cosines(std::uint64_t each) {
  using T = Tracked;
  const Tracked::Format format(sizeof(Float) == 4);
  const auto root = [](const auto& x) {
    using std::sqrt;
    return sqrt(x);
  };
  const auto arc_cosine = [](const auto& x) {
    using std::acos;
    return acos(x);
  };
  std::uint64_t roots = 0, angles = 0, angles_near_ends = 0;
  for (std::uint64_t i = 0; i < each; ++i) {
    DrawStream draws = DrawStream::seeded(seed_of(sizeof(Float), "roots", i));
    const Float x = number<Float>(draws), y = number<Float>(draws);
    roots += holds<Float>(root, T(std::fabs(x)), Exact(exact_value(std::fabs(x))));
    roots += holds<Float>(root, T(x) * T(y), Exact(exact_value(x)) * Exact(exact_value(y)));
    const Float less = std::nextafter(x, Float(0));
    roots +=
        holds<Float>(root, T(x) * T(x) - T(x) * T(less), Exact(exact_value(x) * (exact_value(x) - exact_value(less))));
    if (x == 0 || y == 0) continue;
    const Float small = std::fmin(std::fabs(x), std::fabs(y)), large = std::fmax(std::fabs(x), std::fabs(y));
    const Float sign = draws.below(2) == 0 ? Float(1) : Float(-1);
    angles +=
        holds<Float>(arc_cosine, T(sign * small) / T(large), Exact(exact_value(sign * small) / exact_value(large)));
    // Beside an end: n / (n + k) for a large n, rounded; and exact numbers there.
    const Float n = std::ldexp(Float(1), static_cast<int>(draws.below(std::numeric_limits<Float>::digits))),
                k = static_cast<Float>(draws.below(4));
    angles_near_ends +=
        holds<Float>(arc_cosine, T(sign * n) / T(n + k), Exact(exact_value(sign * n) / exact_value(n + k)));
    const Float beside = sign - sign * k * std::numeric_limits<Float>::epsilon() / 2;
    angles_near_ends += holds<Float>(arc_cosine, T(beside), Exact(exact_value(beside)));
    angles +=
        holds<Float>(arc_cosine, T(beside * small) / T(small), Exact(exact_value(beside * small) / exact_value(small)));
  }
  CHECK(roots > each);
  CHECK(angles > each);
  CHECK(angles_near_ends > each);
}

}  // namespace

TEST_CASE("Tracked: in double, every value is the plain one and its bound contains the exact value") {
  hold_random_formulas<double>(40000);
}
TEST_CASE("Tracked: in float too") { hold_random_formulas<float>(20000); }

TEST_CASE("Tracked: an operation that happens to be exact adds nothing, one that rounds at most its half unit") {
  using T = Tracked;
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
  CHECK((T(5e-324) * T(0.5)).error() >= 5e-324);               // half of it is no double
  CHECK(std::isinf((T(1e308) * T(10.0)).error()));
  CHECK(std::isinf((T(1.0) / T(0.0)).error()));
}

TEST_CASE("Tracked: the spread counts every given number and every step as rounded, integers of the formula not") {
  using T = Tracked;
  constexpr double u = 0x1p-53;
  CHECK(T(3.0).spread() == 3 * u);
  CHECK(T(3).spread() == 0);
  CHECK((T(3.0) + T(4.0)).error() == 0);
  CHECK((T(3.0) + T(4.0)).spread() == (3 + 4 + 7) * u);
  CHECK((T(3.0) - T(4.0)).spread() == (3 + 4 + 1) * u);
  CHECK((-T(3.0)).spread() == 3 * u);
  CHECK((T(2) * T(4.0)).spread() == (2 * 4 + 8) * u);
  CHECK((T(4.0) / T(2)).spread() == (4.0 / 2 + 2) * u);
  CHECK(sqrt(T(16.0)).spread() >= (16.0 / (2 * 4) + 4) * u);
  CHECK(sqrt(T(16.0)).spread() < (16.0 / (2 * 4) + 4) * u * (1 + 0x1p-40));
  CHECK((T(0x1p-1000) * T(0x1p-1000)).spread() == 5e-324);
  // What is divided by may be 0, and what left the range anything.
  CHECK(std::isinf((T(1.0) / (T(1.0) - T(1.0))).spread()));
  CHECK(std::isinf((T(1e308) + T(1e308)).spread()));
  CHECK(std::isinf(T(HUGE_VAL).spread()));
  const T root = sqrt(T(1.0) - T(1.0));  // of at most 2u
  CHECK(root.spread() >= std::sqrt(2 * u));
  CHECK(root.spread() < std::sqrt(2.5 * u));
  const T::Format in_float(true);
  CHECK(T(3.0).spread() == 3 * 0x1p-24);
}

TEST_CASE("Tracked: a quotient by a number that is far off is within its bound, its own rounding included") {
  // Each 6 is half way between two floats beyond 2^25 and counts for 8: the divisor is 88 instead of 66. The bound is a
  // double: its own roundings are no help to a float.
  using T = Tracked;
  const T::Format in_float(true);
  T divisor(0x1p25);
  for (int i = 0; i < 11; ++i) divisor = divisor + T(6.0);
  divisor = divisor - T(0x1p25);
  REQUIRE(divisor.value() == 88);
  REQUIRE(divisor.error() >= 22);
  int wrong = 0;
  for (int a = 1; a <= 5000; ++a) {
    const T quotient = T(a) / divisor;
    wrong += abs(mpq_class(exact_value(quotient.value()) - mpq_class(a) / 66)) > exact_value(quotient.error());
  }
  CHECK(wrong == 0);
}

TEST_CASE("Tracked: roots and arc cosines, their bounds contain the exact value") {
  hold_roots_and_arc_cosines<double>(4000);
  hold_roots_and_arc_cosines<float>(2000);
}

TEST_CASE("Tracked: bounds of roots and arc cosines are no larger than they must be") {
  using T = Tracked;
  CHECK(sqrt(T(6.25)).error() == 0);
  CHECK(sqrt(T(0.0)).error() == 0);
  CHECK((sqrt(T(2.0)).error() > 0 && sqrt(T(2.0)).error() <= 0x1p-53 * (1 + 0x1p-40)));  // half a unit
  CHECK(acos(T(1.0)).error() == 0);
  const T tenth = T(0.1) * T(1.1);  // off by at most 2^-57
  CHECK(sqrt(tenth).error() <= 0x1p-57 / 0.33 / 1.9 * 2 + 0x1p-54);
  for (const double x : {0.0, 0.5, -1.0}) {  // pi/2, pi/3 and pi are irrational: two units at most
    CHECK((acos(T(x)).error() > 0 && acos(T(x)).error() <= 4 * 0x1p-52));
  }
  CHECK(acos(tenth).error() <= 0x1p-57 * 1.01 + 4 * 0x1p-53 * 1.01);
  const T almost_one = T(1.0) / T(1 + 0x1p-52) + T(0x1p-53);  // 1, off by 2^-53: the angle may be sqrt(2^-52)
  CHECK((acos(almost_one).error() > 0x1p-26 && acos(almost_one).error() < 4 * 0x1p-26));
}

TEST_CASE(
    "Tracked: whether there is an arc cosine is in doubt beside 1 where the argument was rounded, and nowhere else") {
  using T = Tracked;
  const auto inconclusive = [](const T& argument) {
    T::inconclusive() = false;
    acos(argument);
    return T::inconclusive();
  };
  CHECK(inconclusive(T(0.1) * T(10.0)));
  CHECK(inconclusive(T(-0.1) * T(10.0)));
  CHECK_FALSE(inconclusive(T(0.1) * T(9.0)));
  CHECK_FALSE(inconclusive(T(1.0)));
  CHECK_FALSE(inconclusive(T(3.0)));  // undefined, certainly
  CHECK_FALSE(inconclusive(T(3.0) / T(3.0)));
  T::inconclusive() = false;
}

TEST_CASE("Tracked: overflow, and bits lost below the least normal number, are noticed, and nothing else") {
  using T = Tracked;
  const auto left = [](const T&) { return std::exchange(T::out_of_range(), false); };
  T::out_of_range() = false;
  CHECK(left(T(1e200) * T(1e200)));
  CHECK(left(T(1e308) + T(1e308)));
  CHECK(left(T(-1e308) - T(1e308)));
  CHECK(left(T(1e308) / T(0.1)));
  CHECK(left(T(1e-200) * T(1e-200)));
  CHECK(left(T(1e-200) / T(1e200)));
  CHECK(left(T(0x1.0000000000001p-1000) * T(0x1p-40)));  // 53 bits, 35 of them above 2^-1075
  CHECK(left(T(0x1p-1074) * T(0.5)));
  CHECK(left(T(0x1p-1074) / T(3.0)));
  CHECK(left(T(0x1p-1072) / T(3.0)));
  CHECK_FALSE(left(T(0x1p-1000) * T(0x1p-74)));  // the least double, exactly
  CHECK_FALSE(left(T(0x1p-1072) / T(4.0)));
  CHECK_FALSE(left(T(0x1.8p-1000) / T(0x1p72)));
  CHECK_FALSE(left(T(0x1p-1022) + T(0x1p-1074)));
  CHECK_FALSE(left(T(0x1.0000000000001p-1022) - T(0x1p-1022)));  // subnormal, exactly
  CHECK_FALSE(left(T(0.0) * T(1e-300)));
  CHECK_FALSE(left(T(0.1) * T(0.1)));  // rounded, within the range
  CHECK_FALSE(left(T(1e16) + T(1.0)));
  CHECK_FALSE(left(T(1.0) / T(3.0)));
  CHECK_FALSE(left(T(1.0) / T(0.0)));  // undefined, not too large
  CHECK_FALSE(left((T(1.0) / T(0.0)) * T(1e300) + T(1e308)));
}

TEST_CASE("Tracked: the range of float is noticed likewise, and the format is that of the innermost choice") {
  using T = Tracked;
  T::out_of_range() = false;
  {
    const T::Format in_float(true);
    CHECK(T(0.1).value() == static_cast<double>(0.1f));
    CHECK(T(16777217).value() == 16777216);
    CHECK((T(1e-30) * T(1e-30)).value() == 0);
    CHECK(std::exchange(T::out_of_range(), false));
    CHECK((T(0x1p-100) * T(0x1p-49)).value() == 0x1p-149);
    CHECK((T(0x1p-100) / T(0x1p49)).value() == 0x1p-149);
    CHECK_FALSE(T::out_of_range());
    CHECK((T(0x1.8p-100) / T(0x1p49)).value() > 0);
    CHECK(std::exchange(T::out_of_range(), false));
    {
      const T::Format in_double(false);
      CHECK((T(1e-30) * T(1e-30)).value() == 1e-30 * 1e-30);
    }
    CHECK(std::isinf((T(3e38) + T(3e38)).value()));
    CHECK(std::exchange(T::out_of_range(), false));
  }
  CHECK(T(0.1).value() == 0.1);
}

TEST_CASE("Tracked: a comparison that the bound cannot decide is in doubt, no other") {
  using T = Tracked;
  const auto inconclusive = [](const auto& comparison) {
    T::inconclusive() = false;
    comparison();
    return T::inconclusive();
  };
  const T ten_tenths = T(0.1) * T(10.0);  // 1 + 2^-54 rounded to 1
  CHECK(inconclusive([&] { return ten_tenths == T(1.0); }));
  CHECK(inconclusive([&] { return ten_tenths < T(1.0); }));
  CHECK(inconclusive([&] { return ten_tenths >= T(1.0); }));
  CHECK_FALSE(inconclusive([&] { return ten_tenths > T(0.5); }));
  CHECK_FALSE(inconclusive([&] { return ten_tenths != T(2.0); }));
  CHECK_FALSE(inconclusive([&] { return T(1.0) == T(1.0); }));           // both exact
  CHECK_FALSE(inconclusive([&] { return T(0.0) / T(0.0) <= T(1.0); }));  // undefined in exact arithmetic too
  CHECK_FALSE(inconclusive([&] { return T(1.0) / T(0.0) <= T(1.0); }));
  CHECK_FALSE(inconclusive([&] { return T(3.0) * (T(1.0) / T(0.0)) + T(0.1) * T(0.1) > T(1.0); }));
  CHECK(inconclusive([&] { return T(1.0) / (ten_tenths - T(1.0)) > T(1.0); }));  // the divisor is 0 by rounding
  CHECK(inconclusive([&] { return T(1e308) * T(10.0) > T(0.0); }));
  CHECK((T(0.0) / T(0.0)).value() != 0);
  T::inconclusive() = false;
}

TEST_CASE("formulas: -0 is not less than 0, so that what is clamped at 0 keeps its sign") {
  // clang 14 for WebAssembly makes a maximum of `x < 0 ? 0 : x`, which is 0.
  volatile double zero = -0.0;
  reference::RootsOfSphere<double> roots;
  roots.real = true, roots.smaller = zero, roots.greater = 1;
  const double entry = reference::passage_of_ray(roots).first.value();
  CHECK((entry == 0 && std::signbit(entry)));
}

}  // namespace touchstone::proptests::formulas_tests
