// SPDX-License-Identifier: Apache-2.0
#include "robust/kernel/integers/rounding.h"

#include <mpfr.h>

#include "catalogue/families/numbers.h"
#include "proptests/property.h"
#include "robust/lines/line_point_at.h"

// Correct rounding against MPFR. Numbers are built from draws whose exponents fall everywhere: normal, subnormal,
// below, beyond; every second quotient is built next to a double or next to the middle between two.
namespace touchstone::proptests::rounding_tests {
namespace {

using catalogue::DrawStream;
namespace kernel = robust::kernel;

/// MPFR's result as a double: its exponent range set to that of binary64, subnormals rounded once.
class Mpfr {
 public:
  Mpfr() {
    mpfr_set_emin(-1073), mpfr_set_emax(1024);
    mpfr_init2(result_, 53);
  }
  ~Mpfr() { mpfr_clear(result_); }
  Mpfr(const Mpfr&) = delete;
  Mpfr& operator=(const Mpfr&) = delete;

  /// `compute` sets an mpfr_t and returns the ternary value.
  template <class Compute>
  double operator()(const Compute& compute) {
    const int direction = mpfr_check_range(result_, compute(result_), MPFR_RNDN);
    mpfr_subnormalize(result_, direction, MPFR_RNDN);
    return mpfr_get_d(result_, MPFR_RNDN);
  }

 private:
  mpfr_t result_;
};

bool same_bits(double a, double b) { return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b); }

mpz_class random_integer(DrawStream& draws, int bits) {
  mpz_class n = 0;
  for (int left = bits; left > 0; left -= 32) n = (n << 32) + draws.below(std::uint64_t{1} << 32);
  return n >> static_cast<std::uint64_t>((32 - bits % 32) % 32);
}

/// A numerator and a denominator whose quotient is a double, the middle between two, or a little more or less than
/// that, or anything.
std::pair<mpz_class, mpz_class> fraction(DrawStream& draws, int most_bits) {
  mpz_class d = random_integer(draws, 1 + static_cast<int>(draws.below(static_cast<std::uint64_t>(most_bits)))) + 1, n;
  if (draws.below(2) == 0) {
    n = random_integer(draws, 1 + static_cast<int>(draws.below(static_cast<std::uint64_t>(most_bits))));
  } else {
    // 54 bits: the last one set is a middle. One more or less than a multiple of d is just beside it.
    n = random_integer(draws, 54) * d;
    n += catalogue::small_integer(draws, 2);
  }
  return {draws.below(2) == 0 ? n : mpz_class(-n), d};
}

mpq_class times_power(const mpz_class& n, const mpz_class& d, std::int64_t exponent) {
  mpq_class q(n, d);
  q.canonicalize();
  if (exponent >= 0) {
    q <<= static_cast<mp_bitcnt_t>(exponent);
  } else {
    q >>= static_cast<mp_bitcnt_t>(-exponent);
  }
  return q;
}

/// Mostly where the result is near one end of the range, or in the subnormals.
std::int64_t exponent_of(DrawStream& draws) {
  switch (draws.below(4)) {
    case 0: return static_cast<std::int64_t>(draws.below(200)) - 1180;
    case 1: return static_cast<std::int64_t>(draws.below(120)) + 920;
    case 2: return static_cast<std::int64_t>(draws.below(5000)) - 2500;
    default: return static_cast<std::int64_t>(draws.below(100)) - 50;
  }
}

template <class Check>
void cases(const char* name, std::uint64_t count, const Check& check) {
  const auto wanted = static_cast<std::uint64_t>(scaled(static_cast<int>(count)));
  std::uint64_t wrong = 0;
  for (std::uint64_t i = 0; i < wanted; ++i) {
    DrawStream draws = DrawStream::seeded(catalogue::seed_of(1, name, i));
    if (!check(draws) && wrong++ == 0) UNSCOPED_INFO(name << ": case " << i << " is wrong");
  }
  CHECK(wrong == 0);
}

kernel::Int128 wide(const mpz_class& n) {
  const mpz_class size = abs(n), high = size >> 64;
  const auto value = static_cast<kernel::Int128>(static_cast<kernel::UInt128>(mpz_get_ui(high.get_mpz_t())) << 64 |
                                                 mpz_get_ui(size.get_mpz_t()));
  return sgn(n) < 0 ? -value : value;
}

}  // namespace

TEST_CASE("rounding: a million quotients of integers of any size are MPFR's") {
  Mpfr mpfr;
  cases("quotients", 1000000, [&](DrawStream& draws) {
    const auto [n, d] = fraction(draws, 200);
    const std::int64_t exponent = exponent_of(draws);
    const mpq_class q = times_power(n, d, exponent);
    return same_bits(kernel::round_quotient(n, d, exponent),
                     mpfr([&](mpfr_t r) { return mpfr_set_q(r, q.get_mpq_t(), MPFR_RNDN); }));
  });
}

