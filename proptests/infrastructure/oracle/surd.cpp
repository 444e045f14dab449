// SPDX-License-Identifier: Apache-2.0
#include "oracle/exact/numbers/surd.h"

#include <mpfr.h>

#include <bit>
#include <limits>
#include <stdexcept>
#include <vector>

#include "catalogue/families/numbers.h"
#include "oracle/exact/numbers/nearest_double.h"
#include "oracle/exact/numbers/nearest_float.h"
#include "proptests/catch.h"

// Exact numbers p + q sqrt(r): by hand, by identities, and against MPFR with 6000 digits. Two of the numbers drawn here
// that differ, or one and the middle between two doubles, differ by more than 2^-4000 of their terms: times its
// conjugate, which has fewer than 1000 digits, such a difference is a fraction whose denominator has fewer than 2200.
namespace touchstone::proptests::surd_tests {
namespace {

using catalogue::DrawStream;
using oracle::Integer, oracle::Rational, oracle::Surd, oracle::surd_of;

constexpr int digits = 6000;
constexpr std::int64_t indistinguishable = -5000;  ///< an exponent: those compared are near 1

Rational power_of_two(int exponent) { return oracle::scaled(Rational(1), exponent); }
Surd root(const Rational& r) { return Surd(Rational(0), Rational(1), r); }
bool same_bits(double a, double b) { return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b); }
bool same_bits(float a, float b) { return std::bit_cast<std::uint32_t>(a) == std::bit_cast<std::uint32_t>(b); }

/// A number to `digits` digits.
class Mpfr {
 public:
  Mpfr() { mpfr_init2(value_, digits); }
  explicit Mpfr(const Surd& surd) : Mpfr() {
    Mpfr rest;
    mpfr_set_z(value_, surd.radicand().get_mpz_t(), MPFR_RNDN);
    mpfr_sqrt(value_, value_, MPFR_RNDN);
    mpfr_mul_q(value_, value_, surd.coefficient().get_mpq_t(), MPFR_RNDN);
    mpfr_add_q(value_, value_, surd.rational_part().get_mpq_t(), MPFR_RNDN);
  }
  /// p + q sqrt(n / d), from the numbers that were given.
  Mpfr(const Rational& p, const Rational& q, const Rational& r) : Mpfr() {
    mpfr_set_q(value_, r.get_mpq_t(), MPFR_RNDN);
    mpfr_sqrt(value_, value_, MPFR_RNDN);
    mpfr_mul_q(value_, value_, q.get_mpq_t(), MPFR_RNDN);
    mpfr_add_q(value_, value_, p.get_mpq_t(), MPFR_RNDN);
  }
  ~Mpfr() { mpfr_clear(value_); }
  Mpfr(const Mpfr&) = delete;
  Mpfr& operator=(const Mpfr&) = delete;

  const mpfr_t& value() const { return value_; }
  int sign() const { return negligible() ? 0 : mpfr_sgn(value_); }
  bool negligible() const { return mpfr_zero_p(value_) || mpfr_get_exp(value_) < indistinguishable; }
  double nearest_double() const { return mpfr_get_d(value_, MPFR_RNDN); }
  float nearest_float() const { return mpfr_get_flt(value_, MPFR_RNDN); }

  using Operation = int (*)(mpfr_ptr, mpfr_srcptr, mpfr_srcptr, mpfr_rnd_t);
  Mpfr(Operation operation, const Mpfr& a, const Mpfr& b) : Mpfr() { operation(value_, a.value_, b.value_, MPFR_RNDN); }

