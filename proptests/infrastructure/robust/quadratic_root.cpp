// SPDX-License-Identifier: Apache-2.0
#include "robust/kernel/integers/quadratic_root.h"

#include <mpfr.h>

#include <bit>
#include <limits>

#include "catalogue/families/numbers.h"
#include "catalogue/judge/environment.h"
#include "proptests/catch.h"
#include "proptests/property.h"

// Roots of quadratic polynomials, rounded once: by hand, and in every floating-point environment against MPFR with so
// many digits that a root that is no tie does not look like one.
namespace touchstone::proptests::quadratic_root_tests {
namespace {

using catalogue::DrawStream, catalogue::Environment, catalogue::environment_count;
namespace kernel = robust::kernel;
using kernel::UInt128;

bool same_bits(double a, double b) { return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b); }

/// (n + sign sqrt(square)) / d * 2^exponent.
struct Root {
  mpz_class n;
  int sign = 1;
  mpz_class square, d = 1;
  std::int64_t exponent = 0;

  double rounded() const { return kernel::round_quadratic_root(n, sign, square, d, exponent); }
};

/// The nearest double by 6000 digits. A root drawn here and the middle between two doubles, if they are not equal,
/// differ by more than 2^-4000 of n: times its conjugate, which has fewer than 900 digits, such a difference is a
/// fraction whose denominator has fewer than 2200.
double by_mpfr(const Root& root) {
  mpfr_t value;
  mpfr_init2(value, 6000);
  mpfr_set_z(value, root.square.get_mpz_t(), MPFR_RNDN);
  mpfr_sqrt(value, value, MPFR_RNDN);
  if (root.sign < 0) mpfr_neg(value, value, MPFR_RNDN);
  mpfr_add_z(value, value, root.n.get_mpz_t(), MPFR_RNDN);
  mpfr_div_z(value, value, root.d.get_mpz_t(), MPFR_RNDN);
  mpfr_mul_2si(value, value, root.exponent, MPFR_RNDN);
  const double result = mpfr_zero_p(value) ? 0.0 : mpfr_get_d(value, MPFR_RNDN);
  mpfr_clear(value);
  return result;
}

mpz_class random_integer(DrawStream& draws, int most_bits) {
  mpz_class n = 0;
  const int bits = 1 + static_cast<int>(draws.below(static_cast<std::uint64_t>(most_bits)));
  for (int left = bits; left > 0; left -= 32) n = (n << 32) + draws.below(std::uint64_t{1} << 32);
  return n >> static_cast<std::uint64_t>((32 - bits % 32) % 32);
}

/// Small and large parts; squares; roots that nearly or just cancel n; roots beside a double or beside the middle
/// between two; results everywhere in the range and beyond.
Root drawn(DrawStream& draws) {
  Root root;
  const auto integer = [&](int bits) {
    return draws.below(3) == 0 ? mpz_class(static_cast<std::int64_t>(draws.below(30))) : random_integer(draws, bits);
  };
  root.n = integer(300), root.square = integer(400), root.d = integer(200) + 1;
  switch (draws.below(4)) {
    case 0: root.square = root.square * root.square; break;
    case 1:
      root.square = abs(mpz_class(root.n * root.n + static_cast<std::int64_t>(catalogue::small_integer(draws, 2))));
      break;
    case 2: {
      // 54 digits, the last one set or not, times d; what is taken off comes back as a root, or a little more or less.
      const mpz_class m = random_integer(draws, 200), off = m * static_cast<std::int64_t>(draws.below(3));
      root.d = mpz_class(1) << draws.below(600);
      root.n = random_integer(draws, 54) * root.d * m - off;
      root.square = abs(mpz_class(off * off + static_cast<std::int64_t>(catalogue::small_integer(draws, 2))));
      root.d *= m + (m == 0 ? 1 : 0);
      break;
    }
    default: break;
  }
  if (draws.below(2) == 1) root.n = -root.n;
  if (draws.below(2) == 1) root.d = -root.d;
  root.sign = draws.below(2) == 1 ? 1 : -1;
  root.exponent = draws.below(3) == 0 ? static_cast<std::int64_t>(draws.below(120)) - 60
                                      : static_cast<std::int64_t>(draws.below(2600)) - 1300;
  return root;
}

template <class Check>
void cases(const char* name, int usual, const Check& check) {
  const auto wanted = static_cast<std::uint64_t>(scaled(usual));
  std::uint64_t wrong = 0;
  for (std::uint64_t i = 0; i < wanted; ++i) {
    DrawStream draws = DrawStream::seeded(catalogue::seed_of(1, name, i));
    if (!check(draws, i) && wrong++ == 0) UNSCOPED_INFO(name << ": case " << i << " is wrong");
  }
  CHECK(wrong == 0);
}

mpz_class integer_of(UInt128 n) {
  mpz_class high(static_cast<std::uint64_t>(n >> 64));
  return (high << 64) + static_cast<std::uint64_t>(n);
}

}  // namespace

