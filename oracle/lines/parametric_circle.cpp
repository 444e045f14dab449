// SPDX-License-Identifier: Apache-2.0
#include "oracle/lines/parametric_circle.h"

#include <algorithm>
#include <bit>
#include <cstdint>

#include "geometry/door.h"
#include "oracle/exact/circular.h"
#include "oracle/exact/decode.h"
#include "oracle/exact/nearest_double.h"

namespace touchstone::oracle {
namespace {

const int closeness = 60;  // the answer is within 2^-60 units in the last place

Enclosure on_axis(double center, double radius, const Enclosure& unit) {
  const Rational from = exact(center), factor = exact(radius);
  return {Rational(from + factor * unit.low), Rational(from + factor * unit.value),
          Rational(from + factor * unit.high)};
}

/// One double (and one sign) is nearest to everything in the enclosure, and the enclosure is narrow enough.
bool certain(const Enclosure& x) {
  const auto bits = [](const Rational& value) { return std::bit_cast<std::uint64_t>(nearest_double(value)); };
  if (sgn(x.low) != sgn(x.high) || bits(x.low) != bits(x.high)) return false;
  return Rational(x.high - x.low) < scaled(Rational(1), ulp_exponent(x.value) - closeness);
}

struct Found {
  Point2<Rational> point;
  CosineAndSine enclosures;
};

/// u and the radius are not 0: cos u and sin u are transcendental, so both coordinates are irrational, no tie is
/// possible, and some precision decides.
Found find(const Circle2d& circle, double u) {
  for (int bits = 128;; bits += bits / 2) {
    const CosineAndSine turn = cosine_and_sine(u, bits);
    const Enclosure x = on_axis(circle.center.x, circle.radius, turn.cosine);
    const Enclosure y = on_axis(circle.center.y, circle.radius, turn.sine);
    if (certain(x) && certain(y)) return {{x.value, y.value}, turn};
  }
}

bool admitted_exact(const Circle2d& circle, double u) {
  door::admit("circle", circle), door::admit("u", u);
  return door::zero(u) || door::zero(circle.radius);
}

/// The position of the leading bit of a positive rational, give or take one.
int order(const Rational& value) {
  return static_cast<int>(mpz_sizeinbase(value.get_num_mpz_t(), 2)) -
         static_cast<int>(mpz_sizeinbase(value.get_den_mpz_t(), 2));
}

}  // namespace

Truth<Point2<Rational>> parametric_circle(const Circle2d& circle, double u) {
  Point2<Rational> point;
  if (admitted_exact(circle, u)) {
    point = {Rational(exact(circle.center.x) + exact(circle.radius)), exact(circle.center.y)};
  } else {
    point = find(circle, u).point;
  }
  return {point, std::min(rounding_margin(point.x), rounding_margin(point.y))};
}

Certificate parametric_circle_certificate(const Circle2d& circle, double u) {
  if (admitted_exact(circle, u)) return {"exact", {}};
  const auto [cosine, sine] = find(circle, u).enclosures;
  const Rational narrowest = std::min(Rational(cosine.high - cosine.low), Rational(sine.high - sine.low));
  const int bits = std::max(0, -order(narrowest)) + 32;  // fixed point for the checker, finer than the enclosures
  return {"enclosure",
          {{"cosine", {cosine.low, cosine.high}},
           {"sine", {sine.low, sine.high}},
           {"quarter_turns", {Rational(quarter_turns(u))}},
           {"bits", {Rational(bits)}}}};
}

}  // namespace touchstone::oracle