 private:
  mpfr_t value_;
};

bool alike(const Mpfr& a, const Mpfr& b) { return Mpfr(mpfr_sub, a, b).negligible(); }

Integer random_integer(DrawStream& draws, int most_bits) {
  Integer n = 0;
  for (auto left = 1 + static_cast<int>(draws.below(static_cast<std::uint64_t>(most_bits))); left > 0; left -= 32)
    n = (n << 32) + draws.below(std::uint64_t{1} << 32);
  return n;
}

Rational small_fraction(DrawStream& draws, int most) {
  const double n = catalogue::small_integer(draws, most);
  Rational q(static_cast<std::int64_t>(n), 1 + static_cast<std::int64_t>(draws.below(12)));
  q.canonicalize();
  return q;
}

struct Parts {
  Rational p, q, r;
  Surd surd() const { return Surd(p, q, r); }
};

Parts small(DrawStream& draws) {
  const Rational p = small_fraction(draws, 30), q = small_fraction(draws, 30);
  return {p, q, abs(small_fraction(draws, 60))};
}

/// (a +- sqrt(s)) / d 2^e: small numbers and large ones, squares, and roots that nearly cancel a.
Parts large(DrawStream& draws) {
  Integer a = draws.below(3) == 0 ? Integer(static_cast<std::int64_t>(draws.below(10))) : random_integer(draws, 300);
  Integer s = draws.below(4) == 0 ? Integer(static_cast<std::int64_t>(draws.below(31))) : random_integer(draws, 400);
  const Integer d = random_integer(draws, 200) + 1;
  if (draws.below(4) == 0) s = s * s;
  if (draws.below(3) == 0) s = abs(Integer(a * a + static_cast<std::int64_t>(catalogue::small_integer(draws, 2))));
  if (draws.below(2) == 1) a = -a;
  const int e =
      draws.below(3) == 0 ? static_cast<int>(draws.below(2400)) - 1250 : static_cast<int>(draws.below(120)) - 60;
  Rational p(a, d), q(draws.below(2) == 1 ? -1 : 1, d);
  p.canonicalize(), q.canonicalize();
  return {oracle::scaled(p, e), oracle::scaled(q, e), Rational(s)};
}

/// Asks `check(draws)` that many times.
template <class Check>
void cases(const char* name, int count, const Check& check) {
  int wrong = 0;
  for (int i = 0; i < count; ++i) {
    DrawStream draws = DrawStream::seeded(catalogue::seed_of(1, name, static_cast<std::uint64_t>(i)));
    if (!check(draws) && wrong++ == 0) UNSCOPED_INFO(name << ": case " << i << " is wrong");
  }
  CHECK(wrong == 0);
}

}  // namespace

TEST_CASE("surds: equal numbers have equal parts and equal text, by hand") {
  CHECK(Surd(Rational(3, 2), Rational(-1, 2), 5).text() == "3/2-1/2*sqrt(5)");
  CHECK(root(8).text() == "2*sqrt(2)");
  CHECK(root(Rational(1, 2)).text() == "1/2*sqrt(2)");
  CHECK(Surd(0, -1, Rational(3, 4)).text() == "-1/2*sqrt(3)");
  CHECK(Surd(-1, 101, 2).text() == "-1+101*sqrt(2)");
  CHECK(Surd(Rational(-1, 3), -1, 7).text() == "-1/3-sqrt(7)");
  CHECK(root(Rational(4, 9)).text() == "2/3");
  CHECK(Surd(1, 3, 0) == Surd(Rational(1)));
  CHECK(Surd(1, 0, 2) == Surd(Rational(1)));
  CHECK(Surd(1, -2, 9) == Surd(Rational(-5)));
  CHECK(Surd().text() == "0");
  // The square of a prime above 50 stays where it was not asked for alone: 53^2 2 = 5618.
  CHECK(Surd(0, 53, 2) == root(5618));
  CHECK(Surd(0, 53, 2).text() == root(5618).text());
  CHECK(root(53 * 53).text() == "53");
}

