// SPDX-License-Identifier: Apache-2.0
#include <gmpxx.h>

#include <functional>

#include "catalogue/families/draw_stream.h"
#include "proptests/catch.h"
#include "proptests/infrastructure/robust/narrow_float.h"
#include "robust/kernel/enclosed/enclosed.h"

// The number kernel on formats of 12 and 13 digits, where every truth is known: no enclosure misses it, no rounded
// number is another, and most are found. Quotients and roots of single numbers are tried on all of them.
namespace touchstone::proptests::toy_enclosed_tests {
namespace {

using namespace robust::kernel;
using catalogue::DrawStream;

/// How far from the middle of its enclosure the truth lies, in units of the error: above 1 it is missed.
struct Count {
  std::uint64_t asked = 0, missed = 0, misrounded = 0, found = 0;
  double farthest = 0;

  template <int p>
  void add(const Enclosed<Narrow<p>>& x, const mpq_class& truth) {
    const mpq_class distance = abs(truth - x.high.value() - x.low.value()), error = x.error.value();
    asked += 1;
    missed += distance > error;
    if (error > 0) farthest = std::max(farthest, mpq_class(distance / error).get_d());
    const auto said = rounded(x);
    found += said.has_value();
    misrounded += said && abs(truth - said->value()) * 2 > ulp<p>(said->value());
  }