TEST_CASE("rounding: a million quotients of 128-bit integers are MPFR's") {
  Mpfr mpfr;
  cases("short quotients", 1000000, [&](DrawStream& draws) {
    const auto [n, d] = fraction(draws, 70);
    const std::int64_t exponent = exponent_of(draws);
    const mpq_class q = times_power(n, d, exponent);
    return same_bits(kernel::round_quotient(wide(n), wide(d), exponent),
                     mpfr([&](mpfr_t r) { return mpfr_set_q(r, q.get_mpq_t(), MPFR_RNDN); }));
  });
}

TEST_CASE("rounding: quotients of 192 by 128 bits are MPFR's, whatever remainder follows a tie") {
  Mpfr mpfr;
  cases("long quotients", 400000, [&](DrawStream& draws) {
    const mpz_class d = random_integer(draws, 65 + static_cast<int>(draws.below(62))) + 1;
    // 54 bits, the last one set or not; what follows them is below a thousandth of a unit, so that the 64 bits of a
    // quotient end in a tie and only the remainder tells, or anything.
    mpz_class n = random_integer(draws, 54) * d, rest = random_integer(draws, 130) % d;
    if (draws.below(4) != 0) rest >>= 10 + draws.below(10);
    n += draws.below(8) == 0 ? mpz_class(0) : rest;
    if (draws.below(2) == 1) n = -n;
    const std::int64_t exponent = exponent_of(draws);
    const mpq_class q = times_power(n, d, exponent);
    const mpz_class size = abs(n);
    kernel::Int192 limbs{};
    for (std::size_t i = 0; i < 3; ++i) limbs.limb[i] = mpz_getlimbn(size.get_mpz_t(), static_cast<mp_size_t>(i));
    const double expected = mpfr([&](mpfr_t r) { return mpfr_set_q(r, q.get_mpq_t(), MPFR_RNDN); });
    return same_bits(kernel::round_quotient(sgn(n) < 0 ? -limbs : limbs, wide(d), exponent), expected) &&
           same_bits(kernel::round_quotient(n, d, exponent), expected);
  });
}

TEST_CASE("rounding: integers times powers of two are MPFR's, in 128 bits and in any size") {
  Mpfr mpfr;
  cases("scaled integers", 500000, [&](DrawStream& draws) {
    mpz_class n = random_integer(draws, 1 + static_cast<int>(draws.below(124)));
    if (draws.below(3) == 0) {
      n = random_integer(draws, 54) << 60;
      n += static_cast<std::int64_t>(catalogue::small_integer(draws, 2));
    }
    if (draws.below(2) == 1) n = -n;
    const std::int64_t exponent = exponent_of(draws);
    const mpq_class q = times_power(n, 1, exponent);
    const double expected = mpfr([&](mpfr_t r) { return mpfr_set_q(r, q.get_mpq_t(), MPFR_RNDN); });
    return same_bits(kernel::round_scaled(n, exponent), expected) &&
           same_bits(kernel::round_scaled(wide(n), exponent), expected);
  });
}

TEST_CASE("rounding: square roots of fractions are MPFR's") {
  Mpfr mpfr;
  mpfr_t exact;
  mpfr_init2(exact, 2400);
  cases("square roots", 300000, [&](DrawStream& draws) {
    auto [n, d] = fraction(draws, 120);
    n = abs(n);
    if (draws.below(2) == 1) {
      // The square of a double, of a middle, or just beside it.
      const mpz_class root = random_integer(draws, 54);
      n = root * root * d + static_cast<std::int64_t>(std::fabs(catalogue::small_integer(draws, 1)));
    }
    const std::int64_t exponent = exponent_of(draws);
    // A root has two exact neighbours that MPFR cannot miss: q lies between two squares, so 2400 bits of the quotient
    // are enough.
    const mpq_class q = times_power(n, d, exponent);
    const double expected = mpfr([&](mpfr_t r) {
      const auto low = mpfr_get_emin(), high = mpfr_get_emax();
      mpfr_set_emin(mpfr_get_emin_min()), mpfr_set_emax(mpfr_get_emax_max());
      mpfr_set_q(exact, q.get_mpq_t(), MPFR_RNDN);
      const int direction = mpfr_sqrt(r, exact, MPFR_RNDN);
      mpfr_set_emin(low), mpfr_set_emax(high);
      return direction;
    });
    return same_bits(kernel::round_square_root(n, d, exponent), expected);
  });
  mpfr_clear(exact);
}