TEST_CASE("surds: arithmetic by hand") {
  const Surd golden(Rational(1, 2), Rational(1, 2), 5), one(Rational(1)), two(Rational(2));
  CHECK(golden * golden == golden + one);
  CHECK(one / golden == golden - one);
  CHECK(-golden + golden == Surd());
  CHECK(root(2) * root(8) == Surd(Rational(4)));
  CHECK(root(2) + root(8) == Surd(0, 3, 2));
  CHECK(root(2) + root(5618) == Surd(0, 54, 2));
  CHECK((one + root(2)) * (one - root(2)) == Surd(Rational(-1)));
  CHECK(two / root(2) == root(2));
  CHECK(root(2) / root(Rational(1, 2)) == two);
  CHECK(sqrt(Surd(Rational(9, 4))) == Surd(Rational(3, 2)));
  CHECK(sqrt(Surd(Rational(12))) == Surd(0, 2, 3));
  CHECK_THROWS_AS(root(2) + root(3), std::domain_error);
  CHECK_THROWS_AS(root(2) * root(3), std::domain_error);
  CHECK_THROWS_AS(one / Surd(), std::domain_error);
  CHECK_THROWS_AS(root(2) / (root(2) - root(2)), std::domain_error);
  CHECK_THROWS_AS(root(-1), std::domain_error);
  CHECK_THROWS_AS(sqrt(root(2)), std::domain_error);
  CHECK_THROWS_AS(sqrt(Surd(Rational(-4))), std::domain_error);
}

TEST_CASE("surds: their order, for different radicands too, by hand") {
  CHECK(Surd(Rational(99, 70)) > root(2));   // 9801 > 2 4900
  CHECK(Surd(Rational(140, 99)) < root(2));  // 19600 < 2 9801
  CHECK(root(2) < root(3));
  CHECK(Surd(0, -1, 2) > Surd(0, -1, 3));
  CHECK(Surd(1, 1, 2) < root(Rational(583, 100)));  // (1 + sqrt(2))^2 = 3 + 2 sqrt(2) = 5.828...
  CHECK(Surd(1, 1, 2) > root(Rational(582, 100)));
  CHECK(Surd(5, -3, 2) < Surd(-1, 1, 4));  // 0.757 < 1
  CHECK(Surd(2, -1, 3) > Surd(3, -1, 8));  // 0.2679 > 0.1716: 1 / (2 + sqrt(3)) > 1 / (3 + sqrt(8))
  CHECK(Surd(-3, 1, 8) > Surd(-2, 1, 3));  // the same times -1
  CHECK(Surd(-1, 1, 2) > Surd(1, -1, 2));  // opposites
  CHECK(std::is_eq(root(5618) <=> Surd(0, 53, 2)));
  // (n + 1 / (2 n))^2 = n^2 + 1 + 1 / (4 n^2), which is too much.
  const Rational n("100000000000000000000000000000000000000001"), less(1 / (2 * n));
  const Surd beside(Rational(-n), 1, Rational(n * n + 1));
  CHECK(beside < Surd(less));
  CHECK(beside > Surd(Rational(less - less * less * less)));  // and without 1 / (8 n^3) it is too little
  CHECK(sgn(beside) == 1);
  CHECK(sgn(Surd(Rational(-n), 1, Rational(n * n - 1))) == -1);
  CHECK(sgn(Surd()) == 0);
  CHECK(sgn(-root(2)) == -1);
}

TEST_CASE("surds: parts, signs, order and arithmetic are MPFR's, and keep the laws of numbers") {
  int mixed = 0, equal = 0;
  cases("surds", 6000, [&](DrawStream& draws) {
    const Parts of_x = small(draws);
    Parts of_y = small(draws);
    if (draws.below(2) == 1) of_y.r = of_x.r;
    if (draws.below(8) == 0) of_y = of_x;
    const Surd x = of_x.surd(), y = of_y.surd();
    const Mpfr x_is(of_x.p, of_x.q, of_x.r), y_is(of_y.p, of_y.q, of_y.r), difference(mpfr_sub, x_is, y_is);
    const int order = x < y ? -1 : x > y ? 1 : 0;
    bool right =
        alike(Mpfr(x), x_is) && sgn(x) == x_is.sign() && order == difference.sign() && (x == y) == (order == 0);
    equal += order == 0;
    try {
      const Surd sum = x + y, product = x * y;
      right = right && sum - y == x && y + x == sum && -(x - y) == y - x && y * x == product;
      right = right && alike(Mpfr(sum), Mpfr(mpfr_add, x_is, y_is)) && alike(Mpfr(product), Mpfr(mpfr_mul, x_is, y_is));
      if (sgn(y) != 0) right = right && product / y == x && alike(Mpfr(Surd(x / y)), Mpfr(mpfr_div, x_is, y_is));
    } catch (const std::domain_error&) {
      ++mixed;
      right = right && !x.rational() && !y.rational();
    }
    return right;
  });
  CHECK(mixed > 500);
  CHECK(mixed < 4000);
  CHECK(equal > 500);
}

