// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/space.h"
#include "geometry/thin_shapes.h"
#include "robust/kernel/enclosed/window.h"

/// Scalar products and intersections of lines, enclosed; the caller has checked robust/kernel/enclosed/window.h.
/// Computed two at a time if possible.
namespace touchstone::robust::kernel {

inline Factor<Two> swapped(const Factor<Two>& x) { return {x.whole.swapped(), x.head.swapped(), x.tail.swapped()}; }
inline Factor<double> first(const Factor<Two>& x) { return {x.whole.first(), x.head.first(), x.tail.first()}; }
inline Factor<double> second(const Factor<Two>& x) { return {x.whole.second(), x.head.second(), x.tail.second()}; }
inline Term2<double> first(const Term2<Two>& t) { return {t.head.first(), t.tail.first()}; }
inline Term2<double> second(const Term2<Two>& t) { return {t.head.second(), t.tail.second()}; }
inline Enclosed<double> first(const Enclosed<Two>& x) { return {x.high.first(), x.low.first(), x.error.first()}; }
inline Enclosed<double> second(const Enclosed<Two>& x) { return {x.high.second(), x.low.second(), x.error.second()}; }
inline Enclosed<Two> twice(const Enclosed<double>& x) { return {Two(x.high), Two(x.low), Two(x.error)}; }
inline Enclosed<Two> both(const Enclosed<double>& x, const Enclosed<double>& y) {
  return {Two(x.high, y.high), Two(x.low, y.low), Two(x.error, y.error)};
}

inline Factor<Two> both(const Factor<double>& x, const Factor<double>& y) {
  return {Two(x.whole, y.whole), Two(x.head, y.head), Two(x.tail, y.tail)};
}

inline Point2d point_of(Two x) { return {x.first(), x.second()}; }

/// a - b
inline Factor<Two> vector_between(Two b, Two a) { return factor(difference(a, b)); }

/// v.x * w.y - v.y * w.x
inline Enclosed<double> enclosed_cross(const Factor<Two>& v, const Factor<Two>& w) {
  const Term2<Two> products = product(v, swapped(w));
  return (Sum(first(products)) -= second(products)).value();
}

/// v.x * w.x + v.y * w.y
inline Enclosed<double> enclosed_dot(const Factor<Two>& v, const Factor<Two>& w) {
  const Term2<Two> products = product(v, w);
  return (Sum(first(products)) += second(products)).value();
}

/// v x w and v x z
inline Enclosed<Two> enclosed_crosses(const Factor<Two>& v, const Factor<Two>& w, const Factor<Two>& z) {
  const Term2<Two> p = product(swapped(w), v), q = product(swapped(z), v);
  Sum<Two> sum({firsts(p.head, q.head), firsts(p.tail, q.tail)});
  return (sum -= {seconds(p.head, q.head), seconds(p.tail, q.tail)}).value();
}

/// x^2 + y^2 + z^2 of settled numbers: the error of Sum, and twice each number times its error.
inline Enclosed<double> sum_of_squares(const Enclosed<Two>& xy, const Enclosed<double>& z) {
  using Format = filters::FloatFormat<Two>;
  const Factor<Two> v = factor(xy);
  const Factor<double> w = factor(z);
  const Term2<Two> squares = product(v, v);
  Sum sum(first(squares));
  sum += second(squares), sum += product(w, w);
  const Two carried = Format::magnitude(v.whole) * xy.error;
  Enclosed<double> result = sum.value();
  result.error = result.error + 2.5 * (carried.first() + carried.second() +
                                       filters::FloatFormat<double>::magnitude(w.whole) * z.error);
  return result;
}

/// a.a + ta (a.b - a.a) = b.a + tb (b.b - b.a), rounded.
struct Crossing {
  double ta, tb;
  Point2d point;
};

/// The point where the lines of two segments certainly cross; empty if that, or a number, is not certain.
[[gnu::always_inline]] inline std::optional<Crossing> crossing_of(const Segment2d& a, const Segment2d& b) {
  const Two start(a.a), other(b.a);
  const Factor<Two> r = vector_between(start, Two(a.b)), s = vector_between(other, Two(b.b)),
                    between = vector_between(start, other);
  const Enclosed<double> d = enclosed_cross(r, s);
  const Enclosed<Two> n = enclosed_crosses(between, s, r);
  if (!d.settled() || d.high == 0) return std::nullopt;
  const Enclosed<Two> t = n / Divisor(twice(d));
  const auto numbers = rounded(t);
  if (!numbers) return std::nullopt;
  const auto point = rounded(along(start, twice(first(t)), r));
  if (!point) return std::nullopt;
  return Crossing{numbers->first(), numbers->second(), point_of(*point)};
}

/// N . p + d for two planes or points, coordinate by coordinate.
inline Enclosed<Two> enclosed_heights(const Vector3<Factor<Two>>& n, Two offset, const Vector3<Factor<Two>>& p) {
  Sum sum(product(n.x, p.x));
  sum += product(n.y, p.y), sum += product(n.z, p.z), sum += offset;
  return sum.value();
}
inline Vector3<Factor<Two>> factors(Two x, Two y, Two z) { return {factor(x), factor(y), factor(z)}; }
inline Vector3<Factor<Two>> factors(const Vector3d& v) { return factors(Two(v.x), Two(v.y), Two(v.z)); }

}  // namespace touchstone::robust::kernel