TEST_CASE("rounding: points of a line are MPFR's fused multiply-add") {
  Mpfr mpfr;
  mpfr_t a, b, c;
  mpfr_inits2(53, a, b, c, static_cast<mpfr_ptr>(nullptr));
  cases("fused multiply-add", 1000000, [&](DrawStream& draws) {
    const bool wild = draws.below(2) == 1;
    const auto number = [&] { return wild ? catalogue::any_finite(draws) : catalogue::mixed_exponent(draws); };
    const double origin = number(), direction = number(),
                 t = draws.below(2) == 1 ? catalogue::ordinary(draws) : number();
    const double computed = robust::line_point_at({{origin, 0}, {direction, 1}}, t).x;
    // The range of the operands is wider than MPFR's present one: they are set before it is narrowed.
    const auto low = mpfr_get_emin(), high = mpfr_get_emax();
    mpfr_set_emin(-5000), mpfr_set_emax(5000);
    mpfr_set_d(a, t, MPFR_RNDN), mpfr_set_d(b, direction, MPFR_RNDN), mpfr_set_d(c, origin, MPFR_RNDN);
    const double expected = mpfr([&](mpfr_t r) {
      const int direction_of_rounding = mpfr_fma(r, a, b, c, MPFR_RNDN);
      mpfr_set_emin(low), mpfr_set_emax(high);
      return direction_of_rounding;
    });
    return same_bits(computed, expected == 0 && mpfr_zero_p(c) && (t == 0 || direction == 0) ? 0.0 : expected) ||
           (expected == 0 && computed == 0 && !std::signbit(computed));
  });
  mpfr_clears(a, b, c, static_cast<mpfr_ptr>(nullptr));
}

TEST_CASE("rounding: one bit anywhere below a tie decides it") {
  // An even significand, the half, and one bit `at` places above the last; from 55 digits to as many as 128 bits hold.
  const mpz_class even = mpz_class(1) << 52;
  int wrong = 0;
  for (int dropped = 2; dropped < 73; ++dropped) {
    const auto tie = [&](const mpz_class& kept) {
      return mpz_class((kept << static_cast<std::uint64_t>(dropped)) +
                       (mpz_class(1) << static_cast<std::uint64_t>(dropped - 1)));
    };
    for (int at = 0; at + 1 < dropped; ++at) {
      const mpz_class above = tie(even) + (mpz_class(1) << static_cast<std::uint64_t>(at));
      const mpz_class below = tie(even + 1) - (mpz_class(1) << static_cast<std::uint64_t>(at));
      for (const mpz_class& n : {above, below}) {
        wrong +=
            kernel::round_scaled(n, -dropped) != 0x1p52 + 1 || kernel::round_scaled(wide(n), -dropped) != 0x1p52 + 1;
        wrong += kernel::round_quotient(n, mpz_class(1), -dropped) != 0x1p52 + 1;
        wrong += kernel::round_quotient(wide(n), 1, -dropped) != 0x1p52 + 1;
      }
    }
    wrong += kernel::round_scaled(tie(even), -dropped) != 0x1p52 ||
             kernel::round_scaled(wide(tie(even)), -dropped) != 0x1p52;
  }
  CHECK(wrong == 0);
}

TEST_CASE("rounding: ties, subnormals and the ends of the range, by hand") {
  using kernel::round_quotient, kernel::round_scaled;
  const auto scaled_by = [](std::int64_t n, std::int64_t exponent) { return round_scaled(mpz_class(n), exponent); };
  CHECK(scaled_by((std::int64_t{1} << 53) + 1, 0) == 0x1p53);                // a tie: to even
  CHECK(scaled_by((std::int64_t{1} << 53) + 3, 0) == 0x1.0000000000002p53);  // the other way
  CHECK(same_bits(scaled_by(1, -1075), 0.0));                                // half the least number: to even
  CHECK(same_bits(scaled_by(-1, -1075), -0.0));                              // and its sign stays
  CHECK(scaled_by(3, -1076) == 0x1p-1074);                                   // three quarters
  CHECK(scaled_by(3, -1075) == 0x1p-1073);                                   // one and a half: to even
  CHECK(scaled_by((std::int64_t{1} << 53) - 1, -1075) == 0x1p-1022);         // the greatest subnormal and a half
  CHECK(scaled_by((std::int64_t{1} << 54) - 1, 970) == std::numeric_limits<double>::infinity());
  CHECK(scaled_by((std::int64_t{1} << 55) - 3, 969) == std::numeric_limits<double>::max());
  CHECK(scaled_by(-((std::int64_t{1} << 54) - 1), 970) == -std::numeric_limits<double>::infinity());
  CHECK(same_bits(scaled_by(0, 5), 0.0));
  CHECK(round_quotient(mpz_class(1), mpz_class(3)) == 0x1.5555555555555p-2);
  CHECK(round_quotient(mpz_class(2), mpz_class(-3)) == -0x1.5555555555555p-1);
  CHECK(same_bits(round_quotient(mpz_class(0), mpz_class(-3)), 0.0));
}

}  // namespace touchstone::proptests::rounding_tests
