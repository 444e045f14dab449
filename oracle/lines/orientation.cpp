// SPDX-License-Identifier: Apache-2.0
#include "oracle/lines/orientation.h"

#include "geometry/door.h"
#include "oracle/exact/common_power.h"

namespace touchstone::oracle {
namespace {

CommonPower<6> admitted(const Point2d& p0, const Point2d& p1, const Point2d& p) {
  const CommonPower<6> numbers({p0.x, p0.y, p1.x, p1.y, p.x, p.y});
  if (!numbers.finite()) door::admit("p0", p0), door::admit("p1", p1), door::admit("p", p);  // names the field: slower
  return numbers;
}

/// | x0 y0 1 | x1 y1 1 | x y 1 | by cofactors of the last column.
Rational determinant(const Point2d& p0, const Point2d& p1, const Point2d& p) {
  const CommonPower<6> n = admitted(p0, p1, p);
  const Point2<Integer> a{n.whole(0), n.whole(1)}, b{n.whole(2), n.whole(3)}, c{n.whole(4), n.whole(5)};
  const Integer whole((b.x * c.y - b.y * c.x) - (a.x * c.y - a.y * c.x) + (a.x * b.y - a.y * b.x));
  return scaled(whole, 2 * n.exponent());
}

}  // namespace

Truth<Side> orientation(const Point2d& p0, const Point2d& p1, const Point2d& p) {
  const Rational e = determinant(p0, p1, p);
  return {sgn(e) > 0 ? Side::left : sgn(e) < 0 ? Side::right : Side::on, Rational(abs(e))};
}

Side orientation_side(const Point2d& p0, const Point2d& p1, const Point2d& p) {
  const CommonPower<6> n = admitted(p0, p1, p);
  if (n.bits() <= 61) {
    using Word = Point2<std::int64_t>;
    return orientation_side<Int128>(Word{n.word(0), n.word(1)}, Word{n.word(2), n.word(3)}, Word{n.word(4), n.word(5)});
  }
  using Whole = Point2<Integer>;
  return orientation_side<Integer>(Whole{n.whole(0), n.whole(1)}, Whole{n.whole(2), n.whole(3)},
                                   Whole{n.whole(4), n.whole(5)});
}

Certificate orientation_certificate(const Point2d& p0, const Point2d& p1, const Point2d& p) {
  return {"determinant", {{"determinant", {determinant(p0, p1, p)}}}};
}

}  // namespace touchstone::oracle
