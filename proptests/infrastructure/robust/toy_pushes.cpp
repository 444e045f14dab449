// SPDX-License-Identifier: Apache-2.0
#include <gmpxx.h>

#include "catalogue/families/draw_stream.h"
#include "proptests/catch.h"
#include "proptests/infrastructure/robust/narrow_float.h"
#include "robust/kernel/contacts/along_normal.h"

// The one bound of robust/kernel/contacts/along_normal.h and push.h on formats of 12, 13 and 20 digits: a velocity v
// that changes by t n, t = (1 + e) m (d . n) / ((m + l) n . n), d a difference that may cancel, along n or before; and
// a t that is exact.
namespace touchstone::proptests::toy_pushes_tests {
namespace {

using namespace robust::kernel;
using catalogue::DrawStream;

/// p digits, `binades` of them, both signs.
template <int p>
Narrow<p> drawn(DrawStream& draws, std::uint64_t binades = 6) {
  const auto digits = static_cast<double>((std::uint64_t{1} << (p - 1)) + draws.below(std::uint64_t{1} << (p - 1)));
  const double x = std::ldexp(digits, static_cast<int>(draws.below(binades)) - p);
  return Narrow<p>(draws.below(2) == 0 ? x : -x);
}

template <int p>
struct Count {
  std::uint64_t asked = 0, found = 0, missed = 0, misrounded = 0;
  double farthest = 0;  ///< in units of the error: above 1 the truth is missed

  /// v + t n.
  void judge(const mpq_class& truth, const Narrow<p>& v, const Share<Narrow<p>>& t, const Narrow<p>& n) {
    const Enclosed<Narrow<p>> x = along(v, t, factor(n));
    const mpq_class distance = abs(truth - x.high.value() - x.low.value()), error = x.error.value();
    asked += 1;
    missed += distance > error;
    farthest = std::max(farthest, mpq_class(distance / error).get_d());
    if (const auto said = enclosed_push(v, t, factor(n))) {
      const double unit = std::ldexp(1.0, std::ilogb(said->value()) + 1 - p);
      found += 1;
      misrounded += abs(truth - said->value()) * 2 > unit;
    }
  }
};

template <int p>
void push_one(DrawStream& draws, Count<p>& count) {
  using Float = Narrow<p>;
  std::array<Float, 3> v, w, n;
  for (int i = 0; i < 3; ++i) v[i] = drawn<p>(draws), w[i] = drawn<p>(draws), n[i] = drawn<p>(draws);
  if (draws.below(4) == 0) w = v, w[0] = Float(v[0].value() + std::ldexp(w[1].value(), -p / 2));
  // Nearly across: rounded, so that not all digits cancel.
  if (draws.below(3) == 0) {
    const double rest = (v[0].value() - w[0].value()) * n[0].value() + (v[1].value() - w[1].value()) * n[1].value();
    w[2] = Float(v[2].value() + rest / n[2].value());
  }
  const Float m = Float(std::fabs(drawn<p>(draws).value())), l = Float(std::fabs(drawn<p>(draws).value())),
              e = Float(std::ldexp(std::fabs(drawn<p>(draws).value()), -6));
  const auto term = [&](int i) { return product(factor(difference(v[i], w[i])), factor(n[i])); };
  const auto square_term = [&](int i) { return product(factor(n[i]), factor(n[i])); };
  Sum approach(term(0)), square(square_term(0));
  approach += term(1), approach += term(2), square += square_term(1), square += square_term(2);
  const Term2<Float> c = product(factor(two_sum(Float(1), e)), factor(m));
  const Factor<Float> coefficient = factor(Enclosed<Float>{c.head, c.tail, Float()});
  const Term2<Float> below = product(factor(two_sum(m, l)), factor(square.value()));
  const Divisor d(Enclosed<Float>{below.head, below.tail, Float()});
  const Float size = robust::filters::FloatFormat<Float>::magnitude(coefficient.whole) * approach.value().error;
  const Share<Float> t = share(product(factor(approach.value()), coefficient), size, d.value, d.inverse);

  mpq_class dot, squares;
  for (int i = 0; i < 3; ++i) {
    const mpq_class along_n = n[i].value();
    dot += (mpq_class(v[i].value()) - w[i].value()) * along_n, squares += along_n * along_n;
  }
  const mpq_class exact_t =
      (1 + mpq_class(e.value())) * m.value() * dot / ((mpq_class(m.value()) + l.value()) * squares);
  for (int i = 0; i < 3; ++i) {
    const mpq_class truth = v[i].value() + exact_t * n[i].value();
    count.judge(truth, v[i], t, n[i]);
  }
}

/// A t that is exact; a quarter of the points nearly 0, which mostly are not found.
template <int p>
void step_one(DrawStream& draws, Count<p>& count) {
  using Float = Narrow<p>;
  const Float t = drawn<p>(draws), n = drawn<p>(draws);
  const Float v = draws.below(4) == 0 ? Float(-(t.value() * n.value())) : drawn<p>(draws);
  count.judge(v.value() + mpq_class(t.value()) * n.value(), v, share(t), n);
}

/// No truth is missed; and the constant is not idle: a thirty-second of it would be too small.
template <int p>
void pushes(void (*one)(DrawStream&, Count<p>&)) {
  Count<p> count;
  for (std::uint64_t i = 0; i < 60000; ++i) {
    DrawStream draws = DrawStream::seeded(catalogue::seed_of(p, "pushes", i));
    one(draws, count);
  }
  INFO(p << " digits: " << count.asked << " asked, " << count.found << " found, farthest " << count.farthest);
  CHECK(count.missed == 0);
  CHECK(count.misrounded == 0);
  CHECK(count.farthest > 1 / 32.0);
  if (p >= 20) CHECK(2 * count.found > count.asked);
}

}  // namespace

TEST_CASE("along_normal: velocities that change along a normal") {
  pushes<12>(push_one<12>), pushes<13>(push_one<13>), pushes<20>(push_one<20>);
}
TEST_CASE("push: points along a line") { pushes<12>(step_one<12>), pushes<13>(step_one<13>), pushes<20>(step_one<20>); }

}  // namespace touchstone::proptests::toy_pushes_tests
