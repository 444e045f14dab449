// SPDX-License-Identifier: Apache-2.0
#include "oracle/lines/parametric_circle.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <type_traits>
#include <utility>

#include "geometry/validation.h"
#include "oracle/exact/numbers/circular.h"
#include "oracle/exact/numbers/common_scale.h"
#include "oracle/exact/numbers/nearest_double.h"

namespace touchstone::oracle {
namespace {

const int closeness = 60;  // the answer is within 2^-60 units in the last place

/// A coordinate, and the ends between which the true one is.
struct Coordinate {
  Rational value, low, high;
  bool certain;
};

/// One double (and one sign) is nearest to everything in the enclosure, and the enclosure (its width is not 0) is
/// narrow enough.
bool certain(const Coordinate& x, const Rational& width) {
  const auto bits = [](const Rational& value) { return std::bit_cast<std::uint64_t>(nearest_double(value)); };
  return binary_order(width) < ulp_exponent(x.value) - closeness && sgn(x.low) == sgn(x.high) &&
         bits(x.low) == bits(x.high);
}

/// center + radius * unit
template <class Number>
Coordinate on_axis(const CommonScale<Number, 3>& circle, std::size_t center, const Enclosure& unit) {
  const Integer radius = circle.integer(2), off(radius * unit.width);
  Integer whole = circle.integer(center);
  whole <<= static_cast<mp_bitcnt_t>(-unit.exponent);  // |unit| <= 1 has all its bits behind the point
  whole += radius * unit.nearest;
  const auto actual = [&](const Integer& size) { return circle.actual(scaled(size, unit.exponent), 1); };
  Coordinate x{actual(whole), actual(Integer(whole - off)), actual(Integer(whole + off)), false};
  x.certain = certain(x, actual(Integer(2 * off)));
  return x;
}

struct Found {
  Point2<Rational> point;
  CosineAndSine enclosures;
};

/// u and the radius are not 0: cos u and sin u are transcendental, so both coordinates are irrational, no tie is
/// possible, and some precision decides.
template <class Number>
Found find(const CommonScale<Number, 3>& circle, const Number& u) {
  for (int bits = 128;; bits += bits / 2) {
    const CosineAndSine turn = cosine_and_sine(u, bits);
    const Coordinate x = on_axis(circle, 0, turn.cosine), y = on_axis(circle, 1, turn.sine);
    if (x.certain && y.certain) return {{x.value, y.value}, turn};
  }
}

template <class Number>
CommonScale<Number, 3> validated_parametric_circle(const Circle2<Number>& circle, const Number& u) {
  validation::validate_all("circle", circle, "u", u);
  return CommonScale<Number, 3>({circle.center.x, circle.center.y, circle.radius});
}

Certificate certificate_parametric_circle(double u, const CosineAndSine& turn) {
  const auto ends = [](const Enclosure& x) {
    const Integer low(x.nearest - x.width), high(x.nearest + x.width);
    return std::vector<Rational>{scaled(low, x.exponent), scaled(high, x.exponent)};
  };
  const int bits = 32 - std::min(turn.cosine.exponent, turn.sine.exponent);  // for the checker, finer than these
  return {"enclosure",
          {{"cosine", ends(turn.cosine)},
           {"sine", ends(turn.sine)},
           {"quarter_turns", {Rational(quarter_turns(u))}},
           {"bits", {Rational(bits)}}}};
}

}  // namespace

template <Exact Number>
Truth<Point2<Rational>> parametric_circle(const Circle2<Number>& circle, const Number& u) {
  const CommonScale<Number, 3> n = validated_parametric_circle(circle, u);
  Truth<Point2<Rational>> result;
  if (validation::zero(u) || validation::zero(circle.radius)) {
    result.answer = actual_point(n, {rational(Integer(n.integer(0) + n.integer(2))), Rational(n.integer(1))});
    result.certificate = [] { return Certificate{"exact", {}}; };
  } else {
    Found found = find(n, u);
    result.answer = std::move(found.point);
    if constexpr (std::is_same_v<Number, double>)
      result.certificate = [u, turn = std::move(found.enclosures)] { return certificate_parametric_circle(u, turn); };
  }
  result.margin = std::min(rounding_margin(result.answer.x), rounding_margin(result.answer.y));
  return result;
}
template Truth<Point2<Rational>> parametric_circle(const Circle2d&, const double&);
template Truth<Point2<Rational>> parametric_circle(const Circle2<Rational>&, const Rational&);

}  // namespace touchstone::oracle