TEST_CASE("surds: a factor taken out of the root gives the same number and text, and its text is read back") {
  cases("canonical surds", 6000, [](DrawStream& draws) {
    const auto [p, q, r] = draws.below(2) == 1 ? small(draws) : large(draws);
    const Surd x(p, q, r);
    const std::uint64_t below = 1 + draws.below(400), above = 1 + draws.below(400);
    const Rational k(above, below);
    Rational factor = k;
    factor.canonicalize();
    const Surd same(p, Rational(q * factor), Rational(r / (factor * factor)));
    return same == x && same.text() == x.text() && (same <=> x) == 0 && surd_of(x.text()) == x &&
           surd_of(x.text()).text() == x.text();
  });
}

TEST_CASE("surds: text that is no exact number is refused; what is not canonical is read") {
  for (const char* text : {"",
                           "+",
                           "-",
                           "1 ",
                           " 1",
                           "1.5",
                           "1/0",
                           "1/-2",
                           "0x1",
                           "sqrt()",
                           "sqrt(2",
                           "sqrt(-2)",
                           "sqrt(1/2)",
                           "+sqrt(2)",
                           "1sqrt(2)",
                           "--sqrt(2)",
                           "*sqrt(2)",
                           "1*-sqrt(2)",
                           "1-*sqrt(2)",
                           "2*+sqrt(2)",
                           "1+sqrt(2)x",
                           "1+2sqrt(3)",
                           "sqrt(2)+1",
                           "1+-2*sqrt(2)",
                           "1++sqrt(2)",
                           "sqrt(2)sqrt(3)",
                           "1+1/0*sqrt(2)",
                           "/2",
                           "1/",
                           "1+sqrt(2)+sqrt(2)"}) {
    INFO(text);
    CHECK_THROWS_AS(surd_of(text), std::invalid_argument);
  }
  CHECK(surd_of("-6/4") == Surd(Rational(-3, 2)));
  CHECK(surd_of("sqrt(8)") == Surd(0, 2, 2));
  CHECK(surd_of("-sqrt(4)") == Surd(Rational(-2)));
  CHECK(surd_of("1+0*sqrt(2)") == Surd(Rational(1)));
  CHECK(surd_of("-1/2-2/4*sqrt(5)") == Surd(Rational(-1, 2), Rational(-1, 2), 5));
}

TEST_CASE("surds: enclosures hold the number and are as narrow as they are asked to be") {
  const auto two = root(2).enclosure(3), thousand = root(1000).enclosure(-4),
             rational = Surd(Rational(1, 3)).enclosure(0);
  CHECK(two.low == Rational(11, 8));  // 11^2 < 2 64 < 12^2
  CHECK(two.high == Rational(3, 2));
  CHECK(thousand.low == 16);  // 16^2 < 1000 < 32^2
  CHECK(thousand.high == 32);
  CHECK(rational.low == Rational(1, 3));
  CHECK(rational.high == Rational(1, 3));
  cases("enclosures", 6000, [](DrawStream& draws) {
    const Parts parts = draws.below(2) == 1 ? small(draws) : large(draws);
    const Surd x = parts.surd();
    const int bits = static_cast<int>(draws.below(400)) - 100;
    const auto [low, high] = x.enclosure(bits);
    return Surd(low) <= x && x <= Surd(high) && Rational(high - low) <= power_of_two(-bits) &&
           mpfr_cmp_q(Mpfr(x).value(), low.get_mpq_t()) * (x == Surd(low) ? 0 : 1) >= 0 &&
           mpfr_cmp_q(Mpfr(x).value(), high.get_mpq_t()) * (x == Surd(high) ? 0 : 1) <= 0;
  });
}

