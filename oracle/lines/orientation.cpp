// SPDX-License-Identifier: Apache-2.0
#include "oracle/lines/orientation.h"

#include "geometry/validation.h"
#include "oracle/exact/numbers/common_scale.h"

namespace touchstone::oracle {
namespace {

template <class Number>
CommonScale<Number, 6> validated_orientation(const Point2<Number>& p0, const Point2<Number>& p1,
                                             const Point2<Number>& p) {
  const CommonScale<Number, 6> numbers({p0.x, p0.y, p1.x, p1.y, p.x, p.y});
  if (!numbers.finite())
    validation::validate("p0", p0), validation::validate("p1", p1),
        validation::validate("p", p);  // names the field: slower
  return numbers;
}

/// | x0 y0 1 | x1 y1 1 | x y 1 | by cofactors of the last column, in squares of the unit.
template <class Value, class Number>
Truth<Side> truth_orientation(const CommonScale<Number, 6>& n) {
  const Point2<Value> a = integer_point<Value>(n, 0), b = integer_point<Value>(n, 2), c = integer_point<Value>(n, 4);
  const Value e((b.x * c.y - b.y * c.x) - (a.x * c.y - a.y * c.x) + (a.x * b.y - a.y * b.x));
  return {sgn(e) > 0   ? Side::left
          : sgn(e) < 0 ? Side::right
                       : Side::on,
          n.actual(absolute(e), 2), [n, e] {
            return Certificate{"determinant", {{"determinant", {n.actual(rational(e), 2)}}}};
          }};
}

}  // namespace

template <Exact Number>
Truth<Side> orientation(const Point2<Number>& p0, const Point2<Number>& p1, const Point2<Number>& p) {
  const CommonScale<Number, 6> n = validated_orientation(p0, p1, p);
  return n.bits() <= most_bits_in_words ? truth_orientation<Int128>(n) : truth_orientation<Integer>(n);
}
template Truth<Side> orientation(const Point2d&, const Point2d&, const Point2d&);
template Truth<Side> orientation(const Point2<Rational>&, const Point2<Rational>&, const Point2<Rational>&);

Side orientation_side(const Point2d& p0, const Point2d& p1, const Point2d& p) {
  const CommonScale<double, 6> n = validated_orientation(p0, p1, p);
  if (n.bits() <= most_bits_in_words) {
    using Word = Point2<std::int64_t>;
    return orientation_side<Int128>(Word{n.word(0), n.word(1)}, Word{n.word(2), n.word(3)}, Word{n.word(4), n.word(5)});
  }
  return orientation_side<Integer>(integer_point(n, 0), integer_point(n, 2), integer_point(n, 4));
}

}  // namespace touchstone::oracle