TEST_CASE("quadratic roots: rounded as MPFR's, in every floating-point environment") {
  int zero = 0, below = 0, subnormal = 0, infinite = 0;
  cases("quadratic roots", 60000, [&](DrawStream& draws, std::uint64_t i) {
    const Root root = drawn(draws);
    const double expected = by_mpfr(root);
    double found = 0;
    {
      const Environment set(i % environment_count);
      found = root.rounded();
    }
    const int sign = kernel::sign_with_root(root.n, root.sign, root.square);
    zero += sign == 0, below += sign != 0 && expected == 0;
    subnormal += expected != 0 && std::abs(expected) < std::numeric_limits<double>::min();
    infinite += std::abs(expected) > std::numeric_limits<double>::max();
    return same_bits(found, expected);
  });
  CHECK(zero > scaled(400));
  CHECK(below > scaled(400));
  CHECK(subnormal > scaled(400));
  CHECK(infinite > scaled(400));
}

TEST_CASE("quadratic roots: well known ones, and one that all but cancels") {
  const auto rounded = [](const Root& root) { return root.rounded(); };
  CHECK(rounded({0, 1, 2}) == 0x1.6a09e667f3bcdp+0);
  CHECK(rounded({0, -1, 2}) == -0x1.6a09e667f3bcdp+0);
  CHECK(rounded({0, -1, 2, -1}) == 0x1.6a09e667f3bcdp+0);
  CHECK(rounded({1, 1, 5, 2}) == 0x1.9e3779b97f4a8p+0);  // the golden ratio
  CHECK(rounded({-1, 1, 5, 2}) == 0x1.3c6ef372fe95p-1);  // and its reciprocal
  CHECK(rounded({-4, 1, 9, 2}) == -0.5);
  CHECK(rounded({7, 1, 0, 2}) == 3.5);
  // n - sqrt(n^2 - 1) is 1 / (2 n) and about 1 / (8 n^3) more.
  const mpz_class n = mpz_class(1) << 500;
  CHECK(rounded({n, -1, n * n - 1}) == 0x1p-501);
  CHECK(rounded({-n, 1, n * n + 1}) == 0x1p-501);
}

TEST_CASE("quadratic roots: zero is +0 whatever the signs") {
  for (const int sign : {1, -1}) {
    for (const std::int64_t d : {7, -7}) {
      CHECK(same_bits(Root{-3 * sign, sign, 9, d}.rounded(), 0.0));
      CHECK(same_bits(Root{0, sign, 0, d, 1000}.rounded(), 0.0));
    }
  }
}

TEST_CASE("quadratic roots: a square makes ties, which go to even; an irrational root beside one decides") {
  const mpz_class even = mpz_class(1) << 53;  // its neighbours are 2 apart from here on
  CHECK(Root{even, 1, 1}.rounded() == 0x1p53);
  CHECK(Root{even + 2, 1, 1}.rounded() == 0x1p53 + 4);
  CHECK(Root{even + 2, -1, 1}.rounded() == 0x1p53);
  CHECK(Root{-even, -1, 1}.rounded() == -0x1p53);
  // (2^53 m + sqrt(m^2 + 1)) / m: 2^53 + 1 and about 1 / (2 m^2) more.
  for (const int digits : {1, 60, 200, 1000}) {
    const mpz_class m = mpz_class(1) << static_cast<std::uint64_t>(digits);
    CHECK(Root{even * m, 1, m * m + 1, m}.rounded() == 0x1p53 + 2);
    CHECK(Root{even * m, 1, m * m - 1, m}.rounded() == 0x1p53);
    CHECK(Root{(even + 2) * m, -1, m * m + 1, m}.rounded() == 0x1p53);
    CHECK(Root{(even + 2) * m, -1, m * m - 1, m}.rounded() == 0x1p53 + 2);
    CHECK(Root{-even * m, -1, m * m + 1, m}.rounded() == -0x1p53 - 2);
    CHECK(Root{even * m, 1, m * m + 1, -m}.rounded() == -0x1p53 - 2);
  }
}