TEST_CASE("surds: the nearest double and float are MPFR's") {
  int subnormal = 0, infinite = 0, zero = 0;
  cases("nearest", 20000, [&](DrawStream& draws) {
    const Parts parts = large(draws);
    const Surd x = parts.surd();
    if (sgn(x) == 0) return same_bits(oracle::nearest_double(x), 0.0) && same_bits(oracle::nearest_float(x), 0.0F);
    const Mpfr exact(parts.p, parts.q, parts.r);
    const double found = oracle::nearest_double(x);
    subnormal += found != 0 && std::abs(found) < std::numeric_limits<double>::min();
    infinite += std::abs(found) > std::numeric_limits<double>::max(), zero += found == 0;
    return same_bits(found, exact.nearest_double()) && same_bits(oracle::nearest_float(x), exact.nearest_float());
  });
  CHECK(subnormal > 50);
  CHECK(infinite > 50);
  CHECK(zero > 50);
}

TEST_CASE("surds: the nearest double and float by hand, beside ties and at the ends of the range") {
  using oracle::nearest_double, oracle::nearest_float;
  constexpr double least = std::numeric_limits<double>::denorm_min(),
                   infinity = std::numeric_limits<double>::infinity();
  CHECK(nearest_double(root(2)) == 0x1.6a09e667f3bcdp+0);
  CHECK(nearest_float(root(2)) == 0x1.6a09e6p+0F);
  CHECK(nearest_double(Surd(Rational(1, 2), Rational(1, 2), 5)) == 0x1.9e3779b97f4a8p+0);
  // 1 + 2^-53 is a tie; a root of 2^-300 beside it decides, and so does one beside the tie of floats.
  CHECK(nearest_double(Surd(Rational(1 + power_of_two(-53)), power_of_two(-300), 2)) == 1 + 0x1p-52);
  CHECK(nearest_double(Surd(Rational(1 + power_of_two(-53)), Rational(-power_of_two(-300)), 2)) == 1);
  CHECK(nearest_float(Surd(Rational(1 + power_of_two(-24)), power_of_two(-300), 2)) == 1 + 0x1p-23F);
  CHECK(nearest_float(Surd(Rational(1 + power_of_two(-24)), Rational(-power_of_two(-300)), 2)) == 1);
  CHECK(nearest_double(Surd(0, power_of_two(-1074), 2)) == least);                     // 1.41 of the least
  CHECK(nearest_double(Surd(0, power_of_two(-1075), 2)) == least);                     // 0.71
  CHECK(same_bits(nearest_double(Surd(0, power_of_two(-1076), 2)), 0.0));              // 0.35
  CHECK(same_bits(nearest_double(Surd(0, Rational(-power_of_two(-1076)), 2)), -0.0));  // and its sign stays
  CHECK(nearest_double(Surd(0, power_of_two(-1074), 6)) == 2 * least);                 // 2.45
  CHECK(nearest_double(Surd(0, power_of_two(1023), 2)) == 0x1.6a09e667f3bcdp+1023);
  CHECK(nearest_double(Surd(0, power_of_two(1023), 5)) == infinity);  // 2.24
  CHECK(nearest_double(Surd(0, Rational(-power_of_two(1023)), 5)) == -infinity);
  const Rational end(power_of_two(1024) - power_of_two(970));
  CHECK(nearest_double(Surd(end, -1, 2)) == std::numeric_limits<double>::max());
  CHECK(nearest_double(Surd(end, 1, 2)) == infinity);
}

}  // namespace touchstone::proptests::surd_tests