 private:
  template <int p>
  static double ulp(double x) {
    return std::ldexp(1.0, std::ilogb(x) + 1 - p);
  }
};

/// p digits, four binades, both signs.
template <int p>
Narrow<p> drawn(DrawStream& draws) {
  const auto digits = static_cast<double>((std::uint64_t{1} << (p - 1)) + draws.below(std::uint64_t{1} << (p - 1)));
  const double x = std::ldexp(digits, static_cast<int>(draws.below(4)) - p);
  return Narrow<p>(draws.below(2) == 0 ? x : -x);
}

/// A difference of two numbers, now and then nearly cancelled, and what it is.
template <int p>
struct Difference {
  Factor<Narrow<p>> computed;
  double exact;
};
template <int p>
Difference<p> drawn_difference(DrawStream& draws) {
  const Narrow<p> a = drawn<p>(draws);
  Narrow<p> b = drawn<p>(draws);
  if (draws.below(8) == 0) b = Narrow<p>(a.value() + std::ldexp(b.value(), -p / 2));
  return {factor(difference(a, b)), a.value() - b.value()};
}

/// A determinant of differences: a sum of two terms.
template <int p>
struct Determinant {
  Enclosed<Narrow<p>> computed;
  double exact;
};
template <int p>
Determinant<p> drawn_determinant(DrawStream& draws) {
  const auto a = drawn_difference<p>(draws), b = drawn_difference<p>(draws), c = drawn_difference<p>(draws),
             d = drawn_difference<p>(draws);
  Sum sum(product(a.computed, b.computed));
  sum -= product(c.computed, d.computed);
  return {sum.value(), a.exact * b.exact - c.exact * d.exact};
}

/// No truth is missed; and the constants are no worse than they are said to be: `share` of one would be too small.
template <int p>
void for_draws(const char* stream, double share, const std::function<void(DrawStream&, Count&)>& draw) {
  Count count;
  for (std::uint64_t i = 0; i < 60000; ++i) {
    DrawStream draws = DrawStream::seeded(catalogue::seed_of(p, stream, i));
    draw(draws, count);
  }
  INFO(p << " digits: " << count.asked << " asked, " << count.found << " found, farthest " << count.farthest);
  CHECK(count.missed == 0);
  CHECK(count.misrounded == 0);
  CHECK(count.farthest > share);
  if (p >= 20) CHECK(2 * count.found > count.asked);
}

template <int p>
void sums() {
  for_draws<p>("sums", 1 / 8.0, [](DrawStream& draws, Count& count) {
    const auto d = drawn_determinant<p>(draws);
    count.add(d.computed, d.exact);
  });
}

template <int p>
void quotients() {
  for_draws<p>("quotients", 1 / 32.0, [](DrawStream& draws, Count& count) {
    const auto n = drawn_determinant<p>(draws), d = drawn_determinant<p>(draws);
    if (!d.computed.settled() || d.computed.high.value() == 0) return;
    const auto t = n.computed / Divisor(d.computed);
    const mpq_class exact = mpq_class(n.exact) / d.exact;
    count.add(t, exact);
    const auto v = drawn_difference<p>(draws);
    const Narrow<p> start = drawn<p>(draws);
    count.add(along(start, t, v.computed), start.value() + exact * v.exact);
  });
}

template <int p>
void polynomials() {
  for_draws<p>("polynomials", 1 / 32.0, [](DrawStream& draws, Count& count) {
    const auto x = drawn_determinant<p>(draws), y = drawn_determinant<p>(draws), z = drawn_determinant<p>(draws);
    if (!x.computed.settled() || !y.computed.settled() || !z.computed.settled()) return;
    count.add(x.computed * x.computed - y.computed * z.computed,
              mpq_class(x.exact) * x.exact - mpq_class(y.exact) * z.exact);
  });
}

template <int p>
void products() {
  for_draws<p>("products", 1 / 32.0, [](DrawStream& draws, Count& count) {
    const auto x = drawn_determinant<p>(draws), y = drawn_determinant<p>(draws);
    count.add(times(x.computed, y.computed), mpq_class(x.exact) * y.exact);
  });
}

/// The root of x, in whole units beyond any digit that matters: its own error is below one of them.
mpq_class root_of(const mpq_class& x) {
  const mpz_class square = (mpz_class(x.get_num() << 400) / x.get_den());
  return mpq_class(sqrt(square), mpz_class(1) << 200);
}

template <int p>
void roots() {
  for_draws<p>("roots", 1 / 32.0, [](DrawStream& draws, Count& count) {
    const auto x = drawn_determinant<p>(draws);
    if (!x.computed.settled() || x.exact <= 0) return;
    count.add(square_root(x.computed), root_of(x.exact));
  });
}

/// All quotients of two numbers of one binade, and all roots of two.
template <int p>
void all_of_a_binade() {
  using Float = Narrow<p>;
  const auto number = [](int digits) { return Float(std::ldexp(digits, 1 - p)); };
  const Float none;
  Count quotients, roots;
  const int least = 1 << (p - 1), most = 1 << p;
  for (int d = least; d < most; ++d) {
    const Divisor by(Enclosed<Float>{number(d), none, none});
    for (int n = least; n < most; ++n) quotients.add(Enclosed<Float>{number(n), none, none} / by, mpq_class(n, d));
    for (const int factor : {1, 2}) {
      const Float x = number(d) * Float(factor);
      roots.add(square_root(Enclosed<Float>{x, none, none}), root_of(x.value()));
    }
  }
  CHECK(quotients.missed + quotients.misrounded + roots.missed + roots.misrounded == 0);
}

}  // namespace

TEST_CASE("enclosed: sums of products of differences") { sums<12>(), sums<13>(), sums<20>(); }
TEST_CASE("enclosed: their quotients, and points along a line") { quotients<12>(), quotients<13>(), quotients<20>(); }
TEST_CASE("enclosed: products and differences of such sums") {
  polynomials<12>(), polynomials<13>(), polynomials<20>();
}
TEST_CASE("enclosed: products of any such sums") { products<12>(), products<13>(), products<20>(); }
TEST_CASE("enclosed: their square roots") { roots<12>(), roots<13>(), roots<20>(); }
TEST_CASE("enclosed: all quotients of two numbers of 10 digits, and all roots") { all_of_a_binade<10>(); }

}  // namespace touchstone::proptests::toy_enclosed_tests