TEST_CASE("quadratic roots: subnormal ones are rounded once, and one too small keeps its sign") {
  constexpr double least = std::numeric_limits<double>::denorm_min();
  CHECK(Root{0, 1, 2, 1, -1074}.rounded() == least);  // 1.41 of the least
  CHECK(Root{0, 1, 2, 1, -1075}.rounded() == least);  // 0.71
  CHECK(same_bits(Root{0, 1, 2, 1, -1076}.rounded(), 0.0));
  CHECK(same_bits(Root{0, -1, 2, 1, -1076}.rounded(), -0.0));
  CHECK(same_bits(Root{0, 1, 2, -1, -3000}.rounded(), -0.0));
  CHECK(same_bits(Root{0, 1, 1, 1, -1075}.rounded(), 0.0));  // half of the least: to even
  CHECK(Root{0, 1, 9, 1, -1075}.rounded() == 2 * least);     // one and a half: to even
  CHECK(Root{0, 1, 8, 1, -1075}.rounded() == least);         // 1.41
  CHECK(Root{0, 1, 10, 1, -1075}.rounded() == 2 * least);    // 1.58
  // Rounded to 53 digits first, 1/2 + 2^-60 of the least would be a tie.
  const mpz_class m = mpz_class(1) << 60;
  CHECK(Root{m, 1, 2, m, -1075}.rounded() == least);
  CHECK(same_bits(Root{m, -1, 2, m, -1075}.rounded(), 0.0));
}

TEST_CASE("quadratic roots: beyond 2^1024 - 2^970 they are infinite") {
  constexpr double greatest = std::numeric_limits<double>::max(), infinity = std::numeric_limits<double>::infinity();
  CHECK(Root{0, 1, 2, 1, 1023}.rounded() == 0x1.6a09e667f3bcdp+1023);
  CHECK(Root{0, 1, 5, 1, 1023}.rounded() == infinity);
  CHECK(Root{0, -1, 5, 1, 1023}.rounded() == -infinity);
  CHECK(Root{1, 1, 3, -1, 5000}.rounded() == -infinity);
  const mpz_class end = (mpz_class(1) << 54) - 1;  // times 2^970: the tie
  CHECK(Root{end, 1, 0, 1, 970}.rounded() == infinity);
  CHECK(Root{end << 300, 1, 2, mpz_class(1) << 300, 970}.rounded() == infinity);
  CHECK(Root{end << 300, -1, 2, mpz_class(1) << 300, 970}.rounded() == greatest);
  CHECK(Root{-end << 300, 1, 2, mpz_class(1) << 300, 970}.rounded() == -greatest);
}

TEST_CASE("quadratic roots: the sign of n + sqrt(square), by hand") {
  using kernel::sign_with_root;
  CHECK(sign_with_root(3, -1, 9) == 0);
  CHECK(sign_with_root(-3, 1, 9) == 0);
  CHECK(sign_with_root(3, -1, 8) == 1);
  CHECK(sign_with_root(3, -1, 10) == -1);
  CHECK(sign_with_root(-3, 1, 8) == -1);
  CHECK(sign_with_root(-3, 1, 10) == 1);
  CHECK(sign_with_root(3, 1, 9) == 1);
  CHECK(sign_with_root(-3, -1, 9) == -1);
  CHECK(sign_with_root(0, 1, 9) == 1);
  CHECK(sign_with_root(0, -1, 9) == -1);
  CHECK(sign_with_root(0, -1, 0) == 0);
  CHECK(sign_with_root(-5, 1, 0) == -1);
}

TEST_CASE("quadratic roots: products of 128 bits are compared in all their 256") {
  using kernel::compare_products;
  constexpr UInt128 all = ~UInt128{0}, half = UInt128{1} << 64;
  CHECK(compare_products(0, all, all, 0) == 0);
  CHECK(compare_products(all, all, all, all) == 0);
  CHECK(compare_products(all, all, all, all - 1) == 1);
  CHECK(compare_products(all - 1, all - 1, all, all - 2) == 1);  // (n - 1)^2 = n (n - 2) + 1
  CHECK(compare_products(half, half, half - 1, half + 1) == 1);  // 2^128 and one less: the low words tell
  CHECK(compare_products(half - 1, half + 1, all, 1) == 0);
  CHECK(compare_products(2, 3, 7, 1) == -1);
  int equal = 0;
  cases("products", 100000, [&](DrawStream& draws, std::uint64_t) {
    const auto number = [&] {
      const auto part = [&] { return draws.below(4) == 0 ? ~std::uint64_t{0} - draws.below(2) : draws.any_bits(); };
      const UInt128 high = part(), low = part();
      return (high << 64 | low) >> draws.below(128);
    };
    const UInt128 a = number(), b = number();
    UInt128 c = number(), d = number();
    switch (draws.below(3)) {
      case 0: c = b, d = a; break;
      case 1: c = a + 1 == 0 ? a : a + 1, d = b == 0 ? b : b - 1; break;
      default: break;
    }
    const int truth = cmp(mpz_class(integer_of(a) * integer_of(b)), mpz_class(integer_of(c) * integer_of(d)));
    equal += truth == 0;
    return compare_products(a, b, c, d) == (truth > 0) - (truth < 0);
  });
  CHECK(equal > scaled(1000));
}

}  // namespace touchstone::proptests::quadratic_root_tests
